#include "Pockets/EmptySpace.h"

#include "Core/Index.h"

#include <cmath>

namespace isthmus
{
namespace
{

Ball BallOf(const RegularFiltration& f, SimplexId id)
{
  return { f.Complex.Points[At(id)], f.Radii[At(id)] };
}

/// The corner of `cell` that is point `p`.
std::size_t CornerOf(const std::array<SimplexId, 4>& cell, SimplexId p)
{
  std::size_t k = 0;
  while (cell[k] != p)
  {
    ++k;
  }
  return k;
}

double VolumeOf(const std::array<Point3, 4>& p)
{
  return std::fabs(Dot(p[1] - p[0], Cross(p[2] - p[0], p[3] - p[0]))) / 6.0;
}

void TakeThrees(const RegularFiltration& f, const std::array<TriangleId, 4>& faces,
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
      HalfTripleIntersection(BallOf(f, t[0]), BallOf(f, t[1]), BallOf(f, t[2]));
    empty.Volume -= half.Volume;
    for (std::size_t k = 0; k < 3; ++k)
    {
      empty.Area[CornerOf(cell, t[k])] += half.Area[k];
    }
  }
}

void TakeLenses(const RegularFiltration& f, const std::array<SimplexId, 4>& cell,
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
    const Overlap<2> lens = Lens(BallOf(f, cell[i]), BallOf(f, cell[j]));
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

  explicit OuterShare(const CellFiltration& c)
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
    for (const auto& cell : c.Tetrahedra)
    {
      this->TakeCell(c, cell);
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
void AddOutside(const RegularFiltration& f, UnionMeasure& sum)
{
  const CellFiltration& c = f.Complex;
  const OuterShare share(c);
  for (std::size_t v = 0; v < c.Points.size(); ++v)
  {
    if (share.HullVertex[v] && f.VertexValue[v] <= 0.0)
    {
      const Overlap<1> ball = WholeBall(BallOf(f, static_cast<SimplexId>(v)));
      sum.Volume += share.OfVertex[v] * ball.Volume;
      sum.Area += share.OfVertex[v] * ball.Area[0];
    }
  }
  for (const EdgeId e : c.Edges.Keys())
  {
    if (share.HullEdge[e] && c.EdgeValue[e] <= 0.0)
    {
      const Overlap<2> lens = Lens(BallOf(f, c.Edges[e][0]), BallOf(f, c.Edges[e][1]));
      sum.Volume -= share.OfEdge[e] * lens.Volume;
      sum.Area -= share.OfEdge[e] * (lens.Area[0] + lens.Area[1]);
    }
  }
  for (const TriangleId triangle : c.Triangles())
  {
    const auto sides = c.TriangleSides(triangle);
    const bool hull = !sides[0].Exists() || !sides[1].Exists();
    if (hull && c.TriangleValue[triangle] <= 0.0)
    {
      const auto t = c.TrianglePoints(triangle);
      const Overlap<3> half =
        HalfTripleIntersection(BallOf(f, t[0]), BallOf(f, t[1]), BallOf(f, t[2]));
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

EmptyCell EmptySpaceOf(const RegularFiltration& f, const FacesByCell& faces, TetrahedronId cell)
{
  const auto& corners = f.Complex.Tetrahedra[cell];
  std::array<Point3, 4> p;
  for (std::size_t k = 0; k < 4; ++k)
  {
    p[k] = f.Complex.Points[At(corners[k])];
  }
  EmptyCell empty;
  empty.Volume = VolumeOf(p);
  for (std::size_t k = 0; k < 4; ++k)
  {
    if (f.VertexValue[At(corners[k])] <= 0.0)
    {
      const double sector = SolidAngle(p[k], p[(k + 1) % 4], p[(k + 2) % 4], p[(k + 3) % 4]);
      const Overlap<1> ball = WholeBall(BallOf(f, corners[k]));
      empty.Volume -= sector * ball.Volume;
      empty.Area[k] += sector * ball.Area[0];
    }
  }
  TakeLenses(f, corners, p, empty);
  TakeThrees(f, faces[cell], corners, empty);
  return empty;
}

UnionMeasure MeasureUnion(
  const RegularFiltration& f, const HandleVector<TetrahedronId, EmptyCell>& empty)
{
  UnionMeasure sum;
  for (const TetrahedronId id : empty.Keys())
  {
    const auto& cell = f.Complex.Tetrahedra[id];
    sum.Volume += VolumeOf({ f.Complex.Points[At(cell[0])], f.Complex.Points[At(cell[1])],
                    f.Complex.Points[At(cell[2])], f.Complex.Points[At(cell[3])] }) -
      empty[id].Volume;
    for (const double area : empty[id].Area)
    {
      sum.Area += area;
    }
  }
  AddOutside(f, sum);
  return sum;
}

}
