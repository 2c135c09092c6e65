#include "CellComplex/CutAndMerge.h"

#include "CellComplex/Attribute.h"
#include "GeneratedMeshes.h"
#include "IncidenceCheck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;
using Map = CompactCombinatorialMap<>;

std::vector<unsigned char> FirstCells(const Map& map, std::size_t count, bool first)
{
  std::vector<unsigned char> keep(map.NumberOfCells(), first ? 0 : 1);
  std::fill_n(keep.begin(), count, static_cast<unsigned char>(first ? 1 : 0));
  return keep;
}

}

TEST(CutAndMerge, PartsMergeIntoTheWhole)
{
  for (const GeneratedMesh& mesh : { Tetrahedra(3), MixedCells(4) })
  {
    const Map whole(mesh.List());
    for (const std::size_t count : { std::size_t(1), whole.NumberOfCells() / 2 })
    {
      const EditedCells lower = CutOut(whole, FirstCells(whole, count, true));
      const EditedCells upper = CutOut(whole, FirstCells(whole, count, false));
      const Map a(lower.List()), b(upper.List());
      CheckEverything(a, lower.List());
      CheckEverything(b, upper.List());
      EXPECT_EQ(a.NumberOfCells(), count);
      EXPECT_EQ(upper.OldCells.front(), static_cast<std::int64_t>(count));

      std::map<std::int64_t, std::int64_t> newNumber;
      for (std::size_t v = 0; v < lower.OldVertices.size(); ++v)
      {
        newNumber[lower.OldVertices[v]] = static_cast<std::int64_t>(v);
      }
      std::vector<std::pair<std::int64_t, std::int64_t>> same;
      for (std::size_t v = 0; v < upper.OldVertices.size(); ++v)
      {
        const auto found = newNumber.find(upper.OldVertices[v]);
        if (found != newNumber.end())
        {
          same.emplace_back(found->second, static_cast<std::int64_t>(v));
        }
      }
      const EditedCells merged = Merge(a, b, same);
      const Map again(merged.List());
      CheckEverything(again, merged.List());
      EXPECT_EQ(again.NumberOfVertices(), whole.NumberOfVertices());
      EXPECT_EQ(again.NumberOfCells(), whole.NumberOfCells());
      EXPECT_EQ(again.Edges().Size(), whole.Edges().Size());
      EXPECT_EQ(again.NumberOfBoundaryFaces(), whole.NumberOfBoundaryFaces());
      EXPECT_EQ(EulerNumber(again), EulerNumber(whole));
    }
  }
}

TEST(CutAndMerge, RefusesInvalidIds)
{
  const GeneratedMesh mesh = ThreeCells();
  const Map map(mesh.List());
  EXPECT_THROW(CutOut(map, { 1, 0 }), std::invalid_argument);
  EXPECT_THROW(Merge(map, map, { { 0, 8 } }), std::invalid_argument);
  EXPECT_THROW(Merge(map, map, { { 0, 1 }, { 0, 2 } }), std::invalid_argument);
}

TEST(Attribute, EachKindHasItsArray)
{
  const GeneratedMesh mesh = MixedCells(3);
  const Map map(mesh.List());
  Attribute<Map, Map::Vertex, double> onVertices(map, 1.5);
  Attribute<Map, Map::Edge, int> onEdges(map);
  Attribute<Map, Map::Face, int> onFaces(map);
  Attribute<Map, Map::HalfFace, int> onHalfFaces(map);
  Attribute<Map, Map::Dart, int> onDarts(map);
  Attribute<Map, Map::Cell, int> onCells(map);
  for (std::uint32_t c = 0; c < map.NumberOfCells(); ++c)
  {
    ++onCells[Map::Cell(c)];
    for (const Map::HalfFace half : map.HalfFaces(Map::Cell(c)))
    {
      ++onHalfFaces[half];
      onFaces[map.Faces().Find(half)] = 1;
    }
    for (const Map::Dart dart : map.Darts(Map::Cell(c)))
    {
      ++onDarts[dart];
      onEdges[map.Edges().Find(dart)] = 1;
    }
  }
  const auto allOnes = [](const std::vector<int>& values, std::size_t count)
  { return values == std::vector<int>(count, 1); };
  EXPECT_TRUE(allOnes(onCells.Values(), map.NumberOfCells()));
  EXPECT_TRUE(allOnes(onHalfFaces.Values(), map.NumberOfHalfFaces()));
  EXPECT_TRUE(allOnes(onDarts.Values(), map.NumberOfDarts()));
  EXPECT_TRUE(allOnes(onFaces.Values(), map.NumberOfFaces()));
  EXPECT_TRUE(allOnes(onEdges.Values(), map.Edges().Size()));
  EXPECT_EQ(onVertices[Map::Vertex(2)], 1.5);
}
