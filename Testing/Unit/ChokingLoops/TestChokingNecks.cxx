// Every neck of a shape has exactly one loop, at its position and of its circumference.

#include "BeadShapes.h"
#include "ChokingLoops/ChokingLoopsOutput.h"
#include "ChokingLoops/LoopDrawing.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr int UntilGeodesic = 1000;
constexpr double Corner = M_PI / 3.0;

std::vector<Point3> MakePolygon(
  const ChokingLoops& loops, const LoopFeature& geometry, std::size_t loop)
{
  std::vector<Point3> polygon;
  for (const SimplexId p : geometry.Loops[loop])
  {
    polygon.push_back(geometry.Point(p, loops.Samples()));
  }
  return polygon;
}

Point3 Centroid(const std::vector<Point3>& polygon)
{
  Point3 sum{ 0, 0, 0 };
  double length = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point3& a = polygon[i];
    const Point3& b = polygon[(i + 1) % polygon.size()];
    const double piece = std::sqrt(Dot(b - a, b - a));
    sum = sum + (0.5 * piece) * (a + b);
    length += piece;
  }
  return (1.0 / length) * sum;
}

/// A surface's features with their loops.
struct FeatureLoops
{
  explicit FeatureLoops(TriangleMesh mesh, const FeatureSelection& selection = {})
    : Loops(std::move(mesh))
  {
    const std::vector<std::size_t> chosen = this->Loops.Select(selection);
    this->Geometry.reserve(chosen.size());
    for (const std::size_t i : chosen)
    {
      this->Geometry.push_back(MakeLoopFeature(this->Loops, i, UntilGeodesic));
      this->Shown.push_back({ i, &this->Geometry.back() });
    }
    FindShared(this->Loops, this->Shown);
  }

  const ShapeFeature& Feature(const ShownFeature& shown) const
  {
    return this->Loops.Diagram().Features[shown.Index];
  }

  ChokingLoops Loops;
  std::vector<LoopFeature> Geometry;
  std::vector<ShownFeature> Shown;
};

/// Checks that hold for any feature; with `areSmooth` also those for surfaces without sharp edges.
void ExpectTight(const FeatureLoops& analysed, bool areSmooth = true)
{
  for (const ShownFeature& shown : analysed.Shown)
  {
    const ShapeFeature& f = analysed.Feature(shown);
    const auto& lengths = shown.Geometry->Lengths;
    ASSERT_FALSE(lengths.empty());
    EXPECT_FALSE(shown.Geometry->Collapsed);
    if (f.Trusted)
    {
      EXPECT_GE(*std::max_element(lengths.begin(), lengths.end()), 0.98 * ShortestGirth(f))
        << "feature " << shown.Index << " of radius " << f.Radius();
    }
    for (std::size_t k = 0; areSmooth && k < lengths.size(); ++k)
    {
      EXPECT_LT(
        SharpestTurn(MakePolygon(analysed.Loops, *shown.Geometry, k), 1e-6 * f.Radius()), Corner)
        << "feature " << shown.Index << " of radius " << f.Radius() << ", side "
        << static_cast<int>(f.Side) << ", length " << lengths[k];
    }
  }
}

/// One loop at each neck, of its circumference, and no other inside.
void ExpectLoops(const FeatureLoops& analysed, const std::vector<Neck>& necks, SpaceSide side)
{
  std::vector<int> met(necks.size(), 0);
  int others = 0;
  double worstPlace = 0.0;
  double worstLength = 0.0;
  for (const ShownFeature& shown : analysed.Shown)
  {
    const ShapeFeature& f = analysed.Feature(shown);
    if (f.Side != side)
    {
      continue;
    }
    bool isNeck = false;
    for (std::size_t n = 0; n < necks.size(); ++n)
    {
      const Point3 d = Centroid(MakePolygon(analysed.Loops, *shown.Geometry, 0)) - necks[n].Place;
      const double place = std::sqrt(Dot(d, d)) / f.Radius();
      if (place < 0.35)
      {
        const double girth = 2.0 * M_PI * necks[n].Radius;
        worstPlace = std::max(worstPlace, place);
        worstLength = std::max(worstLength, std::abs(shown.Geometry->Lengths[0] / girth - 1.0));
        EXPECT_EQ(shown.Geometry->Lengths.size(), 1U);
        EXPECT_EQ(shown.SharedWith, -1);
        ++met[n];
        isNeck = true;
      }
    }
    others += !isNeck;
  }
  EXPECT_EQ(std::count(met.begin(), met.end(), 1), static_cast<std::ptrdiff_t>(necks.size()));
  EXPECT_EQ(others, 0);
  EXPECT_LT(worstLength, 0.05);
  std::cout << necks.size() << " necks, worst place " << worstPlace << " radii, worst length "
            << 100.0 * worstLength << " %\n";
}

struct Named
{
  const char* Name;
  BeadShape Shape;
};

std::ostream& operator<<(std::ostream& out, const Named& named)
{
  return out << named.Name;
}

class Beads : public ::testing::TestWithParam<Named>
{
};

TEST_P(Beads, HaveALoopAtEachNeck)
{
  const BeadShape& shape = GetParam().Shape;
  const double thinnest = *std::min_element(shape.Radii.begin(), shape.Radii.end());
  const FeatureLoops analysed(shape.Surface(std::min(0.12, 0.3 * thinnest)));
  ExpectTight(analysed);
  ExpectLoops(analysed, shape.Necks(), SpaceSide::Inside);
}

constexpr double Thin = 0.3;
constexpr double Fat = 0.7;

INSTANTIATE_TEST_SUITE_P(Shapes, Beads,
  ::testing::Values(Named{ "Necklace5Thin", Necklace(5, Thin) },
    Named{ "Necklace5Fat", Necklace(5, Fat) }, Named{ "Necklace8Thin", Necklace(8, Thin) },
    Named{ "Necklace8Fat", Necklace(8, Fat) }, Named{ "Necklace11Thin", Necklace(11, Thin) },
    Named{ "Necklace11Fat", Necklace(11, Fat) }, Named{ "Necklace13Thin", Necklace(13, Thin) },
    Named{ "Necklace13Fat", Necklace(13, Fat) }, Named{ "OpenWindows", StackedRings(7, Thin) },
    Named{ "OpenWindowsFat", StackedRings(7, 0.5) }, Named{ "Lattice2", Lattice(2, Thin) },
    Named{ "Lattice3", Lattice(3, Thin) }, Named{ "Lattice2Fat", Lattice(2, 0.5) },
    Named{ "Comb20", Comb(20, Thin) }, Named{ "Honeycomb", Honeycomb(3, Thin) }),
  [](const auto& test) { return std::string(test.param.Name); });

Tube Ring(const Point3& center, std::size_t axis, double waist)
{
  const auto curve = [center, axis](double u)
  {
    Point3 p = center;
    p[(axis + 1) % 3] += 1.5 * std::cos(2.0 * M_PI * u);
    p[(axis + 2) % 3] += 1.5 * std::sin(2.0 * M_PI * u);
    return p;
  };
  return { curve, 0.45, 0.3, waist };
}

Neck FindWaist(const Tube& tube)
{
  return { tube.Curve(tube.Waist), tube.Thin };
}

TEST(ChokingNecks, LinkedTori)
{
  const Tube a = Ring({ 0.0, 0.0, 0.0 }, 2, 0.43);
  const Tube b = Ring({ 1.5, 0.0, 0.0 }, 1, 0.12);
  const FeatureLoops analysed(Together(TubeSurface(a, 160, 36), TubeSurface(b, 160, 36)));
  ExpectTight(analysed);
  ExpectLoops(analysed, { FindWaist(a), FindWaist(b) }, SpaceSide::Inside);
}

TEST(ChokingNecks, TrefoilTube)
{
  const auto curve = [](double u)
  {
    const double t = 2.0 * M_PI * u;
    return Point3{ std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t),
      -std::sin(3.0 * t) };
  };
  const Tube tube{ curve, 0.4, 0.28, 0.21 };
  const FeatureLoops analysed(TubeSurface(tube, 400, 36));
  ExpectTight(analysed);
  ExpectLoops(analysed, { FindWaist(tube) }, SpaceSide::Inside);
}

// A dumbbell-shaped cavity in a dumbbell: the neck of the cavity is outside of the surface, and the
// shell round it is narrow all the way round, where its membrane is an annulus.
TEST(ChokingNecks, NestedShells)
{
  const auto dumbbell = [](double end, double neck)
  {
    BeadShape shape;
    shape.Bead = end;
    shape.Centers = { { -1.5, 0.011, 0.017 }, { 1.5, 0.011, 0.017 } };
    shape.Join(0, 1, neck);
    return shape;
  };
  const BeadShape cavity = dumbbell(0.8, 0.3);
  const BeadShape body = dumbbell(1.3, 0.5);
  const TriangleMesh outer = body.Surface(0.06);
  TriangleMesh inner = cavity.Surface(0.06);
  for (Triangle& t : inner.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  const FeatureLoops analysed(Together(outer, inner));
  ExpectTight(analysed);
  ExpectLoops(analysed, cavity.Necks(), SpaceSide::Outside);
  bool isAnnular = false;
  for (const ShownFeature& shown : analysed.Shown)
  {
    const auto& lengths = shown.Geometry->Lengths;
    std::cout << "side " << static_cast<int>(analysed.Feature(shown).Side) << " radius "
              << analysed.Feature(shown).Radius() << " loops";
    for (const double length : lengths)
    {
      std::cout << " " << length;
    }
    std::cout << "\n";
    isAnnular = isAnnular || lengths.size() == 2;
  }
  EXPECT_TRUE(isAnnular);
}

/// Two stacked rings of seven blobs, sums of Gaussians, whose windows are closed: GroEL's
/// architecture as in Examples/choose_map.py.
TriangleMesh ClosedWindows()
{
  const auto density = [](double x, double y, double z)
  {
    double sum = 0.0;
    for (const int ring : { 0, 1 })
    {
      for (int blob = 0; blob < 7; ++blob)
      {
        const double angle = 2.0 * M_PI * (blob + 0.5 * ring) / 7.0;
        const double dx = x - 50.0 * std::cos(angle);
        const double dy = y - 50.0 * std::sin(angle);
        const double dz = (z - 60.0 * ring + 30.0) / 1.4;
        sum += std::exp(-(dx * dx + dy * dy + dz * dz) / (2.0 * 16.0 * 16.0));
      }
    }
    return sum;
  };
  return LevelSet(
    [density](double x, double y, double z) { return 0.35 - density(x, y, z); }, 110.3, 84);
}

/// Largest distance of a point of one polygon from the nearest of another.
double Apart(const std::vector<Point3>& a, const std::vector<Point3>& b)
{
  double farthest = 0.0;
  for (const Point3& p : a)
  {
    double nearest = HUGE_VAL;
    for (const Point3& q : b)
    {
      nearest = std::min(nearest, std::sqrt(Dot(q - p, q - p)));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

/// No two drawn loops coincide; a loop marked as shared belongs to two features.
void ExpectConsistentSharing(const FeatureLoops& analysed)
{
  for (const ShownFeature& shown : analysed.Shown)
  {
    const double radius = analysed.Feature(shown).Radius();
    for (const ShownFeature& other : analysed.Shown)
    {
      if (static_cast<std::ptrdiff_t>(other.Index) == shown.SharedWith)
      {
        EXPECT_EQ(other.SharedWith, -1);
        EXPECT_EQ(other.Geometry, shown.Geometry);
        EXPECT_TRUE(BelongsToChokePoint(analysed.Loops, shown.Index, *other.Geometry));
      }
      else if (shown.SharedWith < 0 && other.SharedWith < 0 && shown.Index < other.Index &&
        analysed.Feature(shown).Side == analysed.Feature(other).Side &&
        shown.Geometry->Loops.size() == 1 && other.Geometry->Loops.size() == 1)
      {
        EXPECT_GT(Apart(MakePolygon(analysed.Loops, *shown.Geometry, 0),
                    MakePolygon(analysed.Loops, *other.Geometry, 0)),
          0.1 * radius);
      }
    }
  }
}

// In the wall of 14 blobs, each is only a bump: a section of the wall separates it from the next,
// and by symmetry the shortest closed path round that section has the same length everywhere. It
// passes a narrowing of either ring, and represents both.
TEST(ChokingNecks, ClosedWindows)
{
  const FeatureLoops analysed(ClosedWindows());
  ExpectTight(analysed);
  ExpectConsistentSharing(analysed);
  std::vector<double> sections;
  std::ptrdiff_t annular = 0;
  std::ptrdiff_t shared = 0;
  for (const ShownFeature& shown : analysed.Shown)
  {
    EXPECT_FALSE(shown.Geometry->Held) << "feature " << shown.Index;
    annular += shown.Geometry->Loops.size() == 2;
    shared += shown.SharedWith >= 0;
    if (analysed.Feature(shown).Side == SpaceSide::Inside && shown.Geometry->Loops.size() == 1)
    {
      sections.push_back(shown.Geometry->Lengths[0]);
    }
  }
  EXPECT_EQ(sections.size(), 13U); // 14 blobs: 13 narrowings between them, and the ring's handle
  EXPECT_EQ(annular, 1);           // the one between the two rings
  EXPECT_GE(shared, 1);
  const auto [least, most] = std::minmax_element(sections.begin(), sections.end());
  EXPECT_LT(*most, 1.005 * *least);
  std::cout << sections.size() << " sections of length " << *least << " to " << *most << ", "
            << shared << " shared\n";
}

}
