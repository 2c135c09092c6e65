// A million triangles onto 256^3 nodes: flags and signed distance, by part.

#include "SurfaceModels.h"
#include "Surfaces/GridDistance.h"
#include "Surfaces/SurfaceCrossings.h"

#include <benchmark/benchmark.h>

namespace
{

using namespace isthmus;

/// 1,003,520 triangles of a ball, or of a flattened one (half as high); no node is at its center.
struct Case
{
  explicit Case(double height)
    : Mesh(isthmus::testing::Icosphere(224, 100.0))
  {
    for (auto& p : this->Mesh.Points)
    {
      p = { p[0] + 127.3, p[1] + 127.4, height * p[2] + 127.6 };
    }
  }

  isthmus::testing::Model Mesh;
  GridShape Grid{ { 256, 256, 256 }, { 1.0, 1.0, 1.0 } };
};

const Case& TheCase()
{
  static const Case made(1.0);
  return made;
}

void Crossings(benchmark::State& state)
{
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(
      SurfaceCrossings(TheCase().Mesh.View(), TheCase().Grid, CrossingNormal::Triangles));
  }
}

void Inside(benchmark::State& state)
{
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(NodesInside(TheCase().Mesh.View(), TheCase().Grid));
  }
}

void SignedDistance(benchmark::State& state)
{
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(DistanceToSurface(TheCase().Mesh.View(), TheCase().Grid, 2.0));
  }
}

/// range(0): a ball's height in per cent of its width; range(1): nodes along each axis.
void ExactDistance(benchmark::State& state)
{
  const Case made(0.01 * static_cast<double>(state.range(0)));
  const auto n = state.range(1);
  const GridShape grid{ { n, n, n }, { 256.0 / double(n), 256.0 / double(n), 256.0 / double(n) } };
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(ExactDistanceToSurface(made.Mesh.View(), grid));
  }
}

}

BENCHMARK(Crossings)->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(Inside)->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(SignedDistance)->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(ExactDistance)
  ->ArgsProduct({ { 50, 100 }, { 64, 128, 256 } })
  ->Iterations(1)
  ->Unit(benchmark::kSecond)
  ->UseRealTime()
  ->MeasureProcessCPUTime();

BENCHMARK_MAIN();
