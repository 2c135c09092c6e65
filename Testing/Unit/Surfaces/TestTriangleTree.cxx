// The tree's distances against all triangles one by one: any number of them, needles and points
// among them, and any guess.
#include "Surfaces/TriangleTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{

using namespace isthmus;

/// Triangles at random positions: of all sizes, needles, and triangles degenerate to a point or a
/// line.
struct Soup
{
  Soup(std::size_t count, std::mt19937& random)
  {
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    const auto anywhere = [&] { return Point3{ place(random), place(random), place(random) }; };
    for (std::size_t t = 0; t < count; ++t)
    {
      const Point3 first = anywhere();
      const double size = std::pow(10.0, 2.0 * place(random) - 2.0);
      const Point3 second = first + size * anywhere();
      const Point3 third =
        t % 7 == 0 ? first : (t % 5 == 0 ? second + 1e-9 * anywhere() : first + size * anywhere());
      for (const Point3& corner : { first, t % 11 == 0 ? first : second, third })
      {
        this->Surface.Points.push_back(corner);
      }
      const auto next = static_cast<vtkIdType>(this->Surface.Points.size());
      this->Surface.Triangles.push_back({ next - 3, next - 2, next - 1 });
    }
  }

  double SquaredDistance(const Point3& x) const
  {
    double least = std::numeric_limits<double>::infinity();
    const std::vector<Point3>& points = this->Surface.Points;
    for (std::size_t t = 0; t + 2 < points.size(); t += 3)
    {
      least =
        std::min(least, SquaredDistanceToTriangle(x, { points[t], points[t + 1], points[t + 2] }));
    }
    return least;
  }

  TriangleMesh Surface;
};

TEST(TriangleTree, FindsTheNearestOfAnyNumber)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  for (const std::size_t count : { 1, 2, 7, 8, 9, 16, 17, 63, 64, 65, 129, 513, 3000 })
  {
    const Soup soup(count, random);
    const TriangleTree tree(soup.Surface);
    for (int n = 0; n < 200; ++n)
    {
      const Point3 x{ place(random), place(random), place(random) };
      EXPECT_NEAR(std::sqrt(tree.Find(x, -1).Squared), std::sqrt(soup.SquaredDistance(x)), 1e-12)
        << count << " triangles";
    }
  }
}

TEST(TriangleTree, PointsOnTheSurfaceAreAtZero)
{
  std::mt19937 random(4);
  const Soup soup(500, random);
  const TriangleTree tree(soup.Surface);
  for (const Point3& corner : soup.Surface.Points)
  {
    EXPECT_LT(tree.Find(corner, -1).Squared, 1e-30);
  }
}

TEST(TriangleTree, AnyGuessGivesIdenticalResults)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  const Soup soup(1000, random);
  const TriangleTree tree(soup.Surface);
  std::int64_t guess = -1;
  for (int n = 0; n < 500; ++n)
  {
    const Point3 x{ place(random), place(random), place(random) };
    const TriangleTree::Nearest alone = tree.Find(x, -1);
    const TriangleTree::Nearest guessed = tree.Find(x, guess);
    EXPECT_EQ(alone.Squared, guessed.Squared);
    guess = guessed.Guess;
    EXPECT_GE(guess, 0);
  }
}

/// Rounding of cylinders to float must never hide a nearer triangle: at any size, far from the
/// origin and seen from far away.
TEST(TriangleTree, IsExactAtAnySizeAndPlace)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (const double size : { 1e-30, 1e-6, 1.0, 1e6, 1e30 })
  {
    for (const double offset : { 0.0, 1e3, 1e7 })
    {
      Soup soup(1500, random);
      const Point3 shift{ offset * size, -offset * size, 2.0 * offset * size };
      for (Point3& point : soup.Surface.Points)
      {
        point = size * point + shift;
      }
      const TriangleTree tree(soup.Surface);
      for (int n = 0; n < 120; ++n)
      {
        const double reach = size * std::pow(10.0, n % 30 - 6);
        const Point3 x = shift + reach * Point3{ place(random), place(random), place(random) };
        const double expected = std::sqrt(soup.SquaredDistance(x));
        EXPECT_NEAR(std::sqrt(tree.Find(x, -1).Squared), expected,
          1e-12 * expected + 1e-15 * size * (1.0 + offset))
          << "size " << size << ", offset " << offset << ", reach " << reach;
      }
    }
  }
}

TEST(TriangleTree, EmptyIsInfinitelyFar)
{
  const TriangleTree tree(SurfaceView{});
  EXPECT_EQ(tree.Find({ 0.0, 0.0, 0.0 }, -1).Squared, std::numeric_limits<double>::infinity());
  EXPECT_EQ(tree.Find({ 0.0, 0.0, 0.0 }, -1).Guess, -1);
}

}
