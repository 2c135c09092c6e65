// Atoms at protein density (one in 10 cubic angstrom) onto a grid of 0.5 angstrom: both forms, for
// growing numbers of atoms; compared with filling the grid once (a lower bound for any method) and
// beside vtkGaussianSplatter on the same grid with the same reach.

#include "Atoms/MolecularDensity.h"

#include <vtkGaussianSplatter.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace isthmus;

struct Case
{
  explicit Case(std::int64_t count)
  {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> place(0.0, std::cbrt(10.0 * static_cast<double>(count)));
    for (std::int64_t i = 0; i < count; ++i)
    {
      const double x = place(random);
      const double y = place(random);
      const double z = place(random);
      this->Balls.push_back({ { x, y, z }, 1.7 });
    }
    this->Grid = GridAroundBalls(this->Balls, 0.5, { 3.0, 3.0, 3.0 });
    const auto& n = this->Grid.Dimensions;
    this->Nodes.resize(static_cast<std::size_t>(n[0] * n[1] * n[2]));
  }
  GridView<float> View()
  {
    return { this->Nodes.data(), this->Grid.Dimensions, { 0.5, 0.5, 0.5 } };
  }

  std::vector<Ball> Balls;
  DensityGrid Grid;
  std::vector<float> Nodes;
};

/// Seconds of 100,000 Gaussians, kept for the ratios that the peers print.
double Ours = 0.0;

template <typename Work>
double MeasureSeconds(Work&& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Gaussians(benchmark::State& state)
{
  Case c(state.range(0));
  for (auto _ : state)
  {
    const double seconds =
      MeasureSeconds([&] { GaussianSum(c.Balls, 2.3, c.Grid.Origin, c.View()); });
    Ours = state.range(0) == 100000 ? seconds : Ours;
  }
  state.counters["nodes"] = static_cast<double>(c.Nodes.size());
  state.counters["s/atom"] = benchmark::Counter(static_cast<double>(state.range(0)),
    benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void Balls(benchmark::State& state)
{
  Case c(state.range(0));
  for (auto _ : state)
  {
    UnionOfBalls(c.Balls, c.Grid.Origin, c.View());
  }
}

void FillTheGrid(benchmark::State& state)
{
  Case c(state.range(0));
  for (auto _ : state)
  {
    const double seconds = MeasureSeconds(
      [&]
      {
        std::fill(c.Nodes.begin(), c.Nodes.end(), 1.0F);
        benchmark::ClobberMemory();
      });
    state.counters["Gaussians/this"] = Ours / seconds;
  }
}

void VTKGaussianSplatter(benchmark::State& state)
{
  Case c(state.range(0));
  vtkNew<vtkPolyData> atoms;
  vtkNew<vtkPoints> points;
  for (const Ball& ball : c.Balls)
  {
    points->InsertNextPoint(ball.Center.data());
  }
  atoms->SetPoints(points);
  const auto& n = c.Grid.Dimensions;
  double bounds[6];
  double longest = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double length = 0.5 * static_cast<double>(n[axis] - 1);
    bounds[2 * axis] = c.Grid.Origin[axis];
    bounds[2 * axis + 1] = c.Grid.Origin[axis] + length;
    longest = std::max(longest, length);
  }
  // Its radius is a fraction of the longest side; splats are cut there. Ours reach 2.65 radii.
  const double reach = 1.7 * std::sqrt(1.0 + std::log(1e6) / 2.3);
  vtkNew<vtkGaussianSplatter> splatter;
  splatter->SetInputData(atoms);
  splatter->SetSampleDimensions(
    static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2]));
  splatter->SetModelBounds(bounds);
  splatter->SetRadius(reach / longest);
  splatter->SetExponentFactor(-2.3 * reach * reach / (1.7 * 1.7));
  splatter->SetScaleFactor(std::exp(2.3));
  splatter->SetAccumulationModeToSum();
  splatter->ScalarWarpingOff();
  splatter->NormalWarpingOff();
  splatter->CappingOff();
  for (auto _ : state)
  {
    splatter->Modified();
    state.counters["Gaussians/this"] = Ours / MeasureSeconds([&] { splatter->Update(); });
  }
}

}

BENCHMARK(Gaussians)
  ->Unit(benchmark::kSecond)
  ->UseRealTime()
  ->Arg(25000)
  ->Arg(50000)
  ->Arg(100000)
  ->Arg(200000)
  ->Arg(400000);
BENCHMARK(Balls)->Unit(benchmark::kSecond)->UseRealTime()->Arg(100000);
BENCHMARK(FillTheGrid)->Unit(benchmark::kSecond)->UseRealTime()->Arg(100000);
BENCHMARK(VTKGaussianSplatter)->Unit(benchmark::kSecond)->UseRealTime()->Arg(100000)->Iterations(1);

BENCHMARK_MAIN();
