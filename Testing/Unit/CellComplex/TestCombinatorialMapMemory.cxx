// Memory of the combinatorial map: the tables' formula without slack, the peak while it is built.

#include "CellComplex/CompactCombinatorialMap.h"

#include "CellComplex/EdgeTable.h"
#include "CellComplex/FaceTable.h"
#include "GeneratedMeshes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <map>
#include <new>
#include <string>

#include <malloc.h>

namespace
{

std::atomic<std::size_t> held{ 0 }, peak{ 0 };

void* AllocateCounted(std::size_t size)
{
  void* memory = std::malloc(size ? size : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  const std::size_t now = held += malloc_usable_size(memory);
  for (std::size_t most = peak; now > most && !peak.compare_exchange_weak(most, now);)
  {
  }
  return memory;
}

void FreeCounted(void* memory) noexcept
{
  held -= memory ? malloc_usable_size(memory) : 0;
  std::free(memory);
}

}

// Replaces operator new, so that all allocations of the map are counted.
void* operator new(std::size_t size)
{
  return AllocateCounted(size);
}
void* operator new[](std::size_t size)
{
  return AllocateCounted(size);
}
void operator delete(void* memory) noexcept
{
  FreeCounted(memory);
}
void operator delete[](void* memory) noexcept
{
  FreeCounted(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  FreeCounted(memory);
}
void operator delete[](void* memory, std::size_t) noexcept
{
  FreeCounted(memory);
}

namespace
{

using namespace isthmus;
using namespace isthmus::testing;
using Map = CompactCombinatorialMap<>;

std::map<std::string, std::size_t> Report(const Map& map)
{
  std::map<std::string, std::size_t> bytes;
  for (const TableMemory& table : map.MemoryReport())
  {
    bytes[table.Name] = table.Bytes;
  }
  return bytes;
}

}

TEST(CombinatorialMapMemory, TablesHaveNoSlackAndThePeakIsLow)
{
  const GeneratedMesh mesh = Tetrahedra(40);
  const CellList list = mesh.List();
  const std::size_t before = held;
  peak = before;
  const Map map(list);
  const std::size_t n0 = map.NumberOfVertices(), n3 = map.NumberOfCells(),
                    nb = map.NumberOfBoundaryFaces();
  ASSERT_EQ(n3, 384000u);
  const std::size_t tables = 4 * (4 * n3 + 4 * n3 + n0 + nb);
  auto bytes = Report(map);
  EXPECT_EQ(bytes["Cv2V"] + bytes["H2D"] + bytes["V2D"] + bytes["B2D"], tables);
  EXPECT_LE(bytes["Runs"] + bytes["Types"] + bytes["Umbrellas"], 8000u);
  // Increase of the process' memory, including cell types copied from the list.
  EXPECT_LE(held - before, tables + 20000);
  EXPECT_LE(static_cast<double>(peak - before), 2.5 * static_cast<double>(tables));
  RecordProperty("PeakOverTables",
    std::to_string(static_cast<double>(peak - before) / static_cast<double>(tables)));
  std::printf(
    "peak / tables: %.3f\n", static_cast<double>(peak - before) / static_cast<double>(tables));
}

TEST(CombinatorialMapMemory, OptionalTablesHaveTheirDocumentedSize)
{
  const GeneratedMesh mesh = Tetrahedra(10);
  const Map map(mesh.List());
  EXPECT_EQ(Report(map).count("E2D"), 0u); // built on first use
  const std::size_t n0 = map.NumberOfVertices(), n1 = map.Edges().Size(), n2 = map.Faces().Size();
  auto bytes = Report(map);
  EXPECT_EQ(bytes["E2D"], 4 * n1);
  EXPECT_EQ(bytes["E2V"], 4 * (n1 + 8));
  EXPECT_EQ(bytes["V2E"], 4 * (n0 + 1));
  EXPECT_EQ(bytes["F2D"], 4 * n2);
  EXPECT_EQ(bytes["V2F"], 4 * (n0 + 1));
}

// Table 3.8 of the thesis, column "est.", in thousands of bytes.
TEST(CombinatorialMapMemory, EstimateOfTable38)
{
  const struct
  {
    double Boundary, Tetrahedra, Printed;
  } rows[] = { { 48308, 529652, 18625 }, { 77704, 1085997, 38103 }, { 65402, 792038, 27824 },
    { 224024, 3156497, 110742 }, { 19540, 117736, 4175 }, { 125450, 1980912, 69438 },
    { 133476, 2073588, 72695 } };
  for (const auto& row : rows)
  {
    EXPECT_NEAR(Map::EstimatedBytes(row.Tetrahedra, row.Boundary) / 1000.0, row.Printed, 1.0);
  }
}
