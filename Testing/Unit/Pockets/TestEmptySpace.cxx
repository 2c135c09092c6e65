// Overlaps, unions, voids and pockets, compared with Monte Carlo, points on spheres, and each
// other.

#include "Atoms/BallOverlap.h"
#include "Core/Geometry.h"
#include "Pockets/EmptySpace.h"
#include "Pockets/MolecularPockets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <random>

using namespace isthmus;

namespace
{

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
      const Point3 p = ball.Center + r * OnSphere(random);
      const bool free = std::none_of(balls.begin(), balls.end(),
        [&](const Ball& other)
        { return &other != &ball && Distance(p, other.Center) < other.Radius + probe; });
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

bool IsCovered(const std::vector<Ball>& balls, double probe, const Point3& p)
{
  return std::any_of(balls.begin(), balls.end(),
    [&](const Ball& ball) { return Distance(p, ball.Center) < ball.Radius + probe; });
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
    const Overlap<3> half = HalfTripleIntersection(b[0], b[1], b[2]);
    const auto in = [&](const Point3& p, std::size_t skip)
    {
      bool all = true;
      for (std::size_t k = 0; k < 3; ++k)
      {
        all = all && (k == skip || Distance(p, b[k].Center) < b[k].Radius);
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
        hits += in(b[k].Center + b[k].Radius * OnSphere(random), k) ? 1 : 0;
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
    VolumeByPoints(9.0, 2000000, [&](const Point3& p) { return IsCovered(balls, 0.0, p); });
  EXPECT_NEAR(result.UnionVolume, volume.Value, 3.0 * volume.Error());
  const Estimate area = AreaByPoints(balls, 0.0, 4000, [](const Point3&) { return true; });
  EXPECT_NEAR(result.UnionArea, area.Value, 3.0 * area.Error());
}

TEST(EmptySpace, UnionOfFourBallsThreeOfWhichMeetOutside)
{
  // Parts of the triple intersections lie outside the tetrahedron.
  const double a = 1.2 / std::sqrt(8.0);
  const std::vector<Ball> balls{ { { a, a, a }, 1.0 }, { { a, -a, -a }, 1.0 },
    { { -a, a, -a }, 1.0 }, { { -a, -a, a }, 1.0 } };
  PocketOptions options;
  options.ProbeRadius = 0.0;
  const PocketResult result = FindPockets(balls, options);
  const Estimate volume =
    VolumeByPoints(1.9, 1000000, [&](const Point3& p) { return IsCovered(balls, 0.0, p); });
  EXPECT_NEAR(result.UnionVolume, volume.Value, 3.0 * volume.Error());
  const Estimate area = AreaByPoints(balls, 0.0, 40000, [](const Point3&) { return true; });
  EXPECT_NEAR(result.UnionArea, area.Value, 3.0 * area.Error());
}

TEST(EmptySpace, SeparateAndNestedBalls)
{
  // A tetrahedron of separate balls, and one ball inside of another.
  const std::vector<Ball> balls{ { { 0, 0, 0 }, 1.0 }, { { 10, 0, 0 }, 2.0 }, { { 0, 10, 0 }, 1.5 },
    { { 0, 0, 10 }, 1.0 }, { { 10.2, 0, 0 }, 0.5 } };
  PocketOptions options;
  options.ProbeRadius = 0.0;
  const PocketResult result = FindPockets(balls, options);
  EXPECT_NEAR(result.UnionArea, 4.0 * Pi * (1.0 + 4.0 + 2.25 + 1.0), 1e-9);
  EXPECT_NEAR(result.UnionVolume, 4.0 * Pi / 3.0 * (1.0 + 8.0 + 3.375 + 1.0), 1e-9);
}

namespace
{

UnionMeasure MeasureBallUnion(const std::vector<Ball>& balls, double probe)
{
  PocketOptions options;
  options.ProbeRadius = probe;
  const PocketResult result = FindPockets(balls, options);
  EXPECT_TRUE(result.Pockets.empty());
  return { result.UnionVolume, result.UnionArea };
}

}

TEST(EmptySpace, UnionOfFewBallsOrOfBallsInALine)
{
  const UnionMeasure none = MeasureBallUnion({}, 1.4);
  EXPECT_EQ(none.Area, 0.0);
  EXPECT_EQ(none.Volume, 0.0);
  const UnionMeasure one = MeasureBallUnion({ { { 7, -3, 2 }, 1.5 } }, 1.4);
  EXPECT_NEAR(one.Area, 4.0 * Pi * 2.9 * 2.9, 1e-9);
  EXPECT_NEAR(one.Volume, 4.0 / 3.0 * Pi * 2.9 * 2.9 * 2.9, 1e-9);
  // Balls of radius r at a distance d have a lens of two caps of height r - d / 2.
  for (const int count : { 2, 3, 5 })
  {
    std::vector<Ball> row;
    for (int i = 0; i < count; ++i)
    {
      row.push_back({ { 1.0 * i, 2.0 * i, 2.0 * i }, 2.0 }); // at a distance of 3, along no axis
    }
    const double height = 2.0 - 1.5;
    const double lens = 2.0 * Pi * height * height * (2.0 - height / 3.0);
    const UnionMeasure line = MeasureBallUnion(row, 0.0);
    EXPECT_NEAR(line.Volume, count * 32.0 * Pi / 3.0 - (count - 1) * lens, 1e-9) << count;
    EXPECT_NEAR(line.Area, count * 16.0 * Pi - (count - 1) * 2.0 * 2.0 * Pi * 2.0 * height, 1e-9)
      << count;
  }
  // One inside of another, two that do not meet, and one far away.
  const UnionMeasure apart = MeasureBallUnion(
    { { { 0, 0, 0 }, 2.0 }, { { 0.5, 0, 0 }, 1.0 }, { { 9, 0, 0 }, 1.0 }, { { 1e6, 0, 0 }, 1.0 } },
    0.0);
  EXPECT_NEAR(apart.Area, 4.0 * Pi * (4.0 + 1.0 + 1.0), 1e-9);
  EXPECT_NEAR(apart.Volume, 4.0 / 3.0 * Pi * (8.0 + 1.0 + 1.0), 1e-9);
}

TEST(EmptySpace, UnionOfBallsInOnePlane)
{
  // Three that meet pairwise and all together, a ring, and a sheet, in a plane along no axis; balls
  // inside of these but out of the plane add tetrahedra, without any effect.
  std::vector<std::vector<Ball>> flat(3);
  const auto at = [](double u, double v) { return Point3{ u, 0.6 * v, 0.8 * v }; };
  flat[0] = { { at(0, 0), 1.5 }, { at(2, 0), 1.4 }, { at(0.7, 1.6), 1.2 } };
  for (int i = 0; i < 8; ++i)
  {
    flat[1].push_back({ at(3.0 * std::cos(i * Pi / 4.0), 3.0 * std::sin(i * Pi / 4.0)), 2.9 });
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int i = 0; i < 60; ++i)
  {
    flat[2].push_back({ at(9.0 * any(random), 9.0 * any(random)), 0.3 + 1.5 * any(random) });
  }
  for (const std::vector<Ball>& balls : flat)
  {
    std::vector<Ball> solid = balls;
    for (const double side : { -0.1, 0.1 })
    {
      solid.push_back({ balls[0].Center + side * Point3{ 0.0, 0.8, -0.6 }, 0.1 });
    }
    const UnionMeasure plane = MeasureBallUnion(balls, 0.0);
    PocketOptions options;
    options.ProbeRadius = 0.0;
    const PocketResult expected = FindPockets(solid, options);
    EXPECT_GT(expected.HullVolume, 0.0);
    EXPECT_NEAR(plane.Area, expected.UnionArea, 1e-8);
    EXPECT_NEAR(plane.Volume, expected.UnionVolume, 1e-8);
    const Estimate area = AreaByPoints(balls, 0.0, 4000, [](const Point3&) { return true; });
    EXPECT_NEAR(plane.Area, area.Value, 3.0 * area.Error());
  }
  // One atom slightly out of the plane.
  const UnionMeasure ring = MeasureBallUnion(flat[1], 0.0);
  flat[1][0].Center = flat[1][0].Center + Point3{ 0.0, 8e-7, -6e-7 };
  PocketOptions options;
  options.ProbeRadius = 0.0;
  const PocketResult moved = FindPockets(flat[1], options);
  EXPECT_GT(moved.HullVolume, 0.0);
  EXPECT_NEAR(ring.Area, moved.UnionArea, 1e-4);
  EXPECT_NEAR(ring.Volume, moved.UnionVolume, 1e-4);
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
    [&](const Point3& p) { return inside(p) && !IsCovered(balls, options.ProbeRadius, p); });
  EXPECT_NEAR(pocket.Volume, volume.Value, 3.0 * volume.Error());
  const Estimate area = AreaByPoints(balls, options.ProbeRadius, 4000, inside);
  EXPECT_NEAR(pocket.Area, area.Value, 3.0 * area.Error());
  EXPECT_LT(Dot(pocket.Center, pocket.Center), 0.01);
}

TEST(EmptySpace, PocketsAndTheRestSumToTheWhole)
{
  // Wherever mouths cut, the pockets and the rest together have the volume that the balls do not
  // fill.
  auto balls = Shell(400, 9.0);
  balls.erase(std::remove_if(
                balls.begin(), balls.end(), [](const Ball& ball) { return ball.Center[2] > 8.0; }),
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
    14.0, 2000000, [&](const Point3& p) { return IsCovered(balls, options.ProbeRadius, p); });
  EXPECT_NEAR(result.UnionVolume, volume.Value, 3.0 * volume.Error());
}

namespace
{

/// A cube of side 40 with eight atoms at its corners and a cloud inside: its hull is the cube.
std::vector<Ball> CloudInACube()
{
  auto balls = Cloud(500, 13.0, 1.2, 1.9);
  for (int i = 0; i < 8; ++i)
  {
    balls.push_back({ { i & 1 ? 20.0 : -20.0, i & 2 ? 20.0 : -20.0, i & 4 ? 20.0 : -20.0 }, 1.7 });
  }
  return balls;
}

/// Two rooms, mirror images in z = 0, separated there by a ring of atoms with a narrow passage.
std::vector<Ball> TwoRooms(double neck)
{
  std::vector<Ball> balls;
  for (const double side : { -1.0, 1.0 })
  {
    for (const Ball& ball : Shell(300, 8.0))
    {
      const Ball moved{ { ball.Center[0], ball.Center[1], side * (ball.Center[2] + 7.0) }, 1.7 };
      if (side * moved.Center[2] > 0.8)
      {
        balls.push_back(moved);
      }
    }
  }
  for (double r = neck; r < 9.0; r += 1.5)
  {
    const int count = static_cast<int>(2.0 * Pi * r / 1.5);
    for (int i = 0; i < count; ++i)
    {
      const double angle = 2.0 * Pi * (i + 0.5) / count;
      balls.push_back({ { r * std::cos(angle), r * std::sin(angle), 0.0 }, 1.7 });
    }
  }
  return balls;
}

}

TEST(EmptySpace, VolumeDoesNotDependOnMouths)
{
  // Pockets, the rest and the atoms fill a cube, whatever radii separate them; random points
  // confirm it.
  const auto balls = CloudInACube();
  const Estimate empty =
    VolumeByPoints(20.0, 300000, [&](const Point3& p) { return !IsCovered(balls, 1.4, p); });
  std::vector<double> pocketVolumes;
  for (const auto& [inner, outer] : std::vector<std::pair<double, double>>{
         { 1.5, 2.2 }, { 1.7, 3.1 }, { 2.0, 4.5 }, { 1.4, 9.0 } })
  {
    PocketOptions options;
    options.InnerRadius = inner;
    options.OuterRadius = outer;
    const PocketResult result = FindPockets(balls, options);
    EXPECT_NEAR(result.HullVolume, 64000.0, 1e-6);
    EXPECT_NEAR(result.PocketVolume + result.RestVolume, empty.Value, 3.0 * empty.Error());
    EXPECT_NEAR(
      result.HullVolume - result.PocketVolume - result.RestVolume, result.FullVolume, 1e-6);
    EXPECT_GT(result.Pockets.size(), 0u);
    pocketVolumes.push_back(result.PocketVolume);
  }
  EXPECT_GT(pocketVolumes.back(), pocketVolumes.front());
}

TEST(EmptySpace, AMouthDividesTheVolumeIntoEqualHalves)
{
  for (const double neck : { 3.4, 3.8, 4.2 }) // its ball has the radius 1.7, 2.1, 2.5
  {
    const auto balls = TwoRooms(neck);
    PocketOptions options;
    options.InnerRadius = 2.6;
    options.OuterRadius = 20.0;
    const PocketResult result = FindPockets(balls, options);
    ASSERT_EQ(result.Pockets.size(), 2u) << neck;
    const double whole = result.Pockets[0].Volume + result.Pockets[1].Volume;
    const Estimate empty = VolumeByPoints(16.0, 500000,
      [&](const Point3& p)
      {
        const double z = std::fabs(p[2]) - 7.0;
        return p[0] * p[0] + p[1] * p[1] + z * z < 64.0 && !IsCovered(balls, 1.4, p);
      });
    EXPECT_NEAR(whole, empty.Value, 3.0 * empty.Error()) << neck;
    EXPECT_NEAR(result.Pockets[0].Volume, 0.5 * whole, 1e-6 * whole) << neck;
    EXPECT_NEAR(result.Pockets[0].Area, result.Pockets[1].Area, 1e-6 * result.Pockets[0].Area);
    // As one pocket they are the same space.
    options.InnerRadius = 1.5;
    const PocketResult joined = FindPockets(balls, options);
    ASSERT_GE(joined.Pockets.size(), 1u) << neck; // small ones may exist outside
    EXPECT_NEAR(joined.Pockets[0].Volume, whole, 1e-6 * whole) << neck;
  }
}

TEST(EmptySpace, APocketsVolumeIsNearThatOfItsTetrahedra)
{
  // At a mouth balls are cut with their sectors; compared with a cut by its triangles.
  const auto balls = CloudInACube();
  const PocketResult result = FindPockets(balls, {});
  ASSERT_FALSE(result.Pockets.empty());
  const Pocket& pocket = *std::max_element(result.Pockets.begin(), result.Pockets.end(),
    [](const Pocket& a, const Pocket& b) { return a.Volume < b.Volume; });
  ASSERT_FALSE(pocket.Mouths.empty());
  const auto inside = [&](const Point3& p)
  {
    return std::any_of(pocket.Cells.begin(), pocket.Cells.end(),
      [&](const PocketCell& cell)
      {
        const auto at = [&](std::size_t k)
        { return balls[static_cast<std::size_t>(cell.Atoms[k])].Center; };
        int signs = 0;
        for (std::size_t k = 0; k < 4; ++k)
        {
          const Point3 a = at((k + 1) % 4);
          const Point3 normal = Cross(at((k + 2) % 4) - a, at((k + 3) % 4) - a);
          signs += Dot(p - a, normal) * Dot(at(k) - a, normal) >= 0.0 ? 1 : 0;
        }
        return signs == 4;
      });
  };
  const Estimate exact = VolumeByPoints(
    14.0, 200000, [&](const Point3& p) { return inside(p) && !IsCovered(balls, 1.4, p); });
  std::cout << "volume " << pocket.Volume << ", cut by triangles " << exact.Value << " +- "
            << exact.Error() << "\n";
  EXPECT_NEAR(pocket.Volume, exact.Value, 0.03 * exact.Value + 3.0 * exact.Error());
}

TEST(EmptySpace, OpenAreaOfATriangleIsExactWhereDiscsReachAcross)
{
  // Against midpoints of 400 x 400 cells of the parallelogram, of which each near a border is wrong
  // by at most its area: less than 10 rows of them, 0.5 % of the triangle.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  int across = 0;
  for (int trial = 0; trial < 60; ++trial)
  {
    std::array<Point3, 3> corners;
    std::array<double, 3> radii{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = { 6.0 * part(random), 6.0 * part(random), 6.0 * part(random) };
      radii[k] = trial % 5 == 0 && k == 2 ? 0.0 : 2.6 * part(random);
    }
    const Point3 u = corners[1] - corners[0];
    const Point3 v = corners[2] - corners[0];
    const double whole = 0.5 * Length(Cross(u, v));
    constexpr int n = 400;
    int open = 0, all = 0;
    for (int i = 0; i < n * n; ++i)
    {
      const double s = (i % n + 0.5) / n, t = (i / n + 0.5) / n;
      if (s + t < 1.0)
      {
        const Point3 x = corners[0] + s * u + t * v;
        bool isOpen = true;
        for (std::size_t k = 0; k < 3; ++k)
        {
          isOpen = isOpen && Distance(x, corners[k]) >= radii[k];
        }
        open += isOpen ? 1 : 0;
        ++all;
      }
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double height = 2.0 * whole / Distance(corners[(k + 1) % 3], corners[(k + 2) % 3]);
      across += radii[k] > height ? 1 : 0;
    }
    EXPECT_NEAR(MeasureOpenArea(corners, radii), whole * open / all, 0.005 * whole) << trial;
  }
  EXPECT_GT(across, 10);
}
