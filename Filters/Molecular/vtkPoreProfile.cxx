#include "vtkPoreProfile.h"

#include "AlgorithmGuard.h"
#include "AtomInput.h"
#include "PoreOutput.h"
#include "PoreProfile.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <stdexcept>

vtkStandardNewMacro(vtkPoreProfile);

vtkPoreProfile::vtkPoreProfile()
{
  this->SetNumberOfOutputPorts(6);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radius");
}

vtkTable* vtkPoreProfile::GetProfile()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

vtkTable* vtkPoreProfile::GetPoreTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

vtkPolyData* vtkPoreProfile::GetBottlenecks()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(3));
}

vtkTable* vtkPoreProfile::GetLiningResidues()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(4));
}

vtkPolyData* vtkPoreProfile::GetTubes()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(5));
}

int vtkPoreProfile::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkPoreProfile::FillOutputPortInformation(int port, vtkInformation* info)
{
  const bool isTable = port == 1 || port == 2 || port == 4;
  info->Set(vtkDataObject::DATA_TYPE_NAME(), isTable ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkPoreProfile::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
  const auto clear = [&]()
  {
    for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
    {
      vtkDataObject::GetData(outputVector, port)->Initialize();
    }
  };
  clear();
  const bool done = isthmus::Succeeds(this, vtkDataObject::GetData(outputVector, 0),
    [&]()
    {
      if (atoms)
      {
        this->Compute(atoms, outputVector);
      }
    });
  if (!done || this->GetAbortExecute())
  {
    clear();
  }
  return 1;
}

void vtkPoreProfile::Compute(vtkPointSet* input, vtkInformationVector* outputs)
{
  if (this->MaximumPores < 0)
  {
    throw std::invalid_argument("MaximumPores is negative, but it is a number of pores.");
  }
  isthmus::PolymerOptions keep;
  keep.Hydrogens = this->KeepHydrogens;
  keep.Ions = this->KeepIons;
  keep.Ligands = this->KeepLigands;
  keep.ProstheticGroups = true;
  isthmus::PoreOptions options;
  options.EndRadius = this->EndRadius;
  options.Spacing = this->Spacing;
  options.MinimumRadius = this->MinimumRadius;
  options.MinimumSpan = this->MinimumSpan;
  options.MaximumPores = static_cast<std::size_t>(this->MaximumPores);
  options.MaximumOffset = this->MaximumOffset;
  isthmus::ChosenAtoms atoms;
  if (input->GetNumberOfPoints() > 0)
  {
    atoms = isthmus::ChooseAtoms(
      isthmus::InputArrayName(this, 0), input, keep, isthmus::WithoutRadii::SurfacePoints);
  }
  const auto progress = isthmus::Between(isthmus::ProgressOf(this), 0.0, 0.95);
  const auto point = [](const double* p) { return isthmus::Point3{ p[0], p[1], p[2] }; };
  std::vector<isthmus::Pore> pores;
  if (this->Mode == Automatic || atoms.Balls.empty())
  {
    pores = isthmus::FindPores(atoms.Balls, options, progress);
  }
  else if (this->Mode == TwoPoints)
  {
    pores.push_back(isthmus::PoreBetween(
      atoms.Balls, point(this->Point1), point(this->Point2), options, progress));
  }
  else
  {
    pores.push_back(isthmus::PoreAlong(
      atoms.Balls, point(this->Point), point(this->Direction), options, progress));
  }
  const isthmus::PoreReport report{ pores, atoms };
  auto* lines = vtkPolyData::GetData(outputs, 0);
  isthmus::FillPoreLines(report, lines);
  isthmus::FillPoreSamples(report, vtkTable::GetData(outputs, 1));
  isthmus::FillPoreTable(report, vtkTable::GetData(outputs, 2));
  isthmus::FillBottlenecks(report, vtkPolyData::GetData(outputs, 3));
  isthmus::FillPoreLining(report, vtkTable::GetData(outputs, 4));
  isthmus::FillTubes(lines, vtkPolyData::GetData(outputs, 5));
  isthmus::AddNotes(atoms.Notes, lines);
  for (const std::string& warning : atoms.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
}

void vtkPoreProfile::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [&](const char* name, const double* v)
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  os << indent << "Mode: " << this->Mode << "\n";
  vector("Point1", this->Point1);
  vector("Point2", this->Point2);
  vector("Point", this->Point);
  vector("Direction", this->Direction);
  os << indent << "EndRadius: " << this->EndRadius << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "MinimumRadius: " << this->MinimumRadius << "\n";
  os << indent << "MinimumSpan: " << this->MinimumSpan << "\n";
  os << indent << "MaximumPores: " << this->MaximumPores << "\n";
  os << indent << "MaximumOffset: " << this->MaximumOffset << "\n";
  os << indent << "KeepHydrogens: " << this->KeepHydrogens << "\n";
  os << indent << "KeepIons: " << this->KeepIons << "\n";
  os << indent << "KeepLigands: " << this->KeepLigands << "\n";
}
