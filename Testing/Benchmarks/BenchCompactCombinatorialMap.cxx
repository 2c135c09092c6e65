// Time and memory of the combinatorial map beside CGAL's linear cell complex and VTK's links, on
// tetrahedra of a grid of cubes. ISTHMUS_BENCH_TETRAHEDRA sets their number (5 million).
//
// Construction is timed for several sizes; queries sweep over the whole mesh, and "ns" is the time
// of one query. All peers answer the same question; their answers are compared by checksum.

#include "CellComplex/CompactCombinatorialMap.h"
#include "CellComplex/EdgeTable.h"
#include "CellComplex/FaceTable.h"
#include "CellComplex/StarTable.h"
#include "CellComplex/VertexStar.h"
#include "MapSweeps.h"

#include <benchmark/benchmark.h>

#include <vtkEdgeTable.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <cstdint>
#include <vector>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;

// --- construction

void BuildOurs(benchmark::State& state)
{
  const GeneratedMesh mesh = MakeMesh(static_cast<double>(state.range(0)));
  TimeBuild(state, NumberOfTetrahedra(mesh),
    [&](std::size_t before)
    {
      const Map map(mesh.List());
      return HeldBytes() - before;
    });
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
  OurMap();
  TimeBuild(state, NumberOfTetrahedra(Mesh()),
    [](std::size_t before)
    {
      const EdgeTable<std::uint32_t> edges(OurMap());
      const FaceTable<std::uint32_t> faces(OurMap());
      const StarTable<std::uint32_t> stars(OurMap());
      return HeldBytes() - before;
    });
}
BENCHMARK(BuildOurOptionalTables)->Unit(benchmark::kMillisecond)->UseRealTime();

void BuildVTKLinks(benchmark::State& state)
{
  vtkUnstructuredGrid* grid = Grid();
  TimeBuild(state, NumberOfTetrahedra(Mesh()),
    [grid](std::size_t)
    {
      vtkNew<vtkUnstructuredGrid> copy;
      copy->ShallowCopy(grid);
      copy->SetLinks(nullptr);
      const std::size_t before = HeldBytes();
      copy->BuildLinks();
      return HeldBytes() - before;
    });
}
BENCHMARK(BuildVTKLinks)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

// --- vertex star: the cells around each vertex

void StarOurs(benchmark::State& state)
{
  const Map& map = OurMap();
  VertexStar<> star(map);
  Sweep<Map::Vertex>(state, map.NumberOfVertices(),
    [&](Map::Vertex vertex) { return SumOfCells(map, star.Gather(vertex)); });
}
BENCHMARK(StarOurs)->Unit(benchmark::kMillisecond);

void StarFromTableOurs(benchmark::State& state)
{
  const Map& map = OurMap();
  const auto& stars = map.Stars();
  Sweep<Map::Vertex>(state, map.NumberOfVertices(),
    [&](Map::Vertex vertex) { return SumOfCells(map, stars.Find(vertex)); });
}
BENCHMARK(StarFromTableOurs)->Unit(benchmark::kMillisecond);

void StarVTK(benchmark::State& state)
{
  vtkUnstructuredGrid* grid = Grid();
  vtkNew<vtkIdList> cells;
  Sweep<vtkIdType>(state, static_cast<std::size_t>(grid->GetNumberOfPoints()),
    [&](vtkIdType point)
    {
      grid->GetPointCells(point, cells);
      return SumOfIds(cells);
    });
}
BENCHMARK(StarVTK)->Unit(benchmark::kMillisecond);

// --- vertex star with its edges: the neighbours of each vertex

void VertexNeighboursOurs(benchmark::State& state)
{
  const Map& map = OurMap();
  VertexStar<> star(map);
  Sweep<Map::Vertex>(state, map.NumberOfVertices(),
    [&](Map::Vertex vertex)
    {
      star.Gather(vertex);
      return ComputeSum(
        star.EdgeDarts(), [&map](Map::Dart dart) { return map.EndVertex(dart).Value; });
    });
}
BENCHMARK(VertexNeighboursOurs)->Unit(benchmark::kMillisecond);

void VertexNeighboursVTK(benchmark::State& state)
{
  vtkUnstructuredGrid* grid = Grid();
  vtkNew<vtkIdList> cells, buffer, neighbours;
  Sweep<vtkIdType>(state, static_cast<std::size_t>(grid->GetNumberOfPoints()),
    [&](vtkIdType point)
    {
      grid->GetPointCells(point, cells);
      neighbours->Reset();
      for (const vtkIdType cell : *cells)
      {
        vtkIdType count;
        const vtkIdType* points;
        grid->GetCellPoints(cell, count, points, buffer);
        for (vtkIdType i = 0; i < count; ++i)
        {
          if (points[i] != point)
          {
            neighbours->InsertUniqueId(points[i]);
          }
        }
      }
      return SumOfIds(neighbours);
    });
}
BENCHMARK(VertexNeighboursVTK)->Unit(benchmark::kMillisecond);

// --- edge fan: the cells around each edge

void FanOurs(benchmark::State& state)
{
  const Map& map = OurMap();
  const auto& edges = map.Edges();
  Sweep<Map::Edge>(
    state, edges.Size(), [&](Map::Edge edge) { return SumOfCells(map, edges.Fan(edge)); });
}
BENCHMARK(FanOurs)->Unit(benchmark::kMillisecond);

void FanVTK(benchmark::State& state)
{
  vtkUnstructuredGrid* grid = Grid();
  const Map& map = OurMap();
  vtkNew<vtkIdList> ends, cells;
  ends->SetNumberOfIds(2);
  Sweep<Map::Edge>(state, map.Edges().Size(),
    [&](Map::Edge edge)
    {
      const Map::Dart dart = map.Edges().GetDart(edge);
      ends->SetId(0, map.StartVertex(dart).Value);
      ends->SetId(1, map.EndVertex(dart).Value);
      grid->GetCellNeighbors(-1, ends, cells);
      return SumOfIds(cells);
    });
}
BENCHMARK(FanVTK)->Unit(benchmark::kMillisecond)->Iterations(1);

// --- dart to edge: the number of the edge of each dart

/// With one of our tables.
template <typename Edges>
void SweepDartToEdge(benchmark::State& state, const Edges& edges)
{
  const Map& map = OurMap();
  std::uint64_t checksum = 0;
  for (auto _ : state)
  {
    checksum = 0;
    for (std::uint32_t c = 0; c < map.NumberOfCells(); ++c)
    {
      checksum +=
        ComputeSum(map.Darts(Map::Cell(c)), [&](Map::Dart dart) { return edges.Find(dart).Value; });
    }
  }
  ReportSweep(state, map.NumberOfDarts(), checksum);
}

void DartToEdgeOurs(benchmark::State& state)
{
  SweepDartToEdge(state, OurMap().Edges());
}
BENCHMARK(DartToEdgeOurs)->Unit(benchmark::kMillisecond);

void DartToEdgeFromTableOurs(benchmark::State& state)
{
  SweepDartToEdge(state, OurMap().CellEdges());
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
    const Map::Dart dart = map.Edges().GetDart(Map::Edge(e));
    table->InsertEdge(map.StartVertex(dart).Value, map.EndVertex(dart).Value, e);
  }
  const CellType& type = CellType::Tetrahedron();
  std::uint64_t checksum = 0;
  for (auto _ : state)
  {
    checksum = 0;
    for (std::size_t c = 0; c < NumberOfTetrahedra(Mesh()); ++c)
    {
      const std::int64_t* v = Mesh().CellVertices.data() + 4 * c;
      for (unsigned d = 1; d <= 12; ++d)
      {
        checksum += static_cast<std::uint64_t>(
          table->IsEdge(v[type.At(d).Start], v[type.At(CellType::Beta2(d)).Start]));
      }
    }
  }
  ReportSweep(state, map.NumberOfDarts(), checksum);
}
BENCHMARK(DartToEdgeVTK)->Unit(benchmark::kMillisecond)->Iterations(1);

// --- cell neighbours: the cells beyond the faces of each cell

void CellNeighboursOurs(benchmark::State& state)
{
  const Map& map = OurMap();
  Sweep<Map::Cell>(state, map.NumberOfCells(),
    [&map](Map::Cell cell)
    {
      return ComputeSum(map.Neighbours(cell),
        [&map](Map::Dart across) { return map.IsOutside(across) ? 0 : map.GetCell(across).Value; });
    });
}
BENCHMARK(CellNeighboursOurs)->Unit(benchmark::kMillisecond);

void CellNeighboursVTK(benchmark::State& state)
{
  vtkUnstructuredGrid* grid = Grid();
  vtkNew<vtkIdList> face, cells;
  face->SetNumberOfIds(3);
  Sweep<vtkIdType>(state, NumberOfTetrahedra(Mesh()),
    [&](vtkIdType cell)
    {
      const std::int64_t* v = Mesh().CellVertices.data() + 4 * cell;
      std::uint64_t sum = 0;
      for (const std::vector<int>& corners : CellType::Tetrahedron().Faces())
      {
        for (int i = 0; i < 3; ++i)
        {
          face->SetId(i, v[corners[static_cast<std::size_t>(i)]]);
        }
        grid->GetCellNeighbors(cell, face, cells);
        sum += SumOfIds(cells);
      }
      return sum;
    });
}
BENCHMARK(CellNeighboursVTK)->Unit(benchmark::kMillisecond)->Iterations(1);

}

#ifdef ISTHMUS_HAS_CGAL
#include "CGALSweeps.h"
#endif

BENCHMARK_MAIN();
