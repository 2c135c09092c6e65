// A million triangles onto 256^3 nodes: flags and signed distance, by part.

#include "GridDistance.h"
#include "SurfaceCrossings.h"
#include "SurfaceModels.h"

#include <benchmark/benchmark.h>

namespace
{

using namespace isthmus;

struct Case
{
  Case()
    : Mesh(isthmus::testing::Icosphere(224, 100.0))
  {
    for (auto& p : this->Mesh.Points)
    {
      p = { p[0] + 127.3, p[1] + 127.4, p[2] + 127.6 };
    }
  }

  isthmus::testing::Model Mesh; ///< 1,003,520 triangles
  GridShape Grid{ { 256, 256, 256 }, { 1.0, 1.0, 1.0 } };
};

const Case& TheCase()
{
  static const Case made;
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

}

BENCHMARK(Crossings)->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(Inside)->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(SignedDistance)->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime();

BENCHMARK_MAIN();
