// Atoms in exactly symmetric places, where many tetrahedra and triangles have the same value: pores
// and pockets are those of the same atoms moved by a millionth of the size.

#include "Core/Geometry.h"
#include "Pockets/MolecularPockets.h"
#include "Pockets/PoreProfile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace isthmus;

namespace
{

constexpr double AtomRadius = 1.7;
constexpr double Same = 1e-5; // of the size: the change that jitter may cause

/// Rings of atoms around the axis, every second one turned by half a step with `staggered`.
std::vector<Ball> TubeOfRings(
  int rings, double step, int around, bool staggered, double radius = 5.0)
{
  std::vector<Ball> atoms;
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * Pi * (i + (staggered && ring % 2 == 1 ? 0.5 : 0.0)) / around;
      atoms.push_back(
        { { radius * std::cos(angle), radius * std::sin(angle), step * ring }, AtomRadius });
    }
  }
  return atoms;
}

/// The places of a lattice (cubic, 2.8 apart) in a box that `isThere` keeps.
std::vector<Ball> Lattice(
  std::array<int, 3> count, const std::function<bool(const Point3& fromMiddle)>& isThere)
{
  constexpr double step = 2.8;
  std::vector<Ball> atoms;
  for (int k = 0; k < count[2]; ++k)
  {
    for (int j = 0; j < count[1]; ++j)
    {
      for (int i = 0; i < count[0]; ++i)
      {
        const Point3 p{ step * (i - 0.5 * (count[0] - 1)), step * (j - 0.5 * (count[1] - 1)),
          step * (k - 0.5 * (count[2] - 1)) };
        if (isThere(p))
        {
          atoms.push_back({ p, AtomRadius });
        }
      }
    }
  }
  return atoms;
}

double MeasureSize(const std::vector<Ball>& atoms)
{
  Bounds3 box{ atoms.front().Center, atoms.front().Center };
  for (const Ball& atom : atoms)
  {
    box.Add(atom.Center);
  }
  return box.Diagonal();
}

std::vector<Ball> AddJitter(std::vector<Ball> atoms, unsigned int seed)
{
  std::mt19937 random(seed);
  const double most = 1e-6 * MeasureSize(atoms);
  std::uniform_real_distribution<double> part(-most, most);
  for (Ball& atom : atoms)
  {
    atom.Center = atom.Center + Point3{ part(random), part(random), part(random) };
  }
  return atoms;
}

struct Numbers
{
  double Least, Span;
};

/// The narrowest radius and the span of each pore, the narrowest first.
std::vector<Numbers> MeasurePores(const std::vector<Ball>& atoms, const PoreOptions& options)
{
  std::vector<Numbers> found;
  for (const Pore& pore : FindPores(atoms, options))
  {
    double least = HUGE_VAL;
    for (const PoreSample& sample : pore.Samples)
    {
      least = std::min(least, sample.Radius);
    }
    found.push_back({ least, pore.Span });
  }
  std::sort(found.begin(), found.end(),
    [](const Numbers& a, const Numbers& b) { return a.Least < b.Least; });
  return found;
}

struct Input
{
  std::string Name;
  std::vector<Ball> Atoms;
};

/// Same number of pores, same narrowest radii, spans to a plane at each end.
void ExpectSamePores(const Input& input, std::size_t count, double least)
{
  const PoreOptions options;
  const double size = MeasureSize(input.Atoms);
  const auto exact = MeasurePores(input.Atoms, options);
  ASSERT_EQ(exact.size(), count) << input.Name;
  for (unsigned int seed = 1; seed <= 3; ++seed)
  {
    const auto jittered = MeasurePores(AddJitter(input.Atoms, seed), options);
    ASSERT_EQ(jittered.size(), count) << input.Name << ", jitter " << seed;
    for (std::size_t i = 0; i < count; ++i)
    {
      EXPECT_NEAR(exact[i].Least, jittered[i].Least, Same * size) << input.Name << ", " << seed;
      EXPECT_NEAR(exact[i].Least, least, Same * size) << input.Name;
      EXPECT_NEAR(exact[i].Span, jittered[i].Span, 2.1 * options.Spacing)
        << input.Name << ", " << seed;
    }
  }
}

}

TEST(ExactSymmetry, TubesOfRingsHaveTheirPore)
{
  for (const int around : { 8, 10 })
  {
    for (const bool staggered : { false, true })
    {
      for (const double step : { around == 8 ? 1.5 : 2.0 })
      {
        const int rings = static_cast<int>(24.0 / step);
        ExpectSamePores({ std::to_string(around) + (staggered ? " staggered" : " aligned") +
                            " at " + std::to_string(step),
                          TubeOfRings(rings, step, around, staggered) },
          1, 3.3);
      }
    }
  }
}

/// A channel wider than EndRadius ends at the hull; with jitter, flat tetrahedra there extended it
/// by up to 20 angstrom.
TEST(ExactSymmetry, WideTubesEndAtTheHull)
{
  struct Tube
  {
    double Radius, Step;
    int Around, Rings;
  };
  for (const Tube& t : { Tube{ 9.0, 2.0, 18, 14 }, Tube{ 8.0, 2.6, 14, 12 } })
  {
    const auto exact = TubeOfRings(t.Rings, t.Step, t.Around, false, t.Radius);
    const PoreOptions options;
    const double step = 4.0 * options.Spacing; // of a wide channel
    for (unsigned int seed = 0; seed <= 4; ++seed)
    {
      const auto pores = MeasurePores(seed == 0 ? exact : AddJitter(exact, seed), options);
      ASSERT_EQ(pores.size(), 1u) << t.Radius << ", " << seed;
      EXPECT_NEAR(pores[0].Least, t.Radius - AtomRadius, Same * MeasureSize(exact)) << seed;
      EXPECT_NEAR(pores[0].Span, t.Step * (t.Rings - 1), 2.1 * step) << t.Radius << ", " << seed;
    }
  }
}

TEST(ExactSymmetry, LatticeSlabsHaveTheirHoles)
{
  const auto off = [](const Point3& p, double x, double y)
  { return std::hypot(p[0] - x, p[1] - y); };
  // Nearest atoms to the axis in the middle between four: at 1.5 steps by 0.5.
  const double nearest = 2.8 * std::hypot(1.5, 0.5);
  ExpectSamePores(
    { "one hole", Lattice({ 10, 10, 9 }, [&](const Point3& p) { return off(p, 0, 0) > 3.0; }) }, 1,
    nearest - AtomRadius);
  ExpectSamePores({ "four holes",
                    Lattice({ 14, 14, 9 },
                      [&](const Point3& p)
                      {
                        return off(p, 8.4, 8.4) > 3.0 && off(p, -8.4, 8.4) > 3.0 &&
                          off(p, 8.4, -8.4) > 3.0 && off(p, -8.4, -8.4) > 3.0;
                      }) },
    4, nearest - AtomRadius);
}

TEST(ExactSymmetry, LatticeBlocksHaveTheirPockets)
{
  // A void in the middle; eight voids; dents in six faces; a hole through.
  const auto from = [](const Point3& p, const Point3& q) { return Distance(p, q); };
  const double d = 7.0;
  std::vector<Input> inputs;
  inputs.push_back({ "a void",
    Lattice({ 8, 8, 8 },
      [&](const Point3& p) {
        return from(p, { 0, 0, 0 }) > 3.0;
      }) });
  inputs.push_back({ "eight voids",
    Lattice({ 12, 12, 12 },
      [&](const Point3& p) {
        return from({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }, { 8.4, 8.4, 8.4 }) > 3.0;
      }) });
  inputs.push_back({ "dents",
    Lattice({ 9, 9, 9 },
      [&](const Point3& p)
      {
        const Point3 q{ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) };
        return from(q, { 0, 0, d + 1.4 }) > 3.0 && from(q, { 0, d + 1.4, 0 }) > 3.0 &&
          from(q, { d + 1.4, 0, 0 }) > 3.0;
      }) });
  inputs.push_back({ "a hole",
    Lattice({ 8, 8, 8 }, [&](const Point3& p) { return std::hypot(p[0], p[1]) > 3.0; }) });
  for (const Input& input : inputs)
  {
    const double size = MeasureSize(input.Atoms);
    const auto volumesOf = [&](const std::vector<Ball>& atoms)
    {
      PocketOptions options;
      options.MinimumVolume = 0.0;
      std::vector<std::array<double, 3>> found; // volume, area, radius
      for (const Pocket& pocket : FindPockets(atoms, options).Pockets)
      {
        if (pocket.Volume > Same * size)
        {
          found.push_back({ pocket.Volume, pocket.Area, pocket.Radius });
        }
      }
      std::sort(found.begin(), found.end());
      return found;
    };
    const auto exact = volumesOf(input.Atoms);
    std::cout << input.Name << ": " << exact.size() << " pockets, volumes from " << exact.front()[0]
              << " to " << exact.back()[0] << "\n";
    ASSERT_FALSE(exact.empty()) << input.Name;
    for (unsigned int seed = 1; seed <= 3; ++seed)
    {
      const auto jittered = volumesOf(AddJitter(input.Atoms, seed));
      ASSERT_EQ(exact.size(), jittered.size()) << input.Name << ", jitter " << seed;
      for (std::size_t i = 0; i < exact.size(); ++i)
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          EXPECT_NEAR(exact[i][k], jittered[i][k], Same * size * std::max(1.0, exact[i][k]))
            << input.Name << ", jitter " << seed << ", pocket " << i << ", number " << k;
        }
      }
    }
  }
}
