// Ratio of estimated and actual CPU time of an analysis of choking loops and of drawing its loops:
// ten shared surfaces, and contours with noise. The last row has the worst ratio.

#include "ChokingLoops/ChokingLoops.h"
#include "ChokingLoops/LoopDrawing.h"
#include "ChokingSurfaces.h"
#include "CpuEstimate.h"
#include "PeakMemory.h"

#include <benchmark/benchmark.h>

#include <malloc.h>

#include <memory>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Resident memory after freed memory is returned to the system, in bytes.
double MemoryNow()
{
  malloc_trim(0);
  ResetPeakMemory();
  return PeakMemory();
}

/// The largest factor so far by which estimates were too high or too low.
struct Worst
{
  double Time = 1.0;
  double Memory = 1.0;
  double Drawing = 1.0;
};

Worst& Misses()
{
  static Worst worst;
  return worst;
}

void UpdateWorst(double ratio, double& worst)
{
  worst = std::max({ worst, ratio, 1.0 / ratio });
}

/// Until loops are geodesic, as the filter draws them.
constexpr int ManyRounds = 1000;

/// Below this many seconds, estimates are not relevant.
constexpr double WorthTelling = 0.2;

void Draw(benchmark::State& state, ChokingLoops& loops)
{
  const std::vector<std::size_t> chosen = loops.Select({});
  DrawnFeatures drawn;
  const double began = CpuSeconds();
  double sampled = began;
  double told = 0.0;
  DrawFeatures(loops, chosen, ManyRounds, drawn,
    [&](const DrawingCost& left)
    {
      sampled = CpuSeconds();
      told = DrawingCost::After(chosen.size() - left.Loops, chosen.size(), sampled - began).Seconds;
    });
  const double end = CpuSeconds();
  state.counters["features"] = static_cast<double>(chosen.size());
  state.counters["drawn_s"] = end - began;
  if (sampled > began && end - sampled > WorthTelling)
  {
    state.counters["estimated/drawn_s"] = told / (end - sampled);
    UpdateWorst(told / (end - sampled), Misses().Drawing);
  }
}

void MeasureEstimate(benchmark::State& state, const std::function<TriangleMesh()>& make)
{
  for (auto _ : state)
  {
    const TriangleMesh mesh = make();
    const double before = MemoryNow();
    CpuEstimate told;
    ChokingLoopParameters parameters;
    parameters.Estimated = std::ref(told);
    ChokingLoops loops(TriangleMesh(mesh), parameters);
    const double took = CpuSeconds() - told.Began;
    const double analysed = PeakMemory() - before;
    Draw(state, loops);
    const double bytes = PeakMemory() - before; // of both
    const AnalysisCost& cost = loops.Cost();
    UpdateWorst(told.Last.Seconds / took, Misses().Time);
    UpdateWorst(cost.Bytes / bytes, Misses().Memory);
    state.counters["samples"] = static_cast<double>(cost.Samples);
    state.counters["rank"] = static_cast<double>(cost.Rank);
    state.counters["took_s"] = took;
    state.counters["estimated/took_s"] = told.Last.Seconds / took;
    if (told.Corrected > 0.0)
    {
      state.counters["corrected/took_s"] = told.Corrected / took;
    }
    state.counters["analysed_MB"] = analysed / 1e6;
    state.counters["took_MB"] = bytes / 1e6;
    state.counters["estimated/took_MB"] = cost.Bytes / bytes;
  }
}

void OfSurface(benchmark::State& state, const char* name)
{
  MeasureEstimate(state, [name] { return ReadSurface(name); });
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

/// Whether a node is so close to the border of the cube that it is set to outside.
bool IsAtBorder(double x, double y, double z)
{
  return std::max({ std::abs(x), std::abs(y), std::abs(z) }) > 0.93;
}

/// A shape in a cube of side 2, on n cells per side, with normal noise at its nodes of deviation
/// `noise`.
void OfNoise(benchmark::State& state, Shape shape, double noise, int n, unsigned seed = 7)
{
  MeasureEstimate(state,
    [=]
    {
      std::mt19937 random(seed);
      std::normal_distribution<double> normal(0.0, noise);
      return LevelSet(
        [&](double x, double y, double z)
        {
          const double value = shape(x, y, z) + normal(random);
          return IsAtBorder(x, y, z) ? 1.0 : value;
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

// Data that were not used to fit the constants.
#define ISTHMUS_UNSEEN(id, shape, noise, n, seed)                                                  \
  BENCHMARK_CAPTURE(OfNoise, id, shape, noise, n, seed)                                            \
    ->Unit(benchmark::kMillisecond)                                                                \
    ->Iterations(1)
ISTHMUS_UNSEEN(unseen_ball, Ball, 0.08, 45, 21);
ISTHMUS_UNSEEN(unseen_ball_fine, Ball, 0.05, 70, 22);
ISTHMUS_UNSEEN(unseen_ring, Ring, 0.15, 35, 23);
ISTHMUS_UNSEEN(unseen_gyroid, Gyroid, 0.07, 45, 24);
ISTHMUS_UNSEEN(unseen_gyroid_rough, Gyroid, 0.15, 30, 25);
ISTHMUS_UNSEEN(unseen_dust, Nothing, 0.22, 28, 26);

/// Gaussian blobs at random places.
void OfBlobs(benchmark::State& state, int count, double width, double level, unsigned seed)
{
  MeasureEstimate(state,
    [=]
    {
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> place(-0.8, 0.8);
      std::vector<Point3> blobs(static_cast<std::size_t>(count));
      for (Point3& p : blobs)
      {
        p = { place(random), place(random), place(random) };
      }
      return LevelSet(
        [&](double x, double y, double z)
        {
          double sum = 0.0;
          for (const Point3& p : blobs)
          {
            const Point3 d = Point3{ x, y, z } - p;
            sum += std::exp(-Dot(d, d) / (2.0 * width * width));
          }
          return IsAtBorder(x, y, z) ? 1.0 : level - sum;
        },
        1.0, 50);
    });
}
#define ISTHMUS_BLOBS(id, count, width, level, seed)                                               \
  BENCHMARK_CAPTURE(OfBlobs, id, count, width, level, seed)                                        \
    ->Unit(benchmark::kMillisecond)                                                                \
    ->Iterations(1)
ISTHMUS_BLOBS(unseen_80, 80, 0.1, 0.6, 31);
ISTHMUS_BLOBS(unseen_200, 200, 0.06, 0.5, 32);

/// The largest factor by which an estimate in the previous rows was too high or too low.
void WorstOfAll(benchmark::State& state)
{
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(Misses());
  }
  state.counters["time"] = Misses().Time;
  state.counters["memory"] = Misses().Memory;
  state.counters["drawing"] = Misses().Drawing;
}
BENCHMARK(WorstOfAll)->Iterations(1);

}

BENCHMARK_MAIN();
