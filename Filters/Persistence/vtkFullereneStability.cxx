#include "vtkFullereneStability.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/RangeChecks.h"
#include "Persistence/FullereneStability.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkGraph.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkTable.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkFullereneStability);

namespace
{

using isthmus::Point3;

/// Positions and, for the points of a vtkPointSet, their data.
std::vector<Point3> AtomsOf(vtkDataObject* input, vtkDataSetAttributes*& data)
{
  vtkPoints* points = nullptr;
  if (auto* set = vtkPointSet::SafeDownCast(input))
  {
    points = set->GetPoints();
    data = set->GetPointData();
  }
  else if (auto* graph = vtkGraph::SafeDownCast(input))
  {
    points = graph->GetPoints();
    data = graph->GetVertexData();
  }
  std::vector<Point3> atoms(points ? static_cast<std::size_t>(points->GetNumberOfPoints()) : 0);
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    points->GetPoint(static_cast<vtkIdType>(i), atoms[i].data());
  }
  return atoms;
}

std::vector<double> RadiiOf(vtkDataSetAttributes* data, std::size_t atoms)
{
  vtkDataArray* radii = data ? data->GetArray("Radius") : nullptr;
  if (!radii || radii->GetNumberOfComponents() != 1 ||
    radii->GetNumberOfTuples() != static_cast<vtkIdType>(atoms))
  {
    throw std::invalid_argument(
      "ScaleByRadius needs a point array Radius with one number for each "
      "atom: read the atoms with vtkMacromoleculeReader, or switch it off.");
  }
  std::vector<double> scales(atoms);
  for (std::size_t i = 0; i < atoms; ++i)
  {
    scales[i] = radii->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return scales;
}

template <typename Array>
Array* AddColumn(vtkTable* table, const char* name)
{
  vtkNew<Array> column;
  column->SetName(name);
  table->GetRowData()->AddArray(column);
  return column;
}

}

struct vtkFullereneStability::Tables
{
  Tables(vtkTable* rows, vtkTable* bars)
    : Molecule(AddColumn<vtkIdTypeArray>(rows, "Molecule"))
    , Atoms(AddColumn<vtkIdTypeArray>(rows, "Atoms"))
    , Bars(AddColumn<vtkIdTypeArray>(rows, "Bars"))
    , BarMolecule(AddColumn<vtkIdTypeArray>(bars, "Molecule"))
    , FeatureId(AddColumn<vtkIdTypeArray>(bars, "FeatureId"))
    , Dimension(AddColumn<vtkIntArray>(bars, "Dimension"))
  {
    const char* names[] = { "Integral", "FilteredIntegral", "Cavity", "BoxLength",
      "IntegralPerAtom", "FilteredIntegralPerAtom", "FilteredIntegralPerBoxLength", "EnergyProxy" };
    for (const char* name : names)
    {
      this->Numbers.push_back(AddColumn<vtkDoubleArray>(rows, name));
    }
    for (const char* name : { "Birth", "Death", "Persistence" })
    {
      this->BarNumbers.push_back(AddColumn<vtkDoubleArray>(bars, name));
    }
  }

  void AddRow(vtkIdType molecule, const isthmus::FullereneStability& row)
  {
    this->Molecule->InsertNextValue(molecule);
    this->Atoms->InsertNextValue(row.Atoms);
    this->Bars->InsertNextValue(row.Bars);
    const auto atoms = static_cast<double>(row.Atoms);
    const double values[] = { row.Integral, row.FilteredIntegral, row.Cavity, row.BoxLength,
      row.Integral / atoms, row.FilteredIntegral / atoms,
      row.BoxLength > 0.0 ? row.FilteredIntegral / row.BoxLength : 0.0, row.EnergyProxy };
    for (std::size_t i = 0; i < this->Numbers.size(); ++i)
    {
      this->Numbers[i]->InsertNextValue(values[i]);
    }
  }

  void AddBars(vtkIdType molecule, const std::vector<isthmus::DistanceBar>& bars)
  {
    for (std::size_t i = 0; i < bars.size(); ++i)
    {
      this->BarMolecule->InsertNextValue(molecule);
      this->FeatureId->InsertNextValue(static_cast<vtkIdType>(i));
      this->Dimension->InsertNextValue(bars[i].Dimension);
      this->BarNumbers[0]->InsertNextValue(bars[i].Birth);
      this->BarNumbers[1]->InsertNextValue(bars[i].Death);
      this->BarNumbers[2]->InsertNextValue(bars[i].Length());
    }
  }

  vtkIdTypeArray* Molecule;
  vtkIdTypeArray* Atoms;
  vtkIdTypeArray* Bars;
  std::vector<vtkDoubleArray*> Numbers;
  vtkIdTypeArray* BarMolecule;
  vtkIdTypeArray* FeatureId;
  vtkIntArray* Dimension;
  std::vector<vtkDoubleArray*> BarNumbers;
};

vtkFullereneStability::vtkFullereneStability()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkFullereneStability::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMolecule");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

void vtkFullereneStability::CheckParameters() const
{
  if (!(this->FilterDelta >= 0.0) || std::isinf(this->FilterDelta))
  {
    throw std::invalid_argument("FilterDelta is " + isthmus::FormatNumber(this->FilterDelta) +
      ", but it is the length of a bar: give 0 or a positive number.");
  }
  if (this->ScaleByRadius && this->Method == Exact)
  {
    throw std::invalid_argument("ScaleByRadius needs the method Grid, since the exact alpha "
                                "complex is for balls of equal size.");
  }
}

void vtkFullereneStability::AddMolecule(vtkDataObject* input, vtkIdType number, Tables& tables)
{
  vtkDataSetAttributes* data = nullptr;
  const std::vector<Point3> atoms = AtomsOf(input, data);
  if (atoms.empty())
  {
    return;
  }
  std::vector<isthmus::DistanceBar> bars;
  double theta = std::numeric_limits<double>::infinity();
  if (this->Method == Grid)
  {
    theta = this->Theta;
    const auto scales = this->ScaleByRadius ? RadiiOf(data, atoms.size()) : std::vector<double>();
    bars = isthmus::GridBars(
      atoms, scales, { this->Spacing, this->Theta, this->FastMarching }, isthmus::ProgressOf(this));
  }
  else
  {
    bars = isthmus::AlphaBars(atoms, isthmus::ProgressOf(this));
  }
  const isthmus::FullereneStability row =
    isthmus::ComputeStability(atoms, bars, this->FilterDelta, theta);
  if (const auto all = static_cast<std::int64_t>(atoms.size()); row.Atoms < all)
  {
    vtkWarningMacro(<< isthmus::TextOf(all - row.Atoms, " of ", all,
                      " atoms lie exactly where another one lies and count once. Is the molecule "
                      "there twice, for instance in several models?"));
  }
  tables.AddRow(number, row);
  tables.AddBars(number, bars);
}

int vtkFullereneStability::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* rows = vtkTable::GetData(outputVector, 0);
  vtkTable* bars = vtkTable::GetData(outputVector, 1);
  isthmus::ClearOutputs(outputVector);
  return isthmus::Guarded(this, outputVector,
    [&]()
    {
      this->CheckParameters();
      Tables tables(rows, bars);
      for (int i = 0; i < inputVector[0]->GetNumberOfInformationObjects(); ++i)
      {
        isthmus::RequireOneRank(this, vtkDataObject::GetData(inputVector[0], i), "atoms");
        this->AddMolecule(vtkDataObject::GetData(inputVector[0], i), i, tables);
      }
    });
}

void vtkFullereneStability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "FilterDelta: " << this->FilterDelta << "\n";
  os << indent << "Theta: " << this->Theta << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "FastMarching: " << this->FastMarching << "\n";
  os << indent << "ScaleByRadius: " << this->ScaleByRadius << "\n";
}
