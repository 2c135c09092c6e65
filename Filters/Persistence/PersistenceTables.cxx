#include "Persistence/PersistenceTables.h"

#include "Core/ArrayMemory.h"
#include "Core/NamedColumns.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <cmath>
#include <string>

namespace isthmus
{
namespace
{

/// The properties of features, as arrays with one tuple for each.
class FeatureColumns
{
public:
  FeatureColumns(vtkDataSetAttributes* data, std::size_t count, double end)
    : End(end)
    , Id(AddArray<vtkIdTypeArray>(data, "FeatureId", count))
    , Dimension(AddArray<vtkIntArray>(data, "Dimension", count))
    , Birth(AddArray<vtkDoubleArray>(data, "Birth", count))
    , Death(AddArray<vtkDoubleArray>(data, "Death", count))
    , Persistence(AddArray<vtkDoubleArray>(data, "Persistence", count))
    , DeathShown(AddArray<vtkDoubleArray>(data, "DeathShown", count))
    , Joins(AddArray<vtkIdTypeArray>(data, "Joins", count))
  {
  }

  void Set(vtkIdType at, const FeatureList& features, std::size_t i)
  {
    const ScalarFeature& feature = features.Features[i];
    this->Id->SetValue(at, static_cast<vtkIdType>(i));
    this->Dimension->SetValue(at, feature.Pair.Dimension);
    this->Birth->SetValue(at, feature.Birth);
    this->Death->SetValue(at, feature.Death);
    this->Persistence->SetValue(at, feature.Persistence);
    this->DeathShown->SetValue(at,
      feature.Pair.Death.Node() < 0 || !std::isfinite(feature.Death) ? this->End : feature.Death);
    this->Joins->SetValue(at, static_cast<vtkIdType>(feature.Joined));
  }

private:
  double End;
  vtkIdTypeArray* Id;
  vtkIntArray* Dimension;
  vtkDoubleArray* Birth;
  vtkDoubleArray* Death;
  vtkDoubleArray* Persistence;
  vtkDoubleArray* DeathShown;
  vtkIdTypeArray* Joins;
};

int GetDimension(const CubicalCell& cell)
{
  return (cell.Step(0) != 0) + (cell.Step(1) != 0) + (cell.Step(2) != 0);
}

std::array<double, 3> GetPosition(vtkImageData* image, std::int64_t node)
{
  std::array<double, 3> place;
  image->GetPoint(static_cast<vtkIdType>(node), place.data());
  return place;
}

}

void FillCurves(
  const BettiCurves& curves, const std::vector<std::int64_t>& eulerNumbers, vtkTable* table)
{
  AddColumn<vtkDoubleArray>(table->GetRowData(), "Level", curves.Levels);
  for (std::size_t d = 0; d < 3; ++d)
  {
    AddColumn<vtkIdTypeArray>(table->GetRowData(), "Beta" + std::to_string(d), curves.All[d]);
  }
  for (std::size_t d = 0; d < 3; ++d)
  {
    AddColumn<vtkIdTypeArray>(
      table->GetRowData(), "FilteredBeta" + std::to_string(d), curves.Filtered[d]);
  }
  AddColumn<vtkIdTypeArray>(table->GetRowData(), "EulerNumber", eulerNumbers);
  for (std::size_t d = 0; d < 3; ++d)
  {
    AddColumn<vtkDoubleArray>(
      table->GetRowData(), "IntegralBeta" + std::to_string(d), curves.Integral[d]);
  }
  for (std::size_t d = 0; d < 3; ++d)
  {
    AddColumn<vtkDoubleArray>(
      table->GetRowData(), "IntegralFilteredBeta" + std::to_string(d), curves.FilteredIntegral[d]);
  }
}

void FillDiagram(const FeatureList& features, double end, vtkTable* table)
{
  FeatureColumns columns(table->GetRowData(), features.Kept, end);
  for (std::size_t i = 0; i < features.Kept; ++i)
  {
    columns.Set(static_cast<vtkIdType>(i), features, i);
  }
}

void FillSaddles(const FeatureList& features, double end, vtkImageData* image,
  const VolumeView& volume, vtkPolyData* points)
{
  // The saddle first: where a component ends, a tunnel or a cavity begins.
  std::vector<std::pair<std::size_t, CubicalCell>> ends;
  for (int round = 0; round < 2; ++round)
  {
    for (std::size_t i = 0; i < features.Kept; ++i)
    {
      const CubicalPair& pair = features.Features[i].Pair;
      const bool isDeath = (pair.Dimension == 0) == (round == 0);
      if (pair.Death.Node() >= 0)
      {
        ends.emplace_back(i, isDeath ? pair.Death : pair.Birth);
      }
      else if (round == 0)
      {
        ends.emplace_back(i, pair.Birth);
      }
    }
  }
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  SizePoints(places, static_cast<vtkIdType>(ends.size()));
  vtkNew<vtkCellArray> vertices;
  FeatureColumns columns(points->GetPointData(), ends.size(), end);
  auto* value = AddArray<vtkDoubleArray>(points->GetPointData(), "Value", ends.size());
  auto* index = AddArray<vtkIntArray>(points->GetPointData(), "CriticalIndex", ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const auto at = static_cast<vtkIdType>(i);
    places->SetPoint(at, GetPosition(image, ends[i].second.Node()).data());
    vertices->InsertNextCell(1, &at);
    columns.Set(at, features, ends[i].first);
    value->SetValue(at, volume.Value(ends[i].second.Node()));
    index->SetValue(at, GetDimension(ends[i].second));
  }
  points->SetPoints(places);
  points->SetVerts(vertices);
  points->GetPointData()->SetActiveScalars("CriticalIndex");
}

void FillCycles(const FeatureList& features, const std::vector<CubicalCycle>& cycles,
  vtkImageData* image, vtkPolyData* lines)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkCellArray> loops;
  FeatureColumns columns(
    lines->GetCellData(), cycles.size(), std::numeric_limits<double>::infinity());
  auto* length = AddArray<vtkDoubleArray>(lines->GetCellData(), "Length", cycles.size());
  for (std::size_t i = 0; i < cycles.size(); ++i)
  {
    const auto first = places->GetNumberOfPoints();
    loops->InsertNextCell(static_cast<int>(cycles[i].Nodes.size() + 1));
    for (const std::int64_t node : cycles[i].Nodes)
    {
      loops->InsertCellPoint(places->InsertNextPoint(GetPosition(image, node).data()));
    }
    loops->InsertCellPoint(first);
    const auto at = static_cast<vtkIdType>(i);
    columns.Set(at, features, static_cast<std::size_t>(cycles[i].Feature));
    length->SetValue(at, cycles[i].Length);
  }
  lines->SetPoints(places);
  lines->SetLines(loops);
  lines->GetCellData()->SetActiveScalars("FeatureId");
}

}
