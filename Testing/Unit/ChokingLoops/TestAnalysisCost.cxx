// The predicted cost of an analysis: counts for shapes of known genus, bytes against the peak that
// the kernel reports, CPU seconds relative to a stage of the same run.

#include "ChokingLoops/ChokingLoops.h"
#include "ChokingLoops/LoopDrawing.h"
#include "ChokingSurfaces.h"
#include "CpuEstimate.h"
#include "PeakMemory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

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
  EXPECT_EQ(EstimateCost(ball).Rank, 0U);
  EXPECT_EQ(EstimateCost(Torus(1.0, 0.3, 30, 20)).Rank, 2U);
  EXPECT_EQ(EstimateCost(Twice(Torus(1.0, 0.3, 30, 20))).Rank, 4U);
  EXPECT_EQ(EstimateCost(TangleCube(30)).Rank, 10U);
}

TEST(AnalysisCost, TimeIsAMultipleOfTheTriangulation)
{
  const AnalysisCost cost = EstimateCost(Torus(1.0, 0.3, 30, 20));
  EXPECT_LT(cost.Seconds, 0.0); // not known before
  EXPECT_GT(cost.After(1.0).Seconds, 1.0);
  EXPECT_DOUBLE_EQ(cost.After(4.0).Seconds, 4.0 * cost.After(1.0).Seconds);
  EXPECT_EQ(cost.After(4.0).Bytes, cost.Bytes);
}

TEST(AnalysisCost, ReusesTheCostOfTheRoundBefore)
{
  const AnalysisCost first = EstimateCost(Torus(1.0, 0.3, 30, 20)).After(2.0);
  AnalysisCost second = EstimateCost(Torus(1.0, 0.3, 60, 40));
  const AnalysisCost usual = second;
  second.LearnFrom(first, 9.0); // 4.5 triangulations
  EXPECT_DOUBLE_EQ(second.After(4.0).Seconds, 18.0);
  EXPECT_EQ(second.Bytes, usual.Bytes);
  // An analysis that was not even triangulated provides no estimate.
  AnalysisCost third = usual;
  third.LearnFrom(EstimateCost(Torus(1.0, 0.3, 30, 20)), 9.0);
  EXPECT_EQ(third.After(1.0).Seconds, usual.After(1.0).Seconds);
}

TEST(AnalysisCost, OwnPointsOfTheSurfaceCostMore)
{
  const AnalysisCost cost = EstimateCost(Torus(1.0, 0.3, 30, 20)).After(1.0);
  EXPECT_EQ(cost.Completion(), 0.0);
  AnalysisCost more = cost;
  more.ExpectCompletion(300);
  AnalysisCost most = cost;
  most.ExpectCompletion(600);
  EXPECT_GT(more.Completion(), 0.0);
  EXPECT_DOUBLE_EQ(most.Completion(), 2.0 * more.Completion());
  EXPECT_DOUBLE_EQ(more.After(1.0).Seconds, cost.Seconds + more.Completion());
  EXPECT_DOUBLE_EQ(most.Bytes - cost.Bytes, 2.0 * (more.Bytes - cost.Bytes));
  EXPECT_EQ(AnalysisCost{}.Completion(), 0.0);
}

/// A ring in noise: of rank over 20, refined twice or more, handles too thin for its samples.
TriangleMesh NoisyRing()
{
  std::mt19937 random(17);
  std::normal_distribution<double> normal(0.0, 0.1);
  return LevelSet(
    [&](double x, double y, double z)
    {
      const double value = std::hypot(std::hypot(x, y) - 0.55, z) - 0.25 + normal(random);
      return std::max({ std::abs(x), std::abs(y), std::abs(z) }) > 0.93 ? 1.0 : value;
    },
    1.0, 20);
}

TEST(AnalysisCost, SecondsOfANoisyContourAreWithinAFactorOfTwo)
{
  CpuEstimate reported;
  ChokingLoopParameters parameters;
  parameters.Estimated = std::ref(reported);
  const ChokingLoops loops(NoisyRing(), parameters);
  const double took = CpuSeconds() - reported.Began;
  EXPECT_GT(loops.Cost().Rank, 20U);
  EXPECT_GT(loops.Cost().Own, 0U);
  std::cout << "told " << reported.Last.Seconds << " s, took " << took << " s of CPU\n";
  EXPECT_GT(reported.Last.Seconds, 0.5 * took);
  EXPECT_LT(reported.Last.Seconds, 2.0 * took);
}

TEST(FeatureDrawing, SampleIsSpreadOverAll)
{
  for (const std::size_t count : { 0, 1, 23, 24, 25, 100, 193, 1000 })
  {
    std::size_t sample = 0;
    const std::vector<std::size_t> order = SampledFirst(count, sample);
    EXPECT_EQ(sample, std::min(count, std::max<std::size_t>(24, count / 4)));
    std::vector<std::size_t> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(sorted.size(), count);
    for (std::size_t i = 0; i < count; ++i)
    {
      EXPECT_EQ(sorted[i], i) << "each once";
    }
    // One in each of equal parts.
    for (std::size_t i = 0; i < sample; ++i)
    {
      EXPECT_GE((order[i] + 1) * sample, i * count);
      EXPECT_LE(order[i] * sample, (i + 1) * count);
    }
  }
}

TEST(FeatureDrawing, ReportsOnceAndDrawsTheRest)
{
  ChokingLoops loops(NoisyRing());
  const std::vector<std::size_t> chosen = loops.Select({});
  ASSERT_GT(chosen.size(), 50U);
  DrawnFeatures drawn;
  std::vector<DrawingCost> reported;
  const auto tell = [&reported](const DrawingCost& cost) { reported.push_back(cost); };
  DrawFeatures(loops, chosen, 1000, drawn, tell);
  ASSERT_EQ(reported.size(), 1U);
  EXPECT_EQ(reported[0].Loops, chosen.size() - std::max<std::size_t>(24, chosen.size() / 4));
  EXPECT_GT(reported[0].Seconds, 0.0);
  ASSERT_EQ(drawn.size(), chosen.size());
  for (std::size_t i = 0; i < chosen.size(); i += 25)
  {
    const LoopFeature alone = MakeLoopFeature(loops, chosen[i], 1000);
    const LoopFeature& among = drawn.at({ chosen[i], 1000 });
    EXPECT_EQ(among.Loops, alone.Loops);
    EXPECT_EQ(among.Lengths, alone.Lengths);
    EXPECT_EQ(among.Extra, alone.Extra);
  }
  // All loops are drawn: nothing to compute, nothing to report. Loops without shortening are a
  // separate drawing.
  DrawFeatures(loops, chosen, 1000, drawn, tell);
  EXPECT_EQ(reported.size(), 1U);
  DrawFeatures(loops, { chosen.front() }, 0, drawn, tell);
  EXPECT_EQ(reported.size(), 1U);
  EXPECT_EQ(drawn.size(), chosen.size() + 1);
}

TEST(AnalysisCost, ReportedBeforeAndAfterTriangulation)
{
  std::vector<AnalysisCost> reported;
  ChokingLoopParameters parameters;
  parameters.SampleSpacing = 0.05; // one round
  parameters.Estimated = [&reported](const AnalysisCost& cost) { reported.push_back(cost); };
  const ChokingLoops loops(Torus(1.0, 0.3, 60, 30), parameters);
  ASSERT_EQ(reported.size(), 2U);
  EXPECT_EQ(reported[0].Samples, loops.Samples().Points.size());
  EXPECT_LT(reported[0].Seconds, 0.0);
  EXPECT_GT(reported[1].Seconds, 0.0);
  EXPECT_EQ(reported[1].Seconds, loops.Cost().Seconds);
  EXPECT_GT(loops.Times().LastRound, 0.0);
}

TEST(AnalysisCost, BytesAreWithinAFactorOfTwo)
{
  TriangleMesh mesh =
    Torus(1.0, 0.3, 600, 200); // 120,000 points: the heap before it is small in comparison
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
