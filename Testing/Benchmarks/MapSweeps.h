/**
 * @file MapSweeps.h
 * @brief The mesh that combinatorial maps are compared on, and the times of builds and of sweeps
 * over it.
 */
#ifndef isthmus_MapSweeps_h
#define isthmus_MapSweeps_h

#include "CellComplex/CompactCombinatorialMap.h"
#include "GeneratedMeshes.h"

#include <benchmark/benchmark.h>

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <malloc.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace isthmus::testing
{

using Map = CompactCombinatorialMap<>;

/// Bytes currently allocated.
inline std::size_t HeldBytes()
{
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

inline GeneratedMesh MakeMesh(double tetrahedra)
{
  return Tetrahedra(std::llround(std::cbrt(tetrahedra / 6.0)));
}

inline std::size_t NumberOfTetrahedra(const GeneratedMesh& mesh)
{
  return mesh.CellVertices.size() / 4;
}

/// The mesh of all sweeps.
inline const GeneratedMesh& Mesh()
{
  static const GeneratedMesh mesh = []()
  {
    const char* chosen = std::getenv("ISTHMUS_BENCH_TETRAHEDRA");
    return MakeMesh(chosen ? std::atof(chosen) : 5e6);
  }();
  return mesh;
}

inline vtkUnstructuredGrid* Grid()
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

inline const Map& OurMap()
{
  static const Map map(Mesh().List());
  return map;
}

/// Reports a sweep of `questions` queries.
inline void ReportSweep(benchmark::State& state, std::size_t questions, std::uint64_t checksum)
{
  const auto total = static_cast<double>(questions) * static_cast<double>(state.iterations());
  state.counters["ns"] =
    benchmark::Counter(total * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["checksum"] = static_cast<double>(checksum % 1000003);
}

/// Times one query for each Handle(0) ... Handle(count - 1); the sum of of(handle) must equal that
/// of the peers.
template <typename Handle, typename Of>
void Sweep(benchmark::State& state, std::size_t count, Of&& of)
{
  std::uint64_t checksum = 0;
  for (auto _ : state)
  {
    checksum = 0;
    for (std::uint32_t i = 0; i < count; ++i)
    {
      checksum += of(Handle(i));
    }
  }
  ReportSweep(state, count, checksum);
}

/// The sum of of(item) over a range.
template <typename Items, typename Of>
std::uint64_t ComputeSum(const Items& items, Of&& of)
{
  std::uint64_t sum = 0;
  for (const auto item : items)
  {
    sum += of(item);
  }
  return sum;
}

/// The cells of darts, as numbers.
template <typename Darts>
std::uint64_t SumOfCells(const Map& map, const Darts& darts)
{
  return ComputeSum(darts, [&map](Map::Dart dart) { return map.GetCell(dart).Value; });
}

inline std::uint64_t SumOfIds(vtkIdList* ids)
{
  return ComputeSum(*ids, [](vtkIdType id) { return static_cast<std::uint64_t>(id); });
}

/// Times `build`, which builds a structure of `cells` cells and returns its size in bytes.
template <typename Build>
void TimeBuild(benchmark::State& state, std::size_t cells, Build&& build)
{
  std::size_t bytes = 0;
  for (auto _ : state)
  {
    const std::size_t before = HeldBytes();
    bytes = build(before);
  }
  const auto total = static_cast<double>(cells) * static_cast<double>(state.iterations());
  state.counters["cells/s"] = benchmark::Counter(total, benchmark::Counter::kIsRate);
  state.counters["ns/cell"] =
    benchmark::Counter(total * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["bytes/cell"] = static_cast<double>(bytes) / static_cast<double>(cells);
}

}

#endif
