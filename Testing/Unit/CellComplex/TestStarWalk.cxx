// The building blocks of a walk around a vertex, compared with the standard library, and stars that
// exceed the initial buffer of a walk.

#include "CellComplex/EdgeTable.h"
#include "CellComplex/StarTable.h"
#include "CellComplex/StarWalk.h"
#include "CellComplex/VertexStar.h"
#include "GeneratedMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;

template <typename Id>
void SetsAgree()
{
  std::mt19937 random(11);
  ReusableSet<Id> ours;
  for (int round = 0; round < 200; ++round)
  {
    ours.Clear();
    std::set<Id> expected;
    // A few ids, each many times, and in some rounds more than the initial buffer holds.
    const int count = round % 20 == 0 ? 5000 : 60;
    std::uniform_int_distribution<Id> any(0, static_cast<Id>(count));
    for (int i = 0; i < 2 * count; ++i)
    {
      const Id id = any(random) * (round % 2 == 0 ? 1 : 1024);
      ASSERT_EQ(ours.Insert(id), expected.insert(id).second) << "round " << round << ", id " << id;
    }
    EXPECT_LE(expected.size(), ours.Room());
  }
}

TEST(StarWalk, ReusableSetAgreesWithStdSet)
{
  SetsAgree<std::uint32_t>();
  SetsAgree<std::uint64_t>();
}

TEST(StarWalk, WithRoomKeepsTheContents)
{
  ReusableSet<std::uint32_t> set;
  EXPECT_TRUE(set.Insert(7));
  const auto marks = set.WithRoomFor(3000);
  EXPECT_FALSE(marks.Insert(7));
  EXPECT_TRUE(marks.Insert(8));
  EXPECT_FALSE(set.Insert(8));
}

template <typename Id>
void FindsAsTheStandardLibrary()
{
  std::mt19937 random(3);
  std::uniform_int_distribution<Id> any(0, 12);
  for (int round = 0; round < 1000; ++round)
  {
    std::vector<Id> numbers(8);
    std::generate(numbers.begin(), numbers.end(),
      [&] { return static_cast<Id>(any(random) * Id(0x10000001)); });
    const Id wanted = static_cast<Id>(any(random) * Id(0x10000001));
    const auto expected = std::find(numbers.begin(), numbers.end(), wanted) - numbers.begin();
    EXPECT_EQ(FirstEqualOfEight(numbers.data(), wanted), expected);
  }
}

TEST(StarWalk, FirstEqualOfEightAgreesWithStdFind)
{
  FindsAsTheStandardLibrary<std::uint32_t>();
  FindsAsTheStandardLibrary<std::uint64_t>();
}

/// `count` tetrahedra around the edge of vertices 0 and 1, whole or open.
GeneratedMesh Umbrella(std::int64_t count, bool whole)
{
  GeneratedMesh mesh = EmptyMesh();
  mesh.Points.resize(static_cast<std::size_t>(count + (whole ? 2 : 3)));
  for (std::int64_t c = 0; c < count; ++c)
  {
    mesh.Add(Tetrahedron, { 0, 1, 2 + c, 2 + (whole ? (c + 1) % count : c + 1) });
  }
  return mesh;
}

/// The same with a prism on the last cell's face: not only tetrahedra, so the general walk is used.
GeneratedMesh WithPrism(GeneratedMesh mesh)
{
  const auto n = static_cast<std::int64_t>(mesh.Points.size());
  mesh.Points.resize(mesh.Points.size() + 6);
  mesh.Add(Prism, { n, n + 1, n + 2, n + 3, n + 4, n + 5 });
  return mesh;
}

TEST(StarWalk, AgreesWithTheListWhereStarsAreLarge)
{
  for (const std::int64_t count : { 3, 40, 511, 512, 513, 3000 })
  {
    for (const bool whole : { true, false })
    {
      const GeneratedMesh mesh = Umbrella(count, whole), mixed = WithPrism(mesh);
      const CompactCombinatorialMap<> map(mesh.List()), general(mixed.List());
      ASSERT_TRUE(map.HasOnlyTetrahedra());
      ASSERT_FALSE(general.HasOnlyTetrahedra());
      VertexStar<> star(map), generalStar(general);
      for (std::uint32_t v = 0; v < map.NumberOfVertices(); ++v)
      {
        const auto walked = star.Gather(VertexHandle<std::uint32_t>(v));
        const auto generally = generalStar.Gather(VertexHandle<std::uint32_t>(v));
        std::vector<std::uint32_t> cells, expected;
        for (const auto dart : walked)
        {
          EXPECT_EQ(map.StartVertex(dart).Value, v);
          cells.push_back(map.GetCell(dart).Value);
        }
        std::sort(cells.begin(), cells.end());
        for (const auto dart : map.Stars().Find(VertexHandle<std::uint32_t>(v)))
        {
          expected.push_back(map.GetCell(dart).Value);
        }
        ASSERT_EQ(cells, expected) << count << " cells, vertex " << v;
        // Both walks find the same darts in the same order.
        ASSERT_EQ(walked.size(), generally.size());
        EXPECT_TRUE(std::equal(walked.begin(), walked.end(), generally.begin()));
      }
    }
  }
}

TEST(StarWalk, TetrahedraAreWalkedInTheOrderOfTheGeneralWay)
{
  const GeneratedMesh mesh = Tetrahedra(5), mixed = WithPrism(mesh);
  const CompactCombinatorialMap<> map(mesh.List()), general(mixed.List());
  VertexStar<> star(map), generalStar(general);
  for (std::uint32_t v = 0; v < map.NumberOfVertices(); ++v)
  {
    const auto walked = star.Gather(VertexHandle<std::uint32_t>(v));
    const auto generally = generalStar.Gather(VertexHandle<std::uint32_t>(v));
    ASSERT_EQ(walked.size(), generally.size());
    EXPECT_TRUE(std::equal(walked.begin(), walked.end(), generally.begin())) << "vertex " << v;
  }
}

}
