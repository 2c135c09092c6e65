/**
 * @file CGALSweeps.h
 * @brief The builds and sweeps of BenchCompactCombinatorialMap by CGAL's linear cell complex.
 */
#ifndef isthmus_CGALSweeps_h
#define isthmus_CGALSweeps_h

#include "CGALPeer.h"
#include "MapSweeps.h"

#include <cstdint>

namespace
{

using namespace isthmus::testing;

using PlainCGAL = peers::CGALTetrahedra<peers::CGALPlainItems>;
using NumberedCGAL = peers::CGALTetrahedra<peers::CGALNumberedItems>;

void BuildCGAL(benchmark::State& state)
{
  TimeBuild(state, NumberOfTetrahedra(Mesh()),
    [](std::size_t before)
    {
      const PlainCGAL map(Mesh());
      return HeldBytes() - before - map.Vertices.capacity() * sizeof(map.Vertices[0]);
    });
}
BENCHMARK(BuildCGAL)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

NumberedCGAL& CGAL()
{
  static NumberedCGAL map(Mesh());
  return map;
}

/// Times one query for each item; the sum of of(item) must equal that of our map.
template <typename Items, typename Of>
void SweepCGAL(benchmark::State& state, const Items& items, Of&& of)
{
  std::uint64_t checksum = 0;
  for (auto _ : state)
  {
    checksum = ComputeSum(items, of);
  }
  ReportSweep(state, items.size(), checksum);
}

/// The cells of a range of CGAL's, as numbers.
template <typename Range>
std::uint64_t SumOfCGALCells(Range&& range)
{
  std::uint64_t sum = 0;
  for (auto at = range.begin(); at.cont(); ++at)
  {
    sum += CGAL().Map.info<3>(at);
  }
  return sum;
}

void StarCGAL(benchmark::State& state)
{
  auto& map = CGAL().Map;
  SweepCGAL(state, CGAL().Vertices,
    [&map](const auto& vertex)
    { return SumOfCGALCells(map.one_dart_per_incident_cell<3, 0>(vertex->dart())); });
}
BENCHMARK(StarCGAL)->Unit(benchmark::kMillisecond)->Iterations(1);

void FanCGAL(benchmark::State& state)
{
  auto& map = CGAL().Map;
  SweepCGAL(state, CGAL().EdgeDarts,
    [&map](const auto& edge)
    { return SumOfCGALCells(map.one_dart_per_incident_cell<3, 1>(edge)); });
}
BENCHMARK(FanCGAL)->Unit(benchmark::kMillisecond)->Iterations(1);

/// By hand, as we do: beta2 o beta3 until the fan ends. Faster than CGAL's own range.
void FanByHandCGAL(benchmark::State& state)
{
  auto& map = CGAL().Map;
  SweepCGAL(state, CGAL().EdgeDarts,
    [&map](const auto& edge)
    {
      auto first = edge;
      while (!map.is_free<3>(map.beta<2>(first)) && map.beta<2, 3>(first) != edge)
      {
        first = map.beta<2, 3>(first);
      }
      std::uint64_t sum = 0;
      auto at = first;
      do
      {
        sum += map.info<3>(at);
        at = map.is_free<3>(at) ? first : map.beta<3, 2>(at);
      } while (at != first);
      return sum;
    });
}
BENCHMARK(FanByHandCGAL)->Unit(benchmark::kMillisecond);

void DartToEdgeCGAL(benchmark::State& state)
{
  auto& map = CGAL().Map;
  std::uint64_t checksum = 0;
  for (auto _ : state)
  {
    checksum = 0;
    for (auto dart = map.darts().begin(); dart != map.darts().end(); ++dart)
    {
      checksum += map.info<1>(dart);
    }
  }
  ReportSweep(state, map.number_of_darts(), checksum);
}
BENCHMARK(DartToEdgeCGAL)->Unit(benchmark::kMillisecond);

void CellNeighboursCGAL(benchmark::State& state)
{
  auto& map = CGAL().Map;
  std::uint64_t checksum = 0;
  for (auto _ : state)
  {
    checksum = 0;
    for (auto cell = map.attributes<3>().begin(); cell != map.attributes<3>().end(); ++cell)
    {
      // One dart of each face: of the face itself, then of those across its three edges.
      const auto base = cell->dart();
      const auto one = map.beta<2>(base), two = map.beta<1, 2>(base), three = map.beta<0, 2>(base);
      for (const auto dart : { base, one, two, three })
      {
        checksum += map.is_free<3>(dart) ? 0 : map.info<3>(map.beta<3>(dart));
      }
    }
  }
  ReportSweep(state, NumberOfTetrahedra(Mesh()), checksum);
}
BENCHMARK(CellNeighboursCGAL)->Unit(benchmark::kMillisecond);

}

#endif
