#include "Surfaces/SurfaceMeasures.h"

#include "Core/DisjointSets.h"
#include "Core/ParallelFor.h"
#include "Surfaces/ChordError.h"
#include "Surfaces/TriangleStars.h"

#include <Eigen/Dense>

#include <algorithm>
#include <limits>

namespace isthmus
{
namespace
{

using Eigen::Vector3d;
using PointMap = Eigen::Map<const Vector3d>;

/// The edges from a point to points of higher id.
struct EdgeCount
{
  vtkIdType Edges = 0;
  vtkIdType Open = 0;
};

/// Calls `visit(neighbour, leaving, entering)` for each neighbour of `point` with a higher id:
/// how many triangles run along the edge away from `point`, and how many towards it.
template <typename Visit>
void ForEachHigherNeighbour(vtkIdType point,
  const std::vector<std::pair<vtkIdType, vtkIdType>>& link,
  std::vector<std::pair<vtkIdType, int>>& uses, Visit&& visit)
{
  uses.clear();
  for (const auto& [a, b] : link)
  {
    // Triangle (point, a, b) runs point -> a and b -> point.
    uses.emplace_back(a, 0);
    uses.emplace_back(b, 1);
  }
  std::sort(uses.begin(), uses.end());
  for (std::size_t i = 0; i < uses.size();)
  {
    const vtkIdType neighbour = uses[i].first;
    vtkIdType counts[2] = { 0, 0 };
    for (; i < uses.size() && uses[i].first == neighbour; ++i)
    {
      ++counts[uses[i].second];
    }
    if (neighbour > point)
    {
      visit(neighbour, counts[0], counts[1]);
    }
  }
}

std::vector<EdgeCount> CountEdges(const SurfaceView& mesh, const TriangleStars& stars)
{
  std::vector<EdgeCount> counts(mesh.Points.size());
  ParallelFor(0, mesh.NumberOfPoints(), 4096,
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<std::pair<vtkIdType, vtkIdType>> link;
      std::vector<std::pair<vtkIdType, int>> uses;
      for (vtkIdType point = first; point < last; ++point)
      {
        EdgeCount& count = counts[static_cast<std::size_t>(point)];
        stars.Link(point, link);
        ForEachHigherNeighbour(point, link, uses,
          [&](vtkIdType, vtkIdType leaving, vtkIdType entering)
          {
            ++count.Edges;
            count.Open += leaving != entering;
          });
      }
    });
  return counts;
}

/// Component number of each point (meaningless for points without triangles), and how many.
std::vector<vtkIdType> NumberComponents(
  const SurfaceView& mesh, const TriangleStars& stars, vtkIdType& components)
{
  DisjointSets<vtkIdType> sets(mesh.NumberOfPoints());
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const Triangle& corner = mesh.Corners(t);
    sets.Join(corner[0], corner[1]);
    sets.Join(corner[0], corner[2]);
  }
  std::vector<vtkIdType> number(mesh.Points.size(), -1);
  components = 0;
  for (vtkIdType point = 0; point < mesh.NumberOfPoints(); ++point)
  {
    if (stars.Size(point) > 0)
    {
      // The root of a set is its lowest id, so it is numbered before its other members.
      const vtkIdType root = sets.Find(point);
      number[static_cast<std::size_t>(point)] =
        root == point ? components++ : number[static_cast<std::size_t>(root)];
    }
  }
  return number;
}

/// Joins the ends of open edges and adds the number of rings they form to each component.
void CountBoundaryLoops(const SurfaceView& mesh, const TriangleStars& stars,
  const std::vector<EdgeCount>& edges, const std::vector<vtkIdType>& componentOf,
  std::vector<SurfaceMeasure>& components)
{
  DisjointSets<vtkIdType> rings(mesh.NumberOfPoints());
  std::vector<bool> joined(mesh.Points.size(), false);
  std::vector<std::pair<vtkIdType, vtkIdType>> link;
  std::vector<std::pair<vtkIdType, int>> uses;
  for (vtkIdType point = 0; point < mesh.NumberOfPoints(); ++point)
  {
    if (edges[static_cast<std::size_t>(point)].Open == 0)
    {
      continue;
    }
    stars.Link(point, link);
    ForEachHigherNeighbour(point, link, uses,
      [&](vtkIdType neighbour, vtkIdType leaving, vtkIdType entering)
      {
        if (leaving != entering)
        {
          rings.Join(point, neighbour);
          joined[static_cast<std::size_t>(point)] = true;
        }
      });
  }
  for (vtkIdType point = 0; point < mesh.NumberOfPoints(); ++point)
  {
    // The lowest point of a ring has a higher neighbour in it, so it was joined from there.
    if (rings.Find(point) == point && joined[static_cast<std::size_t>(point)])
    {
      const vtkIdType component = componentOf[static_cast<std::size_t>(point)];
      ++components[static_cast<std::size_t>(component)].BoundaryLoops;
    }
  }
}

/// A point near the surface, to measure from: far from the origin, digits would cancel.
Vector3d Center(const SurfaceView& mesh)
{
  Vector3d sum = Vector3d::Zero();
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    sum += PointMap(mesh.Point(mesh.Corners(t)[0]).data());
  }
  return sum / static_cast<double>(std::max<vtkIdType>(mesh.NumberOfTriangles(), 1));
}

void AddTriangles(const SurfaceView& mesh, const std::vector<vtkIdType>& componentOf,
  std::vector<SurfaceMeasure>& components)
{
  const Vector3d center = Center(mesh);
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const Triangle& corner = mesh.Corners(t);
    const Vector3d a = PointMap(mesh.Point(corner[0]).data()) - center;
    const Vector3d b = PointMap(mesh.Point(corner[1]).data()) - center;
    const Vector3d c = PointMap(mesh.Point(corner[2]).data()) - center;
    const Vector3d twiceArea = (b - a).cross(c - a);
    const auto number = static_cast<std::size_t>(componentOf[static_cast<std::size_t>(corner[0])]);
    SurfaceMeasure& component = components[number];
    component.Area += 0.5 * twiceArea.norm();
    component.Volume += a.dot(twiceArea) / 6.0;
    ++component.Triangles;
  }
}

/// Computes the derived measures of a component.
void FinishMeasure(SurfaceMeasure& measure)
{
  if (!measure.IsClosed())
  {
    measure.Volume = measure.VolumeError = std::numeric_limits<double>::quiet_NaN();
  }
  measure.Genus =
    measure.IrregularPoints > 0 ? -1 : (2 - measure.EulerNumber() - measure.BoundaryLoops) / 2;
}

SurfaceMeasure Sum(const std::vector<SurfaceMeasure>& components)
{
  SurfaceMeasure whole;
  for (const SurfaceMeasure& part : components)
  {
    whole.Area += part.Area;
    whole.Volume += part.Volume; // not a number if any part's is not
    whole.AreaError += part.AreaError;
    whole.VolumeError += part.VolumeError;
    whole.Points += part.Points;
    whole.Edges += part.Edges;
    whole.Triangles += part.Triangles;
    whole.OpenEdges += part.OpenEdges;
    whole.BoundaryLoops += part.BoundaryLoops;
    whole.IrregularPoints += part.IrregularPoints;
    whole.Genus += part.Genus;
  }
  whole.Genus = whole.IrregularPoints > 0 ? -1 : whole.Genus;
  return whole;
}

}

SurfaceMeasures MeasureSurface(const SurfaceView& mesh, const ProgressCallback& progress)
{
  const TriangleStars stars(mesh);
  Report(progress, 0.2);
  const std::vector<StarKind> kinds = StarKinds(mesh, stars);
  Report(progress, 0.5);
  const std::vector<EdgeCount> edges = CountEdges(mesh, stars);
  Report(progress, 0.7);
  vtkIdType count = 0;
  const std::vector<vtkIdType> componentOf = NumberComponents(mesh, stars, count);
  Report(progress, 0.8);

  SurfaceMeasures result;
  result.Components.resize(static_cast<std::size_t>(count));
  AddTriangles(mesh, componentOf, result.Components);
  const std::vector<ChordError> errors = EstimateChordErrors(mesh, stars, componentOf, count);
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    result.Components[i].AreaError = errors[i].Area;
    result.Components[i].VolumeError = errors[i].Volume;
  }
  for (std::size_t point = 0; point < kinds.size(); ++point)
  {
    if (kinds[point] != StarKind::Isolated)
    {
      SurfaceMeasure& component = result.Components[static_cast<std::size_t>(componentOf[point])];
      ++component.Points;
      component.Edges += edges[point].Edges;
      component.OpenEdges += edges[point].Open;
      component.IrregularPoints += kinds[point] == StarKind::Irregular;
    }
  }
  CountBoundaryLoops(mesh, stars, edges, componentOf, result.Components);
  for (SurfaceMeasure& component : result.Components)
  {
    FinishMeasure(component);
  }
  result.Whole = Sum(result.Components);
  Report(progress, 1.0);
  return result;
}

std::string DescribeTopologyChange(const SurfaceView& before, const SurfaceView& after)
{
  const SurfaceMeasures old = MeasureSurface(before);
  const SurfaceMeasures now = MeasureSurface(after);
  if (old.Whole.Genus < 0 || now.Whole.Genus < 0)
  {
    return {};
  }
  const auto change = [](const char* what, auto from, auto to)
  {
    return from == to
      ? std::string()
      : std::string(what) + " from " + std::to_string(from) + " to " + std::to_string(to);
  };
  const std::string parts =
    change("the number of components", old.Components.size(), now.Components.size());
  const std::string genus = change("the genus", old.Whole.Genus, now.Whole.Genus);
  if (parts.empty() && genus.empty())
  {
    return {};
  }
  return "Repair changed " + parts + (parts.empty() || genus.empty() ? "" : ", and ") + genus + ".";
}

}
