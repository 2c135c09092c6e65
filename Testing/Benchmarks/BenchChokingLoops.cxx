// Choking loops against GUDHI's alpha complex and persistence on the same points; growth of time
// with size, peak memory, and response times to sliders.

#include "ChokingLoops/LoopDrawing.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "ChokingSurfaces.h"
#include "PeakMemory.h"
#include "vtkChokingLoops.h"

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

/// Loops and membranes of both sides; how many features they belong to.
std::size_t LoopsAndMembranes(ChokingLoops& loops)
{
  FeatureSelection selection;
  selection.MinimumPersistence = 4.0;
  const std::vector<std::size_t> chosen = loops.Select(selection);
  for (const std::size_t i : chosen)
  {
    benchmark::DoNotOptimize(MakeLoopFeature(loops, i, 0));
  }
  return chosen.size();
}

double Seconds(const std::function<void()>& work)
{
  const auto started = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
}

/// Everything for a surface; seconds by stage, microseconds per sample, peak memory.
void MakeWhole(benchmark::State& state, const TriangleMesh& mesh)
{
  for (auto _ : state)
  {
    ResetPeakMemory();
    std::optional<ChokingLoops> loops;
    std::size_t features = 0;
    const double took = Seconds(
      [&]
      {
        loops.emplace(TriangleMesh(mesh));
        features = LoopsAndMembranes(*loops);
      });
    const auto samples = static_cast<double>(loops->Samples().Points.size());
    const ChokingLoopTimes& t = loops->Times();
    state.counters["points"] = static_cast<double>(mesh.Points.size());
    state.counters["samples"] = samples;
    state.counters["features"] = static_cast<double>(features);
    state.counters["us_a_sample"] = 1e6 * took / samples;
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
  MakeWhole(state, ReadSurface("soccerball.obj"));
}
BENCHMARK(BM_Soccerball)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(3.0);

#if ISTHMUS_HAS_GUDHI
/// Alpha complex and persistence over Z/2 by GUDHI: no sides, no loops, no membranes.
template <Gudhi::alpha_complex::complexity Accuracy>
void PairsByGudhi(const TriangleMesh& mesh)
{
  using Alpha = Gudhi::alpha_complex::Alpha_complex_3d<Accuracy>;
  using Tree = Gudhi::Simplex_tree<>;
  using Persistence = Gudhi::persistent_cohomology::Persistent_cohomology<Tree,
    Gudhi::persistent_cohomology::Field_Zp>;
  std::vector<typename Alpha::Bare_point_3> points;
  for (const Point3& p : mesh.Points)
  {
    points.emplace_back(p[0], p[1], p[2]);
  }
  Alpha alpha(points);
  Tree tree;
  alpha.create_complex(tree);
  Persistence persistence(tree);
  persistence.init_coefficients(2);
  persistence.compute_persistent_cohomology();
  benchmark::DoNotOptimize(persistence.get_persistent_pairs().size());
}

/// GUDHI's time on the points that we sample, ours, and the ratio of ours to GUDHI's.
/// SAFE has exact predicates and filtered values as ours, FAST has plain doubles.
template <Gudhi::alpha_complex::complexity Accuracy>
void BM_SoccerballGudhi(benchmark::State& state)
{
  const TriangleMesh mesh = ReadSurface("soccerball.obj");
  const TriangleMesh samples = ChokingLoops(TriangleMesh(mesh)).Samples();
  double ours = 0.0;
  double gudhi = 0.0;
  for (auto _ : state)
  {
    gudhi += Seconds([&] { PairsByGudhi<Accuracy>(samples); });
    state.PauseTiming();
    ours += Seconds(
      [&mesh]
      {
        ChokingLoops loops{ TriangleMesh(mesh) };
        LoopsAndMembranes(loops);
      });
    state.ResumeTiming();
  }
  state.counters["ours_s"] = ours / static_cast<double>(state.iterations());
  state.counters["gudhi_s"] = gudhi / static_cast<double>(state.iterations());
  state.counters["ours/gudhi"] = ours / gudhi;
}
BENCHMARK(BM_SoccerballGudhi<Gudhi::alpha_complex::complexity::SAFE>)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->Iterations(3);
BENCHMARK(BM_SoccerballGudhi<Gudhi::alpha_complex::complexity::FAST>)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->Iterations(5);
#endif

/// A torus of about the given number of points: growth of time with size.
void BM_Growth(benchmark::State& state)
{
  const auto across = static_cast<int>(std::sqrt(static_cast<double>(state.range(0)) / 3.0));
  // Slightly deformed: a torus of regular rings is maximally degenerate.
  TriangleMesh mesh = Torus(1.0, 0.3, 3 * across, across);
  for (Point3& p : mesh.Points)
  {
    const double bulge =
      1.0 + 0.05 * std::sin(5.0 * p[0] + 3.0 * p[1]) * std::cos(4.0 * p[1] - p[2]);
    p = bulge * p;
  }
  MakeWhole(state, mesh);
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

/// `mesh` with edges split until it has at least `points` points, but only slightly more.
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
  MakeWhole(state, SplitTo(ReadSurface("armadillo.obj"), static_cast<std::size_t>(state.range(0))));
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
  MakeWhole(state, SplitTo(ToTriangleMesh(subdivision->GetOutput()), 1000000));
}
BENCHMARK(BM_ArmadilloSmooth)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

/// Time of the filter until its first result after each change.
void Steering(benchmark::State& state, const std::function<void(vtkChokingLoops*)>& change)
{
  vtkNew<vtkPolyData> surface;
  SetMesh(ReadSurface("soccerball.obj"), surface);
  for (auto _ : state)
  {
    state.PauseTiming();
    vtkNew<vtkChokingLoops> loops;
    loops->SetInputData(surface);
    loops->SetMinimumPersistence(50.0);
    loops->SetSide(vtkChokingLoops::Inside);
    loops->Update();
    state.ResumeTiming();
    change(loops);
    loops->Update();
  }
}

void BM_SteerThreshold(benchmark::State& state)
{
  Steering(state, [](vtkChokingLoops* loops) { loops->SetMinimumPersistence(0.0); });
}
BENCHMARK(BM_SteerThreshold)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(5);

void BM_SteerSide(benchmark::State& state)
{
  Steering(state, [](vtkChokingLoops* loops) { loops->SetSide(vtkChokingLoops::Both); });
}
BENCHMARK(BM_SteerSide)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(5);

void BM_SteerEverything(benchmark::State& state)
{
  Steering(state,
    [](vtkChokingLoops* loops)
    {
      loops->SetMinimumPersistence(4.0);
      loops->SetSide(vtkChokingLoops::Both);
      loops->SetShortening(vtkChokingLoops::Geodesic);
    });
}
BENCHMARK(BM_SteerEverything)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(5);

}

BENCHMARK_MAIN();
