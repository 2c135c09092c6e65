#include "vtkFullereneStability.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/NamedColumns.h"
#include "Core/RangeChecks.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkGraph.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkTable.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkFullereneStability);

namespace
{

using isthmus::Point3;

/// Positions and, for the points of a vtkPointSet, their data.
std::vector<Point3> ReadAtoms(vtkDataObject* input, vtkDataSetAttributes*& data)
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

std::vector<double> ReadRadii(vtkDataSetAttributes* data, std::size_t atoms)
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

/// The columns of a molecule's row.
struct MoleculeRow
{
  vtkIdType Molecule = 0;
  isthmus::FullereneStability Stability;
  std::vector<isthmus::DistanceBar> Bars;
};

void FillMolecules(const std::vector<MoleculeRow>& rows, vtkTable* table)
{
  using Row = isthmus::FullereneStability;
  vtkFieldData* const data = table->GetRowData();
  const auto add = [&](const char* name, double (*value)(const Row&, double))
  {
    isthmus::AddComputedColumn<vtkDoubleArray>(data, name, rows,
      [value](const MoleculeRow& row)
      { return value(row.Stability, static_cast<double>(row.Stability.Atoms)); });
  };
  isthmus::AddComputedColumn<vtkIdTypeArray>(
    data, "Molecule", rows, [](const MoleculeRow& row) { return row.Molecule; });
  isthmus::AddComputedColumn<vtkIdTypeArray>(
    data, "Atoms", rows, [](const MoleculeRow& row) { return row.Stability.Atoms; });
  isthmus::AddComputedColumn<vtkIdTypeArray>(
    data, "Bars", rows, [](const MoleculeRow& row) { return row.Stability.Bars; });
  add("Integral", [](const Row& row, double) { return row.Integral; });
  add("FilteredIntegral", [](const Row& row, double) { return row.FilteredIntegral; });
  add("Cavity", [](const Row& row, double) { return row.Cavity; });
  add("BoxLength", [](const Row& row, double) { return row.BoxLength; });
  add("IntegralPerAtom", [](const Row& row, double atoms) { return row.Integral / atoms; });
  add("FilteredIntegralPerAtom",
    [](const Row& row, double atoms) { return row.FilteredIntegral / atoms; });
  add("FilteredIntegralPerBoxLength",
    [](const Row& row, double)
    { return row.BoxLength > 0.0 ? row.FilteredIntegral / row.BoxLength : 0.0; });
  add("EnergyProxy", [](const Row& row, double) { return row.EnergyProxy; });
}

void FillBars(const std::vector<MoleculeRow>& rows, vtkTable* table)
{
  vtkFieldData* const data = table->GetRowData();
  std::vector<vtkIdType> molecules, features;
  std::vector<isthmus::DistanceBar> bars;
  for (const MoleculeRow& row : rows)
  {
    for (std::size_t i = 0; i < row.Bars.size(); ++i)
    {
      molecules.push_back(row.Molecule);
      features.push_back(static_cast<vtkIdType>(i));
      bars.push_back(row.Bars[i]);
    }
  }
  using Bar = isthmus::DistanceBar;
  isthmus::AddColumn<vtkIdTypeArray>(data, "Molecule", molecules);
  isthmus::AddColumn<vtkIdTypeArray>(data, "FeatureId", features);
  isthmus::AddComputedColumn<vtkIntArray>(
    data, "Dimension", bars, [](const Bar& bar) { return bar.Dimension; });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    data, "Birth", bars, [](const Bar& bar) { return bar.Birth; });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    data, "Death", bars, [](const Bar& bar) { return bar.Death; });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    data, "Persistence", bars, [](const Bar& bar) { return bar.Length(); });
}

}

const std::vector<isthmus::OutputArray>& vtkFullereneStability::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Rows, "Molecule", 1, "", ArrayChoice::None, "number among the inputs" },
    { 0, ArrayPlace::Rows, "Atoms", 1, "", ArrayChoice::None, "at different positions" },
    { 0, ArrayPlace::Rows, "Bars", 1, "", ArrayChoice::None,
      "rings (dimension 1) with a persistence of at least FilterDelta" },
    { 0, ArrayPlace::Rows, "Integral", 1, "length", ArrayChoice::None,
      "of beta_1: sum of the lengths of all bars of dimension 1" },
    { 0, ArrayPlace::Rows, "FilteredIntegral", 1, "length", ArrayChoice::None,
      "that of the counted bars" },
    { 0, ArrayPlace::Rows, "Cavity", 1, "length", ArrayChoice::None,
      "length of the longest bar of dimension 2" },
    { 0, ArrayPlace::Rows, "BoxLength", 1, "length", ArrayChoice::None,
      "longest side of the box around the atoms" },
    { 0, ArrayPlace::Rows, "IntegralPerAtom", 1, "length", ArrayChoice::None, "Integral / Atoms" },
    { 0, ArrayPlace::Rows, "FilteredIntegralPerAtom", 1, "length", ArrayChoice::None,
      "FilteredIntegral / Atoms" },
    { 0, ArrayPlace::Rows, "FilteredIntegralPerBoxLength", 1, "", ArrayChoice::None,
      "FilteredIntegral / BoxLength" },
    { 0, ArrayPlace::Rows, "EnergyProxy", 1, "length", ArrayChoice::None,
      "-FilteredIntegral / Atoms, the indicator of the thesis" },
    { 1, ArrayPlace::Rows, "Molecule", 1, "", ArrayChoice::None, "number among the inputs" },
    { 1, ArrayPlace::Rows, "FeatureId", 1, "", ArrayChoice::None, "from 0 in each molecule" },
    { 1, ArrayPlace::Rows, "Dimension", 1, "", ArrayChoice::None, "1 ring, 2 cage" },
    { 1, ArrayPlace::Rows, "Birth", 1, "length", ArrayChoice::None,
      "radius of the balls at which it closes" },
    { 1, ArrayPlace::Rows, "Death", 1, "length", ArrayChoice::None,
      "radius at which it is filled" },
    { 1, ArrayPlace::Rows, "Persistence", 1, "length", ArrayChoice::None, "Death - Birth" },
  };
  return table;
}

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

isthmus::FullereneStability vtkFullereneStability::Analyse(
  vtkDataObject* input, std::vector<isthmus::DistanceBar>& bars)
{
  vtkDataSetAttributes* data = nullptr;
  const std::vector<Point3> atoms = ReadAtoms(input, data);
  if (atoms.empty())
  {
    return {};
  }
  double theta = std::numeric_limits<double>::infinity();
  const isthmus::StabilityParameters& parameters = this->Parameters;
  if (parameters.Method == isthmus::StabilityMethod::Grid)
  {
    theta = parameters.Theta;
    const auto scales =
      parameters.ScaleByRadius ? ReadRadii(data, atoms.size()) : std::vector<double>();
    bars = isthmus::GridBars(atoms, scales, parameters, isthmus::MakeProgress(this));
  }
  else
  {
    bars = isthmus::AlphaBars(atoms, isthmus::MakeProgress(this));
  }
  const isthmus::FullereneStability row =
    isthmus::ComputeStability(atoms, bars, parameters.FilterDelta, theta);
  if (const auto all = static_cast<std::int64_t>(atoms.size()); row.Atoms < all)
  {
    vtkWarningMacro(<< isthmus::JoinText(all - row.Atoms, " of ", all,
                      " atoms lie exactly where another one lies and count once. Does the input "
                      "contain the molecule twice, for instance in several models?"));
  }
  return row;
}

int vtkFullereneStability::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* rows = vtkTable::GetData(outputVector, 0);
  vtkTable* bars = vtkTable::GetData(outputVector, 1);
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      isthmus::Check(this->Parameters);
      std::vector<MoleculeRow> molecules;
      for (int i = 0; i < inputVector[0]->GetNumberOfInformationObjects(); ++i)
      {
        isthmus::RequireOneRank(this, vtkDataObject::GetData(inputVector[0], i), "atoms");
        MoleculeRow row;
        row.Molecule = i;
        row.Stability = this->Analyse(vtkDataObject::GetData(inputVector[0], i), row.Bars);
        if (row.Stability.Atoms > 0)
        {
          molecules.push_back(std::move(row));
        }
      }
      FillMolecules(molecules, rows);
      FillBars(molecules, bars);
    });
}

void vtkFullereneStability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethod() << "\n";
  os << indent << "FilterDelta: " << this->GetFilterDelta() << "\n";
  os << indent << "Theta: " << this->GetTheta() << "\n";
  os << indent << "Spacing: " << this->GetSpacing() << "\n";
  os << indent << "FastMarching: " << this->GetFastMarching() << "\n";
  os << indent << "ScaleByRadius: " << this->GetScaleByRadius() << "\n";
}
