// The cell complex under the filtrations, compared with a direct evaluation of its tetrahedra.

#include "Persistence/DelaunayFiltration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace isthmus;

namespace
{

CellFiltration OfRandomPoints(std::size_t count)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  std::vector<Point3> points(count);
  for (Point3& p : points)
  {
    p = { place(random), place(random), place(random) };
  }
  return DelaunayFiltration(points);
}

/// Sides of each triangle, by its corners.
std::map<std::array<SimplexId, 3>, std::set<TetrahedronId>> GetSides(const CellFiltration& f)
{
  std::map<std::array<SimplexId, 3>, std::set<TetrahedronId>> sides;
  for (const TetrahedronId cell : f.Tetrahedra.Keys())
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      std::vector<SimplexId> face(f.Tetrahedra[cell].begin(), f.Tetrahedra[cell].end());
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(k));
      std::sort(face.begin(), face.end());
      sides[{ face[0], face[1], face[2] }].insert(cell);
    }
  }
  return sides;
}

class DelaunayCells : public ::testing::TestWithParam<std::size_t>
{
};

TEST_P(DelaunayCells, HaveEachFaceOnceWithItsSides)
{
  const CellFiltration f = OfRandomPoints(GetParam());
  const auto sides = GetSides(f);
  ASSERT_EQ(f.TriangleCount(), sides.size());
  for (const TriangleId t : f.Triangles())
  {
    const auto found = sides.find(f.TrianglePoints(t));
    ASSERT_NE(found, sides.end());
    const auto beside = f.TriangleSides(t);
    EXPECT_EQ(beside[0], *found->second.begin());
    EXPECT_EQ(beside[1].Exists(), found->second.size() == 2);
    EXPECT_TRUE(!beside[1].Exists() || beside[1] == *found->second.rbegin());
    EXPECT_EQ(f.Across(t, beside[0]), beside[1]);
  }
}

// A cell finds its triangles, whichever block of cells their ids are in.
TEST_P(DelaunayCells, FindTheTriangleOppositeToACorner)
{
  const CellFiltration f = OfRandomPoints(GetParam());
  for (const TetrahedronId cell : f.Tetrahedra.Keys())
  {
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      const TriangleId found = f.GetTriangle(cell, corner);
      ASSERT_LT(found.Index(), f.TriangleCount());
      const auto sides = f.TriangleSides(found);
      EXPECT_TRUE(sides[0] == cell || sides[1] == cell) << cell.Value;
      EXPECT_EQ(f.Across(found, cell), f.Neighbours[cell][corner]);
      EXPECT_EQ(f.Opposite(cell, f.TrianglePoints(found)), f.Tetrahedra[cell][corner]);
    }
  }
}

void ExpectEdgesOfTriangles(const CellFiltration& f)
{
  for (const TriangleId t : f.Triangles())
  {
    const auto p = f.TrianglePoints(t);
    const auto edges = f.TriangleEdges(t);
    EXPECT_EQ(edges[0], f.FindEdge(p[1], p[2]));
    EXPECT_EQ(edges[1], f.FindEdge(p[0], p[2]));
    EXPECT_EQ(edges[2], f.FindEdge(p[0], p[1]));
    EXPECT_EQ(f.Edges[edges[0]], (std::array<SimplexId, 2>{ p[1], p[2] }));
  }
}

TEST_P(DelaunayCells, FindTheEdgesOppositeToCorners)
{
  ExpectEdgesOfTriangles(OfRandomPoints(GetParam()));
}

TEST_P(DelaunayCells, CompareTrianglesByRank)
{
  CellFiltration f = OfRandomPoints(GetParam());
  for (const bool some : { false, true })
  {
    f.TriangleIndistinct.assign(some ? f.TriangleCount() : 0, 0);
    for (std::size_t i = 0; some && i < f.TriangleCount(); i += 3)
    {
      f.TriangleIndistinct[TriangleId::At(i)] = 1;
    }
    f.Order();
    for (std::size_t i = 1; i < f.TriangleCount(); ++i)
    {
      const TriangleId before = f.TrianglesInOrder[TriangleRank::At(i - 1)];
      const TriangleId t = f.TrianglesInOrder[TriangleRank::At(i)];
      EXPECT_TRUE(f.RanksAbove(t, before));
      EXPECT_FALSE(f.RanksAbove(before, t));
      EXPECT_FALSE(f.RanksAbove(t, t));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Few, DelaunayCells, ::testing::Values(4, 5, 7, 30, 2000));

// The center of a sphere has more edges than places of one byte can number.
TEST(CellFiltration, EdgesOfAPointWithManyNeighboursAreFound)
{
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  std::vector<Point3> points{ { 0.0, 0.0, 0.0 } };
  while (points.size() <= 700)
  {
    const Point3 p{ normal(random), normal(random), normal(random) };
    points.push_back((1.0 / Length(p)) * p);
  }
  const CellFiltration f = DelaunayFiltration(points);
  ASSERT_GT(f.FirstEdge[1].Value, 600);
  ExpectEdgesOfTriangles(f);
}

}
