// An update of lysozyme's coupled surface and field (1HEW, dielectrics 2 and 80), on grids of
// growing size: the time of a converged run divided by its updates, including start, border and
// energies. In the same run, a single solution of the Poisson-Boltzmann equation on the last
// surface, from zero, and the ratio of the two. Needs ISTHMUS_DATA_DIR or the default data.

#include "ChargedProtein.h"
#include "Solvation/SolvationFlow.h"

#include <benchmark/benchmark.h>

#include <chrono>

namespace
{

using namespace isthmus;

double Seconds(std::chrono::steady_clock::time_point from)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

void Update(benchmark::State& state)
{
  SolvationParameters p;
  p.Flow.Spacing = 0.01 * static_cast<double>(state.range(0));
  p.Flow.ProbeRadius = 1.4;
  p.Potential.Padding = 6.0;
  const SolvationAtoms atoms = isthmus::testing::ProteinAtoms("molecules/1hew/1hew.pqr");
  for (auto _ : state)
  {
    auto start = std::chrono::steady_clock::now();
    SolvationFlow flow(atoms, p);
    flow.Run();
    const double update = Seconds(start) / static_cast<double>(flow.GetUpdates().size());
    state.SetIterationTime(update);
    std::vector<ChargedAtom> placed = atoms.Charges;
    for (ChargedAtom& atom : placed)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        atom.Position[a] -= flow.GetSurface().Grid.Origin[a];
      }
    }
    start = std::chrono::steady_clock::now();
    const SolverBox box = BoxAround(flow.GetLevel(), p.Potential.Padding);
    const auto alone = SolvePoissonBoltzmann(
      flow.GetLevel(), box, placed, p.Potential, IonAtmosphere({}, p.Potential.Temperature));
    const double nodes =
      static_cast<double>(box.Dimensions[0] * box.Dimensions[1] * box.Dimensions[2]);
    state.counters["nodes"] = nodes;
    state.counters["updates"] = static_cast<double>(flow.GetUpdates().size());
    state.counters["us_node"] = 1e6 * update / nodes;
    state.counters["to_alone"] = update / Seconds(start);
    benchmark::DoNotOptimize(alone);
  }
}

// 0.70 angstrom gives about 440 thousand nodes.
BENCHMARK(Update)
  ->Arg(110)
  ->Arg(70)
  ->Arg(62)
  ->Arg(50)
  ->Unit(benchmark::kSecond)
  ->UseManualTime()
  ->Iterations(1);

}

BENCHMARK_MAIN();
