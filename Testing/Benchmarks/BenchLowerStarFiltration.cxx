// Filtration and pairing of a function on a tetrahedral mesh beside TTK's preconditioning and
// pairing of the same in the same run: CPU seconds, one thread each, and whether the pairs are
// equal.
//
// ISTHMUS_PEERS names the folder of TTK's program (PeerPrograms.h); a row says if it is missing.
// TTK runs before and after ours, so that a changing load of the machine is visible. The meshes are
// TetGen's, of the inside of shared surfaces, the function the distance from the surface, squared.

#include "ChokingSurfaces.h"
#include "PeerPrograms.h"
#include "Persistence/FiltrationPairs.h"
#include "Persistence/LowerStarFiltration.h"
#include "Persistence/MorseValues.h"
#include "Surfaces/SurfaceTopology.h"
#include "Tetrahedra/TetrahedralMesher.h"

#include <vtkSMPTools.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;

struct Case
{
  TriangleMesh Surface;
  TetrahedralMesh Mesh;
  std::vector<double> Values;
};

/// At least twice as many tetrahedra as `volumes`.
Case Make(const std::string& file, double volumes)
{
  Case made;
  made.Surface = ReadSurface(file);
  TetrahedralParameters parameters;
  parameters.TetGen.MaximumVolume = std::abs(SignedVolume(made.Surface)) / volumes;
  parameters.TetGen.Limits.TimeLimit = 3600.0;
  made.Mesh = MeshTetrahedra(made.Surface, parameters);
  made.Values = MorseValues(made.Surface, made.Mesh, MorseFunction::EdgePaths);
  return made;
}

using Bar3 = std::array<double, 3>; ///< dimension, birth, death

/// Loops and voids with positive, finite persistence.
std::vector<Bar3> CollectBars(const CellFiltration& f, const FiltrationPairs& pairs)
{
  std::vector<Bar3> bars;
  const auto add = [&bars](double dimension, double birth, double death)
  {
    if (birth != death)
    {
      bars.push_back({ dimension, birth, death });
    }
  };
  for (const EdgeId e : f.Edges.Keys())
  {
    const TriangleId filler = pairs.LoopFilled(e);
    if (filler.Exists())
    {
      add(1.0, f.EdgeValue[e], f.TriangleValue[filler]);
    }
  }
  for (const TriangleId t : f.Triangles())
  {
    const TetrahedronId filler = pairs.VoidFilled(t);
    if (filler.Exists())
    {
      add(2.0, f.TriangleValue[t], f.TetrahedronValue[filler]);
    }
  }
  std::sort(bars.begin(), bars.end());
  return bars;
}

std::vector<Bar3> CollectBars(const DiphaPairs& pairs)
{
  std::vector<Bar3> bars;
  for (const DiphaPair& pair : pairs)
  {
    if (pair.Dimension > 0 && std::isfinite(pair.Death))
    {
      bars.push_back({ static_cast<double>(pair.Dimension), pair.Birth, pair.Death });
    }
  }
  std::sort(bars.begin(), bars.end());
  return bars;
}

double Since(std::clock_t start)
{
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Our CPU seconds on one thread, filtration and pairing.
double RunOurs(benchmark::State& state, const Case& made, std::vector<Bar3>& bars)
{
  double seconds = 0.0;
  vtkSMPTools::LocalScope(vtkSMPTools::Config(1, std::string("STDThread"), false),
    [&]
    {
      TriangleMesh surface = made.Surface;
      const std::clock_t start = std::clock();
      const CellFiltration f = LowerStarFiltration(made.Mesh, made.Values, surface);
      state.counters["filtration_s"] = Since(start);
      const FiltrationPairs pairs(f);
      seconds = Since(start);
      bars = CollectBars(f, pairs);
      state.counters["cells"] = static_cast<double>(
        f.Points.size() + f.Edges.size() + f.TriangleCount() + f.Tetrahedra.size());
    });
  state.counters["ours_s"] = seconds;
  state.counters["pairs"] = static_cast<double>(bars.size());
  return seconds;
}

void BesideTTK(benchmark::State& state, const std::string& file, double volumes)
{
  const Case made = Make(file, volumes);
  ValuedTetrahedra theirs{ made.Mesh.Points, made.Values, {} };
  for (const Tetrahedron& t : made.Mesh.Tetrahedra)
  {
    theirs.Tetrahedra.push_back({ t[0], t[1], t[2], t[3] });
  }
  for (double& value : theirs.Values)
  {
    value *= value; // as in our filtration, so that births and deaths are the same numbers
  }
  for (auto _ : state)
  {
    const auto before = RunMeshPeer(theirs, 1);
    std::vector<Bar3> bars;
    const double ours = RunOurs(state, made, bars);
    if (!before)
    {
      state.SkipWithError("no ttk_mesh_persistence in $ISTHMUS_PEERS");
      return;
    }
    const auto after = RunMeshPeer(theirs, 1);
    const double ttk = 0.5 * (before->Seconds + after->Seconds);
    state.counters["TTK_s"] = ttk;
    state.counters["TTK_2_threads_wall_s"] = RunMeshPeer(theirs, 2)->Wall;
    state.counters["ours/TTK"] = ours / ttk;
    if (bars != CollectBars(before->Pairs))
    {
      state.SkipWithError("the pairs differ from TTK's");
      return;
    }
  }
}

void Register()
{
  for (const auto& [name, volumes] :
    { std::pair<const char*, double>{ "armadillo", 4e5 }, { "fertility", 1e5 } })
  {
    const std::string file = name + std::string(std::string(name) == "armadillo" ? ".obj" : ".off");
    const double parts = volumes;
    benchmark::RegisterBenchmark((std::string("BesideTTK/") + name).c_str(),
      [file, parts](benchmark::State& state) { BesideTTK(state, file, parts); })
      ->Unit(benchmark::kSecond)
      ->Iterations(1);
  }
}

}

int main(int count, char** words)
{
  benchmark::Initialize(&count, words);
  Register();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
