// Pockets and channels of 1AON (58,674 atoms) and of lysozyme, beside the triangulation alone.

#include "MolecularPockets.h"
#include "PoreProfile.h"
#include "RegularFiltration.h"
#include "vtkMacromoleculeReader.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <string>

using namespace isthmus;

namespace
{

std::vector<Ball> AtomsOf(const std::string& name)
{
  const char* given = std::getenv("ISTHMUS_DATA_DIR");
  vtkNew<vtkMacromoleculeReader> reader;
  reader->SetFileName(
    (std::string(given ? given : ISTHMUS_DEFAULT_DATA_DIR) + "/molecules/" + name).c_str());
  reader->SetReadHetero(false);
  reader->SetReadWater(false);
  reader->BondsByDistanceOff();
  reader->Update();
  std::vector<Ball> atoms;
  for (vtkIdType i = 0; i < reader->GetOutput()->GetNumberOfPoints(); ++i)
  {
    Ball ball{ {}, reader->GetOutput()->GetPointData()->GetArray("Radius")->GetComponent(i, 0) };
    reader->GetOutput()->GetPoint(i, ball.Centre.data());
    atoms.push_back(ball);
  }
  return atoms;
}

const std::string Files[] = { "1hew.pdb", "1aon.pdb.gz" };

void Triangulation(benchmark::State& state)
{
  const auto atoms = AtomsOf(Files[state.range(0)]);
  for (auto _ : state)
  {
    std::vector<Point3> centres;
    std::vector<double> radii;
    for (const Ball& atom : atoms)
    {
      centres.push_back(atom.Centre);
      radii.push_back(atom.Radius + 1.4);
    }
    benchmark::DoNotOptimize(MakeRegularFiltration(std::move(centres), std::move(radii)));
  }
}

void Pockets(benchmark::State& state)
{
  const auto atoms = AtomsOf(Files[state.range(0)]);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(FindPockets(atoms, {}));
  }
}

void Channels(benchmark::State& state)
{
  const auto atoms = AtomsOf(Files[state.range(0)]);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(FindPores(atoms, {}));
  }
}

}

BENCHMARK(Triangulation)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(Pockets)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(Channels)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
