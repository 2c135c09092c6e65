// Removal of small handles and tunnels, compared with the minimum cost: one analysis of the
// surface, and the membranes of the removed features.

#include "ChokingLoops/HandleFilling.h"
#include "ChokingLoops/LoopDrawing.h"
#include "ChokingSurfaces.h"

#include <benchmark/benchmark.h>

#include <chrono>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

double Seconds(const std::function<void()>& work)
{
  const auto started = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
}

/// As FillHandles() draws them.
constexpr int UntilGeodesic = 1000;

/// The unavoidable cost: finding the features to remove, and computing their membranes.
void Find(const TriangleMesh& mesh, double below)
{
  ChokingLoops loops{ TriangleMesh(mesh) };
  for (std::size_t i = 0; i < loops.Diagram().Features.size(); ++i)
  {
    const ShapeFeature& f = loops.Diagram().Features[i];
    if (IsGenerator(f) && f.Radius() < below)
    {
      benchmark::DoNotOptimize(MakeLoopFeature(loops, i, UntilGeodesic));
    }
  }
}

/// Both alternately, on one surface; the difference is the surgery.
void Filling(benchmark::State& state, const char* name, double below)
{
  const TriangleMesh mesh = ReadSurface(name);
  HandleFillingParameters parameters;
  parameters.FillHandlesBelow = below;
  double ours = 0.0;
  double limit = 0.0;
  std::size_t filled = 0;
  std::size_t left = 0;
  for (auto _ : state)
  {
    state.PauseTiming();
    limit += Seconds([&] { Find(mesh, below); });
    state.ResumeTiming();
    ours += Seconds(
      [&]
      {
        const FilledSurface surface = FillHandles(mesh, parameters);
        filled = surface.Fills.size();
        left = surface.Left;
      });
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["ours_s"] = ours / runs;
  state.counters["limit_s"] = limit / runs;
  state.counters["ours/limit"] = ours / limit;
  state.counters["filled"] = static_cast<double>(filled);
  state.counters["left"] = static_cast<double>(left);
}
#define ISTHMUS_FILLING(id, name, below)                                                           \
  BENCHMARK_CAPTURE(Filling, id, name, below)                                                      \
    ->Unit(benchmark::kMillisecond)                                                                \
    ->UseRealTime()                                                                                \
    ->Iterations(3)
ISTHMUS_FILLING(soccerball, "soccerball.obj", 0.2);
ISTHMUS_FILLING(groel_smallest, "emd_5043.obj", 5.0);
ISTHMUS_FILLING(groel_all, "emd_5043.obj", 8.0);
ISTHMUS_FILLING(fertility, "fertility.off", 1e3);

}

BENCHMARK_MAIN();
