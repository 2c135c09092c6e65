#include "vtkPDETransform.h"

#include "DiffusionImage.h"
#include "PDETransform.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <functional>
#include <string>

vtkStandardNewMacro(vtkPDETransform);

vtkPDETransform::vtkPDETransform() = default;

isthmus::PDETransformParameters vtkPDETransform::GetParameters() const
{
  isthmus::PDETransformParameters parameters;
  parameters.Modes = this->NumberOfModes;
  parameters.FirstOrder = this->FirstOrder;
  parameters.LastOrder = this->LastOrder;
  parameters.FirstWavelength = this->FirstWavelength;
  parameters.Ratio = this->WavelengthRatio;
  return parameters;
}

int vtkPDETransform::HaloWidth()
{
  isthmus::DiffusionParameters highest;
  highest.EdgeStopping = isthmus::DiffusionParameters::EdgeStoppingType::None;
  highest.Order = std::clamp(this->FirstOrder, 0, 3);
  return isthmus::HaloWidth(highest);
}

template <typename T>
void vtkPDETransform::Transform(isthmus::DiffusionImage<T>& image)
{
  const isthmus::PDETransformParameters parameters = this->GetParameters();
  isthmus::Check(parameters);
  auto values = image.Copy(this->ChosenScalars(image.GetInput()), this->GetMaskInvalid());
  values->SetName("Residue");
  isthmus::TransformByPDE<T>(
    image.GetGrid(), parameters, values->GetPointer(0),
    [&](int k, const T* before, const T* after)
    {
      auto mode = image.Duplicate(values, "Mode" + std::to_string(k + 1));
      std::transform(
        before, before + image.GetGrid().Size(), after, mode->GetPointer(0), std::minus<T>());
      image.AddResult(mode, false);
    },
    image.GetProgress());
  image.AddResult(values, true);
}

void vtkPDETransform::Process(isthmus::DiffusionImage<float>& image)
{
  this->Transform(image);
}

void vtkPDETransform::Process(isthmus::DiffusionImage<double>& image)
{
  this->Transform(image);
}

void vtkPDETransform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfModes: " << this->NumberOfModes << '\n';
  os << indent << "FirstOrder: " << this->FirstOrder << '\n';
  os << indent << "LastOrder: " << this->LastOrder << '\n';
  os << indent << "FirstWavelength: " << this->FirstWavelength << '\n';
  os << indent << "WavelengthRatio: " << this->WavelengthRatio << '\n';
}
