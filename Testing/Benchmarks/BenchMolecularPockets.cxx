// Pockets and channels of lysozyme, of 1AON (58,674 atoms) and of 1AON without its lid (chains A to
// N), compared with the triangulation alone, the lower bound: times_triangulation is the ratio of
// CPU times, all threads. peak_MB is what a run needed beyond the atoms.

#include "PeakMemory.h"
#include "Persistence/RegularFiltration.h"
#include "Pockets/MolecularPockets.h"
#include "Pockets/PoreProfile.h"
#include "vtkMacromoleculeReader.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <benchmark/benchmark.h>

#include <malloc.h>

#include <cstdlib>
#include <ctime>
#include <string>

using namespace isthmus;

namespace
{

struct Input
{
  const char* File;
  const char* Chains;
};

const Input Inputs[] = { { "1hew.pdb", "" }, { "1aon.pdb.gz", "" },
  { "1aon.pdb.gz", "A B C D E F G H I J K L M N" } };

std::vector<Ball> ReadHeavyAtoms(const Input& input)
{
  const char* given = std::getenv("ISTHMUS_DATA_DIR");
  vtkNew<vtkMacromoleculeReader> reader;
  reader->SetFileName(
    (std::string(given ? given : ISTHMUS_DEFAULT_DATA_DIR) + "/molecules/" + input.File).c_str());
  reader->SetChains(input.Chains);
  reader->SetReadHetero(false);
  reader->SetReadWater(false);
  reader->BondsByDistanceOff();
  reader->Update();
  std::vector<Ball> atoms;
  for (vtkIdType i = 0; i < reader->GetOutput()->GetNumberOfPoints(); ++i)
  {
    Ball ball{ {}, reader->GetOutput()->GetPointData()->GetArray("Radius")->GetComponent(i, 0) };
    reader->GetOutput()->GetPoint(i, ball.Center.data());
    atoms.push_back(ball);
  }
  return atoms;
}

double CpuSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void Triangulate(const std::vector<Ball>& atoms)
{
  std::vector<Point3> centers;
  std::vector<double> radii;
  for (const Ball& atom : atoms)
  {
    centers.push_back(atom.Center);
    radii.push_back(atom.Radius + 1.4);
  }
  benchmark::DoNotOptimize(MakeRegularFiltration(std::move(centers), std::move(radii)));
}

/// Runs `work` on the atoms, beside the triangulation.
template <typename Work>
void Measure(benchmark::State& state, Work work)
{
  const auto atoms = ReadHeavyAtoms(Inputs[state.range(0)]);
  double begin = CpuSeconds();
  Triangulate(atoms);
  const double floor = CpuSeconds() - begin;
  malloc_trim(0);
  isthmus::testing::ResetPeakMemory();
  const double before = isthmus::testing::PeakMemory();
  begin = CpuSeconds();
  for (auto _ : state)
  {
    work(atoms);
  }
  const double seconds = (CpuSeconds() - begin) / static_cast<double>(state.iterations());
  state.counters["atoms"] = static_cast<double>(atoms.size());
  state.counters["cpu_s"] = seconds;
  state.counters["times_triangulation"] = seconds / floor;
  state.counters["peak_MB"] = (isthmus::testing::PeakMemory() - before) / 1e6;
}

void Triangulation(benchmark::State& state)
{
  Measure(state, Triangulate);
}

void Pockets(benchmark::State& state)
{
  Measure(state,
    [](const std::vector<Ball>& atoms) { benchmark::DoNotOptimize(FindPockets(atoms, {})); });
}

void Channels(benchmark::State& state)
{
  Measure(
    state, [](const std::vector<Ball>& atoms) { benchmark::DoNotOptimize(FindPores(atoms, {})); });
}

}

BENCHMARK(Triangulation)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(Pockets)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(Channels)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->UseRealTime();

BENCHMARK_MAIN();
