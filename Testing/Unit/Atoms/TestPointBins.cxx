// Points near a position, compared with a search through all points.

#include "Atoms/PointBins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using namespace isthmus;

namespace
{

std::vector<Point3> Cloud(std::size_t count, double size)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(-size, size);
  std::vector<Point3> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.push_back({ at(random), at(random), at(random) });
  }
  return points;
}

void ExpectAllNear(const std::vector<Point3>& points, double size, double reach)
{
  const PointBins bins(points, size);
  const std::vector<std::int64_t> order = bins.Order();
  EXPECT_EQ(std::set<std::int64_t>(order.begin(), order.end()).size(), points.size());
  std::vector<Point3> places = Cloud(50, 25.0);
  places.insert(places.end(), points.begin(), points.begin() + 5);
  places.push_back({ 1e6, 0.0, 0.0 });
  for (const Point3& place : places)
  {
    std::set<std::int64_t> expected;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Point3 d = points[i] - place;
      if (Dot(d, d) <= reach * reach)
      {
        expected.insert(static_cast<std::int64_t>(i));
      }
    }
    std::vector<std::int64_t> found;
    bins.Near(place, reach,
      [&](std::int64_t id, double squared)
      {
        const Point3 d = points[static_cast<std::size_t>(id)] - place;
        EXPECT_EQ(squared, Dot(d, d));
        found.push_back(id);
      });
    EXPECT_EQ(std::set<std::int64_t>(found.begin(), found.end()), expected);
    EXPECT_EQ(found.size(), expected.size());
    // The ranges of Order() contain each point exactly once.
    std::vector<std::int64_t> inRanges;
    bins.NearRanges(place, reach,
      [&](std::size_t first, std::size_t last)
      {
        inRanges.insert(inRanges.end(), order.begin() + static_cast<std::ptrdiff_t>(first),
          order.begin() + static_cast<std::ptrdiff_t>(last));
      });
    const std::set<std::int64_t> some(inRanges.begin(), inRanges.end());
    EXPECT_EQ(some.size(), inRanges.size());
    EXPECT_TRUE(std::includes(some.begin(), some.end(), expected.begin(), expected.end()));
  }
}

}

TEST(PointBins, AllNearAndNoOther)
{
  const std::vector<Point3> cloud = Cloud(2000, 20.0);
  for (const double size : { 0.7, 3.0, 6.0, 100.0 })
  {
    ExpectAllNear(cloud, size, 5.0);
  }
}

TEST(PointBins, AnOutlierDoesNoHarm)
{
  std::vector<Point3> points = Cloud(2000, 20.0);
  points.push_back({ 1e9, -1e9, 1e9 }); // a table of bins would have 10^28
  ExpectAllNear(points, 3.0, 6.0);
}

TEST(PointBins, PointsThatAreNotFiniteAreNearNone)
{
  for (const double stray : { 1e300, -1e300, HUGE_VAL, static_cast<double>(NAN) })
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::vector<Point3> points = Cloud(200, 20.0);
      points.push_back(points.front());
      points.back()[axis] = stray;
      ExpectAllNear(points, 3.0, 6.0);
    }
  }
}

TEST(PointBins, PointsOnTheBordersOfBinsAndOfTheBall)
{
  std::vector<Point3> points;
  for (int x = -4; x <= 4; ++x)
  {
    for (int y = -4; y <= 4; ++y)
    {
      points.push_back({ 3.0 * x, 3.0 * y, 0.0 });
    }
  }
  ExpectAllNear(points, 3.0, 6.0);
}

TEST(PointBins, NoPoints)
{
  const PointBins bins(std::vector<Point3>{}, 2.0);
  bins.Near({ 0.0, 0.0, 0.0 }, 10.0, [](std::int64_t, double) { ADD_FAILURE(); });
  EXPECT_TRUE(bins.Order().empty());
}
