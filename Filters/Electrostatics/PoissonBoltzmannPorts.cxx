// What goes in and out of vtkPoissonBoltzmann.

#include "Atoms/AtomInput.h"
#include "Core/AlgorithmGuard.h"
#include "Electrostatics/ChargedAtoms.h"
#include "vtkPoissonBoltzmann.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

int vtkPoissonBoltzmann::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkImageData");
  if (port == 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  }
  if (port > 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkPoissonBoltzmann::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* const types[] = { "vtkImageData", "vtkPolyData", "vtkPointSet" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

vtkTypeBool vtkPoissonBoltzmann::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->MakeOutputs(inputVector, outputVector);
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

int vtkPoissonBoltzmann::MakeOutputs(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto ensure = [&](int port, vtkDataObject* wanted)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    vtkDataObject* present = info->Get(vtkDataObject::DATA_OBJECT());
    if (!present || !present->IsA(wanted->GetClassName()))
    {
      vtkSmartPointer<vtkDataObject> made =
        vtkSmartPointer<vtkDataObject>::Take(wanted->NewInstance());
      info->Set(vtkDataObject::DATA_OBJECT(), made);
    }
  };
  vtkNew<vtkImageData> image;
  vtkNew<vtkPolyData> surface;
  ensure(0, image);
  ensure(1, surface);
  vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
  ensure(2, atoms ? static_cast<vtkDataObject*>(atoms) : surface);
  return 1;
}

vtkPointSet* vtkPoissonBoltzmann::AtomsWithCharges(vtkInformationVector** inputVector)
{
  vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
  const isthmus::ChargeArrays arrays{ isthmus::InputArrayName(this, 0),
    isthmus::InputArrayName(this, 1) };
  if (!atoms || atoms->GetNumberOfPoints() == 0 || !isthmus::LacksCharges(atoms, arrays))
  {
    return atoms;
  }
  return this->Charged->Get(atoms, arrays, static_cast<isthmus::ChargeTable>(this->ForceField),
    isthmus::Between(isthmus::ProgressOf(this), 0.0, 0.05));
}

vtkPolyData* vtkPoissonBoltzmann::GetSurface()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

vtkPointSet* vtkPoissonBoltzmann::GetAtoms()
{
  return vtkPointSet::SafeDownCast(this->GetOutputDataObject(2));
}

void vtkPoissonBoltzmann::Warn(const std::string& sentence)
{
  if (!sentence.empty())
  {
    vtkWarningMacro(<< sentence);
  }
}
