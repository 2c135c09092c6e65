// Overlaps, unions, voids and pockets against Monte Carlo, points on spheres, and each other.

#include "BallOverlap.h"
#include "EmptySpace.h"
#include "MolecularPockets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

using namespace isthmus;

namespace
{

constexpr double Pi = 3.14159265358979323846;

double Distance(const Point3& a, const Point3& b)
{
  return std::sqrt(Dot(a - b, a - b));
}

Point3 OnSphere(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  const Point3 p{ normal(random), normal(random), normal(random) };
  return (1.0 / std::sqrt(Dot(p, p))) * p;
}

/// Accessible area of each atom's sphere that lies where `counts`, by random points; with its
/// error.
struct Estimate
{
  double Value = 0.0;
  double Variance = 0.0;
  double Error() const { return std::sqrt(this->Variance); }
};

template <typename Counts>
Estimate AreaByPoints(const std::vector<Ball>& balls, double probe, int perBall, Counts counts)
{
  std::mt19937 random(5);
  Estimate estimate;
  for (const Ball& ball : balls)
  {
    const double r = ball.Radius + probe;
    int hits = 0;
    for (int i = 0; i < perBall; ++i)
    {
      const Point3 p = ball.Centre + r * OnSphere(random);
      const bool free = std::none_of(balls.begin(), balls.end(),
        [&](const Ball& other)
        { return &other != &ball && Distance(p, other.Centre) < other.Radius + probe; });
      hits += free && counts(p) ? 1 : 0;
    }
    const double share = static_cast<double>(hits) / perBall;
    const double sphere = 4.0 * Pi * r * r;
    estimate.Value += sphere * share;
    estimate.Variance += sphere * sphere * share * (1.0 - share) / perBall;
  }
  return estimate;
}

/// Volume of the places in a cube around the origin for which `counts`.
template <typename Counts>
Estimate VolumeByPoints(double half, int number, Counts counts)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-half, half);
  int hits = 0;
  for (int i = 0; i < number; ++i)
  {
    hits += counts(Point3{ place(random), place(random), place(random) }) ? 1 : 0;
  }
  const double share = static_cast<double>(hits) / number;
  const double cube = std::pow(2.0 * half, 3);
  return { cube * share, cube * cube * share * (1.0 - share) / number };
}

bool Covered(const std::vector<Ball>& balls, double probe, const Point3& p)
{
  return std::any_of(balls.begin(), balls.end(),
    [&](const Ball& ball) { return Distance(p, ball.Centre) < ball.Radius + probe; });
}

/// Atoms of four sizes, spread over a sphere.
std::vector<Ball> Shell(int count, double radius)
{
  const double radii[] = { 1.76, 1.45, 1.65, 1.8 };
  std::vector<Ball> balls;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = Pi * (1.0 + std::sqrt(5.0)) * i;
    const double rho = std::sqrt(1.0 - z * z);
    balls.push_back(
      { { radius * rho * std::cos(angle), radius * rho * std::sin(angle), radius * z },
        radii[i % 4] });
  }
  return balls;
}

std::vector<Ball> Cloud(int count, double half, double smallest, double largest)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-half, half);
  std::uniform_real_distribution<double> radius(smallest, largest);
  std::vector<Ball> balls;
  for (int i = 0; i < count; ++i)
  {
    const Point3 p{ place(random), place(random), place(random) };
    balls.push_back({ p, radius(random) });
  }
  return balls;
}

}

TEST(BallOverlap, LensOfEqualBallsAsInTheTextbook)
{
  const Overlap<2> lens = Lens({ { 0, 0, 0 }, 1.0 }, { { 1, 0, 0 }, 1.0 });
  EXPECT_NEAR(lens.Volume, 5.0 * Pi / 12.0, 1e-14);
  EXPECT_NEAR(lens.Area[0], Pi, 1e-14);
  EXPECT_NEAR(lens.Area[1], Pi, 1e-14);
}

TEST(BallOverlap, HalvesOfThreeAgainstRandomPoints)
{
  // Acute, obtuse (the common points' foot lies outside of the triangle), very different sizes.
  const std::vector<std::vector<Ball>> triples{ { { { 0, 0, 0 }, 1.5 }, { { 1.4, 0, 0 }, 1.2 },
                                                  { { 0.5, 1.3, 0 }, 1.4 } },
    { { { -1.2, 0, 0 }, 1.5 }, { { 1.2, 0, 0 }, 1.5 }, { { 0, 0.3, 0 }, 1.1 } },
    { { { 0, 0, 0 }, 3.0 }, { { 2.6, 0, 0 }, 0.8 }, { { 2.4, 0.7, 0.3 }, 0.9 } } };
  for (const auto& b : triples)
  {
    const Overlap<3> half = HalfOfThree(b[0], b[1], b[2]);
    const auto in = [&](const Point3& p, std::size_t skip)
    {
      bool all = true;
      for (std::size_t k = 0; k < 3; ++k)
      {
        all = all && (k == skip || Distance(p, b[k].Centre) < b[k].Radius);
      }
      return all;
    };
    const Estimate volume = VolumeByPoints(4.0, 4000000, [&](const Point3& p) { return in(p, 3); });
    EXPECT_NEAR(2.0 * half.Volume, volume.Value, 4.0 * volume.Error());
    std::mt19937 random(9);
    for (std::size_t k = 0; k < 3; ++k)
    {
      int hits = 0;
      constexpr int number = 200000;
      for (int i = 0; i < number; ++i)
      {
        hits += in(b[k].Centre + b[k].Radius * OnSphere(random), k) ? 1 : 0;
      }
      const double share = static_cast<double>(hits) / number;
      const double sphere = 4.0 * Pi * b[k].Radius * b[k].Radius;
      EXPECT_NEAR(2.0 * half.Area[k], sphere * share,
        4.0 * sphere * std::sqrt(share * (1.0 - share) / number) + 1e-9);
    }
  }
}

TEST(EmptySpace, UnionOfRandomBallsAttachedOnesAmongThem)
{
  // Radii from 0.2 to 2.5: many balls are attached or hidden by others.
  const auto balls = Cloud(300, 6.0, 0.2, 2.5);
  PocketOptions options;
  options.ProbeRadius = 0.0;
  const PocketResult result = FindPockets(balls, options);
  const Estimate volume =
    VolumeByPoints(9.0, 2000000, [&](const Point3& p) { return Covered(balls, 0.0, p); });
  EXPECT_NEAR(result.UnionVolume, volume.Value, 3.0 * volume.Error());
  const Estimate area = AreaByPoints(balls, 0.0, 4000, [](const Point3&) { return true; });
  EXPECT_NEAR(result.UnionArea, area.Value, 3.0 * area.Error());
}

TEST(EmptySpace, SeparateAndNestedBalls)
{
  // A tetrahedron of lone balls, and one ball inside of another.
  const std::vector<Ball> balls{ { { 0, 0, 0 }, 1.0 }, { { 10, 0, 0 }, 2.0 }, { { 0, 10, 0 }, 1.5 },
    { { 0, 0, 10 }, 1.0 }, { { 10.2, 0, 0 }, 0.5 } };
  PocketOptions options;
  options.ProbeRadius = 0.0;
  const PocketResult result = FindPockets(balls, options);
  EXPECT_NEAR(result.UnionArea, 4.0 * Pi * (1.0 + 4.0 + 2.25 + 1.0), 1e-9);
  EXPECT_NEAR(result.UnionVolume, 4.0 * Pi / 3.0 * (1.0 + 8.0 + 3.375 + 1.0), 1e-9);
}

TEST(EmptySpace, ClosedShellIsOneVoid)
{
  const auto balls = Shell(400, 9.0);
  PocketOptions options;
  options.OuterRadius = 20.0;
  const PocketResult result = FindPockets(balls, options);
  ASSERT_EQ(result.Pockets.size(), 1u);
  const Pocket& pocket = result.Pockets[0];
  EXPECT_TRUE(pocket.Mouths.empty());
  const auto inside = [](const Point3& p) { return Dot(p, p) < 81.0; };
  const Estimate volume = VolumeByPoints(9.0, 2000000,
    [&](const Point3& p) { return inside(p) && !Covered(balls, options.ProbeRadius, p); });
  EXPECT_NEAR(pocket.Volume, volume.Value, 3.0 * volume.Error());
  const Estimate area = AreaByPoints(balls, options.ProbeRadius, 4000, inside);
  EXPECT_NEAR(pocket.Area, area.Value, 3.0 * area.Error());
  EXPECT_LT(Dot(pocket.Centre, pocket.Centre), 0.01);
}

TEST(EmptySpace, PocketsAndTheRestAddUp)
{
  // Wherever mouths cut, what pockets and the rest leave empty is what the balls do not fill.
  auto balls = Shell(400, 9.0);
  balls.erase(std::remove_if(
                balls.begin(), balls.end(), [](const Ball& ball) { return ball.Centre[2] > 8.0; }),
    balls.end());
  PocketOptions options;
  options.OuterRadius = 6.0;
  const PocketResult result = FindPockets(balls, options);
  ASSERT_GE(result.Pockets.size(), 1u);
  EXPECT_GE(result.Pockets[0].Mouths.size(), 1u);
  EXPECT_NEAR(result.PocketVolume + result.RestVolume + result.FullVolume, result.HullVolume, 1e-8);
  const Estimate area =
    AreaByPoints(balls, options.ProbeRadius, 4000, [](const Point3&) { return true; });
  EXPECT_NEAR(result.UnionArea, area.Value, 3.0 * area.Error());
  const Estimate volume = VolumeByPoints(
    14.0, 2000000, [&](const Point3& p) { return Covered(balls, options.ProbeRadius, p); });
  EXPECT_NEAR(result.UnionVolume, volume.Value, 3.0 * volume.Error());
}
