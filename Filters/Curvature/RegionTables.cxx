#include "Curvature/RegionTables.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkTable.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

template <typename Array, typename Get>
void AddColumn(vtkTable* table, const std::string& name, std::size_t rows, Get&& get)
{
  vtkNew<Array> column;
  column->SetName(name.c_str());
  for (std::size_t row = 0; row < rows; ++row)
  {
    column->InsertNextValue(get(row));
  }
  table->AddColumn(column);
}

double LowerEnd(const ThresholdedScalar& scalar, std::size_t region)
{
  return region == 0 ? -Infinity : scalar.Thresholds[region - 1];
}

double UpperEnd(const ThresholdedScalar& scalar, std::size_t region)
{
  return region + 1 == scalar.Regions() ? Infinity : scalar.Thresholds[region];
}

std::string NameOf(const ThresholdedScalar& scalar, const std::string& name, std::size_t region)
{
  std::ostringstream text;
  text << name;
  if (region == 0)
  {
    text << " below " << UpperEnd(scalar, region);
  }
  else if (region + 1 == scalar.Regions())
  {
    text << " from " << LowerEnd(scalar, region);
  }
  else
  {
    text << " " << LowerEnd(scalar, region) << " to " << UpperEnd(scalar, region);
  }
  return text.str();
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

}

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
  AddColumn<vtkIntArray>(
    table, "Region", rows, [](std::size_t row) { return static_cast<int>(row); });
  AddColumn<vtkDoubleArray>(
    table, "From", rows, [&](std::size_t row) { return LowerEnd(first, row); });
  AddColumn<vtkDoubleArray>(
    table, "To", rows, [&](std::size_t row) { return UpperEnd(first, row); });
  AddColumn<vtkDoubleArray>(table, "Area", rows, rowArea);
  AddColumn<vtkDoubleArray>(
    table, "Fraction", rows, [&](std::size_t row) { return Share(rowArea(row), total); });
  for (std::size_t column = 0; columns > 1 && column < columns; ++column)
  {
    AddColumn<vtkDoubleArray>(table, NameOf(second, secondName, column), rows,
      [&](std::size_t row) { return areas[row * columns + column]; });
  }
}

void FillSweepTable(vtkTable* table, const SurfaceView& mesh, const ThresholdedScalar& scalar,
  double target, int steps, AreaRule rule)
{
  const bool between = scalar.Thresholds.size() > 1 && scalar.Thresholds.front() < target &&
    target < scalar.Thresholds.back();
  if (!between)
  {
    throw std::invalid_argument("SweepTarget is " + std::to_string(target) +
      ", but the sweep needs it between a lowest and a highest threshold: give thresholds on both "
      "sides of it, or set SweepSteps to 0.");
  }
  const double low = scalar.Thresholds.front();
  const double high = scalar.Thresholds.back();
  std::vector<double> minima, maxima;
  for (int i = 0; i <= 2 * steps; ++i)
  {
    // The last step is the target itself, not what rounding makes of it.
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
  AddColumn<vtkDoubleArray>(table, "Minimum", rows, [&](std::size_t i) { return minima[i]; });
  AddColumn<vtkDoubleArray>(table, "Maximum", rows, [&](std::size_t i) { return maxima[i]; });
  AddColumn<vtkDoubleArray>(
    table, "Below", rows, [&](std::size_t i) { return sum(-Infinity, minima[i]); });
  AddColumn<vtkDoubleArray>(
    table, "Between", rows, [&](std::size_t i) { return sum(minima[i], maxima[i]); });
  AddColumn<vtkDoubleArray>(
    table, "Above", rows, [&](std::size_t i) { return sum(maxima[i], Infinity); });
}

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
    bins = low == high ? 1 : 0; // a constant, or no surface
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
  AddColumn<vtkDoubleArray>(table, "Value", rows, middle);
  AddColumn<vtkDoubleArray>(table, "Area", rows, [&](std::size_t i) { return areas[i]; });
  AddColumn<vtkDoubleArray>(
    table, "Fraction", rows, [&](std::size_t i) { return Share(areas[i], total); });
}

}
