// Time and memory of the combinatorial map beside OpenVolumeMesh, on the same million tetrahedra of
// a grid of cubes. "ns" is the time of one query; each pair must give the same sum of answers.

#include "CellComplex/CompactCombinatorialMap.h"

#include "CellComplex/EdgeTable.h"
#include "CellComplex/VertexStar.h"
#include "GeneratedMeshes.h"

#include <benchmark/benchmark.h>

#ifdef ISTHMUS_HAS_OPENVOLUMEMESH
#include <OpenVolumeMesh/Mesh/TetrahedralMesh.hh>
#endif

#include <malloc.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace
{

using Map = isthmus::CompactCombinatorialMap<>;

constexpr double tetrahedra = 1e6;

const isthmus::testing::GeneratedMesh& Mesh()
{
  static const auto mesh = isthmus::testing::Tetrahedra(std::llround(std::cbrt(tetrahedra / 6.0)));
  return mesh;
}

std::size_t Cells()
{
  return Mesh().CellVertices.size() / 4;
}

std::size_t HeldBytes()
{
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// `make` builds the structure; rate and memory go to the counters.
template <typename Make>
void Build(benchmark::State& state, Make make)
{
  Mesh(); // what is generated on first use is excluded
  std::size_t bytes = 0;
  for (auto _ : state)
  {
    const std::size_t before = HeldBytes();
    const auto mesh = make();
    bytes = HeldBytes() - before;
  }
  const auto cells = static_cast<double>(Cells());
  state.counters["cells/s"] = benchmark::Counter(
    cells * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["bytes/cell"] = static_cast<double>(bytes) / cells;
}

/// `sweep` sums the results of `queries` queries; all implementations of one `question` must agree.
template <typename Sweep>
void RunQueries(
  benchmark::State& state, const std::string& question, std::size_t queries, Sweep sweep)
{
  static std::map<std::string, std::uint64_t> answers;
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = sweep();
  }
  if (answers.emplace(question, sum).first->second != sum)
  {
    state.SkipWithError("the answers differ");
    return;
  }
  state.counters["ns"] = benchmark::Counter(
    1e-9 * static_cast<double>(queries) * static_cast<double>(state.iterations()),
    benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

const Map& Ours()
{
  static const Map map(Mesh().List());
  return map;
}

void BuildOurs(benchmark::State& state)
{
  Build(state, []() { return std::make_unique<Map>(Mesh().List()); });
}

void StarOurs(benchmark::State& state)
{
  const Map& map = Ours();
  RunQueries(state, "star", map.NumberOfVertices(),
    [&]()
    {
      isthmus::VertexStar<> star(map);
      std::uint64_t sum = 0;
      for (std::uint32_t v = 0; v < map.NumberOfVertices(); ++v)
      {
        for (const Map::Dart dart : star.Gather(Map::Vertex(v)))
        {
          sum += map.GetCell(dart).Value;
        }
      }
      return sum;
    });
}

void FanOurs(benchmark::State& state)
{
  const Map& map = Ours();
  const auto& edges = map.Edges();
  RunQueries(state, "fan", edges.Size(),
    [&]()
    {
      std::uint64_t sum = 0;
      for (std::uint32_t e = 0; e < edges.Size(); ++e)
      {
        for (const Map::Dart dart : edges.Fan(Map::Edge(e)))
        {
          sum += map.GetCell(dart).Value;
        }
      }
      return sum;
    });
}

#ifdef ISTHMUS_HAS_OPENVOLUMEMESH

using Peer = OpenVolumeMesh::TopologicTetrahedralMesh;

/// With its bottom-up incidences, which all of these queries need.
std::unique_ptr<Peer> MakePeer()
{
  auto peer = std::make_unique<Peer>();
  peer->reserve_vertices(Mesh().Points.size());
  peer->reserve_cells(Cells());
  for (std::size_t v = 0; v < Mesh().Points.size(); ++v)
  {
    peer->add_vertex();
  }
  const auto vertex = [](std::int64_t id)
  { return OpenVolumeMesh::VertexHandle(static_cast<int>(id)); };
  for (std::size_t c = 0; c < Cells(); ++c)
  {
    const std::int64_t* const v = Mesh().CellVertices.data() + 4 * c;
    peer->add_cell(vertex(v[0]), vertex(v[1]), vertex(v[2]), vertex(v[3]));
  }
  return peer;
}

const Peer& OpenVolumeMeshPeer()
{
  static const std::unique_ptr<Peer> peer = MakePeer();
  return *peer;
}

void BuildPeer(benchmark::State& state)
{
  Build(state, MakePeer);
}

void StarPeer(benchmark::State& state)
{
  const Peer& peer = OpenVolumeMeshPeer();
  RunQueries(state, "star", peer.n_vertices(),
    [&]()
    {
      std::uint64_t sum = 0;
      for (const auto vertex : peer.vertices())
      {
        for (auto cell = peer.vc_iter(vertex); cell.valid(); ++cell)
        {
          sum += static_cast<std::uint64_t>(cell->idx());
        }
      }
      return sum;
    });
}

void FanPeer(benchmark::State& state)
{
  const Peer& peer = OpenVolumeMeshPeer();
  RunQueries(state, "fan", peer.n_edges(),
    [&]()
    {
      std::uint64_t sum = 0;
      for (const auto edge : peer.edges())
      {
        for (auto cell = peer.ec_iter(edge); cell.valid(); ++cell)
        {
          sum += static_cast<std::uint64_t>(cell->idx());
        }
      }
      return sum;
    });
}

#else

constexpr const char* missing = "missing: no OpenVolumeMesh_DIR was given to CMake";
void BuildPeer(benchmark::State& state)
{
  state.SkipWithError(missing);
}

void StarPeer(benchmark::State& state)
{
  state.SkipWithError(missing);
}

void FanPeer(benchmark::State& state)
{
  state.SkipWithError(missing);
}

#endif

BENCHMARK(BuildOurs)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BuildPeer)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(StarOurs)->Unit(benchmark::kMillisecond);
BENCHMARK(StarPeer)->Unit(benchmark::kMillisecond);
BENCHMARK(FanOurs)->Unit(benchmark::kMillisecond);
BENCHMARK(FanPeer)->Unit(benchmark::kMillisecond);

}

BENCHMARK_MAIN();
