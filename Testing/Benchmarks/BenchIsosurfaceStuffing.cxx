// Isosurface stuffing: tetrahedra per second and memory, uniform and graded. Acceptance: 10^6
// tetrahedra in under 10 s. Run by hand on a quiet machine.

#include "Tetrahedra/IsosurfaceStuffing.h"

#include <benchmark/benchmark.h>

#include <sys/resource.h>

using namespace isthmus;

namespace
{

/// A ball of radius 1 in cells of 1/n, with the requested number of levels of grading.
void Ball(benchmark::State& state, MeshedSide side)
{
  StuffingParameters parameters;
  parameters.CellSize = 1.0 / static_cast<double>(state.range(0));
  parameters.GradingLevels = static_cast<int>(state.range(1));
  parameters.Side = side;
  std::size_t count = 0;
  for (auto _ : state)
  {
    count = IsosurfaceStuffing([](const Point3& x) { return 1.0 - std::sqrt(Dot(x, x)); },
      { { -1, -1, -1 }, { 1, 1, 1 } }, parameters)
              .Mesh.Tetrahedra.size();
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["tetrahedra"] = static_cast<double>(count);
  state.counters["MB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}

}

BENCHMARK_CAPTURE(Ball, Inside, MeshedSide::Inside)
  ->Args({ 28, 0 }) // 1.1 million
  ->Args({ 28, 3 })
  ->Args({ 60, 0 }) // 11 million
  ->Unit(benchmark::kMillisecond)
  ->Iterations(1);
BENCHMARK_CAPTURE(Ball, Both, MeshedSide::Both)
  ->Args({ 28, 0 })
  ->Args({ 28, 3 })
  ->Unit(benchmark::kMillisecond)
  ->Iterations(1);

BENCHMARK_MAIN();
