#include "ChokingLoops/ChokingLoopsOutput.h"

#include "ChokingLoops/LoopDrawing.h"
#include "Core/Geometry.h"
#include "Core/NamedColumns.h"
#include "Surfaces/TriangleTree.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// SharedLoops
namespace
{

constexpr double SimilarLength = 0.02; ///< relative
constexpr double SamePlace = 0.1;      ///< in radii
constexpr double NearMembrane = 0.3;   ///< in radii

using Polygon = std::vector<Point3>;

/// A feature's loops as polygons, with a quick test that two of them differ.
struct Outline
{
  SpaceSide Side;
  double Radius;
  double Length;
  Bounds3 Box;
  std::vector<Polygon> Loops;
};

Outline MakeOutline(const ChokingLoops& loops, const ShownFeature& shown)
{
  const ShapeFeature& f = loops.Diagram().Features[shown.Index];
  const LoopFeature& geometry = *shown.Geometry;
  Outline outline{ f.Side, f.Radius(),
    std::accumulate(geometry.Lengths.begin(), geometry.Lengths.end(), 0.0), {}, {} };
  for (const auto& loop : geometry.Loops)
  {
    outline.Loops.emplace_back();
    for (const SimplexId p : loop)
    {
      const Point3& place = geometry.Point(p, loops.Samples());
      outline.Loops.back().push_back(place);
      outline.Box.Min = outline.Box.Max = place;
    }
  }
  for (const Polygon& polygon : outline.Loops)
  {
    std::for_each(
      polygon.begin(), polygon.end(), [&](const Point3& place) { outline.Box.Add(place); });
  }
  return outline;
}

/// True when each point of `a` is within `reach` of some loop of `b`.
bool LiesAlong(const Outline& a, const Outline& b, double reach)
{
  const auto isNear = [&](const Point3& p)
  {
    return std::any_of(b.Loops.begin(), b.Loops.end(),
      [&](const Polygon& loop)
      {
        for (std::size_t i = 0; i < loop.size(); ++i)
        {
          if (SquaredDistanceToSegment(p, loop[i], loop[(i + 1) % loop.size()]) <= reach * reach)
          {
            return true;
          }
        }
        return false;
      });
  };
  return std::all_of(a.Loops.begin(), a.Loops.end(),
    [&](const Polygon& loop) { return std::all_of(loop.begin(), loop.end(), isNear); });
}

bool Coincide(const Outline& a, const Outline& b)
{
  const double reach = SamePlace * std::min(a.Radius, b.Radius);
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (std::abs(a.Box.Min[k] - b.Box.Min[k]) > reach ||
      std::abs(a.Box.Max[k] - b.Box.Max[k]) > reach)
    {
      return false;
    }
  }
  return a.Side == b.Side && a.Loops.size() == b.Loops.size() &&
    std::abs(a.Length - b.Length) <= SimilarLength * std::max(a.Length, b.Length) &&
    LiesAlong(a, b, reach) && LiesAlong(b, a, reach);
}

/// True when some triangle of the membrane is within this distance.
bool PassesNear(
  const ChokingLoops& loops, const LoopFeature& geometry, const Point3& center, double reach)
{
  return std::any_of(geometry.Membrane.begin(), geometry.Membrane.end(),
    [&](const auto& t)
    {
      std::vector<Point3> corners;
      corners.reserve(t.size());
      for (const SimplexId p : t)
      {
        corners.push_back(geometry.Point(p, loops.Samples()));
      }
      return IsSurrounded(center, reach, corners);
    });
}

/// The feature whose loop `borrower` can share if the surface has no loop of its own for it, or
/// null. With an encircling loop it shares only that of an earlier feature, if that is not longer.
const ShownFeature* LoopsFor(const ChokingLoops& loops, const std::vector<ShownFeature>& features,
  const std::vector<char>& isFree, const ShownFeature& borrower)
{
  const bool isEncircled = !borrower.Geometry->Held && !borrower.Geometry->Collapsed;
  const auto end =
    isEncircled ? static_cast<std::size_t>(&borrower - features.data()) : features.size();
  const double longest =
    isEncircled ? (1.0 + SimilarLength) * borrower.Geometry->LongestLength() : HUGE_VAL;
  const auto& all = loops.Diagram().Features;
  const ShapeFeature& f = all[borrower.Index];
  const Point3 center = loops.ChokePoint(borrower.Index);
  const ShownFeature* best = nullptr;
  for (std::size_t i = 0; i < end; ++i)
  {
    const LoopFeature& other = *features[i].Geometry;
    if (!isFree[i] && features[i].SharedWith < 0 && other.LongestLength() <= longest &&
      all[features[i].Index].Side == f.Side &&
      (!best || other.LongestLength() < best->Geometry->LongestLength()) &&
      BelongsToChokePoint(loops, borrower.Index, other) &&
      PassesNear(loops, other, center, NearMembrane * f.Radius()))
    {
      best = &features[i];
    }
  }
  return best;
}

}

void FindShared(const ChokingLoops& loops, std::vector<ShownFeature>& features)
{
  std::vector<char> isFree; // the surface has no loop of its own for it
  isFree.reserve(features.size());
  for (const ShownFeature& shown : features)
  {
    isFree.push_back(shown.Geometry->Held || shown.Geometry->Collapsed);
  }
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    const ShownFeature* other = isFree[i] || features[i].Geometry->Encircling
      ? LoopsFor(loops, features, isFree, features[i])
      : nullptr;
    if (other)
    {
      features[i].SharedWith = static_cast<std::ptrdiff_t>(other->Index);
      features[i].Geometry = other->Geometry;
    }
  }
  std::vector<Outline> outlines;
  for (ShownFeature& shown : features)
  {
    outlines.push_back(MakeOutline(loops, shown));
    for (std::size_t i = 0; i + 1 < outlines.size() && !outlines.back().Loops.empty(); ++i)
    {
      if (shown.SharedWith < 0 && features[i].SharedWith < 0 &&
        Coincide(outlines[i], outlines.back()))
      {
        shown.SharedWith = static_cast<std::ptrdiff_t>(features[i].Index);
        shown.Geometry = features[i].Geometry;
      }
    }
  }
}

// ------------------------------------------------------------------------------------------
// LoopLimits
namespace
{

double LongestLoopLength(const ShownFeature& feature)
{
  const std::vector<double>& lengths = feature.Geometry->Lengths;
  return lengths.empty() ? 0.0 : *std::max_element(lengths.begin(), lengths.end());
}

}

double ComputeReach(const ChokingLoops& loops, const ShownFeature& feature)
{
  const Point3 center = loops.ChokePoint(feature.Index);
  double farthest = 0.0;
  for (const std::vector<SimplexId>& loop : feature.Geometry->Loops)
  {
    for (const SimplexId p : loop)
    {
      farthest = std::max(farthest, Distance(center, feature.Geometry->Point(p, loops.Samples())));
    }
  }
  const double radius = loops.Diagram().Features[feature.Index].Radius();
  return radius > 0.0 ? farthest / radius : 0.0;
}

void ApplyLimits(
  const ChokingLoops& loops, const LoopLimits& limits, std::vector<ShownFeature>& features)
{
  Check(limits);
  const auto isBeyond = [&](const ShownFeature& feature)
  {
    return (limits.MaximumLength > 0.0 && LongestLoopLength(feature) > limits.MaximumLength) ||
      (limits.MaximumReach > 0.0 && ComputeReach(loops, feature) > limits.MaximumReach);
  };
  const auto end = std::remove_if(features.begin(), features.end(), isBeyond);
  if (end != features.end())
  {
    features.erase(end, features.end());
    std::map<const LoopFeature*, std::size_t> first;
    for (ShownFeature& feature : features)
    {
      const auto [known, isFirst] = first.emplace(feature.Geometry, feature.Index);
      feature.SharedWith = isFirst ? -1 : static_cast<std::ptrdiff_t>(known->second);
    }
  }
  if (limits.LoopOrder == LoopOrder::ByLength)
  {
    std::stable_sort(features.begin(), features.end(),
      [](const ShownFeature& a, const ShownFeature& b)
      { return LongestLoopLength(a) < LongestLoopLength(b); });
  }
}

// ------------------------------------------------------------------------------------------
// ChokingLoopsOutput
namespace
{

const char* GetKindName(FeatureKind kind)
{
  switch (kind)
  {
    case FeatureKind::Handle:
      return "handle";
    case FeatureKind::Tunnel:
      return "tunnel";
    case FeatureKind::Additional:
      return "additional";
    default:
      return "noise";
  }
}

/// A cell or point of an output, and the feature it belongs to.
struct FeatureRow
{
  const ShownFeature* Shown;
  const ShapeFeature* Feature;
  double Reach = 0.0;
  std::size_t Loop = 0; ///< of the feature
};
using FeatureRows = std::vector<FeatureRow>;
using Row = const FeatureRow&;

/// Attributes that loops, membranes and choke points have.
void AddCommonColumns(vtkFieldData* data, const FeatureRows& rows)
{
  AddComputedColumn<vtkIntArray>(data, "FeatureId", rows, [](Row row) { return row.Shown->Index; });
  AddComputedColumn<vtkIntArray>(
    data, "Kind", rows, [](Row row) { return static_cast<int>(row.Feature->Kind); });
  AddComputedColumn<vtkDoubleArray>(
    data, "Radius", rows, [](Row row) { return row.Feature->Radius(); });
  AddComputedColumn<vtkDoubleArray>(
    data, "Birth", rows, [](Row row) { return row.Feature->Birth(); });
  AddComputedColumn<vtkDoubleArray>(
    data, "Death", rows, [](Row row) { return row.Feature->Death; });
  AddComputedColumn<vtkDoubleArray>(
    data, "Persistence", rows, [](Row row) { return row.Feature->Persistence(); });
}

void AddSide(vtkFieldData* data, const FeatureRows& rows)
{
  AddComputedColumn<vtkIntArray>(
    data, "Side", rows, [](Row row) { return static_cast<int>(row.Feature->Side); });
}

/// Points of a feature in an output, each inserted once.
class PointMap
{
public:
  PointMap(const LoopFeature& geometry, const SurfaceView& samples, vtkPoints* points)
    : Geometry(geometry)
    , Samples(samples)
    , Points(points)
  {
  }

  vtkIdType Of(SimplexId id)
  {
    const auto known = this->Ids.find(id);
    if (known != this->Ids.end())
    {
      return known->second;
    }
    return this->Ids[id] =
             this->Points->InsertNextPoint(this->Geometry.Point(id, this->Samples).data());
  }

private:
  const LoopFeature& Geometry;
  SurfaceView Samples;
  vtkPoints* Points;
  std::map<SimplexId, vtkIdType> Ids;
};

vtkSmartPointer<vtkPoints> DoublePoints()
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  return points;
}

/// The cells of one feature's loops.
using Cells = std::vector<std::vector<vtkIdType>>;

Cells InsertLoops(const ShownFeature& shown, const SurfaceView& samples, vtkPoints* points)
{
  PointMap map(*shown.Geometry, samples, points);
  Cells cells;
  for (const auto& loop : shown.Geometry->Loops)
  {
    cells.emplace_back();
    for (std::size_t i = 0; i <= loop.size(); ++i)
    {
      cells.back().push_back(map.Of(loop[i % loop.size()]));
    }
  }
  return cells;
}

}

void FillLoops(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output)
{
  const vtkSmartPointer<vtkPoints> points = DoublePoints();
  vtkNew<vtkCellArray> lines;
  FeatureRows rows;
  std::map<const LoopFeature*, Cells> drawn;
  for (const ShownFeature& shown : features)
  {
    const ShapeFeature& f = loops.Diagram().Features[shown.Index];
    const auto [known, isNew] = drawn.emplace(shown.Geometry, Cells{});
    if (isNew)
    {
      known->second = InsertLoops(shown, loops.Samples(), points);
    }
    const Cells& cells = known->second;
    const double reach = ComputeReach(loops, shown);
    for (std::size_t k = 0; k < cells.size(); ++k)
    {
      lines->InsertNextCell(static_cast<vtkIdType>(cells[k].size()), cells[k].data());
      rows.push_back({ &shown, &f, reach, k });
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  vtkFieldData* const data = output->GetCellData();
  AddCommonColumns(data, rows);
  AddSide(data, rows);
  AddComputedColumn<vtkStringArray>(
    data, "KindName", rows, [](Row row) { return GetKindName(row.Feature->Kind); });
  AddComputedColumn<vtkIntArray>(
    data, "Trusted", rows, [](Row row) { return row.Feature->Trusted; });
  AddComputedColumn<vtkIntArray>(
    data, "SharedWith", rows, [](Row row) { return row.Shown->SharedWith; });
  AddComputedColumn<vtkIntArray>(data, "Component", rows,
    [&](Row row) { return loops.Homology().GetComponent(row.Shown->Geometry->Anchors[row.Loop]); });
  AddComputedColumn<vtkDoubleArray>(
    data, "Uncertainty", rows, [](Row row) { return ComputeUncertainty(*row.Feature); });
  AddComputedColumn<vtkDoubleArray>(
    data, "Length", rows, [](Row row) { return row.Shown->Geometry->Lengths[row.Loop]; });
  AddComputedColumn<vtkDoubleArray>(data, "Reach", rows, [](Row row) { return row.Reach; });
  output->GetCellData()->SetActiveScalars("Radius");
}

void FillMembranes(const ChokingLoops& loops, const std::vector<ShownFeature>& features,
  MembraneMethod method, vtkPolyData* output)
{
  const vtkSmartPointer<vtkPoints> points = DoublePoints();
  vtkNew<vtkCellArray> triangles;
  FeatureRows rows;
  for (const ShownFeature& shown : features)
  {
    const ShapeFeature& f = loops.Diagram().Features[shown.Index];
    PointMap map(*shown.Geometry, loops.Samples(), points);
    for (const auto& t : shown.Geometry->Membrane)
    {
      triangles->InsertNextCell({ map.Of(t[0]), map.Of(t[1]), map.Of(t[2]) });
      rows.push_back({ &shown, &f });
    }
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  vtkFieldData* const data = output->GetCellData();
  AddCommonColumns(data, rows);
  AddComputedColumn<vtkDoubleArray>(
    data, "Area", rows, [](Row row) { return row.Shown->Geometry->Area; });
  if (method != MembraneMethod::Automatic)
  {
    AddComputedColumn<vtkIntArray>(
      data, "Method", rows, [](Row row) { return static_cast<int>(row.Shown->Geometry->Method); });
  }
  if (method == MembraneMethod::Greedy)
  {
    AddComputedColumn<vtkDoubleArray>(
      data, "GrowthCost", rows, [](Row row) { return row.Shown->Geometry->GrowthCost; });
  }
}

void FillChokePoints(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output)
{
  const vtkSmartPointer<vtkPoints> points = DoublePoints();
  vtkNew<vtkCellArray> vertices;
  FeatureRows rows;
  for (const ShownFeature& shown : features)
  {
    const ShapeFeature& f = loops.Diagram().Features[shown.Index];
    vertices->InsertNextCell({ points->InsertNextPoint(loops.ChokePoint(shown.Index).data()) });
    rows.push_back({ &shown, &f });
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  AddCommonColumns(output->GetPointData(), rows);
  AddSide(output->GetPointData(), rows);
  output->GetPointData()->SetActiveScalars("Radius");
}

void FillDiagram(const ChokingLoops& loops, vtkTable* output)
{
  using Feature = const ShapeFeature&;
  const std::vector<ShapeFeature>& features = loops.Diagram().Features;
  vtkFieldData* const data = output->GetRowData();
  AddComputedColumn<vtkIntArray>(
    data, "FeatureId", features.size(), [](std::size_t row) { return row; });
  AddComputedColumn<vtkIntArray>(
    data, "Dimension", features, [](Feature f) { return f.Dimension; });
  AddComputedColumn<vtkIntArray>(
    data, "Side", features, [](Feature f) { return static_cast<int>(f.Side); });
  AddComputedColumn<vtkIntArray>(
    data, "Kind", features, [](Feature f) { return static_cast<int>(f.Kind); });
  AddComputedColumn<vtkDoubleArray>(data, "Birth", features, [](Feature f) { return f.PairBirth; });
  AddComputedColumn<vtkDoubleArray>(data, "Death", features, [](Feature f) { return f.PairDeath; });
  AddComputedColumn<vtkDoubleArray>(
    data, "Persistence", features, [](Feature f) { return f.PairDeath - f.PairBirth; });
  AddComputedColumn<vtkDoubleArray>(data, "Radius", features, [](Feature f) { return f.Radius(); });
}

void AddAnalysisFieldData(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output)
{
  std::array<vtkIdType, 4> shown{ 0, 0, 0, 0 }; // handles, tunnels, additional inside and outside
  for (const ShownFeature& s : features)
  {
    const ShapeFeature& f = loops.Diagram().Features[s.Index];
    const auto kind = static_cast<std::size_t>(f.Kind);
    ++shown[kind < 2 ? kind : 2 + static_cast<std::size_t>(f.Side)];
  }
  vtkFieldData* const data = output->GetFieldData();
  AddColumn<vtkIdTypeArray>(data, "NumberOfSamples", { loops.Samples().Points.size() });
  AddColumn<vtkIdTypeArray>(data, "NumberOfHandles", { shown[0] });
  AddColumn<vtkIdTypeArray>(data, "NumberOfTunnels", { shown[1] });
  AddColumn<vtkIdTypeArray>(data, "NumberOfAdditionalLoops", { shown[2], shown[3] });
  AddColumn<vtkDoubleArray>(data, "LargestSamplingError", { loops.LargestError() });
  AddColumn<vtkDoubleArray>(data, "ReferenceLength", loops.Diagram().Reference);
  auto* threshold = AddArray<vtkDoubleArray>(data, "ProposedThreshold", 2, 2);
  threshold->SetComponentName(0, "Threshold");
  threshold->SetComponentName(1, "Width");
  for (const SpaceSide side : { SpaceSide::Inside, SpaceSide::Outside })
  {
    const PersistenceGap gap = LargestGap(loops.Diagram(), side);
    threshold->SetTuple2(side == SpaceSide::Inside ? 0 : 1, gap.Threshold, gap.Width);
  }
  const RepairReport& repairs = loops.Repairs();
  if (!repairs.Message.empty())
  {
    AddColumn<vtkIdTypeArray>(data, "Repaired", { repairs.Changed });
    auto* places = AddArray<vtkDoubleArray>(data, "RepairedPlaces", repairs.Places.size(), 3);
    for (std::size_t i = 0; i < repairs.Places.size(); ++i)
    {
      places->SetTuple(static_cast<vtkIdType>(i), repairs.Places[i].data());
    }
  }
}

}
