#include "Contouring/MapSurface.h"

#include "Core/DisjointSets.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

Point3 DoubleArea(const SurfaceView& mesh, const Triangle& t)
{
  const Point3& a = mesh.Points[static_cast<std::size_t>(t[0])];
  return Cross(mesh.Points[static_cast<std::size_t>(t[1])] - a,
    mesh.Points[static_cast<std::size_t>(t[2])] - a);
}

struct Component
{
  double Area = 0.0;
  std::int64_t First = 0; ///< triangle
};

/// Components in the order of their first triangles, and which one each triangle belongs to.
std::vector<Component> FindComponents(
  const SurfaceView& mesh, std::vector<std::int64_t>& ofTriangle)
{
  DisjointSets<std::int64_t> sets(static_cast<std::int64_t>(mesh.Points.size()));
  for (const Triangle& t : mesh.Triangles)
  {
    sets.Join(t[0], t[1]);
    sets.Join(t[0], t[2]);
  }
  std::vector<std::int64_t> ofRoot(mesh.Points.size(), -1);
  std::vector<Component> components;
  ofTriangle.resize(mesh.Triangles.size());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    auto& component = ofRoot[static_cast<std::size_t>(sets.Find(mesh.Triangles[t][0]))];
    if (component < 0)
    {
      component = static_cast<std::int64_t>(components.size());
      components.push_back({ 0.0, static_cast<std::int64_t>(t) });
    }
    const Point3 normal = DoubleArea(mesh, mesh.Triangles[t]);
    components[static_cast<std::size_t>(component)].Area += Length(normal) / 2.0;
    ofTriangle[t] = component;
  }
  return components;
}

/// Rank of each component by area, or -1 for one that is removed; `areas` of the remaining ones.
std::vector<std::int64_t> RankByArea(const std::vector<Component>& components,
  const DustParameters& parameters, std::vector<double>& areas)
{
  std::vector<std::size_t> order(components.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return components[a].Area > components[b].Area; });
  std::vector<std::int64_t> rank(components.size(), -1);
  const auto most = parameters.LargestComponents == 0
    ? order.size()
    : static_cast<std::size_t>(parameters.LargestComponents);
  for (std::size_t r = 0; r < std::min(most, order.size()); ++r)
  {
    const double area = components[order[r]].Area;
    if (area < parameters.MinimumComponentArea ||
      area < parameters.MinimumComponentShare * components[order[0]].Area)
    {
      break;
    }
    rank[order[r]] = static_cast<std::int64_t>(r);
    areas.push_back(area);
  }
  return rank;
}

/// Removes the triangles without a rank, and the points that are then unused.
void Compact(TriangleMesh& mesh, std::vector<std::int64_t>& ranks)
{
  std::vector<std::int64_t> ids(mesh.Points.size(), -1);
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    if (ranks[t] >= 0)
    {
      for (const std::int64_t corner : mesh.Triangles[t])
      {
        ids[static_cast<std::size_t>(corner)] = 0;
      }
      ranks[kept] = ranks[t];
      mesh.Triangles[kept++] = mesh.Triangles[t];
    }
  }
  mesh.Triangles.resize(kept);
  ranks.resize(kept);
  std::size_t points = 0;
  for (std::size_t p = 0; p < ids.size(); ++p)
  {
    if (ids[p] == 0)
    {
      ids[p] = static_cast<std::int64_t>(points);
      mesh.Points[points++] = mesh.Points[p];
    }
  }
  mesh.Points.resize(points);
  for (Triangle& t : mesh.Triangles)
  {
    for (vtkIdType& corner : t)
    {
      corner = ids[static_cast<std::size_t>(corner)];
    }
  }
}

}

void Check(const DustParameters& parameters)
{
  RequireRange("MinimumComponentArea", parameters.MinimumComponentArea, 0.0, Unlimited);
  RequireRange("MinimumComponentShare", parameters.MinimumComponentShare, 0.0, 1.0);
  RequireRange(
    "LargestComponents", parameters.LargestComponents, 0, Unlimited, "0 stands for all of them.");
}

DustResult HideDust(TriangleMesh mesh, const DustParameters& parameters)
{
  Check(parameters);
  DustResult result;
  const std::vector<Component> components = FindComponents(mesh, result.Components);
  const std::vector<std::int64_t> rank = RankByArea(components, parameters, result.Areas);
  result.Found = static_cast<std::int64_t>(components.size());
  for (std::int64_t& component : result.Components)
  {
    component = rank[static_cast<std::size_t>(component)];
  }
  if (result.Areas.size() < components.size())
  {
    Compact(mesh, result.Components);
  }
  result.Surface = std::move(mesh);
  return result;
}

std::vector<Point3> PointNormals(const SurfaceView& mesh)
{
  std::vector<Point3> normals(mesh.Points.size(), Point3{ 0, 0, 0 });
  for (const Triangle& t : mesh.Triangles)
  {
    const Point3 normal = DoubleArea(mesh, t);
    for (const std::int64_t corner : t)
    {
      Point3& sum = normals[static_cast<std::size_t>(corner)];
      sum = sum + normal;
    }
  }
  for (Point3& normal : normals)
  {
    const double length = Length(normal);
    if (length > 0.0)
    {
      normal = (1.0 / length) * normal;
    }
  }
  return normals;
}

}
