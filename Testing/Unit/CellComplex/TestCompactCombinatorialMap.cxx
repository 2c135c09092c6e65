#include "CellComplex/CompactCombinatorialMap.h"

#include "CellComplex/EdgeTable.h"
#include "CellComplex/FaceTable.h"
#include "GeneratedMeshes.h"
#include "IncidenceCheck.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;
using Map = CompactCombinatorialMap<>;

/// (cell, local dart), as the thesis' tables print a dart; (boundary face, 0) beyond the boundary.
using Printed = std::pair<unsigned, unsigned>;

Printed Print(const Map& map, Map::Dart dart)
{
  return { map.GetCell(dart).Value, map.LocalDart(dart) };
}

std::string Refusal(const CellList& mesh)
{
  try
  {
    const Map map(mesh);
  }
  catch (const MeshError& error)
  {
    return error.what();
  }
  return "";
}

}

TEST(CompactCombinatorialMap, TypesOfTables31To34)
{
  const std::vector<std::vector<unsigned>> beta1{ { 9, 3, 8, 5, 12, 1, 11, 2, 6, 7, 10, 4 },
    { 9, 3, 8, 5, 15, 1, 11, 2, 14, 7, 18, 4, 17, 6, 12, 13, 16, 10 } };
  const std::vector<std::vector<Printed>> darts{ { { 0, 1 }, { 1, 0 }, { 0, 2 }, { 2, 0 }, { 0, 3 },
                                                   { 3, 0 }, { 1, 2 }, { 2, 1 }, { 1, 3 }, { 3, 1 },
                                                   { 2, 3 }, { 3, 2 } },
    { { 0, 1 }, { 1, 0 }, { 0, 2 }, { 2, 0 }, { 0, 3 }, { 3, 0 }, { 1, 2 }, { 2, 1 }, { 1, 4 },
      { 4, 1 }, { 2, 5 }, { 5, 2 }, { 3, 4 }, { 4, 3 }, { 3, 5 }, { 5, 3 }, { 4, 5 }, { 5, 4 } } };
  const std::vector<const CellType*> types{ &CellType::Tetrahedron(), &CellType::Prism() };
  for (std::size_t t = 0; t < 2; ++t)
  {
    ASSERT_EQ(static_cast<std::size_t>(types[t]->NumberOfDarts()), beta1[t].size());
    for (unsigned d = 1; d <= beta1[t].size(); ++d)
    {
      EXPECT_EQ(types[t]->At(d).Next, beta1[t][d - 1]);
      EXPECT_EQ(types[t]->At(d).Start, darts[t][d - 1].first);
      EXPECT_EQ(types[t]->At(CellType::Beta2(d)).Start, darts[t][d - 1].second);
      EXPECT_EQ(CellType::Beta2(d), d % 2 ? d + 1 : d - 1);
    }
  }
}

TEST(CompactCombinatorialMap, BytesOfATypeMatchItsTables)
{
  for (const CellType* type : { &CellType::Tetrahedron(), &CellType::Hexahedron() })
  {
    const auto darts = static_cast<std::size_t>(type->NumberOfDarts());
    std::size_t faces = 0;
    for (const std::vector<int>& face : type->Faces())
    {
      faces += sizeof(std::vector<int>) + face.size() * sizeof(int);
    }
    // Darts, those of faces and of vertices; offsets have one entry more.
    const std::size_t least = sizeof(CellType) + (darts + 1) * sizeof(CellType::Dart) + faces +
      (2 * darts + static_cast<std::size_t>(type->NumberOfFaces() + type->NumberOfVertices() + 2)) *
        sizeof(CellType::Local);
    EXPECT_GE(type->MemoryBytes(), least) << type->Name();
    EXPECT_LE(type->MemoryBytes(), 2 * least) << type->Name();
  }
}

TEST(CompactCombinatorialMap, TablesOfTheThreeCells)
{
  const GeneratedMesh mesh = ThreeCells();
  const Map map(mesh.List());
  const std::vector<std::vector<Printed>> h2d{ { { 2, 8 }, { 0, 0 }, { 1, 0 }, { 2, 0 } },
    { { 2, 16 }, { 3, 0 }, { 4, 0 }, { 5, 0 } },
    { { 0, 8 }, { 6, 0 }, { 7, 0 }, { 8, 0 }, { 1, 2 } } };
  for (unsigned c = 0; c < 3; ++c)
  {
    const auto across = map.Neighbours(Map::Cell(c));
    ASSERT_EQ(across.size(), h2d[c].size());
    for (std::size_t f = 0; f < across.size(); ++f)
    {
      EXPECT_EQ(Print(map, across[f]), h2d[c][f]) << "cell " << c << " face " << f;
    }
  }
  const std::vector<Printed> b2d{ { 0, 1 }, { 0, 7 }, { 0, 4 }, { 1, 1 }, { 1, 7 }, { 1, 4 },
    { 2, 1 }, { 2, 7 }, { 2, 4 } };
  ASSERT_EQ(map.NumberOfBoundaryFaces(), b2d.size());
  for (unsigned b = 0; b < b2d.size(); ++b)
  {
    EXPECT_EQ(Print(map, map.GetDart(Map::BoundaryFace(b))), b2d[b]);
  }
  for (unsigned v = 0; v < 8; ++v)
  {
    EXPECT_EQ(map.StartVertex(map.GetDart(Map::Vertex(v))).Value, v);
    EXPECT_TRUE(map.IsBoundary(Map::Vertex(v)));
  }
  EXPECT_EQ(map.DartBits(), 5u);
}

TEST(CompactCombinatorialMap, EdgesOfTheThreeCells)
{
  const GeneratedMesh mesh = ThreeCells();
  const Map map(mesh.List());
  const std::vector<std::pair<Pair, Printed>> e2d{ { { 0, 1 }, { 0, 2 } }, { { 0, 2 }, { 2, 3 } },
    { { 0, 3 }, { 2, 5 } }, { { 0, 6 }, { 0, 9 } }, { { 1, 2 }, { 0, 3 } }, { { 1, 4 }, { 2, 9 } },
    { { 1, 6 }, { 0, 5 } }, { { 2, 5 }, { 2, 11 } }, { { 2, 6 }, { 0, 11 } },
    { { 3, 4 }, { 2, 13 } }, { { 3, 5 }, { 1, 3 } }, { { 3, 7 }, { 1, 5 } },
    { { 4, 5 }, { 2, 17 } }, { { 4, 7 }, { 1, 9 } }, { { 5, 7 }, { 1, 11 } } };
  ASSERT_EQ(map.Edges().Size(), e2d.size());
  for (unsigned e = 0; e < e2d.size(); ++e)
  {
    const Map::Dart dart = map.Edges().GetDart(Map::Edge(e));
    EXPECT_EQ(Ends(map, dart), e2d[e].first);
    EXPECT_EQ(Print(map, dart), e2d[e].second);
  }
  const std::vector<unsigned> v2e{ 0, 4, 7, 9, 12, 14 };
  for (unsigned v = 0; v < v2e.size(); ++v)
  {
    EXPECT_EQ(map.Edges().StartingAt(Map::Vertex(v))[0].Value, v2e[v]);
  }
  EXPECT_EQ(map.Edges().StartingAt(Map::Vertex(6)).size(), 0u);
  EXPECT_EQ(map.Edges().StartingAt(Map::Vertex(7)).size(), 0u);
  CheckEverything(map, mesh.List());
}

TEST(CompactCombinatorialMap, AgreesWithBruteForceOnEachTypeAndMixed)
{
  for (const GeneratedMesh& mesh :
    { Tetrahedra(4), Prisms(4), Pyramids(3), Hexahedra(4), MixedCells(5) })
  {
    const Map map(mesh.List());
    CheckEverything(map, mesh.List());
    EXPECT_EQ(EulerNumber(map), 1);
    const CompactCombinatorialMap<std::uint64_t> wide(mesh.List());
    CheckEverything(wide, mesh.List());
  }
}

TEST(CompactCombinatorialMap, AgreesWithBruteForceWhereCellsComeInAnyOrder)
{
  GeneratedMesh mesh = Tetrahedra(5);
  std::mt19937 random(7);
  std::vector<std::size_t> order(mesh.CellVertices.size() / 4);
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<std::int64_t> names(mesh.Points.size());
  std::iota(names.begin(), names.end(), 0);
  std::shuffle(names.begin(), names.end(), random);
  std::vector<std::int64_t> shuffled;
  for (const std::size_t cell : order)
  {
    for (std::size_t v = 0; v < 4; ++v)
    {
      shuffled.push_back(names[static_cast<std::size_t>(mesh.CellVertices[4 * cell + v])]);
    }
  }
  mesh.CellVertices = shuffled;
  const Map map(mesh.List());
  CheckEverything(map, mesh.List());
  EXPECT_EQ(EulerNumber(map), 1);
}

TEST(CompactCombinatorialMap, KeepsStarsAndFansWholeWhereTheMeshIsPinched)
{
  // Two cubes that share one edge, two that share one vertex, and a vertex without cells.
  GeneratedMesh mesh = OnCubes(2,
    [](GeneratedMesh& m, const Cube& c, std::int64_t i, std::int64_t j, std::int64_t k)
    {
      if (i + 2 * j + 4 * k == 0 || i + 2 * j + 4 * k == 3 || i + 2 * j + 4 * k == 5)
      {
        AddTetrahedra(m, c);
      }
    });
  const Map map(mesh.List());
  CheckEverything(map, mesh.List());
  EXPECT_EQ(map.FurtherUmbrellas(Map::Vertex(13)).size(), 2u); // the middle: three cubes
}

TEST(CompactCombinatorialMap, RefusesWithTheCellsNamed)
{
  GeneratedMesh mesh = ThreeCells();
  mesh.CellVertices[5] = 8;
  EXPECT_NE(
    Refusal(mesh.List()).find("Cell 1: a vertex number is not in 0 ... 7"), std::string::npos);
  mesh.CellVertices[5] = 3;
  EXPECT_NE(Refusal(mesh.List()).find("Cell 1: the same vertex occurs twice"), std::string::npos);
  mesh = ThreeCells();
  std::swap(mesh.CellVertices[4], mesh.CellVertices[5]);
  EXPECT_NE(Refusal(mesh.List()).find("Cells 1 and 2 see their common face"), std::string::npos);
  mesh = ThreeCells();
  mesh.Add(Tetrahedron, { 1, 0, 2, 7 });
  EXPECT_NE(Refusal(mesh.List()).find("Cells 0 and 3 share a face"), std::string::npos);
  mesh = ThreeCells();
  mesh.CellVertices.pop_back();
  EXPECT_NE(Refusal(mesh.List()).find("need 14 vertex numbers, but 13"), std::string::npos);
}

TEST(CompactCombinatorialMap, RefusesTypesThatAreNoSphere)
{
  const auto refusal = [](int vertices, const FaceList& faces) -> std::string
  {
    try
    {
      const CellType type("x", vertices, faces);
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
    return "";
  };
  const FaceList tetrahedron = CellType::Tetrahedron().Faces();
  FaceList faces = tetrahedron;
  std::reverse(faces[1].begin(), faces[1].end());
  EXPECT_NE(refusal(4, faces).find("in the same direction"), std::string::npos);
  EXPECT_EQ(OrientFaces(faces), tetrahedron);
  faces.pop_back();
  EXPECT_NE(refusal(4, OrientFaces(faces)).find("is open at its edge"), std::string::npos);
  EXPECT_NE(refusal(5, tetrahedron).find("vertex 4 in none of its faces"), std::string::npos);
  EXPECT_NE(refusal(3, { { 0, 1, 2 }, { 0, 2, 1 } }).find("fewer than four"), std::string::npos);
  EXPECT_NE(refusal(4, { { 0, 1, 7 } }).find("not all among its 4"), std::string::npos);
  FaceList two = tetrahedron;
  for (const std::vector<int>& face : tetrahedron)
  {
    two.push_back({ face[0] + 4, face[1] + 4, face[2] + 4 });
  }
  EXPECT_NE(refusal(8, two).find("not a sphere"), std::string::npos);
}

TEST(CompactCombinatorialMap, ReportsWhatDoesNotFitIn32Bits)
{
  CellList mesh;
  mesh.Types = { CellType::Tetrahedron() };
  mesh.Runs = { { 0, (std::int64_t(1) << 28) - 1 } };
  EXPECT_TRUE(Map::FitsIn(mesh));
  ++mesh.Runs[0].NumberOfCells;
  EXPECT_FALSE(Map::FitsIn(mesh));
  EXPECT_TRUE(CompactCombinatorialMap<std::uint64_t>::FitsIn(mesh));
  EXPECT_NE(Refusal(mesh).find("use the map with 64-bit ids"), std::string::npos);
}

TEST(CompactCombinatorialMap, SameTablesOnAnyNumberOfThreads)
{
  const GeneratedMesh mesh = Tetrahedra(30); // several pieces of every loop
  const auto tables = [&mesh](int threads)
  {
    std::vector<std::uint32_t> all;
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
      [&]()
      {
        const Map map(mesh.List());
        for (std::uint32_t c = 0; c < map.NumberOfCells(); ++c)
        {
          for (const Map::Dart across : map.Neighbours(Map::Cell(c)))
          {
            all.push_back(across.Value);
          }
        }
        for (std::uint32_t v = 0; v < map.NumberOfVertices(); ++v)
        {
          all.push_back(map.GetDart(Map::Vertex(v)).Value);
        }
        for (std::uint32_t e = 0; e < map.Edges().Size(); ++e)
        {
          all.push_back(map.Edges().GetDart(Map::Edge(e)).Value);
        }
        for (std::uint32_t f = 0; f < map.Faces().Size(); ++f)
        {
          all.push_back(map.Faces().GetDart(Map::Face(f)).Value);
        }
      });
    return all;
  };
  const std::vector<std::uint32_t> one = tables(1);
  EXPECT_TRUE(one == tables(2));
  EXPECT_TRUE(one == tables(5));
}

TEST(CompactCombinatorialMap, EmptyMesh)
{
  const Map map(CellList{});
  EXPECT_EQ(map.NumberOfCells(), 0u);
  EXPECT_EQ(map.Edges().Size(), 0u);
  EXPECT_EQ(map.Faces().Size(), 0u);
}
