// Time and memory of the combinatorial map beside CGAL's linear cell complex and VTK's links, on
// tetrahedra of a grid of cubes. ISTHMUS_BENCH_TETRAHEDRA sets their number (5 million).
//
// Construction is timed for several sizes; queries sweep over the whole mesh, and "ns" is the time
// of one query. All peers answer the same question; their answers are compared by checksum.

#include "CompactCombinatorialMap.h"

#include "CellEdgeTable.h"
#include "EdgeTable.h"
#include "FaceTable.h"
#include "GeneratedMeshes.h"
#include "StarTable.h"
#include "VertexStar.h"

#include <benchmark/benchmark.h>

#ifdef ISTHMUS_HAS_CGAL
#include "CGALPeer.h"
#endif

#include <vtkCellArray.h>
#include <vtkEdgeTable.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <malloc.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <optional>
#include <string>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;
using Map = CompactCombinatorialMap<>;

/// Bytes that the program holds now.
std::size_t HeldBytes()
{
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

GeneratedMesh MeshOf(double tetrahedra)
{
  return Tetrahedra(std::llround(std::cbrt(tetrahedra / 6.0)));
}

std::size_t NumberOfTetrahedra(const GeneratedMesh& mesh)
{
  return mesh.CellVertices.size() / 4;
}

/// The mesh of all sweeps.
const GeneratedMesh& Mesh()
{
  static const GeneratedMesh mesh = []()
  {
    const char* chosen = std::getenv("ISTHMUS_BENCH_TETRAHEDRA");
    return MeshOf(chosen ? std::atof(chosen) : 5e6);
  }();
  return mesh;
}

vtkUnstructuredGrid* Grid()
{
  static const vtkNew<vtkUnstructuredGrid> grid;
  if (grid->GetNumberOfCells() == 0)
  {
    vtkNew<vtkPoints> points;
    for (const auto& point : Mesh().Points)
    {
      points->InsertNextPoint(point.data());
    }
    vtkNew<vtkCellArray> cells;
    for (std::size_t c = 0; c < NumberOfTetrahedra(Mesh()); ++c)
    {
      const std::int64_t* v = Mesh().CellVertices.data() + 4 * c;
      const vtkIdType ids[4] = { v[0], v[1], v[2], v[3] };
      cells->InsertNextCell(4, ids);
    }
    grid->SetPoints(points);
    grid->SetCells(VTK_TETRA, cells);
    grid->BuildLinks();
  }
  return grid;
}

const Map& OurMap()
{
  static const Map map(Mesh().List());
  return map;
}

/// Reports one sweep that asked `queries` questions.
void Report(benchmark::State& state, std::size_t queries, std::uint64_t checksum)
{
  const auto total = static_cast<double>(queries) * static_cast<double>(state.iterations());
  state.counters["ns"] =
    benchmark::Counter(total * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["checksum"] = static_cast<double>(checksum % 1000003);
}

void ReportBuild(benchmark::State& state, std::size_t cells, std::size_t bytes)
{
  const auto total = static_cast<double>(cells) * static_cast<double>(state.iterations());
  state.counters["cells/s"] = benchmark::Counter(total, benchmark::Counter::kIsRate);
  state.counters["ns/cell"] =
    benchmark::Counter(total * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["bytes/cell"] = static_cast<double>(bytes) / static_cast<double>(cells);
}

// --- construction

void BuildOurs(benchmark::State& state)
{
  const GeneratedMesh mesh = MeshOf(static_cast<double>(state.range(0)));
  std::size_t bytes = 0;
  for (auto _ : state)
  {
    const std::size_t before = HeldBytes();
    const Map map(mesh.List());
    bytes = HeldBytes() - before;
  }
  ReportBuild(state, NumberOfTetrahedra(mesh), bytes);
}
BENCHMARK(BuildOurs)
  ->Arg(100000)
  ->Arg(1000000)
  ->Arg(5000000)
  ->Arg(10000000)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->MeasureProcessCPUTime();

void BuildOurOptionalTables(benchmark::State& state)
{
  std::size_t bytes = 0;
  for (auto _ : state)
  {
    const std::size_t before = HeldBytes();
    const EdgeTable<std::uint32_t> edges(OurMap());
    const FaceTable<std::uint32_t> faces(OurMap());
    const StarTable<std::uint32_t> stars(OurMap());
    bytes = HeldBytes() - before;
  }
  ReportBuild(state, NumberOfTetrahedra(Mesh()), bytes);
}
BENCHMARK(BuildOurOptionalTables)->Unit(benchmark::kMillisecond)->UseRealTime();

void BuildVTKLinks(benchmark::State& state)
{
  vtkUnstructuredGrid* grid = Grid();
  std::size_t bytes = 0;
  for (auto _ : state)
  {
    vtkNew<vtkUnstructuredGrid> copy;
    copy->ShallowCopy(grid);
    copy->SetLinks(nullptr);
    const std::size_t before = HeldBytes();
    copy->BuildLinks();
    bytes = HeldBytes() - before;
  }
  ReportBuild(state, NumberOfTetrahedra(Mesh()), bytes);
}
BENCHMARK(BuildVTKLinks)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

// --- vertex star: the cells around each vertex

void StarOurs(benchmark::State& state)
{
  const Map& map = OurMap();
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    VertexStar<> star(map);
    sum = 0;
    for (std::uint32_t v = 0; v < map.NumberOfVertices(); ++v)
    {
      for (const Map::Dart dart : star.Gather(Map::Vertex(v)))
      {
        sum += map.CellOf(dart).Value;
      }
    }
  }
  Report(state, map.NumberOfVertices(), sum);
}
BENCHMARK(StarOurs)->Unit(benchmark::kMillisecond);

void StarFromTableOurs(benchmark::State& state)
{
  const Map& map = OurMap();
  const auto& stars = map.Stars();
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (std::uint32_t v = 0; v < map.NumberOfVertices(); ++v)
    {
      for (const Map::Dart dart : stars.Of(Map::Vertex(v)))
      {
        sum += map.CellOf(dart).Value;
      }
    }
  }
  Report(state, map.NumberOfVertices(), sum);
}
BENCHMARK(StarFromTableOurs)->Unit(benchmark::kMillisecond);

void StarVTK(benchmark::State& state)
{
  vtkUnstructuredGrid* grid = Grid();
  vtkNew<vtkIdList> cells;
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (vtkIdType v = 0; v < grid->GetNumberOfPoints(); ++v)
    {
      grid->GetPointCells(v, cells);
      for (const vtkIdType cell : *cells)
      {
        sum += static_cast<std::uint64_t>(cell);
      }
    }
  }
  Report(state, static_cast<std::size_t>(grid->GetNumberOfPoints()), sum);
}
BENCHMARK(StarVTK)->Unit(benchmark::kMillisecond);

// --- vertex star with its edges: the neighbours of each vertex

void VertexNeighboursOurs(benchmark::State& state)
{
  const Map& map = OurMap();
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    VertexStar<> star(map);
    sum = 0;
    for (std::uint32_t v = 0; v < map.NumberOfVertices(); ++v)
    {
      star.Gather(Map::Vertex(v));
      for (const Map::Dart dart : star.EdgeDarts())
      {
        sum += map.EndVertex(dart).Value;
      }
    }
  }
  Report(state, map.NumberOfVertices(), sum);
}
BENCHMARK(VertexNeighboursOurs)->Unit(benchmark::kMillisecond);

void VertexNeighboursVTK(benchmark::State& state)
{
  vtkUnstructuredGrid* grid = Grid();
  vtkNew<vtkIdList> cells, buffer, neighbours;
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (vtkIdType v = 0; v < grid->GetNumberOfPoints(); ++v)
    {
      grid->GetPointCells(v, cells);
      neighbours->Reset();
      for (const vtkIdType cell : *cells)
      {
        vtkIdType count;
        const vtkIdType* points;
        grid->GetCellPoints(cell, count, points, buffer);
        for (vtkIdType i = 0; i < count; ++i)
        {
          if (points[i] != v)
          {
            neighbours->InsertUniqueId(points[i]);
          }
        }
      }
      for (const vtkIdType neighbour : *neighbours)
      {
        sum += static_cast<std::uint64_t>(neighbour);
      }
    }
  }
  Report(state, static_cast<std::size_t>(grid->GetNumberOfPoints()), sum);
}
BENCHMARK(VertexNeighboursVTK)->Unit(benchmark::kMillisecond);

// --- edge fan: the cells around each edge

void FanOurs(benchmark::State& state)
{
  const Map& map = OurMap();
  const auto& edges = map.Edges();
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (std::uint32_t e = 0; e < edges.Size(); ++e)
    {
      for (const Map::Dart dart : edges.Fan(Map::Edge(e)))
      {
        sum += map.CellOf(dart).Value;
      }
    }
  }
  Report(state, edges.Size(), sum);
}
BENCHMARK(FanOurs)->Unit(benchmark::kMillisecond);

void FanVTK(benchmark::State& state)
{
  vtkUnstructuredGrid* grid = Grid();
  const Map& map = OurMap();
  vtkNew<vtkIdList> ends, cells;
  ends->SetNumberOfIds(2);
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (std::uint32_t e = 0; e < map.Edges().Size(); ++e)
    {
      const Map::Dart dart = map.Edges().DartOf(Map::Edge(e));
      ends->SetId(0, map.StartVertex(dart).Value);
      ends->SetId(1, map.EndVertex(dart).Value);
      grid->GetCellNeighbors(-1, ends, cells);
      for (const vtkIdType cell : *cells)
      {
        sum += static_cast<std::uint64_t>(cell);
      }
    }
  }
  Report(state, map.Edges().Size(), sum);
}
BENCHMARK(FanVTK)->Unit(benchmark::kMillisecond)->Iterations(1);

// --- dart to edge: the number of the edge of each dart

void DartToEdgeOurs(benchmark::State& state)
{
  const Map& map = OurMap();
  const auto& edges = map.Edges();
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (std::uint32_t c = 0; c < map.NumberOfCells(); ++c)
    {
      for (const Map::Dart dart : map.Darts(Map::Cell(c)))
      {
        sum += edges.Of(dart).Value;
      }
    }
  }
  Report(state, map.NumberOfDarts(), sum);
}
BENCHMARK(DartToEdgeOurs)->Unit(benchmark::kMillisecond);

void DartToEdgeFromTableOurs(benchmark::State& state)
{
  const Map& map = OurMap();
  const auto& edges = map.CellEdges();
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (std::uint32_t c = 0; c < map.NumberOfCells(); ++c)
    {
      for (const Map::Dart dart : map.Darts(Map::Cell(c)))
      {
        sum += edges.Of(dart).Value;
      }
    }
  }
  Report(state, map.NumberOfDarts(), sum);
}
BENCHMARK(DartToEdgeFromTableOurs)->Unit(benchmark::kMillisecond);

/// VTK's nearest: a vtkEdgeTable filled with our edges, so that the numbers agree.
void DartToEdgeVTK(benchmark::State& state)
{
  const Map& map = OurMap();
  vtkNew<vtkEdgeTable> table;
  table->InitEdgeInsertion(static_cast<vtkIdType>(map.NumberOfVertices()), 1);
  for (std::uint32_t e = 0; e < map.Edges().Size(); ++e)
  {
    const Map::Dart dart = map.Edges().DartOf(Map::Edge(e));
    table->InsertEdge(map.StartVertex(dart).Value, map.EndVertex(dart).Value, e);
  }
  const CellType& type = CellType::Tetrahedron();
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (std::size_t c = 0; c < NumberOfTetrahedra(Mesh()); ++c)
    {
      const std::int64_t* v = Mesh().CellVertices.data() + 4 * c;
      for (unsigned d = 1; d <= 12; ++d)
      {
        sum += static_cast<std::uint64_t>(
          table->IsEdge(v[type.At(d).Start], v[type.At(CellType::Beta2(d)).Start]));
      }
    }
  }
  Report(state, map.NumberOfDarts(), sum);
}
BENCHMARK(DartToEdgeVTK)->Unit(benchmark::kMillisecond)->Iterations(1);

// --- cell neighbours: the cells beyond the faces of each cell

void CellNeighboursOurs(benchmark::State& state)
{
  const Map& map = OurMap();
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (std::uint32_t c = 0; c < map.NumberOfCells(); ++c)
    {
      for (const Map::Dart across : map.Neighbours(Map::Cell(c)))
      {
        sum += map.IsOutside(across) ? 0 : map.CellOf(across).Value;
      }
    }
  }
  Report(state, map.NumberOfCells(), sum);
}
BENCHMARK(CellNeighboursOurs)->Unit(benchmark::kMillisecond);

void CellNeighboursVTK(benchmark::State& state)
{
  vtkUnstructuredGrid* grid = Grid();
  vtkNew<vtkIdList> face, cells;
  face->SetNumberOfIds(3);
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (std::size_t c = 0; c < NumberOfTetrahedra(Mesh()); ++c)
    {
      const std::int64_t* v = Mesh().CellVertices.data() + 4 * c;
      for (const std::vector<int>& corners : CellType::Tetrahedron().Faces())
      {
        for (int i = 0; i < 3; ++i)
        {
          face->SetId(i, v[corners[static_cast<std::size_t>(i)]]);
        }
        grid->GetCellNeighbors(static_cast<vtkIdType>(c), face, cells);
        for (const vtkIdType cell : *cells)
        {
          sum += static_cast<std::uint64_t>(cell);
        }
      }
    }
  }
  Report(state, NumberOfTetrahedra(Mesh()), sum);
}
BENCHMARK(CellNeighboursVTK)->Unit(benchmark::kMillisecond)->Iterations(1);

#ifdef ISTHMUS_HAS_CGAL

using PlainCGAL = peers::CGALTetrahedra<peers::CGALPlainItems>;
using NumberedCGAL = peers::CGALTetrahedra<peers::CGALNumberedItems>;

void BuildCGAL(benchmark::State& state)
{
  std::size_t bytes = 0;
  for (auto _ : state)
  {
    const std::size_t before = HeldBytes();
    const PlainCGAL map(Mesh());
    bytes = HeldBytes() - before - map.Vertices.capacity() * sizeof(map.Vertices[0]);
  }
  ReportBuild(state, NumberOfTetrahedra(Mesh()), bytes);
}
BENCHMARK(BuildCGAL)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

NumberedCGAL& CGAL()
{
  static NumberedCGAL map(Mesh());
  return map;
}

void StarCGAL(benchmark::State& state)
{
  auto& map = CGAL().Map;
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (const auto& vertex : CGAL().Vertices)
    {
      for (auto at = map.one_dart_per_incident_cell<3, 0>(vertex->dart()).begin(); at.cont(); ++at)
      {
        sum += map.info<3>(at);
      }
    }
  }
  Report(state, CGAL().Vertices.size(), sum);
}
BENCHMARK(StarCGAL)->Unit(benchmark::kMillisecond)->Iterations(1);

void FanCGAL(benchmark::State& state)
{
  auto& map = CGAL().Map;
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (const auto edge : CGAL().EdgeDarts)
    {
      for (auto at = map.one_dart_per_incident_cell<3, 1>(edge).begin(); at.cont(); ++at)
      {
        sum += map.info<3>(at);
      }
    }
  }
  Report(state, CGAL().EdgeDarts.size(), sum);
}
BENCHMARK(FanCGAL)->Unit(benchmark::kMillisecond)->Iterations(1);

/// By hand, as we do: beta2 o beta3 until the fan ends. Faster than CGAL's own range.
void FanByHandCGAL(benchmark::State& state)
{
  auto& map = CGAL().Map;
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (const auto edge : CGAL().EdgeDarts)
    {
      auto first = edge;
      while (!map.is_free<3>(map.beta<2>(first)) && map.beta<2, 3>(first) != edge)
      {
        first = map.beta<2, 3>(first);
      }
      auto at = first;
      do
      {
        sum += map.info<3>(at);
        at = map.is_free<3>(at) ? first : map.beta<3, 2>(at);
      } while (at != first);
    }
  }
  Report(state, CGAL().EdgeDarts.size(), sum);
}
BENCHMARK(FanByHandCGAL)->Unit(benchmark::kMillisecond);

void DartToEdgeCGAL(benchmark::State& state)
{
  auto& map = CGAL().Map;
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (auto dart = map.darts().begin(); dart != map.darts().end(); ++dart)
    {
      sum += map.info<1>(dart);
    }
  }
  Report(state, map.number_of_darts(), sum);
}
BENCHMARK(DartToEdgeCGAL)->Unit(benchmark::kMillisecond);

void CellNeighboursCGAL(benchmark::State& state)
{
  auto& map = CGAL().Map;
  std::uint64_t sum = 0;
  for (auto _ : state)
  {
    sum = 0;
    for (auto cell = map.attributes<3>().begin(); cell != map.attributes<3>().end(); ++cell)
    {
      // One dart of each face: of the face itself, then of those across its three edges.
      const auto base = cell->dart();
      const auto one = map.beta<2>(base), two = map.beta<1, 2>(base), three = map.beta<0, 2>(base);
      for (const auto dart : { base, one, two, three })
      {
        sum += map.is_free<3>(dart) ? 0 : map.info<3>(map.beta<3>(dart));
      }
    }
  }
  Report(state, NumberOfTetrahedra(Mesh()), sum);
}
BENCHMARK(CellNeighboursCGAL)->Unit(benchmark::kMillisecond);

#endif

}

BENCHMARK_MAIN();
