#include "Persistence/RegularFiltration.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Core/Stopwatch.h"
#include "Persistence/ExactOrthosphere.h"
#include "Persistence/TriangulationCells.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>

namespace isthmus
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ExactKernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using RegularVertexBase = CGAL::Triangulation_vertex_base_with_info_3<SimplexId, Kernel,
  CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using RegularCellBase = CGAL::Triangulation_cell_base_with_info_3<TetrahedronId, Kernel,
  CGAL::Regular_triangulation_cell_base_3<Kernel, CGAL::Triangulation_cell_base_3<Kernel>,
    CGAL::Discard_hidden_points>>;
using Regular = CGAL::Regular_triangulation_3<Kernel,
  CGAL::Triangulation_data_structure_3<RegularVertexBase, RegularCellBase>>;

/// Below this sine-like measure the plain formula could be wrong by more than 1e-9.
constexpr double RegularFlatnessLimit = 1e-5;
/// Powers nearer to 0 than this, relative to their terms, are decided exactly.
constexpr double Doubtful = 1e-11;

template <typename K>
typename K::Weighted_point_3 GetBall(const RegularFiltration& f, SimplexId id)
{
  const Point3& p = f.Complex.Points[At(id)];
  const double r = f.Radii[At(id)];
  return typename K::Weighted_point_3(typename K::Point_3(p[0], p[1], p[2]), r * r);
}

double GetWeight(const RegularFiltration& f, SimplexId id)
{
  return f.Radii[At(id)] * f.Radii[At(id)];
}

void CheckBalls(const std::vector<Point3>& centers, const std::vector<double>& radii)
{
  // Powers are products of two lengths, orientations of three: beyond this they lose all digits.
  constexpr double largest = 1e9;
  if (centers.size() != radii.size())
  {
    throw std::invalid_argument("There must be one radius for each ball.");
  }
  for (std::size_t i = 0; i < centers.size(); ++i)
  {
    const Point3& p = centers[i];
    if (!(std::max({ std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2]) }) < largest))
    {
      throw std::invalid_argument("Ball " + std::to_string(i) +
        " has a coordinate that is not a finite number, or beyond 1e9: these can't be atoms in "
        "angstrom.");
    }
    if (!(radii[i] >= 0.0 && radii[i] < largest))
    {
      throw std::invalid_argument("Ball " + std::to_string(i) + " has the radius " +
        FormatNumber(radii[i]) + ", but a radius is a finite number and not negative.");
    }
  }
}

Orthosphere ComputeOrthosphere(const RegularFiltration& f, const std::array<SimplexId, 4>& t)
{
  const auto& p = f.Complex.Points;
  const Point3 a = p[At(t[1])] - p[At(t[0])];
  const Point3 b = p[At(t[2])] - p[At(t[0])];
  const Point3 c = p[At(t[3])] - p[At(t[0])];
  const double w = GetWeight(f, t[0]);
  const Point3 bc = Cross(b, c);
  const double det = Dot(a, bc);
  const double aa = Dot(a, a);
  const double bb = Dot(b, b);
  const double cc = Dot(c, c);
  if (det * det <= RegularFlatnessLimit * RegularFlatnessLimit * aa * bb * cc)
  {
    return ExactOrthosphere({ p[At(t[0])], p[At(t[1])], p[At(t[2])], p[At(t[3])] },
      { w, GetWeight(f, t[1]), GetWeight(f, t[2]), GetWeight(f, t[3]) });
  }
  const Point3 center = (0.5 / det) *
    ((aa + w - GetWeight(f, t[1])) * bc + (bb + w - GetWeight(f, t[2])) * Cross(c, a) +
      (cc + w - GetWeight(f, t[3])) * Cross(a, b));
  return { p[At(t[0])] + center, Dot(center, center) - w };
}

double TrianglePower(const RegularFiltration& f, const std::array<SimplexId, 3>& t)
{
  const auto& p = f.Complex.Points;
  const Point3 a = p[At(t[1])] - p[At(t[0])];
  const Point3 b = p[At(t[2])] - p[At(t[0])];
  const Point3 n = Cross(a, b);
  const double nn = Dot(n, n);
  const double w = GetWeight(f, t[0]);
  if (nn <= RegularFlatnessLimit * RegularFlatnessLimit * Dot(a, a) * Dot(b, b))
  {
    return CGAL::to_double(CGAL::squared_radius_smallest_orthogonal_sphere(
      GetBall<ExactKernel>(f, t[0]), GetBall<ExactKernel>(f, t[1]), GetBall<ExactKernel>(f, t[2])));
  }
  const Point3 center = (0.5 / nn) *
    ((Dot(a, a) + w - GetWeight(f, t[1])) * Cross(b, n) +
      (Dot(b, b) + w - GetWeight(f, t[2])) * Cross(n, a));
  return Dot(center, center) - w;
}

/// Power of the edge's smallest orthogonal sphere, and where its center lies from the first end.
Orthosphere EdgeOrthosphere(const RegularFiltration& f, const std::array<SimplexId, 2>& e)
{
  const auto& p = f.Complex.Points;
  const Point3 d = p[At(e[1])] - p[At(e[0])];
  const double dd = Dot(d, d);
  const double t = 0.5 * (dd + GetWeight(f, e[0]) - GetWeight(f, e[1])) / dd;
  return { p[At(e[0])] + t * d, t * t * dd - GetWeight(f, e[0]) };
}

void Triangulate(const RegularFiltration& f, Regular& triangulation,
  const ProgressCallback& progress, const std::function<void(double)>& predicted)
{
  // CPU time, unless other threads work as well: a busy machine does not make it longer.
  Stopwatch watch;
  const std::clock_t begin = std::clock();
  double wall = 0.0;
  double eighth = 0.0;
  const auto seconds = [&]()
  {
    wall += watch.Lap();
    return std::min(wall, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  };
  std::vector<Kernel::Point_3> sites;
  sites.reserve(f.Radii.size());
  for (const Point3& p : f.Complex.Points)
  {
    sites.emplace_back(p[0], p[1], p[2]);
  }
  // Neighbours in this order are near each other, so the last vertex is a good hint; the order is
  // random at large, which the prediction of the time needs.
  const std::vector<std::size_t> order = SpatialOrder<Kernel>(sites);
  Regular::Vertex_handle hint;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i == order.size() / 8)
    {
      eighth = seconds();
    }
    if (i == order.size() / 4 && predicted)
    {
      const double quarter = seconds();
      // From an eighth to a quarter of the balls: linear for atoms, up to quadratic in convex
      // position.
      const double power = std::clamp(std::log2(quarter / std::max(eighth, 1e-9)), 1.0, 2.0);
      predicted(quarter * std::pow(4.0, power));
    }
    const auto id = static_cast<SimplexId>(order[i]);
    const auto vertex = hint == Regular::Vertex_handle()
      ? triangulation.insert(GetBall<Kernel>(f, id))
      : triangulation.insert(GetBall<Kernel>(f, id), hint->cell());
    // A hidden ball gets no vertex; the vertex of the hint may later be hidden as well.
    hint = vertex;
    if (vertex != Regular::Vertex_handle())
    {
      vertex->info() = id;
    }
    if (i % 8192 == 0)
    {
      Report(progress, static_cast<double>(i) / static_cast<double>(order.size()));
    }
  }
}

/// Calls `body` for all ids of a kind. Blocks are so small that progress moves where each
/// body needs exact arithmetic, as that of flat simplices does.
template <typename Id>
void ForEachId(
  std::size_t n, const std::function<void(Id)>& body, const ProgressCallback& progress = {})
{
  ParallelFor(
    0, static_cast<std::int64_t>(n), 1024,
    [&body](std::int64_t begin, std::int64_t end)
    {
      for (const Id id : HandleRange<Id>(begin, end))
      {
        body(id);
      }
    },
    progress);
}

double TriangleValue(const RegularFiltration& f, TriangleId triangle)
{
  const CellFiltration& complex = f.Complex;
  const auto t = complex.TrianglePoints(triangle);
  bool attached = false;
  double lowest = HUGE_VAL;
  for (const TetrahedronId cell : complex.TriangleSides(triangle))
  {
    if (!cell.Exists())
    {
      continue;
    }
    lowest = std::min(lowest, complex.TetrahedronValue[cell]);
    attached = attached ||
      Kernel().power_side_of_bounded_power_sphere_3_object()(GetBall<Kernel>(f, t[0]),
        GetBall<Kernel>(f, t[1]), GetBall<Kernel>(f, t[2]),
        GetBall<Kernel>(f, complex.Opposite(cell, t))) == CGAL::ON_BOUNDED_SIDE;
  }
  return attached ? lowest : std::min(lowest, TrianglePower(f, t));
}

/// Whether the ball `third` intersects the smallest sphere orthogonal to an edge's balls.
bool CutsInto(const RegularFiltration& f, const std::array<SimplexId, 2>& edge,
  const Orthosphere& sphere, SimplexId third)
{
  const Point3 d = f.Complex.Points[At(third)] - sphere.Center;
  const double dd = Dot(d, d);
  const double power = dd - GetWeight(f, third) - sphere.Power;
  const double scale = dd + GetWeight(f, third) + std::fabs(sphere.Power) + GetWeight(f, edge[0]);
  if (std::fabs(power) > Doubtful * scale)
  {
    return power < 0.0;
  }
  return Kernel().power_side_of_bounded_power_sphere_3_object()(GetBall<Kernel>(f, edge[0]),
           GetBall<Kernel>(f, edge[1]), GetBall<Kernel>(f, third)) == CGAL::ON_BOUNDED_SIDE;
}

/// The neighbours in the link decide whether an edge is attached, as for Gabriel edges.
void ValueEdges(RegularFiltration& f, const ProgressCallback& progress)
{
  CellFiltration& c = f.Complex;
  c.EdgeValue.assign(c.Edges.size(), HUGE_VAL);
  HandleVector<EdgeId, Orthosphere> spheres(c.Edges.size());
  ForEachId<EdgeId>(c.Edges.size(), [&](EdgeId e) { spheres[e] = EdgeOrthosphere(f, c.Edges[e]); });
  HandleVector<EdgeId, char> attached(c.Edges.size(), 0);
  const auto count = static_cast<double>(c.TriangleCount());
  for (const TriangleId t : c.Triangles())
  {
    if (t.Index() % 8192 == 0)
    {
      Report(progress, static_cast<double>(t.Index()) / count);
    }
    const auto edges = c.TriangleEdges(t);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const EdgeId e = edges[k];
      c.EdgeValue[e] = std::min(c.EdgeValue[e], c.TriangleValue[t]);
      if (!attached[e] && CutsInto(f, c.Edges[e], spheres[e], c.TrianglePoints(t)[k]))
      {
        attached[e] = 1;
      }
    }
  }
  for (const EdgeId e : c.Edges.Keys())
  {
    if (!attached[e])
    {
      c.EdgeValue[e] = std::min(c.EdgeValue[e], spheres[e].Power);
    }
  }
}

/// A vertex is attached if a neighbour's ball, shrunk by the same amount, still contains its
/// center.
void ValueVertices(RegularFiltration& f)
{
  const CellFiltration& c = f.Complex;
  f.VertexValue.assign(c.Points.size(), HUGE_VAL);
  std::vector<char> attached(c.Points.size(), 0);
  for (const EdgeId e : c.Edges.Keys())
  {
    const Point3 d = c.Points[At(c.Edges[e][1])] - c.Points[At(c.Edges[e][0])];
    for (std::size_t k = 0; k < 2; ++k)
    {
      const SimplexId v = c.Edges[e][k];
      const SimplexId other = c.Edges[e][1 - k];
      f.VertexValue[At(v)] = std::min(f.VertexValue[At(v)], c.EdgeValue[e]);
      if (Dot(d, d) < GetWeight(f, other) - GetWeight(f, v))
      {
        attached[At(v)] = 1;
      }
    }
  }
  for (std::size_t v = 0; v < c.Points.size(); ++v)
  {
    if (!attached[v] && f.VertexValue[v] < HUGE_VAL)
    {
      f.VertexValue[v] = std::min(f.VertexValue[v], -GetWeight(f, static_cast<SimplexId>(v)));
    }
  }
}

}

RegularFiltration MakeRegularFiltration(std::vector<Point3> centers, std::vector<double> radii,
  const ProgressCallback& progress, const std::function<void(double)>& predicted)
{
  CheckBalls(centers, radii);
  RegularFiltration f;
  f.Complex.Points = std::move(centers);
  f.Radii = std::move(radii);
  {
    Regular triangulation;
    Triangulate(f, triangulation, Between(progress, 0.0, 0.5), predicted);
    if (triangulation.dimension() == 3)
    {
      ImportCells(triangulation, f.Complex, Between(progress, 0.5, 0.55));
    }
  }
  CellFiltration& c = f.Complex;
  c.Connect(Between(progress, 0.55, 0.7));
  f.Centers.resize(c.Tetrahedra.size());
  c.TetrahedronValue.resize(c.Tetrahedra.size());
  ForEachId<TetrahedronId>(
    c.Tetrahedra.size(),
    [&](TetrahedronId cell)
    {
      const Orthosphere sphere = ComputeOrthosphere(f, c.Tetrahedra[cell]);
      f.Centers[cell] = sphere.Center;
      c.TetrahedronValue[cell] = sphere.Power;
    },
    Between(progress, 0.7, 0.8));
  c.TriangleValue.resize(c.TriangleCount());
  ForEachId<TriangleId>(
    c.TriangleCount(), [&](TriangleId t) { c.TriangleValue[t] = TriangleValue(f, t); },
    Between(progress, 0.8, 0.9));
  ValueEdges(f, Between(progress, 0.9, 0.97));
  ValueVertices(f);
  Report(progress, 1.0);
  return f;
}

}
