#include "ChokingLoops/HandleTables.h"

#include "Persistence/NamedColumns.h"

#include <vtkCellArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace isthmus
{
namespace
{

/// Beta1 in the row whose level is nearest to `level`, not a number elsewhere: one mark in a chart.
std::vector<double> Mark(const BettiCurves& curves, double level)
{
  std::vector<double> marks(curves.Levels.size(), std::numeric_limits<double>::quiet_NaN());
  if (!std::isnan(level))
  {
    const auto nearest = std::min_element(curves.Levels.begin(), curves.Levels.end(),
      [level](double a, double b) { return std::abs(a - level) < std::abs(b - level); });
    const auto row = static_cast<std::size_t>(nearest - curves.Levels.begin());
    marks[row] = static_cast<double>(curves.Filtered[1][row]);
  }
  return marks;
}

}

void FillHandles(const std::vector<MapHandle>& handles, bool bridges, const FeatureList& features,
  vtkImageData* image, double level, vtkPolyData* output)
{
  std::vector<MapHandle> wanted;
  std::copy_if(handles.begin(), handles.end(), std::back_inserter(wanted),
    [bridges](const MapHandle& handle) { return handle.IsBridge == bridges; });
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const MapHandle& handle : wanted)
  {
    double place[3];
    image->GetPoint(static_cast<vtkIdType>(handle.Node), place);
    const vtkIdType at = points->InsertNextPoint(place);
    vertices->InsertNextCell(1, &at);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  vtkPointData* data = output->GetPointData();
  const auto featureOf = [&features](const MapHandle& handle) -> const ScalarFeature&
  { return features.Features[static_cast<std::size_t>(handle.Feature)]; };
  AddColumnOf<vtkIdTypeArray>(data, "FeatureId", wanted,
    [](const MapHandle& handle) { return static_cast<vtkIdType>(handle.Feature); });
  AddColumnOf<vtkIntArray>(data, "Dimension", wanted,
    [&](const MapHandle& handle) { return featureOf(handle).Pair.Dimension; });
  const auto add = [&](const char* name, const auto& of)
  { AddColumnOf<vtkDoubleArray>(data, name, wanted, of); };
  add("Birth", [&](const MapHandle& handle) { return featureOf(handle).Birth; });
  add("Death", [&](const MapHandle& handle) { return featureOf(handle).Death; });
  add("Persistence", [&](const MapHandle& handle) { return featureOf(handle).Persistence; });
  add("Level", [](const MapHandle& handle) { return handle.Level; });
  add("From", [](const MapHandle& handle) { return handle.Interval[0]; });
  add("To", [](const MapHandle& handle) { return handle.Interval[1]; });
  AddColumnOf<vtkIntArray>(data, "IsThere", wanted,
    [level](const MapHandle& handle)
    { return handle.Interval[0] <= level && level <= handle.Interval[1] ? 1 : 0; });
  data->SetActiveScalars("Level");
}

void FillLevels(const BettiCurves& curves, double stable, double recommended, vtkTable* table)
{
  vtkDataSetAttributes* rows = table->GetRowData();
  AddColumn<vtkDoubleArray>(rows, "Level", curves.Levels);
  for (std::size_t d = 0; d < 3; ++d)
  {
    AddColumn<vtkIdTypeArray>(rows, "Beta" + std::to_string(d), curves.Filtered[d]);
  }
  AddColumn<vtkDoubleArray>(rows, "StableLevel", Mark(curves, stable));
  AddColumn<vtkDoubleArray>(rows, "RecommendedLevel", Mark(curves, recommended));
}

void FillIntervals(const std::vector<StableInterval>& intervals, vtkTable* table)
{
  vtkDataSetAttributes* rows = table->GetRowData();
  const auto add = [&](const char* name, const auto& of)
  { AddColumnOf<vtkDoubleArray>(rows, name, intervals, of); };
  add("From", [](const StableInterval& interval) { return interval.Low; });
  add("To", [](const StableInterval& interval) { return interval.High; });
  add("Middle", [](const StableInterval& interval) { return interval.Middle(); });
  add("Length", [](const StableInterval& interval) { return interval.High - interval.Low; });
  for (std::size_t d = 0; d < 3; ++d)
  {
    AddColumnOf<vtkIdTypeArray>(rows, "Beta" + std::to_string(d), intervals,
      [d](const StableInterval& interval) { return interval.Betti[d]; });
  }
}

}
