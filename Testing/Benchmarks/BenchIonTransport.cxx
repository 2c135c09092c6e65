// One evaluation of ion transport: a charged pore of 4 angstrom in a membrane, 0.1 mol/l and 100
// mV, on grids of growing size. Beside it in the same run, the time that memory takes to carry what
// the iterations of conjugate gradients read and write (each passes the network's five arrays three
// times and its four vectors four times), at the speed of a copy; and the ratio of the two.

#include "CopyBandwidth.h"
#include "Solvation/PoissonNernstPlanck.h"

#include <benchmark/benchmark.h>

namespace
{

using namespace isthmus;

void Point(benchmark::State& state)
{
  IonTransportParameters p;
  p.Species = { { "K", 1.0, 0.1, 0.1, 1.96, 1.0 }, { "Cl", -1.0, 0.1, 0.1, 2.03, 1.0 } };
  p.LumenRadius = 4.0;
  p.Padding = 10.0;
  p.Spacing = 0.01 * static_cast<double>(state.range(0));
  const TransportDomain domain = DomainAround({}, p);
  const TransportGrid grid = MakeTransportGrid(domain, {}, { { { 5.5, 0.3, 0.1 }, -1.0, 0.0 } }, p);
  int iterations = 0;
  for (auto _ : state)
  {
    PoissonNernstPlanck solution(grid, p);
    const IonTransportReport report = solution.Solve();
    iterations = report.LinearIterations;
    benchmark::DoNotOptimize(report.Converged);
  }
  constexpr double bytes = 8.0 * (3 * 5 + 4 * 4);
  const auto nodes = static_cast<double>(domain.Size());
  const double memory = bytes * nodes * iterations / isthmus::testing::CopyBandwidth();
  state.counters["nodes"] = nodes;
  state.counters["linear"] = iterations;
  state.counters["us_node"] = benchmark::Counter(
    1e-6 * nodes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["to_memory"] = benchmark::Counter(
    memory, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// 0.58 angstrom gives 213 thousand nodes.
BENCHMARK(Point)
  ->Arg(140)
  ->Arg(100)
  ->Arg(70)
  ->Arg(58)
  ->Arg(50)
  ->Unit(benchmark::kSecond)
  ->Iterations(1);

}

BENCHMARK_MAIN();
