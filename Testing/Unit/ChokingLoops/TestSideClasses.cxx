// Which classes of loops bound inside, and which outside: on linked and knotted rings, on a ring in
// a ring with a wall far thinner than the samples, on noise; and the classes that a tetrahedral
// mesh of both sides by TetGen fills.

#include "BeadShapes.h"
#include "ChokingLoops/MeshLoops.h"
#include "ChokingLoops/SideClasses.h"
#include "ChokingSurfaces.h"
#include "LoopChecks.h"
#include "SharedData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr std::array<SpaceSide, 2> BothSides{ SpaceSide::Inside, SpaceSide::Outside };

/// The classes that bound on each side have rank g, and a class is the sum of its parts.
void ExpectHalves(const SurfaceHomology& homology, const SideClasses& sides)
{
  std::array<HomologySpan, 2> spans;
  for (std::size_t i = 0; i < homology.Rank(); ++i)
  {
    HomologyClass c = homology.GetClass(homology.Loop(i));
    HomologyClass sum = c;
    for (const SpaceSide side : BothSides)
    {
      const HomologyClass part = sides.Part(c, side);
      EXPECT_TRUE(sides.Bounds(part, side));
      spans[static_cast<std::size_t>(side)].Add(part);
      std::transform(sum.begin(), sum.end(), part.begin(), sum.begin(), std::bit_xor<>());
    }
    EXPECT_TRUE(IsZero(sum));
  }
  EXPECT_EQ(spans[0].Rank(), homology.Rank() / 2);
  EXPECT_EQ(spans[1].Rank(), homology.Rank() / 2);
}

/// A closed tube around a curve of period 1; point (i, j) is i * across + j.
TriangleMesh TubeAround(
  const std::function<Point3(double)>& curve, double radius, int around, int across)
{
  TriangleMesh tube = Torus(3.0, 1.0, around, across); // its triangles
  Point3 up{ 0.1, 0.2, 0.97 };
  for (int i = 0; i < around; ++i)
  {
    const double u = static_cast<double>(i) / around;
    const Point3 center = curve(u);
    const Point3 step = curve(u + 1e-5) - curve(u - 1e-5);
    const Point3 along = (1.0 / Length(step)) * step;
    const Point3 across1 = (1.0 / Length(Cross(along, up))) * Cross(along, up);
    const Point3 across2 = Cross(across1, along);
    for (int j = 0; j < across; ++j)
    {
      const double angle = 2.0 * M_PI * (j + 0.5 * (i % 2)) / across;
      tube.Points[static_cast<std::size_t>(i * across + j)] =
        center + (radius * std::cos(angle)) * across1 + (radius * std::sin(angle)) * across2;
    }
  }
  return tube;
}

Point3 Circle(const Point3& center, std::size_t axis, double radius, double u)
{
  Point3 p = center;
  p[(axis + 1) % 3] += radius * std::cos(2.0 * M_PI * u);
  p[(axis + 2) % 3] += radius * std::sin(2.0 * M_PI * u);
  return p;
}

TriangleMesh Inverted(TriangleMesh mesh)
{
  for (Triangle& t : mesh.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  return mesh;
}

/// The class of the loop of points first, first + step, ...
HomologyClass ClassOf(const SurfaceAdjacency& surface, const SurfaceHomology& homology,
  SimplexId first, SimplexId step, SimplexId count)
{
  std::vector<SimplexId> loop;
  for (SimplexId i = 0; i < count; ++i)
  {
    loop.push_back(first + i * step);
  }
  return homology.GetClass(LoopEdges(surface, loop));
}

/// The sum of the classes of a feature's loops.
HomologyClass ClassOfLoops(ChokingLoops& loops, std::size_t feature)
{
  HomologyClass sum = loops.Homology().GetClass({});
  for (const auto& loop : loops.GetMembrane(feature).Loops)
  {
    const HomologyClass c = loops.Homology().GetClass(LoopEdges(loops.Adjacency(), loop));
    std::transform(sum.begin(), sum.end(), c.begin(), sum.begin(), std::bit_xor<>());
  }
  return sum;
}

}

// The loop across the tube bounds inside. The loops along two linked rings bound nowhere: outside
// only the sum with the loop across the other ring does.
TEST(SideClasses, LinkedRings)
{
  constexpr int around = 48, across = 12;
  const TriangleMesh one = TubeAround(
    [](double u) {
      return Circle({ 0, 0, 0 }, 2, 1.5, u);
    },
    0.4, around, across);
  const TriangleMesh other = TubeAround(
    [](double u) {
      return Circle({ 1.5, 0, 0 }, 1, 1.5, u);
    },
    0.4, around, across);
  for (const bool isInverted : { false, true })
  {
    const auto shift = static_cast<SimplexId>(one.Points.size());
    const TriangleMesh both = Together(isInverted ? Inverted(one) : one, other);
    const SurfaceAdjacency surface(both);
    const SurfaceHomology homology(surface);
    const SideClasses sides(surface, homology);
    ExpectHalves(homology, sides);
    std::array<HomologyClass, 2> round, along;
    for (const SimplexId k : { 0, 1 })
    {
      round[At(k)] = ClassOf(surface, homology, k * shift, 1, across);
      // Points (i, 0) of even and odd i are half a step apart, and still neighbours.
      along[At(k)] = ClassOf(surface, homology, k * shift, across, around);
      EXPECT_TRUE(sides.Bounds(round[At(k)], SpaceSide::Inside));
      EXPECT_FALSE(sides.Bounds(round[At(k)], SpaceSide::Outside));
      EXPECT_FALSE(sides.Bounds(along[At(k)], SpaceSide::Inside));
      EXPECT_FALSE(sides.Bounds(along[At(k)], SpaceSide::Outside));
    }
    for (const std::size_t k : { 0U, 1U })
    {
      HomologyClass sum = along[k];
      std::transform(sum.begin(), sum.end(), round[1 - k].begin(), sum.begin(), std::bit_xor<>());
      const HomologyClass own = sum;
      HomologyClass framed = sum;
      std::transform(
        framed.begin(), framed.end(), round[k].begin(), framed.begin(), std::bit_xor<>());
      EXPECT_NE(sides.Bounds(own, SpaceSide::Outside), sides.Bounds(framed, SpaceSide::Outside))
        << "one framing of the ring along itself";
    }
  }
}

TEST(SideClasses, TrefoilTube)
{
  const TriangleMesh tube = TubeAround(
    [](double u)
    {
      const double t = 2.0 * M_PI * u;
      return Point3{ std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t),
        -std::sin(3.0 * t) };
    },
    0.35, 200, 16);
  const SurfaceAdjacency surface(tube);
  const SurfaceHomology homology(surface);
  const SideClasses sides(surface, homology);
  ExpectHalves(homology, sides);
  EXPECT_TRUE(sides.Bounds(ClassOf(surface, homology, 0, 1, 16), SpaceSide::Inside));
}

// A ring-shaped cavity in a ring. Inside is the wall between them: there the two loops along bound
// together, and so do the two across.
TEST(SideClasses, WallThinnerThanSamples)
{
  constexpr int around = 60, across = 20;
  for (const double wall : { 0.1, 1e-9 })
  {
    const TriangleMesh outside = Torus(1.0, 0.3, around, across);
    const auto shift = static_cast<SimplexId>(outside.Points.size());
    const TriangleMesh shell = Together(outside, Inverted(Torus(1.0, 0.3 - wall, around, across)));
    const SurfaceAdjacency surface(shell);
    const SurfaceHomology homology(surface);
    const SideClasses sides(surface, homology);
    ExpectHalves(homology, sides);
    const HomologyClass outer = ClassOf(surface, homology, 0, 1, across);
    const HomologyClass inner = ClassOf(surface, homology, shift, 1, across);
    EXPECT_FALSE(sides.Bounds(outer, SpaceSide::Inside));
    EXPECT_TRUE(sides.Bounds(inner, SpaceSide::Outside)) << "the cavity is outside";
    HomologyClass both = outer;
    std::transform(both.begin(), both.end(), inner.begin(), both.begin(), std::bit_xor<>());
    EXPECT_TRUE(sides.Bounds(both, SpaceSide::Inside));

    ChokingLoops loops{ TriangleMesh(shell) };
    const SideClasses ownSides(loops.Adjacency(), loops.Homology());
    const auto [handles, tunnels] = Generators(loops);
    EXPECT_EQ(handles.size(), 2U);
    EXPECT_EQ(tunnels.size(), 2U);
    for (const std::size_t i : handles)
    {
      const ShapeFeature& f = loops.Diagram().Features[i];
      EXPECT_EQ(f.Trusted, wall > 0.05);
      EXPECT_GE(f.Radius(), 0.5 * wall * std::cos(M_PI / across)) << "an upper bound";
      EXPECT_TRUE(ownSides.Bounds(ClassOfLoops(loops, i), f.Side));
    }
  }
}

TEST(SideClasses, Noise)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const TriangleMesh noise = LevelSet(
    [&](double x, double y, double z)
    {
      const double value = normal(random);
      return std::max({ std::abs(x), std::abs(y), std::abs(z) }) > 0.9 ? 1.0 : value;
    },
    1.0, 16);
  const SurfaceAdjacency surface(noise);
  const SurfaceHomology homology(surface);
  EXPECT_GT(homology.Rank(), 200U);
  ExpectHalves(homology, SideClasses(surface, homology));
}

TEST(SideClasses, CrossingItself)
{
  TriangleMesh crossing = Torus(1.0, 0.3, 40, 12);
  for (Point3& p : crossing.Points)
  {
    const double angle = std::atan2(p[1], p[0]);
    if (std::abs(angle) < 0.5)
    {
      p[0] -= 2.0 * (0.5 - std::abs(angle)); // through the other sides of the ring
    }
  }
  const SurfaceAdjacency surface(crossing);
  const SurfaceHomology homology(surface);
  try
  {
    ExpectHalves(homology, SideClasses(surface, homology)); // or the numbers agree by chance
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("crosses itself"), std::string::npos);
  }
}

// With the surface's triangles among the faces of a mesh, handles and tunnels are those of M
// itself.
TEST(SideClasses, TetrahedraOfBothSides)
{
  for (const char* file : { "quadknot.obj", "knot1.off" })
  {
    ISTHMUS_NEEDS_SHARED_DATA(std::string("surfaces/") + file);
    SCOPED_TRACE(file);
    const auto loops = AnalyseOnTetrahedra(
      ReadSurface(file), nullptr, MeshFunctionParameters{}, [](const std::string&) {}, {});
    const SideClasses sides(loops->Adjacency(), loops->Homology());
    ExpectHalves(loops->Homology(), sides);
    const auto found = Generators(*loops);
    for (const SpaceSide side : BothSides)
    {
      const auto& features = found[static_cast<std::size_t>(side)];
      EXPECT_EQ(features.size(), loops->Homology().Rank() / 2);
      for (const std::size_t i : features)
      {
        EXPECT_TRUE(sides.Bounds(ClassOfLoops(*loops, i), side)) << i;
      }
    }
  }
}
