// Pairs of the Delaunay filtration of random points: the boundary of each triangle's filling, that
// every simplex is in one pair, and the numbers that Euler's formula requires.

#include "Persistence/DelaunayFiltration.h"
#include "Persistence/FiltrationPairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

using namespace isthmus;

namespace
{

CellFiltration OfRandomPoints(unsigned seed, std::size_t count)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  std::vector<Point3> points(count);
  for (Point3& p : points)
  {
    p = { place(random), place(random), place(random) };
  }
  return DelaunayFiltration(points);
}

/// Adds an element mod 2.
template <typename T>
void Toggle(std::set<T>& set, const T& element)
{
  if (!set.erase(element))
  {
    set.insert(element);
  }
}

/// The edges of a chain's boundary, by rank.
std::set<std::int64_t> GetBoundary(const CellFiltration& f, const TriangleChain& triangles)
{
  std::set<std::int64_t> ranks;
  for (const TriangleId t : triangles)
  {
    for (const EdgeId e : f.TriangleEdges(t))
    {
      Toggle(ranks, static_cast<std::int64_t>(f.RankOfEdge[e].Value));
    }
  }
  return ranks;
}

}

TEST(FiltrationPairs, AFillingIsBoundedByALoopThatItsEdgeCloses)
{
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    const CellFiltration f = OfRandomPoints(seed, 60);
    const FiltrationPairs pairs(f);
    std::set<std::int64_t> lows;
    std::size_t larger = 0;
    for (const TriangleId t : f.Triangles())
    {
      const EdgeId closed = pairs.LoopClosed(t);
      if (!closed.Exists())
      {
        EXPECT_TRUE(pairs.VoidFilled(t).Exists()); // no class of a convex hull remains
        continue;
      }
      EXPECT_FALSE(pairs.VoidFilled(t).Exists());
      EXPECT_EQ(pairs.LoopFilled(closed), t);
      const TriangleChain filling = pairs.Filling(t);
      larger += filling.size() > 1 ? 1 : 0;
      // No triangle occurs twice, and none after t.
      EXPECT_EQ(std::set<TriangleId>(filling.begin(), filling.end()).size(), filling.size());
      for (const TriangleId other : filling)
      {
        EXPECT_LE(f.RankOfTriangle[other].Value, f.RankOfTriangle[t].Value);
      }
      const std::set<std::int64_t> ranks = GetBoundary(f, filling);
      ASSERT_FALSE(ranks.empty());
      const auto low = static_cast<std::int64_t>(f.RankOfEdge[closed].Value);
      EXPECT_EQ(*ranks.rbegin(), low);
      EXPECT_TRUE(lows.insert(low).second);
    }
    EXPECT_GT(larger, 5u);
    // Edges that close no loop join components: one fewer than points.
    EXPECT_EQ(f.RankOfEdge.size() - lows.size(), f.Points.size() - 1);
  }
}
