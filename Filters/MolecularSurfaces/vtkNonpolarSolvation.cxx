#include "vtkNonpolarSolvation.h"

#include "Atoms/MoleculeAtoms.h"
#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/ImageExtent.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "MolecularSurfaces/AtomsInside.h"
#include "MolecularSurfaces/DispersionAtoms.h"
#include "MolecularSurfaces/NonpolarEnergy.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <cmath>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkNonpolarSolvation);

namespace
{

using isthmus::NonpolarEnergies;
using isthmus::NonpolarTerms;

struct Column
{
  const char* Name;
  double (*Value)(const NonpolarTerms&);
};

const Column Columns[] = {
  { "Area", [](const NonpolarTerms& t) { return t.Area; } },
  { "Volume", [](const NonpolarTerms& t) { return t.Volume; } },
  { "SurfaceEnergy", [](const NonpolarTerms& t) { return t.SurfaceEnergy; } },
  { "VolumeEnergy", [](const NonpolarTerms& t) { return t.VolumeEnergy; } },
  { "DispersionEnergy", [](const NonpolarTerms& t) { return t.DispersionEnergy; } },
  { "NonpolarEnergy", [](const NonpolarTerms& t) { return t.Total(); } },
};

isthmus::DensityGrid MakeGrid(vtkImageData* image)
{
  isthmus::DensityGrid grid;
  const double* h = image->GetSpacing();
  if (!(h[0] > 0.0) || std::abs(h[1] - h[0]) > 1e-6 * h[0] || std::abs(h[2] - h[0]) > 1e-6 * h[0] ||
    !image->GetDirectionMatrix()->IsIdentity())
  {
    throw std::invalid_argument("The cells of the volume are not cubes along the axes: use the "
                                "volume of vtkMolecularFlowSurface.");
  }
  grid.Spacing = h[0];
  const int* extent = image->GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    grid.Origin[a] = image->GetOrigin()[axis] + grid.Spacing * extent[2 * axis];
    grid.Dimensions[a] = image->GetDimensions()[axis];
  }
  return grid;
}

std::vector<float> ReadDistances(vtkImageData* image)
{
  vtkDataArray* array = image->GetPointData()->GetArray("SignedDistance");
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("The volume has no array SignedDistance of one component: use "
                                "output 1 of vtkMolecularFlowSurface.");
  }
  std::vector<float> distances(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType node = 0; node < array->GetNumberOfTuples(); ++node)
  {
    const double value = array->GetComponent(node, 0);
    if (std::isnan(value))
    {
      throw std::invalid_argument(
        "SignedDistance is not a number at node " + std::to_string(node) + ": fill it in first.");
    }
    distances[static_cast<std::size_t>(node)] = static_cast<float>(value);
  }
  return distances;
}

void FillAtoms(vtkDataObject* input, const isthmus::MoleculeAtoms& atoms,
  const NonpolarEnergies& energies, vtkPolyData* output)
{
  output->SetPoints(isthmus::AtomPoints(input));
  output->GetPointData()->ShallowCopy(isthmus::AtomData(input));
  output->SetFieldData(input->GetFieldData());
  auto* surface = vtkPolyData::SafeDownCast(input);
  if (surface && surface->GetNumberOfCells() > 0)
  {
    output->CopyStructure(surface);
    output->GetCellData()->ShallowCopy(surface->GetCellData());
  }
  else
  {
    vtkNew<vtkCellArray> vertices;
    for (vtkIdType atom = 0; atom < atoms.NumberOfAtoms; ++atom)
    {
      vertices->InsertNextCell(1, &atom);
    }
    output->SetVerts(vertices);
  }
  for (const Column& column : Columns)
  {
    auto* values = isthmus::AddArray<vtkDoubleArray>(
      output->GetPointData(), column.Name, static_cast<std::size_t>(atoms.NumberOfAtoms));
    values->FillValue(0.0);
    for (std::size_t i = 0; i < atoms.Points.size(); ++i)
    {
      values->SetValue(atoms.Points[i], column.Value(energies.Atoms[i]));
    }
  }
  output->GetPointData()->SetActiveScalars("NonpolarEnergy");
}

void FillTable(const NonpolarEnergies& energies, vtkTable* table)
{
  vtkDataSetAttributes* rows = table->GetRowData();
  for (const Column& column : Columns)
  {
    isthmus::AddColumn<vtkDoubleArray>(rows, column.Name, { column.Value(energies.Whole) });
  }
  isthmus::AddColumn<vtkDoubleArray>(rows, "NonpolarEnergyError", { energies.Error });
}

}

const std::vector<isthmus::OutputArray>& vtkNonpolarSolvation::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Area", 1, "angstrom^2", ArrayChoice::None,
      "of the surface; part of the atom" },
    { 0, ArrayPlace::Points, "Volume", 1, "angstrom^3", ArrayChoice::None,
      "enclosed; part of the atom" },
    { 0, ArrayPlace::Points, "SurfaceEnergy", 1, "kcal/mol", ArrayChoice::None,
      "SurfaceTension x Area; part of the atom" },
    { 0, ArrayPlace::Points, "VolumeEnergy", 1, "kcal/mol", ArrayChoice::None,
      "Pressure x Volume; part of the atom" },
    { 0, ArrayPlace::Points, "DispersionEnergy", 1, "kcal/mol", ArrayChoice::None,
      "attraction of the atoms and the solvent; part of the atom" },
    { 0, ArrayPlace::Points, "NonpolarEnergy", 1, "kcal/mol", ArrayChoice::None,
      "sum of the three; part of the atom" },
    { 1, ArrayPlace::Rows, "Area", 1, "angstrom^2", ArrayChoice::None, "of the surface" },
    { 1, ArrayPlace::Rows, "Volume", 1, "angstrom^3", ArrayChoice::None, "enclosed" },
    { 1, ArrayPlace::Rows, "SurfaceEnergy", 1, "kcal/mol", ArrayChoice::None,
      "SurfaceTension x Area" },
    { 1, ArrayPlace::Rows, "VolumeEnergy", 1, "kcal/mol", ArrayChoice::None, "Pressure x Volume" },
    { 1, ArrayPlace::Rows, "DispersionEnergy", 1, "kcal/mol", ArrayChoice::None,
      "attraction of the atoms and the solvent" },
    { 1, ArrayPlace::Rows, "NonpolarEnergy", 1, "kcal/mol", ArrayChoice::None, "sum of the three" },
    { 1, ArrayPlace::Rows, "NonpolarEnergyError", 1, "kcal/mol", ArrayChoice::None,
      "estimated, of area and volume due to the spacing" },
  };
  return table;
}

vtkNonpolarSolvation::vtkNonpolarSolvation()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radius");
}

int vtkNonpolarSolvation::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  if (port == 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
    return 1;
  }
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMolecule");
  return 1;
}

int vtkNonpolarSolvation::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkNonpolarSolvation::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // The whole inside is needed, whatever piece is requested.
  if (vtkInformation* image = input[1]->GetInformationObject(0))
  {
    isthmus::RequestWholeExtent(image);
  }
  return 1;
}

int vtkNonpolarSolvation::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      isthmus::Check(this->Parameters);
      vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
      isthmus::RequireOneRank(this, input, "atoms");
      vtkImageData* image = vtkImageData::GetData(inputVector[1]);
      const isthmus::MoleculeAtoms atoms = isthmus::ReadAtoms(input,
        isthmus::SelectWholeMolecule(
          isthmus::InputArrayName(this, 0), this->IncludeWaters, this->UnitedAtoms));
      if (atoms.Balls.empty())
      {
        return;
      }
      for (const std::string& warning : atoms.Warnings)
      {
        vtkWarningMacro(<< warning);
      }
      const std::vector<float> distances = ReadDistances(image);
      const isthmus::DensityGrid grid = MakeGrid(image);
      std::vector<isthmus::Point3> centers;
      for (const isthmus::Ball& atom : atoms.Balls)
      {
        centers.push_back(atom.Center);
      }
      const std::string outside = isthmus::CheckAtomsInside(image, distances, centers, "atoms");
      if (!outside.empty())
      {
        vtkWarningMacro(<< outside);
      }
      isthmus::RequireDistances(grid, distances);
      const NonpolarEnergies energies =
        isthmus::NonpolarEnergy(atoms.Balls, isthmus::MakeDispersionAtoms(input, atoms), grid,
          distances.data(), this->Parameters, isthmus::MakeProgress(this));
      FillAtoms(input, atoms, energies, output);
      FillTable(energies, table);
    });
}

void vtkNonpolarSolvation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->PrintSolventProperties(os, indent);
  os << indent << "SolventDensity: " << this->GetSolventDensity() << "\n";
  os << indent << "SolventRadius: " << this->GetSolventRadius() << "\n";
  os << indent << "SolventWellDepth: " << this->GetSolventWellDepth() << "\n";
  this->PrintAtomProperties(os, indent);
}
