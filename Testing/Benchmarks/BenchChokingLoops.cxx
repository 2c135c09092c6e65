// Choking loops against GUDHI's alpha complex and persistence on the same points, and their growth.

#include "ChokingSurfaces.h"
#include "LoopFeature.h"

#include <benchmark/benchmark.h>

#if ISTHMUS_HAS_GUDHI
#include <gudhi/Alpha_complex_3d.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>
#endif

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

void WholeOf(benchmark::State& state, const TriangleMesh& mesh)
{
  for (auto _ : state)
  {
    ChokingLoops loops{ TriangleMesh(mesh) };
    FeatureSelection selection;
    selection.MinimumPersistence = { 4.0, true };
    for (const std::size_t i : loops.Select(selection))
    {
      benchmark::DoNotOptimize(MakeLoopFeature(loops, i, 0));
    }
    state.counters["points"] = static_cast<double>(loops.Samples().Points.size());
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
  ->Arg(100000)
  ->Arg(1000000)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->Iterations(1);

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
