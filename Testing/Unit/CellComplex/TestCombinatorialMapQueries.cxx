// vtkCombinatorialMap: every relation compared with VTK's cells, and with its transpose.

#include "GridFixtures.h"
#include "vtkCombinatorialMap.h"

#include <vtkCell.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

using namespace isthmus::testing;

namespace
{

using Map = vtkCombinatorialMap;
using Ids = std::vector<vtkIdType>;

Ids Incident(Map* map, int from, vtkIdType id, int to)
{
  vtkNew<vtkIdList> found;
  map->GetIncident(from, id, to, found);
  return { found->begin(), found->end() };
}

Ids SortIds(Ids ids)
{
  std::sort(ids.begin(), ids.end());
  return ids;
}

using Pairs = std::set<std::pair<vtkIdType, vtkIdType>>;

/// The relation as pairs, each reversed on request.
Pairs Relation(Map* map, int from, int to, bool turned)
{
  vtkNew<vtkIdTypeArray> offsets, ids;
  map->GetIncidence(from, to, offsets, ids);
  EXPECT_EQ(offsets->GetNumberOfValues(), map->GetNumber(from) + 1);
  Pairs pairs;
  for (vtkIdType i = 0; i < map->GetNumber(from); ++i)
  {
    const Ids own(
      ids->GetPointer(offsets->GetValue(i)), ids->GetPointer(0) + offsets->GetValue(i + 1));
    EXPECT_EQ(own, Incident(map, from, i, to));
    for (const vtkIdType id : own)
    {
      EXPECT_TRUE(pairs.insert(turned ? std::pair(id, i) : std::pair(i, id)).second) << "twice";
    }
  }
  return pairs;
}

void CheckStarsAndCells(Map* map, vtkUnstructuredGrid* grid)
{
  std::map<vtkIdType, std::set<vtkIdType>> stars;
  std::map<Ids, std::set<vtkIdType>> ofEdges, ofFaces;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    vtkCell* cell = grid->GetCell(c);
    const Ids corners(cell->GetPointIds()->begin(), cell->GetPointIds()->end());
    EXPECT_EQ(SortIds(Incident(map, Map::Cell, c, Map::Vertex)), SortIds(corners));
    for (const vtkIdType p : corners)
    {
      stars[p].insert(c);
    }
    for (int e = 0; e < cell->GetNumberOfEdges(); ++e)
    {
      vtkIdList* ends = cell->GetEdge(e)->GetPointIds();
      ofEdges[SortIds({ ends->begin(), ends->end() })].insert(c);
    }
    for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
    {
      vtkIdList* points = cell->GetFace(f)->GetPointIds();
      ofFaces[SortIds({ points->begin(), points->end() })].insert(c);
    }
  }
  const auto expect = [&](int kind, const auto& truth, const auto& keyOf)
  {
    ASSERT_EQ(map->GetNumber(kind), static_cast<vtkIdType>(truth.size()));
    for (vtkIdType i = 0; i < map->GetNumber(kind); ++i)
    {
      const Ids cells = SortIds(Incident(map, kind, i, Map::Cell));
      EXPECT_EQ(std::set<vtkIdType>(cells.begin(), cells.end()), truth.at(keyOf(i)));
      EXPECT_EQ(cells.size(), truth.at(keyOf(i)).size());
    }
  };
  expect(Map::Vertex, stars, [](vtkIdType i) { return i; });
  expect(Map::Edge, ofEdges,
    [map](vtkIdType i) { return SortIds(Incident(map, Map::Edge, i, Map::Vertex)); });
  expect(Map::Face, ofFaces,
    [map](vtkIdType i) { return SortIds(Incident(map, Map::Face, i, Map::Vertex)); });
}

/// Consecutive cells around an edge share a face that contains the edge.
void CheckFans(Map* map)
{
  for (vtkIdType e = 0; e < map->GetNumber(Map::Edge); ++e)
  {
    const Ids fan = Incident(map, Map::Edge, e, Map::Cell);
    const Ids faces = SortIds(Incident(map, Map::Edge, e, Map::Face));
    for (std::size_t i = 0; i + 1 < fan.size(); ++i)
    {
      const Ids one = SortIds(Incident(map, Map::Cell, fan[i], Map::Face));
      const Ids next = SortIds(Incident(map, Map::Cell, fan[i + 1], Map::Face));
      Ids common, atEdge;
      std::set_intersection(
        one.begin(), one.end(), next.begin(), next.end(), std::back_inserter(common));
      std::set_intersection(
        common.begin(), common.end(), faces.begin(), faces.end(), std::back_inserter(atEdge));
      EXPECT_EQ(atEdge.size(), 1U) << "edge " << e;
    }
  }
}

void CheckDarts(Map* map)
{
  std::array<vtkNew<vtkIdTypeArray>, 4> beta;
  for (int i = 1; i < 4; ++i)
  {
    map->GetBeta(i, beta[static_cast<std::size_t>(i)]);
    ASSERT_EQ(beta[static_cast<std::size_t>(i)]->GetNumberOfValues(), map->GetNumber(Map::Dart));
  }
  std::set<vtkIdType> next;
  for (vtkIdType d = 0; d < map->GetNumber(Map::Dart); ++d)
  {
    next.insert(beta[1]->GetValue(d));
    const vtkIdType turned = beta[2]->GetValue(d), across = beta[3]->GetValue(d);
    EXPECT_EQ(beta[2]->GetValue(turned), d);
    EXPECT_EQ(Incident(map, Map::Dart, turned, Map::Edge), Incident(map, Map::Dart, d, Map::Edge));
    EXPECT_EQ(Incident(map, Map::Dart, turned, Map::Cell), Incident(map, Map::Dart, d, Map::Cell));
    EXPECT_NE(Incident(map, Map::Dart, turned, Map::Face), Incident(map, Map::Dart, d, Map::Face));
    const Ids face = Incident(map, Map::Dart, d, Map::Face);
    EXPECT_EQ(Incident(map, Map::Face, face[0], Map::Cell).size(), across < 0 ? 1U : 2U);
    if (across >= 0)
    {
      EXPECT_EQ(beta[3]->GetValue(across), d);
      EXPECT_EQ(Incident(map, Map::Dart, across, Map::Face), face);
      EXPECT_NE(
        Incident(map, Map::Dart, across, Map::Cell), Incident(map, Map::Dart, d, Map::Cell));
    }
  }
  EXPECT_EQ(static_cast<vtkIdType>(next.size()), map->GetNumber(Map::Dart)) << "a permutation";
}

TEST(CombinatorialMapQueries, AgreeWithVTKAndTheirTransposes)
{
  for (const GridPointer& grid :
    { MakeGrid(MixedCells(2)), MakeGrid(Tetrahedra(2)), MakeGrid(MixedCells(2), true) })
  {
    vtkNew<Map> map;
    ASSERT_TRUE(map->SetMesh(grid));
    CheckStarsAndCells(map, grid);
    CheckFans(map);
    CheckDarts(map);
    for (int from = Map::Vertex; from <= Map::Dart; ++from)
    {
      for (int to = Map::Vertex; to <= Map::Dart; ++to)
      {
        const bool isKnown =
          from != to || from == Map::Vertex || from == Map::Cell || from == Map::HalfFace;
        const bool isWhole = !(from == Map::Dart && to == Map::Vertex) && // a dart has two ends
          !(from == Map::Vertex && to == Map::Dart);                      // those that start there
        if (isKnown && isWhole)
        {
          EXPECT_EQ(Relation(map, from, to, false), Relation(map, to, from, true))
            << from << " to " << to;
        }
      }
    }
  }
}

TEST(CombinatorialMapQueries, CellsKeepTheNumbersOfTheMesh)
{
  const GridPointer grid = MakeGrid(Tetrahedra(1));
  GridPointer mixed = EmptyGrid();
  mixed->SetPoints(grid->GetPoints());
  const vtkIdType triangle[] = { 0, 1, 2 };
  mixed->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    mixed->InsertNextCell(VTK_TETRA, grid->GetCell(c)->GetPointIds());
  }
  vtkNew<Map> plain, shifted;
  ASSERT_TRUE(plain->SetMesh(grid));
  ASSERT_TRUE(shifted->SetMesh(mixed));
  EXPECT_EQ(shifted->GetNumber(Map::Cell), plain->GetNumber(Map::Cell) + 1);
  EXPECT_TRUE(Incident(shifted, Map::Cell, 0, Map::Vertex).empty());
  for (vtkIdType v = 0; v < plain->GetNumber(Map::Vertex); ++v)
  {
    Ids star = Incident(plain, Map::Vertex, v, Map::Cell);
    std::for_each(star.begin(), star.end(), [](vtkIdType& cell) { ++cell; });
    EXPECT_EQ(Incident(shifted, Map::Vertex, v, Map::Cell), star);
  }
}

TEST(CombinatorialMapQueries, MemoryOfTetrahedraMatchesTheirTables)
{
  vtkNew<Map> map;
  ASSERT_TRUE(map->SetMesh(MakeGrid(Tetrahedra(4))));
  std::map<std::string, vtkIdType> bytes;
  for (int i = 0; i < map->GetNumberOfTables(); ++i)
  {
    bytes[map->GetTableName(i)] = map->GetTableBytes(i);
  }
  const vtkIdType cells = map->GetNumber(Map::Cell);
  EXPECT_EQ(bytes.at("Cv2V"), 16 * cells);
  EXPECT_EQ(bytes.at("H2D"), 16 * cells);
  EXPECT_EQ(bytes.at("V2D"), 4 * map->GetNumber(Map::Vertex));
  EXPECT_NEAR(map->GetEstimatedBytes(),
    34.8 * static_cast<double>(cells) + static_cast<double>(bytes.at("B2D")), 1e-9);
  EXPECT_EQ(map->GetTableName(99), nullptr);
  map->GetNumber(Map::Edge);
  EXPECT_GT(map->GetNumberOfTables(), static_cast<int>(bytes.size())) << "tables of edges";
}

TEST(CombinatorialMapQueries, RefuseInvalidIds)
{
  vtkNew<Map> map;
  vtkNew<vtkTest::ErrorObserver> observer;
  map->AddObserver(vtkCommand::ErrorEvent, observer);
  const auto refuses = [&](const std::string& text, auto&& ask)
  {
    observer->Clear();
    ask();
    EXPECT_NE(observer->GetErrorMessage().find(text), std::string::npos)
      << text << ": " << observer->GetErrorMessage();
  };
  EXPECT_EQ(map->GetNumber(Map::Cell), 0) << "no mesh yet";
  refuses("no mesh", [&] { EXPECT_FALSE(map->SetMesh(nullptr)); });
  ASSERT_TRUE(map->SetMesh(MakeGrid(Tetrahedra(1))));
  refuses(
    "no edge 10000", [&] { EXPECT_TRUE(Incident(map, Map::Edge, 10000, Map::Cell).empty()); });
  refuses("no vertex -1", [&] { EXPECT_TRUE(Incident(map, Map::Vertex, -1, Map::Cell).empty()); });
  refuses("no kind 6", [&] { EXPECT_EQ(map->GetNumber(6), 0); });
  refuses("neighbours of their own kind",
    [&] { EXPECT_TRUE(Incident(map, Map::Edge, 0, Map::Edge).empty()); });
  vtkNew<vtkIdTypeArray> darts;
  refuses("no beta_4", [&] { map->GetBeta(4, darts); });
  GridPointer twice = MakeGrid(Tetrahedra(1));
  const vtkIdType folded[] = { 0, 1, 2, 2 };
  twice->InsertNextCell(VTK_TETRA, 4, folded);
  refuses("", [&] { EXPECT_FALSE(map->SetMesh(twice)); });
  EXPECT_EQ(map->GetNumber(Map::Cell), 0);
}

}
