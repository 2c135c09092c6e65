// What an analysis of choking loops was estimated to take, over what it took: ten shared surfaces,
// five noisy contours. The last row has the worst of all.

#include "ChokingLoops.h"
#include "ChokingSurfaces.h"
#include "PeakMemory.h"

#include <benchmark/benchmark.h>

#include <malloc.h>

#include <memory>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Resident memory without what was freed, in bytes.
double MemoryNow()
{
  malloc_trim(0);
  ResetPeakMemory();
  return PeakMemory();
}

/// The largest factor, either way, by which estimates missed so far.
struct Worst
{
  double Time = 1.0;
  double Memory = 1.0;
};

Worst& Misses()
{
  static Worst worst;
  return worst;
}

void EstimateOf(benchmark::State& state, const std::function<TriangleMesh()>& make)
{
  for (auto _ : state)
  {
    const TriangleMesh mesh = make();
    const double before = MemoryNow();
    const ChokingLoops loops{ TriangleMesh(mesh) };
    const double bytes = PeakMemory() - before;
    const AnalysisCost& cost = loops.Cost();
    const double time = cost.Seconds / loops.Times().LastRound;
    const double memory = cost.Bytes / bytes;
    Misses().Time = std::max({ Misses().Time, time, 1.0 / time });
    Misses().Memory = std::max({ Misses().Memory, memory, 1.0 / memory });
    state.counters["samples"] = static_cast<double>(cost.Samples);
    state.counters["rank"] = static_cast<double>(cost.Rank);
    state.counters["took_s"] = loops.Times().LastRound;
    state.counters["took_MB"] = bytes / 1e6;
    state.counters["estimated/took_s"] = time;
    state.counters["estimated/took_MB"] = memory;
  }
}

void OfSurface(benchmark::State& state, const char* name)
{
  EstimateOf(state, [name] { return ReadSurface(name); });
}
#define ISTHMUS_SURFACE(id, name)                                                                  \
  BENCHMARK_CAPTURE(OfSurface, id, name)->Unit(benchmark::kMillisecond)->Iterations(1)
ISTHMUS_SURFACE(soccerball, "soccerball.obj");
ISTHMUS_SURFACE(fertility, "fertility.off");
ISTHMUS_SURFACE(bunny, "bunny.off");
ISTHMUS_SURFACE(kitten, "Kitten.off");
ISTHMUS_SURFACE(casting, "casting.off");
ISTHMUS_SURFACE(groel, "emd_5043.obj");
ISTHMUS_SURFACE(stl, "1514499.stl");
ISTHMUS_SURFACE(protein, "129110__sf.obj");
ISTHMUS_SURFACE(armadillo, "armadillo.obj");
ISTHMUS_SURFACE(botijo, "botijo.off");

using Shape = double (*)(double x, double y, double z);

double Ball(double x, double y, double z)
{
  return std::sqrt(x * x + y * y + z * z) - 0.7;
}

double Ring(double x, double y, double z)
{
  return std::hypot(std::hypot(x, y) - 0.55, z) - 0.25;
}

double Gyroid(double x, double y, double z)
{
  const double k = 7.0;
  return 0.3 *
    (std::sin(k * x) * std::cos(k * y) + std::sin(k * y) * std::cos(k * z) +
      std::sin(k * z) * std::cos(k * x));
}

double Nothing(double, double, double)
{
  return 0.35;
}

/// A shape in a cube of side 2, on n cells a side, its nodes with normal noise of deviation
/// `noise`.
void OfNoise(benchmark::State& state, Shape shape, double noise, int n)
{
  EstimateOf(state,
    [=]
    {
      std::mt19937 random(7);
      std::normal_distribution<double> normal(0.0, noise);
      return LevelSet(
        [&](double x, double y, double z)
        {
          const double value = shape(x, y, z) + normal(random);
          return std::max({ std::abs(x), std::abs(y), std::abs(z) }) > 0.93 ? 1.0 : value;
        },
        1.0, n);
    });
}
#define ISTHMUS_NOISE(id, shape, noise, n)                                                         \
  BENCHMARK_CAPTURE(OfNoise, id, shape, noise, n)->Unit(benchmark::kMillisecond)->Iterations(1)
ISTHMUS_NOISE(ball, Ball, 0.03, 60);
ISTHMUS_NOISE(ball_and_dust, Ball, 0.1, 40);
ISTHMUS_NOISE(ring, Ring, 0.1, 40);
ISTHMUS_NOISE(gyroid, Gyroid, 0.1, 40);
ISTHMUS_NOISE(dust, Nothing, 0.2, 30);

/// By what factor, either way, the worst of the rows before missed.
void WorstOfAll(benchmark::State& state)
{
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(Misses());
  }
  state.counters["time"] = Misses().Time;
  state.counters["memory"] = Misses().Memory;
}
BENCHMARK(WorstOfAll)->Iterations(1);

}

BENCHMARK_MAIN();
