// Atoms and images in exact symmetry, with many simplices and cubes of equal value: bars are those
// of the same places or values moved by a millionth.

#include "Core/Geometry.h"
#include "Persistence/FullereneStability.h"
#include "ScalarImages.h"

#include <vtkFloatArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using isthmus::operator+;
using isthmus::operator*;
using isthmus::AlphaBars;
using isthmus::Bounds3;
using isthmus::DistanceBar;
using isthmus::Point3;
using isthmus::testing::Bar;
using isthmus::testing::CollectBars;
using isthmus::testing::Image;
using isthmus::testing::MakeView;

namespace
{

constexpr double Jitter = 1e-6;
constexpr double Same = 1e-5; // of the size, or of the range of values

/// Even permutations and signs of (a, b, c).
void AddSymmetric(double a, double b, double c, std::vector<Point3>& atoms)
{
  const Point3 cyclic[] = { { a, b, c }, { b, c, a }, { c, a, b } };
  for (const Point3& p : cyclic)
  {
    for (int signs = 0; signs < 8; ++signs)
    {
      const Point3 q{ signs & 1 ? -p[0] : p[0], signs & 2 ? -p[1] : p[1],
        signs & 4 ? -p[2] : p[2] };
      if (std::find(atoms.begin(), atoms.end(), q) == atoms.end())
      {
        atoms.push_back(q);
      }
    }
  }
}

std::vector<Point3> Buckminsterfullerene()
{
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Point3> atoms;
  AddSymmetric(0.0, 1.0, 3.0 * golden, atoms);
  AddSymmetric(1.0, 2.0 + golden, 2.0 * golden, atoms);
  AddSymmetric(2.0, 1.0 + 2.0 * golden, golden, atoms);
  for (Point3& p : atoms)
  {
    p = 0.71 * p;
  }
  return atoms;
}

std::vector<Point3> Dodecahedron()
{
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Point3> atoms;
  AddSymmetric(1.0, 1.0, 1.0, atoms);
  AddSymmetric(0.0, 1.0 / golden, golden, atoms);
  return atoms;
}

/// A cubic lattice without its inner places: a cage.
std::vector<Point3> HollowCube(int n)
{
  std::vector<Point3> atoms;
  for (int i = 0; i < n * n * n; ++i)
  {
    const int at[] = { i % n, i / n % n, i / (n * n) };
    if (std::any_of(at, at + 3, [n](int k) { return k == 0 || k == n - 1; }))
    {
      atoms.push_back({ 1.4 * at[0], 1.4 * at[1], 1.4 * at[2] });
    }
  }
  return atoms;
}

/// Rings of ten, as in a carbon nanotube's cross-section.
std::vector<Point3> Tube()
{
  std::vector<Point3> atoms;
  for (int i = 0; i < 120; ++i)
  {
    const double angle = 2.0 * isthmus::Pi * (i % 10 + 0.5 * (i / 10 % 2)) / 10.0;
    atoms.push_back({ 3.0 * std::cos(angle), 3.0 * std::sin(angle), 1.2 * (i / 10) });
  }
  return atoms;
}

using Numbers = std::vector<std::array<double, 3>>; ///< dimension, birth, death; sorted

void ExpectSame(
  const Numbers& exact, const Numbers& jittered, double scale, const std::string& name)
{
  ASSERT_EQ(exact.size(), jittered.size()) << name;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    EXPECT_EQ(exact[i][0], jittered[i][0]) << name;
    EXPECT_NEAR(exact[i][1], jittered[i][1], Same * scale) << name;
    EXPECT_NEAR(exact[i][2], jittered[i][2], Same * scale) << name;
  }
}

/// Bars to the grid of Same: equal ones are sorted alike regardless of their last digits.
Numbers SortBars(Numbers bars, double scale)
{
  const auto rounded = [scale](double x) { return std::round(x / (20.0 * Same * scale)); };
  std::sort(bars.begin(), bars.end(),
    [&](const std::array<double, 3>& a, const std::array<double, 3>& b)
    {
      return std::make_tuple(a[0], rounded(a[1]), a[2]) <
        std::make_tuple(b[0], rounded(b[1]), b[2]);
    });
  return bars;
}

}

TEST(ExactSymmetryOfBars, OfAtoms)
{
  const std::pair<std::string, std::vector<Point3>> cases[] = { { "C60", Buckminsterfullerene() },
    { "C20", Dodecahedron() }, { "hollow cube", HollowCube(6) }, { "tube", Tube() } };
  for (const auto& [name, atoms] : cases)
  {
    Bounds3 box{ atoms[0], atoms[0] };
    for (const Point3& p : atoms)
    {
      box.Add(p);
    }
    const double size = box.Diagonal();
    const auto barsOf = [size](const std::vector<Point3>& places)
    {
      Numbers bars;
      for (const DistanceBar& bar : AlphaBars(places))
      {
        if (bar.Length() > Same * size)
        {
          bars.push_back({ static_cast<double>(bar.Dimension), bar.Birth, bar.Death });
        }
      }
      return SortBars(bars, size);
    };
    const Numbers exact = barsOf(atoms);
    std::cout << name << ": " << exact.size() << " bars\n";
    EXPECT_FALSE(exact.empty());
    for (unsigned int seed = 1; seed <= 5; ++seed)
    {
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> part(-Jitter * size, Jitter * size);
      std::vector<Point3> moved = atoms;
      for (Point3& p : moved)
      {
        p = p + Point3{ part(random), part(random), part(random) };
      }
      ExpectSame(exact, barsOf(moved), size, name + ", jitter " + std::to_string(seed));
    }
  }
  // Known: the 12 pentagons and 20 hexagons of C60 (one depends on the others), and its cage.
  int rings = 0, cages = 0;
  for (const DistanceBar& bar : AlphaBars(Buckminsterfullerene()))
  {
    rings += bar.Dimension == 1 && bar.Length() > 0.1 ? 1 : 0;
    cages += bar.Dimension == 2 && bar.Length() > 0.1 ? 1 : 0;
  }
  EXPECT_EQ(rings, 31);
  EXPECT_EQ(cages, 1);
}

TEST(ExactSymmetryOfBars, OfImages)
{
  const auto waves = [](double x, double y, double z)
  { return std::cos(x) + std::cos(y) + std::cos(z); };
  const auto steps = [](double x, double y, double z)
  { return std::round(2.0 * std::cos(x)) * std::round(2.0 * std::cos(y)) + std::round(z); };
  const auto shell = [](double x, double y, double z) {
    return std::abs(std::max({ std::abs(x), std::abs(y), std::abs(z) }) - 3.0);
  };
  const std::pair<std::string, std::function<double(double, double, double)>> cases[] = {
    { "waves", waves }, { "steps", steps }, { "shell", shell }
  };
  for (const auto& [name, f] : cases)
  {
    const auto image = Image<vtkFloatArray>(15, f);
    double range[2];
    image->GetPointData()->GetScalars()->GetRange(range);
    const double scale = range[1] - range[0];
    for (const bool superlevel : { false, true })
    {
      const auto barsOf = [&](vtkImageData* of)
      {
        Numbers bars;
        for (const Bar& bar : CollectBars(MakeView(of), superlevel))
        {
          if (std::abs(bar[2] - bar[1]) > 3.0 * Same * scale || std::isinf(bar[2]))
          {
            bars.push_back({ bar[0], bar[1], std::isinf(bar[2]) ? HUGE_VAL : bar[2] });
          }
        }
        return SortBars(bars, scale);
      };
      const Numbers exact = barsOf(image);
      std::cout << name << ": " << exact.size() << " bars\n";
      for (unsigned int seed = 1; seed <= 3; ++seed)
      {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> part(-Jitter * scale, Jitter * scale);
        const auto moved = Image<vtkFloatArray>(
          15, [&, f = f](double x, double y, double z) { return f(x, y, z) + part(random); });
        const Numbers jittered = barsOf(moved);
        ASSERT_EQ(exact.size(), jittered.size()) << name << ", jitter " << seed;
        for (std::size_t i = 0; i < exact.size(); ++i)
        {
          EXPECT_EQ(exact[i][0], jittered[i][0]) << name;
          EXPECT_NEAR(exact[i][1], jittered[i][1], Same * scale) << name;
          EXPECT_TRUE(
            exact[i][2] == jittered[i][2] || std::abs(exact[i][2] - jittered[i][2]) <= Same * scale)
            << name << ": " << exact[i][2] << " " << jittered[i][2];
        }
      }
    }
  }
}
