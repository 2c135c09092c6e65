// The loops of a shape do not depend on the values of the acceptance tolerances.

#include "BeadShapes.h"
#include "ChokingLoops/LoopDrawing.h"
#include "ChokingSurfaces.h"

#include <gtest/gtest.h>

#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr int UntilGeodesic = 1000;

/// Relative to a loop's length; the tolerance for a neck is 5 %.
constexpr double Same = 0.03;

double Degrees(double degrees)
{
  return degrees * M_PI / 180.0;
}

/// Each tolerance at either end of its range (LoopTolerances), the others as they are.
std::vector<LoopTolerances> Ends()
{
  std::vector<LoopTolerances> ends(8);
  ends[0].Nearness = 0.25;
  ends[1].Nearness = 0.32;
  ends[2].SharpestHeld = Degrees(47.0);
  ends[3].SharpestHeld = Degrees(60.0);
  ends[4].SharpestLoop = Degrees(80.0);
  ends[5].SharpestLoop = Degrees(100.0);
  ends[6].CornerCuts = { 0.25, 0.4 };
  ends[7].CornerCuts = { 0.35, 0.52 };
  return ends;
}

/// Loops are the same, or equally good.
void ExpectSameLoops(TriangleMesh mesh, double spacing = 1e3)
{
  ChokingLoopParameters parameters;
  parameters.SampleSpacing = spacing; // all points, if it is that large
  ChokingLoops loops(std::move(mesh), parameters);
  const std::vector<LoopTolerances> ends = Ends();
  int held = 0;
  int worked = 0;
  for (const std::size_t i : loops.Select({}))
  {
    const LoopFeature usual = MakeLoopFeature(loops, i, UntilGeodesic);
    held += usual.Held || usual.Encircling;
    for (std::size_t end = 0; end < ends.size(); ++end)
    {
      const LoopFeature other = MakeLoopFeature(loops, i, UntilGeodesic, {}, ends[end]);
      ASSERT_EQ(other.Loops.size(), usual.Loops.size()) << "feature " << i;
      for (std::size_t k = 0; k < usual.Lengths.size(); ++k)
      {
        EXPECT_NEAR(other.Lengths[k], usual.Lengths[k], Same * usual.Lengths[k])
          << "feature " << i << ", end " << end;
      }
      ++worked;
    }
  }
  std::cout << worked << " drawings, " << held << " features held or of another class\n";
  EXPECT_GT(worked, 0);
}

/// The level 0.35 of Gaussians of deviation 0.32, 1.4 times as wide along z.
TriangleMesh Blobs(const std::vector<Point3>& centers, int n)
{
  return LevelSet(
    [&centers](double x, double y, double z)
    {
      double sum = 0.0;
      for (const Point3& c : centers)
      {
        const Point3 d{ x - c[0], y - c[1], (z - c[2]) / 1.4 };
        sum += std::exp(-Dot(d, d) / (2.0 * 0.32 * 0.32));
      }
      return 0.35 - sum;
    },
    2.27, n);
}

// Two rings of blobs whose windows are closed: the separation of two blobs is not a class of its
// own.
TEST(LoopTolerances, OfAWallOfBlobs)
{
  std::vector<Point3> centers;
  for (int i = 0; i < 14; ++i)
  {
    const double angle = 2.0 * M_PI * (i / 2 + 0.5 * (i % 2)) / 7.0;
    centers.push_back({ std::cos(angle), std::sin(angle), i % 2 == 0 ? -0.6 : 0.6 });
  }
  ExpectSameLoops(Blobs(centers, 44));
}

TEST(LoopTolerances, OfBlobsAtRandom)
{
  for (const unsigned seed : { 1U, 2U })
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-1.7, 1.7);
    std::vector<Point3> centers(30);
    for (Point3& c : centers)
    {
      c = { place(random), place(random), 0.8 * place(random) };
    }
    ExpectSameLoops(Blobs(centers, 44));
  }
}

TEST(LoopTolerances, OfBeads)
{
  ExpectSameLoops(Necklace(5, 0.3).Surface(0.12));
  ExpectSameLoops(Lattice(2, 0.4).Surface(0.12));
}

class OfSharedSurfaces : public ::testing::TestWithParam<const char*>
{
};

TEST_P(OfSharedSurfaces, AreTheSame)
{
  ISTHMUS_NEEDS_SHARED_DATA(std::string("surfaces/") + GetParam());
  ExpectSameLoops(ReadSurface(GetParam()), 0.0);
}

INSTANTIATE_TEST_SUITE_P(LoopTolerances, OfSharedSurfaces,
  ::testing::Values("elk.off", "skull_low_resolution.obj", "cup_input_simple_10000.off"),
  [](const auto& test)
  {
    const std::string name = test.param;
    return name.substr(0, name.find_first_of("_."));
  });

}
