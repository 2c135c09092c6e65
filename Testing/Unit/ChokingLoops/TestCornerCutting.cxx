// Corner cutting of a curve with two fixed points on a cylinder; unrolled, this is plane geometry.

#include "BeadShapes.h"
#include "ChokingLoops/LoopShortening.h"

#include <gtest/gtest.h>

#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr int ManyRounds = 5000; ///< until nothing gets shorter

/// A cylinder of radius 1 round z with flat ends at z = -3 and 3, 2 n points per ring. Points of
/// even rings lie at multiples of pi / n, those of odd ones between.
class Cylinder
{
public:
  explicit Cylinder(int n, double shift = 0.0)
    : Around(2 * n)
    , Rings(2 * static_cast<int>(std::round(3.0 * n / M_PI)) + 1)
  {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> moved(-shift, shift);
    for (int j = 0; j < this->Rings; ++j)
    {
      const double z = 6.0 * j / (this->Rings - 1) - 3.0;
      for (int i = 0; i < this->Around; ++i)
      {
        const double angle = M_PI * (i + 0.5 * (j % 2) + moved(random)) / n;
        this->Mesh.Points.push_back({ std::cos(angle), std::sin(angle), z });
      }
    }
    const auto last = static_cast<std::int64_t>(this->Mesh.Points.size());
    this->Mesh.Points.push_back({ 0.0, 0.0, -3.0 });
    this->Mesh.Points.push_back({ 0.0, 0.0, 3.0 });
    for (int i = 0; i < this->Around; ++i)
    {
      this->Mesh.Triangles.push_back({ last, this->Id(i + 1, 0), this->Id(i, 0) });
      this->Mesh.Triangles.push_back(
        { last + 1, this->Id(i, this->Rings - 1), this->Id(i + 1, this->Rings - 1) });
      for (int j = 0; j + 1 < this->Rings; ++j)
      {
        const int s = j % 2;
        this->Mesh.Triangles.push_back(
          { this->Id(i, j), this->Id(i + 1, j), this->Id(i + s, j + 1) });
        this->Mesh.Triangles.push_back(
          { this->Id(i + 1 - s, j), this->Id(i + 1, j + 1), this->Id(i, j + 1) });
      }
    }
  }

  std::int64_t Id(int i, int j) const
  {
    return j * this->Around + (i + this->Around) % this->Around;
  }
  int MiddleRing() const { return (this->Rings - 1) / 2; }
  double RingHeight(int rings) const { return 6.0 * rings / (this->Rings - 1); }

  /// Once around from (angle 0, z 0): half of it at z 0, `rings` rings up, on round, and down
  /// again.
  std::vector<SimplexId> Stair(int rings) const
  {
    std::vector<SimplexId> loop;
    const int low = this->MiddleRing();
    const int half = this->Around / 2;
    for (int i = 0; i < half; ++i)
    {
      loop.push_back(static_cast<SimplexId>(this->Id(i, low)));
    }
    for (int j = low; j < low + rings; ++j)
    {
      loop.push_back(static_cast<SimplexId>(this->Id(half, j)));
    }
    for (int i = half; i < this->Around; ++i)
    {
      loop.push_back(static_cast<SimplexId>(this->Id(i, low + rings)));
    }
    for (int j = low + rings; j > low; --j)
    {
      loop.push_back(static_cast<SimplexId>(this->Id(0, j)));
    }
    return loop;
  }

  /// The lower end of the staircase, and its upper end on the opposite side.
  std::array<SimplexId, 2> Ends(int rings) const
  {
    return { static_cast<SimplexId>(this->Id(0, this->MiddleRing())),
      static_cast<SimplexId>(this->Id(this->Around / 2, this->MiddleRing() + rings)) };
  }

  int Around;
  int Rings;
  TriangleMesh Mesh;
};

/// Fixed at both ends: two straight lines, pi wide and `Height` (about 2) high, that meet in
/// corners.
struct HeldStair
{
  HeldStair(int n, double shift = 0.0)
    : On(n, shift)
    , Surface(On.Mesh)
    , Steps(2 * ((On.Rings - 1) / 6))
    , Height(On.RingHeight(Steps))
  {
    const auto ends = this->On.Ends(this->Steps);
    this->Curve = ShortenPinned(
      this->Surface, this->On.Stair(this->Steps), { ends[0], ends[1] }, { ManyRounds, 1e-6 });
  }

  double Length() const { return 2.0 * std::hypot(M_PI, this->Height); }
  double Turn() const { return 2.0 * std::atan2(this->Height, M_PI); }

  Cylinder On;
  SurfaceAdjacency Surface;
  int Steps;
  double Height;
  SurfaceCurve Curve;
};

/// Crossings one after another lie on one triangle.
void ExpectOnSurface(const SurfaceAdjacency& surface, const SurfaceCurve& curve)
{
  for (std::size_t i = 0; i < curve.Crossings.size(); ++i)
  {
    const Point3 p = ComputePosition(surface, curve.Crossings[i]);
    EXPECT_LE(std::hypot(p[0], p[1]), 1.0 + 1e-12);
    const Point3 next = ComputePosition(surface, curve.Crossings[(i + 1) % curve.Crossings.size()]);
    const Point3 middle = 0.5 * (p + next);
    // A chord within a facet: no point of the polyhedron is nearer to the axis than its edges are.
    EXPECT_GT(std::hypot(middle[0], middle[1]), 0.98) << i;
  }
  EXPECT_NEAR(CurveLength(surface, curve.Crossings), curve.Length, 1e-12);
}

double WayRound(const SurfaceAdjacency& surface, const SurfaceCurve& curve)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < curve.Crossings.size(); ++i)
  {
    const Point3 p = ComputePosition(surface, curve.Crossings[i]);
    const Point3 q = ComputePosition(surface, curve.Crossings[(i + 1) % curve.Crossings.size()]);
    sum += std::atan2(p[0] * q[1] - p[1] * q[0], p[0] * q[0] + p[1] * q[1]);
  }
  return sum;
}

TEST(CornerCutting, MeasuresWithoutCutting)
{
  const HeldStair stair(96);
  ASSERT_EQ(stair.Curve.Pins.size(), 2U);
  EXPECT_NEAR(stair.Curve.Length, stair.Length(), 0.002 * stair.Length());
  const SurfaceCurve measured = CutCorners(stair.Surface, stair.Curve, 0.0, 0.0);
  EXPECT_NEAR(measured.SharpestBend, stair.Turn(), 0.03);
  EXPECT_EQ(measured.Pins, stair.Curve.Pins);
  ASSERT_EQ(measured.Crossings.size(), stair.Curve.Crossings.size());
  for (std::size_t i = 0; i < measured.Crossings.size(); ++i)
  {
    EXPECT_EQ(measured.Crossings[i].HalfEdge, stair.Curve.Crossings[i].HalfEdge);
    EXPECT_EQ(measured.Crossings[i].Fraction, stair.Curve.Crossings[i].Fraction);
  }
  // No cut where the corners are not sharp, either.
  const SurfaceCurve kept = CutCorners(stair.Surface, stair.Curve, stair.Turn() + 0.1, 0.3);
  EXPECT_EQ(kept.Length, stair.Curve.Length);
  EXPECT_EQ(kept.Pins.size(), 2U);
}

// The third side of a triangle with two sides of length r and a turning angle t is 2 r cos(t / 2),
// and there are two corners of t / 2 each in place of the one.
TEST(CornerCutting, CutsOffATriangle)
{
  double before = HUGE_VAL;
  for (const int n : { 48, 96, 192 })
  {
    const HeldStair stair(n);
    const double reach = 0.5;
    const SurfaceCurve cut = CutCorners(stair.Surface, stair.Curve, 0.9 * stair.Turn(), reach);
    EXPECT_TRUE(cut.Pins.empty());
    ExpectOnSurface(stair.Surface, cut);
    EXPECT_NEAR(WayRound(stair.Surface, cut), 2.0 * M_PI, 1e-9);
    // A cut begins at the next edge that is crossed, so `reach` is passed by an edge at most.
    const double edge = 1.5 * M_PI / n;
    const double saved = stair.Curve.Length - cut.Length;
    const auto triangle = [&](double r) { return 4.0 * r * (1.0 - std::cos(0.5 * stair.Turn())); };
    EXPECT_GT(saved, triangle(reach) * 0.995);
    EXPECT_LT(saved, triangle(reach + edge) * 1.005);
    const double error = std::abs(cut.SharpestBend - 0.5 * stair.Turn());
    EXPECT_LT(error, 0.06);
    EXPECT_LT(error, before + 0.02);
    before = error;
  }
}

// Each generation halves the corners: after k of them none turns by more than t / 2^k.
TEST(CornerCutting, CutsRemainingSharpCornersAgain)
{
  const HeldStair stair(192);
  double length = stair.Curve.Length;
  for (const int generations : { 1, 2, 3 })
  {
    const double allowed = 1.05 * stair.Turn() / std::pow(2.0, generations);
    const SurfaceCurve cut = CutCorners(stair.Surface, stair.Curve, allowed, 0.6);
    EXPECT_LE(cut.SharpestBend, allowed);
    EXPECT_LT(cut.Length, length);
    EXPECT_GT(cut.Length, 2.0 * M_PI) << "no way round is shorter than the ring";
    ExpectOnSurface(stair.Surface, cut);
    length = cut.Length;
  }
}

TEST(CornerCutting, CutsMoreTheFartherItMayReach)
{
  const HeldStair stair(96);
  double length = stair.Curve.Length;
  for (const double reach : { 0.1, 0.3, 0.6, 1.0, 100.0 })
  {
    const SurfaceCurve cut = CutCorners(stair.Surface, stair.Curve, 0.9 * stair.Turn(), reach);
    EXPECT_LE(cut.Length, length + 1e-12);
    EXPECT_NEAR(WayRound(stair.Surface, cut), 2.0 * M_PI, 1e-9) << "another class";
    length = cut.Length;
  }
}

TEST(CornerCutting, DoesNotDependOnUnitOrDirection)
{
  const HeldStair stair(64, 0.2); // shifted points: no two crossings coincide
  const double allowed = 0.6 * stair.Turn();
  const SurfaceCurve cut = CutCorners(stair.Surface, stair.Curve, allowed, 0.4);
  EXPECT_LT(cut.Length, stair.Curve.Length);
  TriangleMesh large = stair.On.Mesh;
  for (Point3& p : large.Points)
  {
    p = 16.0 * p;
  }
  const SurfaceAdjacency largeSurface(large);
  SurfaceCurve curve = stair.Curve;
  curve.Length *= 16.0;
  EXPECT_EQ(CutCorners(largeSurface, curve, allowed, 6.4).Length, 16.0 * cut.Length);
  auto backwards = stair.On.Stair(stair.Steps);
  std::reverse(backwards.begin(), backwards.end());
  const auto ends = stair.On.Ends(stair.Steps);
  const SurfaceCurve other = CutCorners(stair.Surface,
    ShortenPinned(stair.Surface, backwards, { ends[0], ends[1] }, { ManyRounds, 1e-6 }), allowed,
    0.4);
  EXPECT_NEAR(other.Length, cut.Length, 0.01 * cut.Length);
  EXPECT_NEAR(other.SharpestBend, cut.SharpestBend, 0.05);
}

// Between two adjacent fixed points there is no room for a cut: the curve passes both.
TEST(CornerCutting, KeepsPinsThatAreNeighbours)
{
  const HeldStair stair(96);
  const std::vector<SimplexId> loop = stair.On.Stair(stair.Steps);
  const std::vector<SimplexId> pins{ loop[0], loop[1], loop.back() };
  const SurfaceCurve held = ShortenPinned(stair.Surface, loop, pins, { ManyRounds, 1e-6 });
  const SurfaceCurve cut = CutCorners(stair.Surface, held, 0.1, 0.3);
  EXPECT_LE(cut.Length, held.Length);
  EXPECT_GE(cut.Pins.size(), 1U);
  for (const std::size_t pin : cut.Pins)
  {
    ASSERT_LT(pin, cut.Crossings.size());
    const SurfaceCurvePoint& at = cut.Crossings[pin];
    EXPECT_EQ(at.Fraction, 0.0);
    EXPECT_NE(std::find(pins.begin(), pins.end(), stair.Surface.From(at.HalfEdge)), pins.end());
  }
}

TEST(CornerCutting, LeavesACurveWithoutPins)
{
  const HeldStair stair(48);
  SurfaceCurve free = ShortenLoop(stair.Surface, stair.On.Stair(stair.Steps), { ManyRounds, 1e-6 });
  const double length = free.Length;
  const SurfaceCurve cut = CutCorners(stair.Surface, std::move(free), 0.0, 0.5);
  EXPECT_EQ(cut.Length, length);
  EXPECT_EQ(cut.SharpestBend, 0.0);
  EXPECT_TRUE(cut.Pins.empty());
}

}
