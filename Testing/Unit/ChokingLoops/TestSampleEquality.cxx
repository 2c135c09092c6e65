// Surfaces made finer without changing their shape, each triangle divided into four, until they are
// analysed on some of their points: the same features as with all points, one to one, and as before
// the division. One of the lines of a table for each surface; a share in each run (LongTests.h).

#include "BeadShapes.h"
#include "ChokingLoops/ChokingLoops.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "ChokingSurfaces.h"
#include "Core/Index.h"
#include "FeatureRows.h"
#include "LongTests.h"
#include "SharedData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Each triangle divided into four at the midpoints of its edges.
TriangleMesh Divided(const TriangleMesh& mesh)
{
  const SurfaceAdjacency surface(mesh);
  TriangleMesh finer;
  finer.Points = mesh.Points;
  const auto own = static_cast<std::int64_t>(mesh.Points.size());
  for (const SurfaceEdgeId e : surface.Edges())
  {
    const HalfEdgeId h = surface.GetHalfEdge(e);
    finer.Points.push_back(
      0.5 * (mesh.Points[At(surface.From(h))] + mesh.Points[At(surface.To(h))]));
  }
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    std::array<std::int64_t, 3> middle{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const HalfEdgeId h(static_cast<SimplexId>(3 * t + k));
      middle[k] = own + static_cast<std::int64_t>(surface.Edge(h).Index());
    }
    const Triangle& c = mesh.Triangles[t];
    finer.Triangles.push_back({ c[0], middle[0], middle[2] });
    finer.Triangles.push_back({ c[1], middle[1], middle[0] });
    finer.Triangles.push_back({ c[2], middle[2], middle[1] });
    finer.Triangles.push_back({ middle[0], middle[1], middle[2] });
  }
  return finer;
}

/// With all points, and long edges split as for the first samples, none omitted.
ChokingLoops AnalyseAll(const TriangleMesh& surface)
{
  ChokingLoopParameters parameters;
  FirstSamples(surface, parameters.SampleSpacing);
  return ChokingLoops(surface, parameters);
}

constexpr FeatureTolerance OnePercent{ 0.0, 0.01 };

void ExpectSame(const std::string& name, const ChokingLoops& all, const ChokingLoops& few)
{
  FeatureComparison result;
  FeatureComparison back;
  for (const SpaceSide side : { SpaceSide::Inside, SpaceSide::Outside })
  {
    for (const FeatureKind kind :
      { FeatureKind::Handle, FeatureKind::Tunnel, FeatureKind::Additional })
    {
      const auto rows = [&](const ChokingLoops& loops)
      {
        const double reference = loops.Diagram().Reference[static_cast<std::size_t>(side)];
        return RowsOf(loops, kind, side, 0.05 * reference, OnePercent);
      };
      const std::vector<FeatureRow> expected = rows(all);
      const std::vector<FeatureRow> found = rows(few);
      if (kind != FeatureKind::Additional)
      {
        EXPECT_EQ(found.size(), expected.size()) << name;
      }
      ExpectCounterparts(name, expected, found, OnePercent, result);
      ExpectCounterparts(name + ", back", found, expected, OnePercent, back);
    }
  }
  std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %.2f |\n", name.c_str(),
    all.Samples().Points.size(), few.Samples().Points.size(), result.Features, result.Untrusted,
    back.Untrusted, 100.0 * std::max(result.Worst, back.Worst));
}

struct SurfaceCase
{
  std::string Name;
  std::function<TriangleMesh()> Make;
};

std::vector<SurfaceCase> Cases()
{
  std::vector<SurfaceCase> cases;
  for (const char* name : { "129110__sf.obj", "1514499.stl", "2sphere.off", "3holes.off",
         "65004.stl", "697224__sf.obj", "72214.stl", "Kitten.off", "armadillo.obj", "botijo.off",
         "bumpy.off", "bunny.off", "casting.off", "cup_input_simple_10000.off", "double-torus.obj",
         "eight.off", "elk.off", "emd_5043.obj", "fandisk.off", "fertility.off", "genus3.off",
         "helix.off", "helmet.off", "knot1.off", "quadknot.obj", "olivier_hand.off",
         "rocker-arm.obj", "rocker_arm_1600.off", "skull_low_resolution.obj", "soccerball.obj",
         "sphere.off", "spot.obj", "torus.obj", "torus_rdzhao.off", "two-tori.obj" })
  {
    cases.push_back({ name, [name] { return ReadSurface(name); } });
  }
  for (const double small : { 0.1, 0.3, 0.6 })
  {
    cases.push_back(
      { "torus " + std::to_string(small), [small] { return Torus(1.0, small, 120, 60); } });
  }
  for (const int beads : { 3, 5, 8 })
  {
    for (const double neck : { 0.15, 0.3, 0.7 })
    {
      cases.push_back({ "necklace of " + std::to_string(beads) + ", " + std::to_string(neck),
        [beads, neck] { return Necklace(beads, neck).Surface(std::min(0.1, 0.3 * neck)); } });
    }
  }
  for (const double strut : { 0.15, 0.3 })
  {
    cases.push_back({ "lattice, " + std::to_string(strut),
      [strut] { return Lattice(2, strut).Surface(std::min(0.1, 0.3 * strut)); } });
  }
  return cases;
}

}

TEST(AdaptiveSamples, EqualAllPoints)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/fertility.off");
  const std::vector<SurfaceCase> cases = Cases();
  const LongCases turn("EqualAllPoints", 10);
  std::size_t done = 0;
  std::printf("| surface | points | samples | features | trusted with all points only | trusted "
              "here only | largest difference of radii beyond their uncertainty (%%) |\n");
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    if (!turn.Has(i))
    {
      continue;
    }
    TriangleMesh surface = CheckedSurface(cases[i].Make(), false);
    while (surface.Points.size() <= MostUsualSamples)
    {
      surface = Divided(surface);
    }
    const ChokingLoops few{ TriangleMesh(surface) };
    EXPECT_TRUE(few.Fine());
    ExpectSame(cases[i].Name, AnalyseAll(surface), few);
    ++done;
  }
  turn.ReportCases(done, cases.size());
}

// The same polyhedron with 16 and 64 times as many points.
TEST(AdaptiveSamples, DivisionChangesNothing)
{
  const TriangleMesh coarse = TangleCube(60);
  TriangleMesh surface = coarse;
  const ChokingLoops before{ TriangleMesh(coarse) };
  for (int times = 0; times < 3; ++times)
  {
    surface = Divided(surface);
    if (surface.Points.size() > MostUsualSamples)
    {
      ExpectSame("tangle cube", before, ChokingLoops{ TriangleMesh(surface) });
    }
  }
  EXPECT_GT(surface.Points.size(), 500000U);
}
