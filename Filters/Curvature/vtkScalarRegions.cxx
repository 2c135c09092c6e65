#include "vtkScalarRegions.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/Index.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"
#include "Curvature/ScalarRegions.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkScalarRegions);

const std::vector<isthmus::OutputArray>& vtkScalarRegions::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Region", 1, "", ArrayChoice::None, "number of the region" },
    { 0, ArrayPlace::Cells, "Region", 1, "", ArrayChoice::None,
      "number of the region; the middle one of those of the corners" },
    { 0, ArrayPlace::Points, "SecondRegion", 1, "", ArrayChoice::None,
      "region of the second scalar" },
    { 0, ArrayPlace::Cells, "SecondRegion", 1, "", ArrayChoice::None,
      "region of the second scalar; the middle one of those of the corners" },
    { 0, ArrayPlace::Points, "JointRegion", 1, "", ArrayChoice::None,
      "Region x number of second regions + SecondRegion" },
    { 0, ArrayPlace::Cells, "JointRegion", 1, "", ArrayChoice::None,
      "Region x number of second regions + SecondRegion; the middle one of those of the corners" },
    { 0, ArrayPlace::Points, "ToonColor", 3, "", ArrayChoice::None,
      "red, green, blue: the lowest region is red, the highest blue, others are grey" },
    { 1, ArrayPlace::Rows, "Region", 1, "", ArrayChoice::None, "number of the region" },
    { 1, ArrayPlace::Rows, "From", 1, "of the scalars", ArrayChoice::None,
      "lower threshold; -infinity: none" },
    { 1, ArrayPlace::Rows, "To", 1, "of the scalars", ArrayChoice::None,
      "upper threshold; infinity: none" },
    { 1, ArrayPlace::Rows, "Area", 1, "length^2", ArrayChoice::None, "of the region" },
    { 1, ArrayPlace::Rows, "Fraction", 1, "", ArrayChoice::None, "of the area of the surface" },
    { 1, ArrayPlace::Rows, "NAME below NAME", 1, "length^2", ArrayChoice::None,
      "area of the region that is also in the lowest region of the second scalar, whose array "
      "and threshold are in the name" },
    { 1, ArrayPlace::Rows, "NAME NAME to NAME", 1, "length^2", ArrayChoice::None,
      "the same for regions between its thresholds" },
    { 1, ArrayPlace::Rows, "NAME from NAME", 1, "length^2", ArrayChoice::None,
      "the same for its highest region" },
    { 2, ArrayPlace::Rows, "Minimum", 1, "of the scalars", ArrayChoice::None,
      "lowest threshold of the step" },
    { 2, ArrayPlace::Rows, "Maximum", 1, "of the scalars", ArrayChoice::None,
      "highest threshold of the step" },
    { 2, ArrayPlace::Rows, "Below", 1, "length^2", ArrayChoice::None, "area below Minimum" },
    { 2, ArrayPlace::Rows, "Between", 1, "length^2", ArrayChoice::None, "area between them" },
    { 2, ArrayPlace::Rows, "Above", 1, "length^2", ArrayChoice::None, "area above Maximum" },
    { 3, ArrayPlace::Rows, "Value", 1, "of the scalars", ArrayChoice::None, "middle of the bin" },
    { 3, ArrayPlace::Rows, "Area", 1, "length^2", ArrayChoice::None, "of the bin" },
    { 3, ArrayPlace::Rows, "Fraction", 1, "", ArrayChoice::None, "of the area of the surface" },
  };
  return table;
}

namespace
{

using namespace isthmus;

constexpr double Infinity = std::numeric_limits<double>::infinity();

double LowerEnd(const ThresholdedScalar& scalar, std::size_t region)
{
  return region == 0 ? -Infinity : scalar.Thresholds[region - 1];
}

double UpperEnd(const ThresholdedScalar& scalar, std::size_t region)
{
  return region + 1 == scalar.Regions() ? Infinity : scalar.Thresholds[region];
}

std::string FormatName(const ThresholdedScalar& scalar, const std::string& name, std::size_t region)
{
  if (region == 0)
  {
    return isthmus::JoinText(name, " below ", UpperEnd(scalar, region));
  }
  if (region + 1 == scalar.Regions())
  {
    return isthmus::JoinText(name, " from ", LowerEnd(scalar, region));
  }
  return isthmus::JoinText(name, " ", LowerEnd(scalar, region), " to ", UpperEnd(scalar, region));
}

double Share(double area, double total)
{
  return total > 0.0 ? area / total : 0.0;
}

std::vector<double> AreasBetween(const SurfaceView& mesh, const ThresholdedScalar& scalar,
  std::vector<double> thresholds, AreaRule rule)
{
  // Without thresholds of its own, the second scalar is one region; it may be the first again.
  const ThresholdedScalar single{ scalar.Values, {} };
  return RegionAreas(mesh, { scalar.Values, std::move(thresholds) }, single, rule);
}

/// Rows for the regions of `first`; columns for those of `second`, called `secondName`, if it has
/// more than one. `areas` as RegionAreas gives them.
void FillRegionTable(vtkTable* table, const ThresholdedScalar& first,
  const ThresholdedScalar& second, const std::string& secondName, const std::vector<double>& areas)
{
  const std::size_t rows = first.Regions();
  const std::size_t columns = second.Regions();
  const auto rowArea = [&](std::size_t row)
  {
    const auto begin = areas.begin() + static_cast<std::ptrdiff_t>(row * columns);
    return std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(columns), 0.0);
  };
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  isthmus::AddComputedColumn<vtkIntArray>(
    table->GetRowData(), "Region", rows, [](std::size_t row) { return static_cast<int>(row); });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    table->GetRowData(), "From", rows, [&](std::size_t row) { return LowerEnd(first, row); });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    table->GetRowData(), "To", rows, [&](std::size_t row) { return UpperEnd(first, row); });
  isthmus::AddComputedColumn<vtkDoubleArray>(table->GetRowData(), "Area", rows, rowArea);
  isthmus::AddComputedColumn<vtkDoubleArray>(table->GetRowData(), "Fraction", rows,
    [&](std::size_t row) { return Share(rowArea(row), total); });
  for (std::size_t column = 0; columns > 1 && column < columns; ++column)
  {
    isthmus::AddComputedColumn<vtkDoubleArray>(table->GetRowData(),
      FormatName(second, secondName, column), rows,
      [&](std::size_t row) { return areas[row * columns + column]; });
  }
}

/// The lowest threshold moves to `target` in `steps` steps, then the highest does.
/// @throws std::invalid_argument unless `target` is between them.
void FillSweepTable(vtkTable* table, const SurfaceView& mesh, const ThresholdedScalar& scalar,
  double target, int steps, AreaRule rule)
{
  const bool between = scalar.Thresholds.size() > 1 && scalar.Thresholds.front() < target &&
    target < scalar.Thresholds.back();
  isthmus::RequireThat(between, "SweepTarget", target,
    "it must lie between the lowest and the highest threshold: choose thresholds on both sides of "
    "it, or set SweepSteps to 0");
  const double low = scalar.Thresholds.front();
  const double high = scalar.Thresholds.back();
  std::vector<double> minima, maxima;
  for (int i = 0; i <= 2 * steps; ++i)
  {
    // The last step is exactly the target, without rounding.
    const double down = std::min(i, steps) / static_cast<double>(steps);
    const double up = std::max(i - steps, 0) / static_cast<double>(steps);
    minima.push_back(i >= steps ? target : low + down * (target - low));
    maxima.push_back(i == 2 * steps ? target : high + up * (target - high));
  }
  std::vector<double> all(minima);
  all.insert(all.end(), maxima.begin(), maxima.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const std::vector<double> areas = AreasBetween(mesh, scalar, all, rule);

  // Region 0 is below all[0], region i is from all[i - 1] up.
  const auto sum = [&](double from, double to)
  {
    double area = 0.0;
    for (std::size_t region = 0; region < areas.size(); ++region)
    {
      const double start = region == 0 ? -Infinity : all[region - 1];
      area += start >= from && start < to ? areas[region] : 0.0;
    }
    return area;
  };
  const std::size_t rows = minima.size();
  isthmus::AddComputedColumn<vtkDoubleArray>(
    table->GetRowData(), "Minimum", rows, [&](std::size_t i) { return minima[i]; });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    table->GetRowData(), "Maximum", rows, [&](std::size_t i) { return maxima[i]; });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    table->GetRowData(), "Below", rows, [&](std::size_t i) { return sum(-Infinity, minima[i]); });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    table->GetRowData(), "Between", rows, [&](std::size_t i) { return sum(minima[i], maxima[i]); });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    table->GetRowData(), "Above", rows, [&](std::size_t i) { return sum(maxima[i], Infinity); });
}

/// Areas between `bins` + 1 values, equally spaced from the lowest to the highest on the surface.
void FillHistogram(vtkTable* table, const SurfaceView& mesh, const ThresholdedScalar& scalar,
  int bins, AreaRule rule)
{
  double low = Infinity;
  double high = -Infinity;
  for (const Triangle& corners : mesh.Triangles)
  {
    for (const vtkIdType point : corners)
    {
      const double value = scalar.Values[At(point)];
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (!(low < high))
  {
    bins = low == high ? 1 : 0; // a constant scalar, or an empty surface
  }
  const double width = bins > 1 ? (high - low) / bins : 0.0;
  std::vector<double> inner;
  for (int i = 1; i < bins; ++i)
  {
    inner.push_back(low + i * width);
  }
  const std::vector<double> areas = AreasBetween(mesh, scalar, inner, rule);
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  const auto rows = static_cast<std::size_t>(bins);
  const auto middle = [&](std::size_t i)
  { return bins > 1 ? low + (static_cast<double>(i) + 0.5) * width : 0.5 * (low + high); };
  isthmus::AddComputedColumn<vtkDoubleArray>(table->GetRowData(), "Value", rows, middle);
  isthmus::AddComputedColumn<vtkDoubleArray>(
    table->GetRowData(), "Area", rows, [&](std::size_t i) { return areas[i]; });
  isthmus::AddComputedColumn<vtkDoubleArray>(
    table->GetRowData(), "Fraction", rows, [&](std::size_t i) { return Share(areas[i], total); });
}

/// Regions of points, and those of cells: the median of the regions of a cell's corners.
struct Labels
{
  Labels(const ThresholdedScalar& scalar, vtkPolyData* surface, const char* name)
    : OnPoints(isthmus::NamedArray<vtkIntArray>(name, isthmus::At(surface->GetNumberOfPoints())))
    , OnCells(isthmus::NamedArray<vtkIntArray>(name, isthmus::At(surface->GetNumberOfCells())))
  {
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double value = scalar.Values[static_cast<std::size_t>(i)];
      this->OnPoints->SetValue(i, static_cast<int>(scalar.GetRegion(value)));
    }
    vtkNew<vtkIdList> corners;
    std::vector<int> regions;
    for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
    {
      surface->GetCellPoints(cell, corners);
      regions.clear();
      for (const vtkIdType corner : *corners)
      {
        regions.push_back(this->OnPoints->GetValue(corner));
      }
      const auto middle = regions.begin() + static_cast<std::ptrdiff_t>(regions.size()) / 2;
      std::nth_element(regions.begin(), middle, regions.end());
      this->OnCells->SetValue(cell, regions.empty() ? 0 : *middle);
    }
  }

  void AddTo(vtkPolyData* output) const
  {
    output->GetPointData()->AddArray(this->OnPoints);
    output->GetCellData()->AddArray(this->OnCells);
  }

  vtkNew<vtkIntArray> OnPoints;
  vtkNew<vtkIntArray> OnCells;
};

void AddJoint(
  vtkDataSetAttributes* attributes, vtkIntArray* first, vtkIntArray* second, std::size_t columns)
{
  auto* joint = isthmus::AddArray<vtkIntArray>(
    attributes, "JointRegion", isthmus::At(first->GetNumberOfValues()));
  for (vtkIdType i = 0; i < first->GetNumberOfValues(); ++i)
  {
    joint->SetValue(i, first->GetValue(i) * static_cast<int>(columns) + second->GetValue(i));
  }
}

void AddToonColors(vtkPolyData* output, vtkIntArray* regions, std::size_t count)
{
  static constexpr unsigned char red[3] = { 205, 40, 40 };
  static constexpr unsigned char grey[3] = { 190, 190, 190 };
  static constexpr unsigned char blue[3] = { 40, 70, 205 };
  auto* colors = isthmus::AddArray<vtkUnsignedCharArray>(
    output->GetPointData(), "ToonColor", isthmus::At(regions->GetNumberOfValues()), 3);
  for (vtkIdType i = 0; i < regions->GetNumberOfValues(); ++i)
  {
    const int region = regions->GetValue(i);
    const bool highest = count > 1 && region + 1 == static_cast<int>(count);
    colors->SetTypedTuple(i, region == 0 && count > 1 ? red : highest ? blue : grey);
  }
}

}

vtkScalarRegions::vtkScalarRegions()
{
  this->SetNumberOfOutputPorts(4);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  this->SetInputArrayToProcess(
    1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkScalarRegions::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

vtkTable* vtkScalarRegions::TableAt(int port)
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(port));
}

double vtkScalarRegions::At(const std::vector<double>& values, int index)
{
  const auto i = static_cast<std::size_t>(index);
  return index >= 0 && i < values.size() ? values[i] : 0.0;
}

void vtkScalarRegions::Put(std::vector<double>& values, int index, double value)
{
  if (index < 0)
  {
    vtkErrorMacro(<< isthmus::JoinText(
                    "There is no threshold ", index, ": they are counted from 0."));
    return;
  }
  const auto i = static_cast<std::size_t>(index);
  if (i >= values.size())
  {
    values.resize(i + 1, 0.0);
  }
  values[i] = value;
  this->Modified();
}

void vtkScalarRegions::Resize(std::vector<double>& values, int number)
{
  values.resize(static_cast<std::size_t>(std::max(number, 0)), 0.0);
  this->Modified();
}

void vtkScalarRegions::SetNumberOfThresholds(int number)
{
  this->Resize(this->Thresholds, number);
}

void vtkScalarRegions::SetThreshold(int index, double value)
{
  this->Put(this->Thresholds, index, value);
}

void vtkScalarRegions::SetNumberOfSecondThresholds(int number)
{
  this->Resize(this->SecondThresholds, number);
}

void vtkScalarRegions::SetSecondThreshold(int index, double value)
{
  this->Put(this->SecondThresholds, index, value);
}

int vtkScalarRegions::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      const auto input = isthmus::GatherSurface(this, vtkPolyData::GetData(inputVector[0], 0));
      output->ShallowCopy(input);
      if (input->GetNumberOfCells() > 0)
      {
        this->Compute(input, output);
      }
    });
}

ThresholdedScalar vtkScalarRegions::Scalar(int index, vtkPolyData* input, std::string& name)
{
  const std::string which = index == 0 ? "first" : "second";
  // A panel without data sends an empty name, which stands for the active scalars.
  const char* chosen = this->GetInputArrayInformation(index)->Get(vtkDataObject::FIELD_NAME());
  vtkDataArray* array = chosen && !*chosen ? input->GetPointData()->GetScalars()
                                           : this->GetInputArrayToProcess(index, input);
  if (!array)
  {
    throw std::invalid_argument("The surface has no array for the " + which +
      " scalar: choose one of its point arrays (active scalars by default).");
  }
  name = array->GetName() ? array->GetName() : which;
  if (array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    throw std::invalid_argument("The " + which + " scalar, " + name +
      ", does not have one number for each point: choose a point array of one component.");
  }
  ThresholdedScalar scalar;
  scalar.Thresholds = index == 0 ? this->Thresholds : this->SecondThresholds;
  scalar.Values.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    scalar.Values[static_cast<std::size_t>(i)] = array->GetComponent(i, 0);
  }
  return scalar;
}

void vtkScalarRegions::Compute(vtkPolyData* input, vtkPolyData* output)
{
  isthmus::RequireRange("SweepSteps", this->SweepSteps, 0, 1000);
  isthmus::RequireRange("HistogramBins", this->HistogramBins, 1, 10000);
  std::string name, secondName;
  const ThresholdedScalar first = this->Scalar(0, input, name);
  const ThresholdedScalar second = this->UseSecondScalar ? this->Scalar(1, input, secondName)
                                                         : ThresholdedScalar{ first.Values, {} };
  const auto rule = static_cast<isthmus::AreaRule>(this->AreaRule);
  const isthmus::PolyDataTriangles triangles(input);
  const isthmus::SurfaceView mesh = triangles.View();
  const std::vector<double> areas = isthmus::RegionAreas(
    mesh, first, second, rule, isthmus::Between(isthmus::MakeProgress(this), 0.1, 0.5));
  FillRegionTable(this->TableAt(1), first, second, secondName, areas);
  if (this->SweepSteps > 0)
  {
    FillSweepTable(this->TableAt(2), mesh, first, this->SweepTarget, this->SweepSteps, rule);
  }
  FillHistogram(this->TableAt(3), mesh, first, this->HistogramBins, rule);
  isthmus::Report(isthmus::MakeProgress(this), 0.8);

  output->BuildCells();
  const Labels labels(first, output, "Region");
  labels.AddTo(output);
  output->GetPointData()->SetActiveScalars("Region");
  AddToonColors(output, labels.OnPoints, first.Regions());
  if (this->UseSecondScalar)
  {
    const Labels others(second, output, "SecondRegion");
    others.AddTo(output);
    AddJoint(output->GetPointData(), labels.OnPoints, others.OnPoints, second.Regions());
    AddJoint(output->GetCellData(), labels.OnCells, others.OnCells, second.Regions());
  }
}

void vtkScalarRegions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto list = [&](const char* name, const std::vector<double>& values)
  {
    os << indent << name << ":";
    for (const double value : values)
    {
      os << " " << value;
    }
    os << "\n";
  };
  list("Thresholds", this->Thresholds);
  list("SecondThresholds", this->SecondThresholds);
  os << indent << "UseSecondScalar: " << this->UseSecondScalar << "\n";
  os << indent << "AreaRule: " << this->AreaRule << "\n";
  os << indent << "SweepSteps: " << this->SweepSteps << "\n";
  os << indent << "SweepTarget: " << this->SweepTarget << "\n";
  os << indent << "HistogramBins: " << this->HistogramBins << "\n";
}
