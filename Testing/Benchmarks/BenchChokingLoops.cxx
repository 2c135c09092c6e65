// Choking loops against GUDHI's alpha complex and persistence on the same points; their growth and
// peak memory; how fast they answer to sliders.

#include "ChokingSurfaces.h"
#include "LoopFeature.h"
#include "PeakMemory.h"
#include "SurfaceSampling.h"

#include <vtkLoopSubdivisionFilter.h>

#include <benchmark/benchmark.h>

#include <chrono>

#if ISTHMUS_HAS_GUDHI
#include <gudhi/Alpha_complex_3d.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>
#endif

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Both sides, loops and membranes; seconds by stage, microseconds a sample, peak memory.
void WholeOf(benchmark::State& state, const TriangleMesh& mesh)
{
  for (auto _ : state)
  {
    ResetPeakMemory();
    const auto started = std::chrono::steady_clock::now();
    ChokingLoops loops{ TriangleMesh(mesh) };
    FeatureSelection selection;
    selection.MinimumPersistence = { 4.0, true };
    const std::vector<std::size_t> chosen = loops.Select(selection);
    for (const std::size_t i : chosen)
    {
      benchmark::DoNotOptimize(MakeLoopFeature(loops, i, 0));
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - started;
    const auto samples = static_cast<double>(loops.Samples().Points.size());
    const ChokingLoopTimes& t = loops.Times();
    state.counters["points"] = static_cast<double>(mesh.Points.size());
    state.counters["samples"] = samples;
    state.counters["features"] = static_cast<double>(chosen.size());
    state.counters["us_a_sample"] = 1e6 * took.count() / samples;
    state.counters["peak_GB"] = PeakMemory() / 1e9;
    state.counters["1_check"] = t.Check;
    state.counters["2_sampling"] = t.Sampling;
    state.counters["3_filtration"] = t.Filtration;
    state.counters["4_pairing"] = t.Pairing;
    state.counters["5_features"] = t.Features;
  }
}

void BM_Soccerball(benchmark::State& state)
{
  WholeOf(state, ReadSurface("soccerball.obj"));
}
BENCHMARK(BM_Soccerball)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(3.0);

#if ISTHMUS_HAS_GUDHI
void BM_SoccerballGudhi(benchmark::State& state)
{
  using Alpha = Gudhi::alpha_complex::Alpha_complex_3d<Gudhi::alpha_complex::complexity::SAFE>;
  using Tree = Gudhi::Simplex_tree<>;
  using Persistence = Gudhi::persistent_cohomology::Persistent_cohomology<Tree,
    Gudhi::persistent_cohomology::Field_Zp>;
  const TriangleMesh mesh = ReadSurface("soccerball.obj");
  std::vector<Alpha::Bare_point_3> points;
  for (const Point3& p : mesh.Points)
  {
    points.emplace_back(p[0], p[1], p[2]);
  }
  for (auto _ : state)
  {
    Alpha alpha(points);
    Tree tree;
    alpha.create_complex(tree);
    Persistence persistence(tree);
    persistence.init_coefficients(2);
    persistence.compute_persistent_cohomology();
    benchmark::DoNotOptimize(persistence.get_persistent_pairs().size());
  }
}
BENCHMARK(BM_SoccerballGudhi)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(3.0);
#endif

/// A torus of about the given number of points: growth of time with size.
void BM_Growth(benchmark::State& state)
{
  const auto across = static_cast<int>(std::sqrt(static_cast<double>(state.range(0)) / 3.0));
  // Not exactly round: a torus of regular rings is as degenerate as a surface can be.
  TriangleMesh mesh = Torus(1.0, 0.3, 3 * across, across);
  for (Point3& p : mesh.Points)
  {
    const double bulge =
      1.0 + 0.05 * std::sin(5.0 * p[0] + 3.0 * p[1]) * std::cos(4.0 * p[1] - p[2]);
    p = bulge * p;
  }
  WholeOf(state, mesh);
}
BENCHMARK(BM_Growth)
  ->Arg(10000)
  ->Arg(30000)
  ->Arg(100000)
  ->Arg(300000)
  ->Arg(1000000)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->Iterations(1);

/// `mesh` with edges split until it has at least `points` points, and hardly more.
TriangleMesh SplitTo(const TriangleMesh& mesh, std::size_t points)
{
  TriangleMesh split;
  for (double factor = 1.7; split.Points.size() < points; factor *= 0.99)
  {
    const double longest = factor * EdgeLengthFor(mesh, static_cast<double>(points));
    split = SplitLongEdges(
      mesh, [longest](const Point3&, const Point3&) { return longest; }, 2 * points);
  }
  return split;
}

/// Flat pieces: the most degenerate input, since new points lie in the planes of the old triangles.
void BM_ArmadilloSplit(benchmark::State& state)
{
  WholeOf(
    state, SplitTo(ReadSurface("armadillo.obj"), static_cast<std::size_t>(state.range(0))));
}
BENCHMARK(BM_ArmadilloSplit)
  ->Arg(30000)
  ->Arg(100000)
  ->Arg(300000)
  ->Arg(1000000)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->Iterations(1);

/// Smooth: Loop's subdivision three times, and as many edges split as a million points take.
void BM_ArmadilloSmooth(benchmark::State& state)
{
  vtkNew<vtkPolyData> coarse;
  SetMesh(ReadSurface("armadillo.obj"), coarse);
  vtkNew<vtkLoopSubdivisionFilter> subdivision;
  subdivision->SetInputData(coarse);
  subdivision->SetNumberOfSubdivisions(3);
  subdivision->Update();
  WholeOf(state, SplitTo(MeshOf(subdivision->GetOutput()), 1000000));
}
BENCHMARK(BM_ArmadilloSmooth)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

void BM_SlidersOfSoccerball(benchmark::State& state)
{
  ChokingLoops loops(ReadSurface("soccerball.obj"));
  double percent = 4.0;
  for (auto _ : state)
  {
    FeatureSelection selection;
    selection.MinimumPersistence = { percent, true };
    percent = percent > 6.0 ? 4.0 : percent + 0.1;
    for (const std::size_t i : loops.Select(selection))
    {
      benchmark::DoNotOptimize(MakeLoopFeature(loops, i, 0));
    }
  }
}
BENCHMARK(BM_SlidersOfSoccerball)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_GeodesicsOfSoccerball(benchmark::State& state)
{
  ChokingLoops loops(ReadSurface("soccerball.obj"));
  FeatureSelection selection;
  selection.MinimumPersistence = { 4.0, true };
  for (auto _ : state)
  {
    for (const std::size_t i : loops.Select(selection))
    {
      benchmark::DoNotOptimize(MakeLoopFeature(loops, i, 1000));
    }
  }
}
BENCHMARK(BM_GeodesicsOfSoccerball)->Unit(benchmark::kMillisecond)->UseRealTime();

}

BENCHMARK_MAIN();
