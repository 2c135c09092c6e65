#include "Persistence/DelaunayFiltration.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Persistence/ExactOrthosphere.h"
#include "Persistence/TriangulationCells.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ExactKernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<SimplexId, Kernel>;
using CellBase = CGAL::Triangulation_cell_base_with_info_3<TetrahedronId, Kernel,
  CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel,
  CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

/// Below this sine-like measure the plain formula could be wrong by more than 1e-9.
constexpr double FlatnessLimit = 1e-6;

template <typename K>
typename K::Point_3 ToCGALPoint(const Point3& p)
{
  return typename K::Point_3(p[0], p[1], p[2]);
}

/// The edges of a tetrahedron from its first corner, and the squares of their lengths.
struct CornerEdges
{
  Point3 A, B, C;
  double AA, BB, CC;
};

CornerEdges EdgesFrom(const Point3& p, const Point3& q, const Point3& r, const Point3& s)
{
  const Point3 a = q - p;
  const Point3 b = r - p;
  const Point3 c = s - p;
  return { a, b, c, Dot(a, a), Dot(b, b), Dot(c, c) };
}

double SquaredRadius(const Point3& p, const Point3& q, const Point3& r, const Point3& s)
{
  const auto& [a, b, c, aa, bb, cc] = EdgesFrom(p, q, r, s);
  const Point3 bc = Cross(b, c);
  const double det = Dot(a, bc);
  if (det * det <= FlatnessLimit * FlatnessLimit * aa * bb * cc)
  {
    return ExactOrthosphere({ p, q, r, s }, {}).Power;
  }
  const Point3 center = aa * bc + bb * Cross(c, a) + cc * Cross(a, b);
  return Dot(center, center) / (4.0 * det * det);
}

double SquaredRadius(const Point3& p, const Point3& q, const Point3& r)
{
  const Point3 a = q - p;
  const Point3 b = r - p;
  const Point3 c = r - q;
  const double aa = Dot(a, a);
  const double bb = Dot(b, b);
  const Point3 normal = Cross(a, b);
  const double nn = Dot(normal, normal);
  if (nn <= FlatnessLimit * FlatnessLimit * aa * bb)
  {
    return CGAL::to_double(CGAL::squared_radius(
      ToCGALPoint<ExactKernel>(p), ToCGALPoint<ExactKernel>(q), ToCGALPoint<ExactKernel>(r)));
  }
  return aa * bb * Dot(c, c) / (4.0 * nn);
}

// Point by point in spatial order, each located from the last, so that it can be stopped.
void Triangulate(
  const std::vector<Point3>& points, Delaunay& triangulation, const ProgressCallback& progress)
{
  std::vector<Kernel::Point_3> sites;
  sites.reserve(points.size());
  for (const Point3& p : points)
  {
    sites.push_back(ToCGALPoint<Kernel>(p));
  }
  Report(progress, 0.0);
  const std::vector<std::size_t> order = SpatialOrder<Kernel>(sites);
  Delaunay::Vertex_handle hint;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    hint = triangulation.insert(sites[order[i]], hint);
    hint->info() = static_cast<SimplexId>(order[i]);
    if (i % 8192 == 0)
    {
      Report(progress, static_cast<double>(i) / static_cast<double>(order.size()));
    }
  }
  if (triangulation.dimension() < 3)
  {
    throw std::invalid_argument("The surface has " + std::to_string(points.size()) +
      " points that all lie in one plane: it encloses nothing.");
  }
}

constexpr std::size_t ReportEvery = 1 << 18;

/// True if s lies strictly inside the smallest sphere through p, q and r.
bool IsInBall(const Point3& p, const Point3& q, const Point3& r, const Point3& s)
{
  const auto& [a, b, c, aa, bb, cc] = EdgesFrom(p, q, r, s);
  const Point3 n = Cross(a, b);
  // |c|^2 - 2 c.center, times |n|^2.
  const double power = Dot(n, n) * cc - Dot(aa * Cross(b, n) + bb * Cross(n, a), c);
  // Rounding takes at most some thirty units of 2^-53 of |a|^2 |b|^2 |c| (|a| + |b| + |c|).
  const double error = 1.5e-14 * aa * bb * std::sqrt(3.0 * cc * (aa + bb + cc));
  if (std::abs(power) > error)
  {
    return power < 0.0;
  }
  return CGAL::side_of_bounded_sphere(ToCGALPoint<Kernel>(p), ToCGALPoint<Kernel>(q),
           ToCGALPoint<Kernel>(r), ToCGALPoint<Kernel>(s)) == CGAL::ON_BOUNDED_SIDE;
}

double TriangleValue(const CellFiltration& f, TriangleId triangle)
{
  const auto t = f.TrianglePoints(triangle);
  const auto p = [&f](SimplexId id) -> const Point3& { return f.Points[At(id)]; };
  bool gabriel = true;
  double lowest = HUGE_VAL;
  for (const TetrahedronId cell : f.TriangleSides(triangle))
  {
    if (!cell.Exists())
    {
      continue;
    }
    lowest = std::min(lowest, f.TetrahedronValue[cell]);
    gabriel = gabriel && !IsInBall(p(t[0]), p(t[1]), p(t[2]), p(f.Opposite(cell, t)));
  }
  return gabriel ? std::min(lowest, SquaredRadius(p(t[0]), p(t[1]), p(t[2]))) : lowest;
}

/// True if w lies strictly inside the sphere with diameter u, v.
bool IsInBall(const Point3& u, const Point3& v, const Point3& w)
{
  const double angle = Dot(u - w, v - w);
  const double scale = Dot(u - v, u - v);
  return angle < -1e-12 * scale ||
    (angle < 1e-12 * scale &&
      CGAL::side_of_bounded_sphere(ToCGALPoint<Kernel>(u), ToCGALPoint<Kernel>(v),
        ToCGALPoint<Kernel>(w)) == CGAL::ON_BOUNDED_SIDE);
}

/// For each triangle, bit k: the sphere of the edge opposite to corner k has that corner inside.
HandleVector<TriangleId, unsigned char> CornersInEdgeBalls(
  const CellFiltration& f, const ProgressCallback& progress)
{
  HandleVector<TriangleId, unsigned char> inside(f.TriangleCount(), 0);
  ParallelFor(
    0, static_cast<std::int64_t>(f.TriangleCount()), 4096,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (const TriangleId triangle : HandleRange<TriangleId>(begin, end))
      {
        const auto t = f.TrianglePoints(triangle);
        for (std::size_t k = 0; k < 3; ++k)
        {
          const Point3& u = f.Points[At(t[k == 0 ? 1 : 0])];
          const Point3& v = f.Points[At(t[k == 2 ? 1 : 2])];
          inside[triangle] |=
            static_cast<unsigned char>(IsInBall(u, v, f.Points[At(t[k])]) ? 1U << k : 0U);
        }
      }
    },
    progress);
  return inside;
}

/// Edges: the triangles beside decide whether the edge's own sphere is empty.
void ValueEdges(CellFiltration& f, const ProgressCallback& progress)
{
  const auto inside = CornersInEdgeBalls(f, Between(progress, 0.0, 0.5));
  f.EdgeValue.assign(f.Edges.size(), HUGE_VAL);
  HandleVector<EdgeId, char> gabriel(f.Edges.size(), 1);
  const auto rest = Between(progress, 0.5, 1.0);
  for (const TriangleId t : f.Triangles())
  {
    if (t.Index() % ReportEvery == 0)
    {
      Report(rest, static_cast<double>(t.Index()) / static_cast<double>(f.TriangleCount()));
    }
    const auto edges = f.TriangleEdges(t);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const EdgeId e = edges[k];
      f.EdgeValue[e] = std::min(f.EdgeValue[e], f.TriangleValue[t]);
      if (inside[t] >> k & 1U)
      {
        gabriel[e] = 0;
      }
    }
  }
  for (const EdgeId e : f.Edges.Keys())
  {
    if (gabriel[e])
    {
      const Point3 d = f.Points[At(f.Edges[e][1])] - f.Points[At(f.Edges[e][0])];
      f.EdgeValue[e] = std::min(f.EdgeValue[e], 0.25 * Dot(d, d));
    }
  }
}

void ValueCells(CellFiltration& f, const ProgressCallback& progress)
{
  f.TetrahedronValue.resize(f.Tetrahedra.size());
  ParallelFor(
    0, static_cast<std::int64_t>(f.Tetrahedra.size()), 4096,
    [&f](std::int64_t begin, std::int64_t end)
    {
      for (const TetrahedronId cell : HandleRange<TetrahedronId>(begin, end))
      {
        const auto& t = f.Tetrahedra[cell];
        f.TetrahedronValue[cell] = SquaredRadius(
          f.Points[At(t[0])], f.Points[At(t[1])], f.Points[At(t[2])], f.Points[At(t[3])]);
      }
    },
    Between(progress, 0.0, 0.3));
  f.TriangleValue.resize(f.TriangleCount());
  ParallelFor(
    0, static_cast<std::int64_t>(f.TriangleCount()), 4096,
    [&f](std::int64_t begin, std::int64_t end)
    {
      for (const TriangleId t : HandleRange<TriangleId>(begin, end))
      {
        f.TriangleValue[t] = TriangleValue(f, t);
      }
    },
    Between(progress, 0.3, 0.6));
  ValueEdges(f, Between(progress, 0.6, 1.0));
}

void MarkIndistinct(CellFiltration& f, const IndistinctDistance& distance)
{
  f.TriangleIndistinct.assign(f.TriangleCount(), 0);
  f.TetrahedronIndistinct.assign(f.Tetrahedra.size(), 0);
  f.EdgeIndistinct.assign(f.Edges.size(), 0);
  ParallelFor(0, static_cast<std::int64_t>(f.TriangleCount()), 4096,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (const TriangleId t : HandleRange<TriangleId>(begin, end))
      {
        const auto corners = f.TrianglePoints(t);
        f.TriangleIndistinct[t] = f.TriangleValue[t] <= distance(corners.data(), 3) ? 1 : 0;
      }
    });
  ParallelFor(0, static_cast<std::int64_t>(f.Tetrahedra.size()), 4096,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (const TetrahedronId cell : HandleRange<TetrahedronId>(begin, end))
      {
        bool isIndistinct = f.TetrahedronValue[cell] <= distance(f.Tetrahedra[cell].data(), 4);
        for (std::size_t k = 0; k < 4 && isIndistinct; ++k)
        {
          isIndistinct = f.TriangleIndistinct[f.GetTriangle(cell, k)] != 0;
        }
        f.TetrahedronIndistinct[cell] = isIndistinct ? 1 : 0;
      }
    });
  for (const TriangleId t : f.Triangles())
  {
    if (f.TriangleIndistinct[t] != 0)
    {
      for (const EdgeId e : f.TriangleEdges(t))
      {
        f.EdgeIndistinct[e] = 1;
      }
    }
  }
}

}

CellFiltration DelaunayFiltration(std::vector<Point3> points, const ProgressCallback& progress,
  const IndistinctDistance& indistinct)
{
  CellFiltration f;
  f.Points = std::move(points);
  {
    Delaunay triangulation;
    Triangulate(f.Points, triangulation, Between(progress, 0.0, 0.4));
    ImportCells(triangulation, f, Between(progress, 0.4, 0.45));
  }
  ReleaseFreeMemory(); // of the triangulation's many small blocks
  f.Connect(Between(progress, 0.45, 0.6));
  ValueCells(f, Between(progress, 0.6, 0.85));
  if (indistinct)
  {
    MarkIndistinct(f, indistinct);
  }
  f.Order(Between(progress, 0.85, 1.0));
  return f;
}

}
