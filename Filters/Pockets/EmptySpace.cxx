#include "Pockets/EmptySpace.h"

#include "Core/Index.h"
#include "Pockets/CellProgress.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace isthmus
{
namespace
{

Ball GetBall(const RegularFiltration& f, SimplexId id)
{
  return { f.Complex.Points[At(id)], f.Radii[At(id)] };
}

/// The corner of `cell` that is point `p`.
std::size_t FindCorner(const std::array<SimplexId, 4>& cell, SimplexId p)
{
  std::size_t k = 0;
  while (cell[k] != p)
  {
    ++k;
  }
  return k;
}

double ComputeVolume(const std::array<Point3, 4>& p)
{
  return std::fabs(Dot(p[1] - p[0], Cross(p[2] - p[0], p[3] - p[0]))) / 6.0;
}

/// Intersections of three balls are halved by the plane of their triangle: each side's tetrahedron
/// gets its half.
void SubtractTriples(const RegularFiltration& f, const std::array<TriangleId, 4>& faces,
  const std::array<SimplexId, 4>& cell, EmptyCell& empty)
{
  for (const TriangleId face : faces)
  {
    if (f.Complex.TriangleValue[face] > 0.0)
    {
      continue;
    }
    const auto t = f.Complex.TrianglePoints(face);
    const Overlap<3> half =
      HalfTripleIntersection(GetBall(f, t[0]), GetBall(f, t[1]), GetBall(f, t[2]));
    empty.Volume -= half.Volume;
    for (std::size_t k = 0; k < 3; ++k)
    {
      empty.Area[FindCorner(cell, t[k])] += half.Area[k];
    }
  }
}

/// Intersections of two balls, in proportion to the dihedral angle at their edge.
void SubtractLenses(const RegularFiltration& f, const std::array<SimplexId, 4>& cell,
  const std::array<Point3, 4>& p, EmptyCell& empty)
{
  constexpr std::size_t pairs[6][4] = { { 0, 1, 2, 3 }, { 0, 2, 1, 3 }, { 0, 3, 1, 2 },
    { 1, 2, 0, 3 }, { 1, 3, 0, 2 }, { 2, 3, 0, 1 } };
  for (const auto& [i, j, k, l] : pairs)
  {
    const EdgeId edge = f.Complex.FindEdge(cell[i], cell[j]);
    if (f.Complex.EdgeValue[edge] > 0.0)
    {
      continue;
    }
    const double slice = DihedralAngle(p[i], p[j], p[k], p[l]);
    const Overlap<2> lens = Lens(GetBall(f, cell[i]), GetBall(f, cell[j]));
    empty.Volume += slice * lens.Volume;
    empty.Area[i] -= slice * lens.Area[0];
    empty.Area[j] -= slice * lens.Area[1];
  }
}

/// The fraction of the ball of each hull simplex that lies outside all tetrahedra.
struct OuterShare
{
  std::vector<double> OfVertex;
  HandleVector<EdgeId, double> OfEdge;
  std::vector<char> HullVertex;
  HandleVector<EdgeId, char> HullEdge;

  OuterShare(const CellFiltration& c, const ProgressCallback& progress)
    : OfVertex(c.Points.size(), 1.0)
    , OfEdge(c.Edges.size(), 1.0)
    , HullVertex(c.Points.size(), 0)
    , HullEdge(c.Edges.size(), 0)
  {
    for (const TriangleId t : c.Triangles())
    {
      if (c.TriangleSides(t)[0].Exists() && c.TriangleSides(t)[1].Exists())
      {
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->HullVertex[At(c.TrianglePoints(t)[k])] = 1;
        this->HullEdge[c.TriangleEdges(t)[k]] = 1;
      }
    }
    for (const TetrahedronId cell : c.Tetrahedra.Keys())
    {
      ReportCells(progress, cell.Index(), c.Tetrahedra.size());
      this->TakeCell(c, c.Tetrahedra[cell]);
    }
  }

private:
  void TakeCell(const CellFiltration& c, const std::array<SimplexId, 4>& cell)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Point3& p = c.Points[At(cell[i])];
      const auto other = [&](std::size_t k) { return c.Points[At(cell[(i + k) % 4])]; };
      if (!this->HullVertex[At(cell[i])])
      {
        continue;
      }
      this->OfVertex[At(cell[i])] -= SolidAngle(p, other(1), other(2), other(3));
      for (std::size_t k = 1; k < 4; ++k)
      {
        const SimplexId q = cell[(i + k) % 4];
        const EdgeId edge = c.FindEdge(cell[i], q);
        if (cell[i] < q && this->HullEdge[edge])
        {
          this->OfEdge[edge] -=
            DihedralAngle(p, other(k), other(k % 3 + 1), other((k + 1) % 3 + 1));
        }
      }
    }
  }
};

/// Adds the volume and surface of the balls outside all tetrahedra.
void AddOutside(const RegularFiltration& f, UnionMeasure& sum, const ProgressCallback& progress)
{
  const CellFiltration& c = f.Complex;
  const OuterShare share(c, Between(progress, 0.0, 0.6));
  for (std::size_t v = 0; v < c.Points.size(); ++v)
  {
    if (share.HullVertex[v] && f.VertexValue[v] <= 0.0)
    {
      const Overlap<1> ball = WholeBall(GetBall(f, static_cast<SimplexId>(v)));
      sum.Volume += share.OfVertex[v] * ball.Volume;
      sum.Area += share.OfVertex[v] * ball.Area[0];
    }
  }
  const ProgressCallback edges = Between(progress, 0.6, 0.8);
  for (const EdgeId e : c.Edges.Keys())
  {
    ReportCells(edges, e.Index(), c.Edges.size());
    if (share.HullEdge[e] && c.EdgeValue[e] <= 0.0)
    {
      const Overlap<2> lens = Lens(GetBall(f, c.Edges[e][0]), GetBall(f, c.Edges[e][1]));
      sum.Volume -= share.OfEdge[e] * lens.Volume;
      sum.Area -= share.OfEdge[e] * (lens.Area[0] + lens.Area[1]);
    }
  }
  const ProgressCallback triangles = Between(progress, 0.8, 1.0);
  for (const TriangleId triangle : c.Triangles())
  {
    const auto sides = c.TriangleSides(triangle);
    ReportCells(triangles, triangle.Index(), c.TriangleCount());
    const bool hull = !sides[0].Exists() || !sides[1].Exists();
    if (hull && c.TriangleValue[triangle] <= 0.0)
    {
      const auto t = c.TrianglePoints(triangle);
      const Overlap<3> half =
        HalfTripleIntersection(GetBall(f, t[0]), GetBall(f, t[1]), GetBall(f, t[2]));
      sum.Volume += half.Volume;
      sum.Area += half.Area[0] + half.Area[1] + half.Area[2];
    }
  }
}

}

FacesByCell FacesOfCells(const CellFiltration& complex)
{
  FacesByCell faces(complex.Tetrahedra.size());
  for (const TriangleId triangle : complex.Triangles())
  {
    const auto t = complex.TrianglePoints(triangle);
    for (const TetrahedronId cell : complex.TriangleSides(triangle))
    {
      if (!cell.Exists())
      {
        continue;
      }
      const auto& corners = complex.Tetrahedra[cell];
      for (std::size_t k = 0; k < 4; ++k)
      {
        if (corners[k] != t[0] && corners[k] != t[1] && corners[k] != t[2])
        {
          faces[cell][k] = triangle;
        }
      }
    }
  }
  return faces;
}

EmptyCell MeasureEmptySpace(
  const RegularFiltration& f, const FacesByCell& faces, TetrahedronId cell)
{
  const auto& corners = f.Complex.Tetrahedra[cell];
  std::array<Point3, 4> p;
  for (std::size_t k = 0; k < 4; ++k)
  {
    p[k] = f.Complex.Points[At(corners[k])];
  }
  EmptyCell empty;
  empty.Volume = ComputeVolume(p);
  for (std::size_t k = 0; k < 4; ++k)
  {
    if (f.VertexValue[At(corners[k])] <= 0.0)
    {
      const double sector = SolidAngle(p[k], p[(k + 1) % 4], p[(k + 2) % 4], p[(k + 3) % 4]);
      const Overlap<1> ball = WholeBall(GetBall(f, corners[k]));
      empty.Volume -= sector * ball.Volume;
      empty.Area[k] += sector * ball.Area[0];
    }
  }
  SubtractLenses(f, corners, p, empty);
  SubtractTriples(f, faces[cell], corners, empty);
  return empty;
}

namespace
{

using Point2 = std::array<double, 2>;

double Cross2(const Point2& a, const Point2& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// A triangle in its plane, counterclockwise, with discs around its corners.
struct DiscTriangle
{
  std::array<Point2, 3> Corners;
  std::array<double, 3> Radii;

  bool IsInside(const Point2& x) const
  {
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point2& p = this->Corners[k];
      const Point2& q = this->Corners[(k + 1) % 3];
      inside = inside && Cross2({ q[0] - p[0], q[1] - p[1] }, { x[0] - p[0], x[1] - p[1] }) >= 0.0;
    }
    return inside;
  }

  bool IsOpen(const Point2& x, std::size_t except) const
  {
    bool open = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point2& c = this->Corners[k];
      open = open && (k == except || std::hypot(x[0] - c[0], x[1] - c[1]) >= this->Radii[k]);
    }
    return open;
  }

  /// Twice the part of the integral over the open parts of edge k.
  double AlongEdge(std::size_t k) const;

  /// The same over the open parts of circle k, clockwise.
  double AlongCircle(std::size_t k) const;
};

double DiscTriangle::AlongEdge(std::size_t k) const
{
  const Point2& p = this->Corners[k];
  const Point2& q = this->Corners[(k + 1) % 3];
  const Point2 along{ q[0] - p[0], q[1] - p[1] };
  const double square = along[0] * along[0] + along[1] * along[1];
  const auto at = [&](double s) { return Point2{ p[0] + s * along[0], p[1] + s * along[1] }; };
  std::vector<double> breaks{ 0.0, 1.0 };
  for (std::size_t j = 0; j < 3; ++j)
  {
    const Point2 from{ this->Corners[j][0] - p[0], this->Corners[j][1] - p[1] };
    const double middle = (from[0] * along[0] + from[1] * along[1]) / square;
    const double off = Cross2(along, from);
    const double half = this->Radii[j] * this->Radii[j] / square - off * off / (square * square);
    for (const double sign : { -1.0, 1.0 })
    {
      const double s = half > 0.0 ? middle + sign * std::sqrt(half) : 0.0;
      breaks.push_back(std::clamp(s, 0.0, 1.0));
    }
  }
  std::sort(breaks.begin(), breaks.end());
  double sum = 0.0;
  for (std::size_t i = 1; i < breaks.size(); ++i)
  {
    if (this->IsOpen(at(0.5 * (breaks[i - 1] + breaks[i])), 3))
    {
      sum += Cross2(at(breaks[i - 1]), at(breaks[i]));
    }
  }
  return sum;
}

double DiscTriangle::AlongCircle(std::size_t k) const
{
  const Point2& c = this->Corners[k];
  const double r = this->Radii[k];
  if (!(r > 0.0))
  {
    return 0.0;
  }
  std::vector<double> breaks{ -Pi, Pi };
  // Where the circle meets the line at a distance from its center, in the direction of an angle.
  const auto add = [&](double direction, double distance)
  {
    if (std::abs(distance) < r)
    {
      const double half = std::acos(distance / r);
      breaks.push_back(std::remainder(direction - half, 2.0 * Pi));
      breaks.push_back(std::remainder(direction + half, 2.0 * Pi));
    }
  };
  for (std::size_t j = 0; j < 3; ++j)
  {
    const Point2& p = this->Corners[j];
    const Point2& q = this->Corners[(j + 1) % 3];
    const Point2 along{ q[0] - p[0], q[1] - p[1] };
    const double length = std::hypot(along[0], along[1]);
    add(std::atan2(along[0], -along[1]), Cross2({ c[0] - p[0], c[1] - p[1] }, along) / length);
    if (j != k)
    {
      const Point2 to{ p[0] - c[0], p[1] - c[1] };
      const double d = std::hypot(to[0], to[1]);
      const double q2 = this->Radii[j];
      add(std::atan2(to[1], to[0]), 0.5 * (d + (r - q2) * (r + q2) / d));
    }
  }
  std::sort(breaks.begin(), breaks.end());
  double sum = 0.0;
  for (std::size_t i = 1; i < breaks.size(); ++i)
  {
    const double a = breaks[i - 1], b = breaks[i];
    const double middle = 0.5 * (a + b);
    const Point2 x{ c[0] + r * std::cos(middle), c[1] + r * std::sin(middle) };
    if (this->IsInside(x) && this->IsOpen(x, k))
    {
      sum -=
        r * (r * (b - a) + c[0] * (std::sin(b) - std::sin(a)) - c[1] * (std::cos(b) - std::cos(a)));
    }
  }
  return sum;
}

}

double MeasureOpenArea(const std::array<Point3, 3>& corners, const std::array<double, 3>& radii)
{
  const Point3 u = corners[1] - corners[0];
  const Point3 v = corners[2] - corners[0];
  const double twice = Length(Cross(u, v));
  const double base = Length(u);
  // Green's theorem over the boundary of the open part: pieces of edges and arcs of circles.
  if (!(twice > 0.0))
  {
    return 0.0;
  }
  const DiscTriangle t{ { { { 0.0, 0.0 }, { base, 0.0 }, { Dot(u, v) / base, twice / base } } },
    radii };
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    sum += t.AlongEdge(k) + t.AlongCircle(k);
  }
  return std::max(0.0, 0.5 * sum);
}

UnionMeasure MeasureUnion(const RegularFiltration& f,
  const HandleVector<TetrahedronId, EmptyCell>& empty, const ProgressCallback& progress)
{
  UnionMeasure sum;
  const ProgressCallback cells = Between(progress, 0.0, 0.3);
  for (const TetrahedronId id : empty.Keys())
  {
    ReportCells(cells, id.Index(), empty.size());
    const auto& cell = f.Complex.Tetrahedra[id];
    sum.Volume += ComputeVolume({ f.Complex.Points[At(cell[0])], f.Complex.Points[At(cell[1])],
                    f.Complex.Points[At(cell[2])], f.Complex.Points[At(cell[3])] }) -
      empty[id].Volume;
    for (const double area : empty[id].Area)
    {
      sum.Area += area;
    }
  }
  AddOutside(f, sum, Between(progress, 0.3, 1.0));
  return sum;
}

UnionMeasure MeasureFlatUnion(
  std::vector<Point3> centers, std::vector<double> radii, const ProgressCallback& progress)
{
  UnionMeasure sum;
  if (centers.empty())
  {
    return sum;
  }
  Bounds3 box{ centers.front(), centers.front() };
  for (const Point3& p : centers)
  {
    box.Add(p);
  }
  const Point3 middle = 0.5 * (box.Min + box.Max);
  // Atoms in a plane have no tetrahedra. Six points of radius 0, too far away to change a simplex
  // of the atoms, create some, and the sum over the dual complex is that of whole balls.
  const double outside = 1.0 + box.Diagonal() + 2.0 * *std::max_element(radii.begin(), radii.end());
  for (const double along : { -outside, outside })
  {
    centers.push_back(middle + Point3{ along, 0.0, 0.0 });
    centers.push_back(middle + Point3{ 0.0, along, 0.0 });
    centers.push_back(middle + Point3{ 0.0, 0.0, along });
  }
  radii.resize(centers.size(), 0.0);
  const RegularFiltration f = MakeRegularFiltration(std::move(centers), std::move(radii), progress);
  const CellFiltration& c = f.Complex;
  for (std::size_t v = 0; v < c.Points.size(); ++v)
  {
    if (f.VertexValue[v] <= 0.0)
    {
      const Overlap<1> ball = WholeBall(GetBall(f, static_cast<SimplexId>(v)));
      sum.Volume += ball.Volume;
      sum.Area += ball.Area[0];
    }
  }
  for (const EdgeId e : c.Edges.Keys())
  {
    if (c.EdgeValue[e] <= 0.0)
    {
      const Overlap<2> lens = Lens(GetBall(f, c.Edges[e][0]), GetBall(f, c.Edges[e][1]));
      sum.Volume -= lens.Volume;
      sum.Area -= lens.Area[0] + lens.Area[1];
    }
  }
  for (const TriangleId triangle : c.Triangles())
  {
    if (c.TriangleValue[triangle] <= 0.0)
    {
      const auto t = c.TrianglePoints(triangle);
      const Overlap<3> half =
        HalfTripleIntersection(GetBall(f, t[0]), GetBall(f, t[1]), GetBall(f, t[2]));
      sum.Volume += 2.0 * half.Volume;
      sum.Area += 2.0 * (half.Area[0] + half.Area[1] + half.Area[2]);
    }
  }
  return sum;
}

}
