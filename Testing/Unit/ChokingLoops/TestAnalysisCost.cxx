// What an analysis is said to take: counts against shapes of known genus, bytes against the peak
// that the kernel tells. Times are held by BenchAnalysisCost, since a busy machine would fail them.

#include "AnalysisCost.h"
#include "ChokingLoops.h"
#include "ChokingSurfaces.h"
#include "PeakMemory.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// `mesh` and a copy of it elsewhere.
TriangleMesh Twice(TriangleMesh mesh)
{
  const auto points = static_cast<std::int64_t>(mesh.Points.size());
  const std::size_t triangles = mesh.Triangles.size();
  for (std::int64_t i = 0; i < points; ++i)
  {
    mesh.Points.push_back(mesh.Points[static_cast<std::size_t>(i)] + Point3{ 9.0, 0.0, 0.0 });
  }
  for (std::size_t t = 0; t < triangles; ++t)
  {
    const Triangle& own = mesh.Triangles[t];
    mesh.Triangles.push_back({ own[0] + points, own[1] + points, own[2] + points });
  }
  return mesh;
}

TEST(AnalysisCost, RankIsTwiceTheGenusOfAllParts)
{
  const TriangleMesh ball =
    LevelSet([](double x, double y, double z) { return x * x + y * y + z * z - 1.0; }, 1.3, 12);
  EXPECT_EQ(CostOf(ball).Rank, 0U);
  EXPECT_EQ(CostOf(Torus(1.0, 0.3, 30, 20)).Rank, 2U);
  EXPECT_EQ(CostOf(Twice(Torus(1.0, 0.3, 30, 20))).Rank, 4U);
  EXPECT_EQ(CostOf(TangleCube(30)).Rank, 10U);
}

TEST(AnalysisCost, TimeIsAMultipleOfTheTriangulation)
{
  const AnalysisCost cost = CostOf(Torus(1.0, 0.3, 30, 20));
  EXPECT_LT(cost.Seconds, 0.0); // not known before
  EXPECT_GT(cost.After(1.0).Seconds, 1.0);
  EXPECT_DOUBLE_EQ(cost.After(4.0).Seconds, 4.0 * cost.After(1.0).Seconds);
  EXPECT_EQ(cost.After(4.0).Bytes, cost.Bytes);
}

TEST(AnalysisCost, ToldBeforeTheWorkAndOnceTriangulated)
{
  std::vector<AnalysisCost> told;
  ChokingLoopParameters parameters;
  parameters.SampleSpacing = 0.05; // one round
  parameters.Estimated = [&told](const AnalysisCost& cost) { told.push_back(cost); };
  const ChokingLoops loops(Torus(1.0, 0.3, 60, 30), parameters);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0].Samples, loops.Samples().Points.size());
  EXPECT_LT(told[0].Seconds, 0.0);
  EXPECT_GT(told[1].Seconds, 0.0);
  EXPECT_EQ(told[1].Seconds, loops.Cost().Seconds);
  EXPECT_GT(loops.Times().LastRound, 0.0);
}

TEST(AnalysisCost, BytesAreWithinAFactorOfTwo)
{
  TriangleMesh mesh = Torus(1.0, 0.3, 600, 200); // 120,000 points: the heap before is small to it
  for (Point3& p : mesh.Points)
  {
    p = (1.0 + 0.05 * std::sin(5.0 * p[0] + 3.0 * p[1]) * std::cos(4.0 * p[1] - p[2])) * p;
  }
  ResetPeakMemory();
  const double before = PeakMemory();
  if (before <= 0.0)
  {
    GTEST_SKIP() << "The kernel does not tell the peak of a process.";
  }
  const ChokingLoops loops{ TriangleMesh(mesh) };
  const double bytes = PeakMemory() - before;
  EXPECT_GT(loops.Cost().Bytes, 0.5 * bytes);
  EXPECT_LT(loops.Cost().Bytes, 2.0 * bytes);
}

}
