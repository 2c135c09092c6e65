// Flow surfaces of atoms at protein density (one in 10 cubic angstrom): to the thesis' time and to
// convergence, for growing numbers of atoms and falling spacings, the thesis' scheme, and for
// comparison vtkMolecularDensity's algorithm on the same atoms, spacing and padding. With files
// named by ISTHMUS_FLOW_ATOMS (PDB or PQR, divided by colons), those molecules as well.

#include "Atoms/MolecularDensity.h"
#include "Atoms/MoleculeAtoms.h"
#include "MolecularSurfaces/SolventExcludedSurface.h"
#include "MolecularSurfaces/SurfaceFlow.h"
#include "MolecularSurfaces/ThesisFlow.h"
#include "vtkMacromoleculeReader.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace isthmus;

std::vector<Ball> Atoms(std::int64_t count)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(0.0, std::cbrt(10.0 * static_cast<double>(count)));
  std::vector<Ball> balls;
  for (std::int64_t i = 0; i < count; ++i)
  {
    const double x = place(random);
    const double y = place(random);
    const double z = place(random);
    balls.push_back({ { x, y, z }, 1.7 });
  }
  return balls;
}

void ReportCounters(benchmark::State& state, const std::vector<Ball>& balls,
  const SurfaceFlowParameters& parameters, const SurfaceFlowResult& result)
{
  double bytes = 0.0;
  FlowResultGrid(balls, parameters, &bytes);
  state.counters["nodes"] = static_cast<double>(result.Distance.size());
  state.counters["bytes/node"] = bytes / static_cast<double>(result.Distance.size());
  state.counters["area"] = result.History.back().Area;
  state.counters["atoms"] = static_cast<double>(balls.size());
}

void Run(
  benchmark::State& state, const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters)
{
  SurfaceFlowResult result;
  for (auto _ : state)
  {
    result = SurfaceFlow(balls, parameters);
  }
  ReportCounters(state, balls, parameters, result);
}

void ThesisTime(benchmark::State& state)
{
  SurfaceFlowParameters parameters;
  parameters.Spacing = static_cast<double>(state.range(1)) / 100.0;
  Run(state, Atoms(state.range(0)), parameters);
}

void ToRest(benchmark::State& state)
{
  SurfaceFlowParameters parameters;
  parameters.Steady = true;
  parameters.Spacing = static_cast<double>(state.range(1)) / 100.0;
  Run(state, Atoms(state.range(0)), parameters);
}

void WithProbe(benchmark::State& state)
{
  SurfaceFlowParameters parameters;
  parameters.Steady = true;
  parameters.ProbeRadius = 1.4;
  Run(state, Atoms(state.range(0)), parameters);
}

void SolventExcluded(benchmark::State& state)
{
  SurfaceFlowParameters parameters;
  parameters.ProbeRadius = 1.4;
  const std::vector<Ball> balls = Atoms(state.range(0));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(SolventExcludedSurface(balls, parameters));
  }
}

void ThesisScheme(benchmark::State& state)
{
  const SurfaceFlowParameters parameters;
  const std::vector<Ball> balls = Atoms(state.range(0));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(ThesisFlow(balls, parameters));
  }
}

void Density(benchmark::State& state)
{
  const std::vector<Ball> balls = Atoms(state.range(0));
  const DensityGrid grid = GridAroundBalls(balls, 0.5, { 2.2, 2.2, 2.2 });
  const auto& n = grid.Dimensions;
  std::vector<float> nodes(static_cast<std::size_t>(n[0] * n[1] * n[2]));
  for (auto _ : state)
  {
    GaussianSum(balls, 2.3, grid.Origin, { nodes.data(), n, { 0.5, 0.5, 0.5 } });
  }
  state.counters["nodes"] = static_cast<double>(nodes.size());
}

void RegisterFile(const std::string& file)
{
  vtkNew<vtkMacromoleculeReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  const std::vector<Ball> balls =
    ReadAtoms(reader->GetOutput(), SelectWholeMolecule("Radius")).Balls;
  const double spacing = balls.size() > 20000 ? 0.8 : 0.5;
  for (const bool steady : { false, true })
  {
    benchmark::RegisterBenchmark((file + (steady ? " to rest" : " thesis' time")).c_str(),
      [=](benchmark::State& state)
      {
        SurfaceFlowParameters parameters;
        parameters.Spacing = spacing;
        parameters.Steady = steady;
        Run(state, balls, parameters);
      })
      ->Unit(benchmark::kSecond)
      ->UseRealTime();
  }
}

}

// Atoms, spacing in 1/100 angstrom.
BENCHMARK(ThesisTime)
  ->Unit(benchmark::kSecond)
  ->UseRealTime()
  ->Args({ 2000, 50 })
  ->Args({ 8000, 50 })
  ->Args({ 32000, 50 })
  ->Args({ 2000, 35 })
  ->Args({ 2000, 25 });
BENCHMARK(ToRest)
  ->Unit(benchmark::kSecond)
  ->UseRealTime()
  ->Args({ 2000, 50 })
  ->Args({ 8000, 50 })
  ->Args({ 32000, 50 })
  ->Args({ 2000, 35 })
  ->Args({ 2000, 25 });
BENCHMARK(WithProbe)->Unit(benchmark::kSecond)->UseRealTime()->Arg(2000)->Arg(8000);
BENCHMARK(SolventExcluded)->Unit(benchmark::kSecond)->UseRealTime()->Arg(2000)->Arg(8000);
BENCHMARK(ThesisScheme)->Unit(benchmark::kSecond)->UseRealTime()->Arg(2000)->Arg(8000);
BENCHMARK(Density)->Unit(benchmark::kSecond)->UseRealTime()->Arg(2000)->Arg(8000)->Arg(32000);

int main(int argc, char** argv)
{
  const char* files = std::getenv("ISTHMUS_FLOW_ATOMS");
  std::istringstream names(files ? files : "");
  for (std::string file; std::getline(names, file, ':');)
  {
    RegisterFile(file);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
