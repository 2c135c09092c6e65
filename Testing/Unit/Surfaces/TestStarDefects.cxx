// Defects of random triangles, compared with a literal implementation of the definitions.

#include "Surfaces/SurfaceCleaning.h"
#include "Surfaces/SurfaceDefects.h"

#include <gtest/gtest.h>

#include <vtkSMPTools.h>

#include <map>
#include <random>
#include <set>
#include <string>

using namespace isthmus;

namespace
{

using Ids = std::vector<std::int64_t>;

std::set<std::int64_t> GetCorners(const Triangle& t)
{
  return { t.begin(), t.end() };
}

bool RunsFromTo(const Triangle& t, std::int64_t a, std::int64_t b)
{
  return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
}

/// The triangles at each edge, in ascending order.
std::map<std::pair<std::int64_t, std::int64_t>, Ids> TrianglesAtEdges(
  const std::vector<Triangle>& triangles)
{
  std::map<std::pair<std::int64_t, std::int64_t>, Ids> at;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (const std::int64_t a : triangles[t])
    {
      for (const std::int64_t b : triangles[t])
      {
        if (a < b)
        {
          at[{ a, b }].push_back(static_cast<std::int64_t>(t));
        }
      }
    }
  }
  return at;
}

/// The number of sets of triangles at `point` that are connected by edges at it, found by growing
/// each of them.
int FansAt(std::int64_t point, const std::vector<Triangle>& triangles)
{
  std::vector<std::set<std::int64_t>> left;
  for (const Triangle& t : triangles)
  {
    if (GetCorners(t).count(point))
    {
      left.push_back(GetCorners(t));
      left.back().erase(point);
    }
  }
  int fans = 0;
  for (; !left.empty(); ++fans)
  {
    std::set<std::int64_t> reached = left.back();
    left.pop_back();
    for (std::size_t i = 0; i < left.size();)
    {
      const auto other = left[i];
      if (std::none_of(
            other.begin(), other.end(), [&](std::int64_t p) { return reached.count(p) > 0; }))
      {
        ++i;
        continue;
      }
      reached.insert(other.begin(), other.end());
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    }
  }
  return fans;
}

struct Expected
{
  std::set<std::int64_t> Duplicate, Boundary, NonManifold, Flipped, Touching;
};

Expected ByDefinition(std::int64_t points, const std::vector<Triangle>& triangles)
{
  Expected expected;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (std::size_t earlier = 0; earlier < t; ++earlier)
    {
      if (GetCorners(triangles[t]) == GetCorners(triangles[earlier]))
      {
        expected.Duplicate.insert(static_cast<std::int64_t>(t));
      }
    }
  }
  for (const auto& [edge, at] : TrianglesAtEdges(triangles))
  {
    const auto [a, b] = edge;
    const auto up = [&, a = a, b = b](std::int64_t t)
    { return RunsFromTo(triangles[static_cast<std::size_t>(t)], a, b); };
    if (at.size() == 1)
    {
      expected.Boundary.insert(at[0]);
    }
    else if (at.size() > 2)
    {
      expected.NonManifold.insert(at.begin(), at.end());
    }
    else if (up(at[0]) == up(at[1]))
    {
      expected.Flipped.insert(at.begin(), at.end());
    }
  }
  for (std::int64_t p = 0; p < points; ++p)
  {
    if (FansAt(p, triangles) > 1)
    {
      expected.Touching.insert(p);
    }
  }
  return expected;
}

TriangleMesh RandomSoup(std::mt19937& random, std::int64_t points, int triangles)
{
  std::uniform_real_distribution<double> place(0.0, 1.0);
  std::uniform_int_distribution<std::int64_t> id(0, points - 1);
  TriangleMesh soup;
  for (std::int64_t p = 0; p < points; ++p)
  {
    soup.Points.push_back({ place(random), place(random), place(random) });
  }
  while (static_cast<int>(soup.Triangles.size()) < triangles)
  {
    const Triangle t{ id(random), id(random), id(random) };
    if (GetCorners(t).size() == 3)
    {
      soup.Triangles.push_back(t);
    }
  }
  return soup;
}

Ids ToIds(const std::set<std::int64_t>& ids)
{
  return { ids.begin(), ids.end() };
}

}

TEST(StarDefects, MatchTheDefinitionsOnRandomTriangles)
{
  std::mt19937 random(14);
  std::size_t met[5] = {};
  for (int run = 0; run < 2000; ++run)
  {
    const std::int64_t points = 4 + run % 9;
    const TriangleMesh soup = RandomSoup(random, points, 2 + run % 17);
    const Expected expected = ByDefinition(points, soup.Triangles);
    const SurfaceDefects found = FindDefects(soup);
    ASSERT_EQ(found.DuplicateTriangles, ToIds(expected.Duplicate)) << run;
    ASSERT_EQ(found.BoundaryTriangles, ToIds(expected.Boundary)) << run;
    ASSERT_EQ(found.NonManifoldTriangles, ToIds(expected.NonManifold)) << run;
    ASSERT_EQ(found.FlippedTriangles, ToIds(expected.Flipped)) << run;
    ASSERT_EQ(found.NonManifoldPoints, ToIds(expected.Touching)) << run;
    met[0] += expected.Duplicate.size();
    met[1] += expected.Boundary.size();
    met[2] += expected.NonManifold.size();
    met[3] += expected.Flipped.size();
    met[4] += expected.Touching.size();
  }
  for (const std::size_t count : met)
  {
    EXPECT_GT(count, 100U) << "a kind of defect that these runs hardly meet";
  }
}

TEST(StarDefects, DoNotDependOnTheNumberOfThreads)
{
  std::mt19937 random(15);
  const TriangleMesh soup = RandomSoup(random, 100000, 120000);
  std::vector<std::string> sentences;
  for (const int threads : { 1, 2, 7 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
      [&]
      {
        const SurfaceDefects found = FindDefects(soup);
        sentences.push_back(found.Message() + std::to_string(found.NonManifoldPoints.size()));
        EXPECT_TRUE(std::is_sorted(found.BoundaryTriangles.begin(), found.BoundaryTriangles.end()));
      });
  }
  EXPECT_EQ(sentences[0], sentences[1]);
  EXPECT_EQ(sentences[0], sentences[2]);
}

TEST(MergedPoints, AreTheFirstOfEachPlaceAsByComparingAllPairs)
{
  std::mt19937 random(16);
  std::uniform_int_distribution<int> coordinate(-1, 1);
  for (int run = 0; run < 200; ++run)
  {
    TriangleMesh soup = RandomSoup(random, 40, 30);
    for (Point3& p : soup.Points)
    {
      p = { -0.0 * coordinate(random), 0.5 * coordinate(random), 1.0 * coordinate(random) };
    }
    std::set<std::int64_t> used;
    for (const Triangle& t : soup.Triangles)
    {
      used.insert(t.begin(), t.end());
    }
    Ids firsts;
    for (const std::int64_t p : used)
    {
      const auto samePlace = [&](std::int64_t q) {
        return soup.Points[static_cast<std::size_t>(q)] == soup.Points[static_cast<std::size_t>(p)];
      };
      if (std::none_of(firsts.begin(), firsts.end(), samePlace))
      {
        firsts.push_back(p);
      }
    }
    Ids original;
    const TriangleMesh merged = MergePoints(soup, &original);
    ASSERT_EQ(original, firsts) << run;
    ASSERT_LT(firsts.size(), used.size()) << "nothing coincides";
    for (std::size_t i = 0; i < firsts.size(); ++i)
    {
      ASSERT_EQ(merged.Points[i], soup.Points[static_cast<std::size_t>(firsts[i])]);
    }
  }
}
