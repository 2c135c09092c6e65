/**
 * @file IncidenceCheck.h
 * @brief Compares every query of a combinatorial map with sets built by brute force from the cells.
 */
#ifndef isthmus_IncidenceCheck_h
#define isthmus_IncidenceCheck_h

#include "BruteForceIncidence.h"
#include "CellComplex/CompactCombinatorialMap.h"
#include "CellComplex/EdgeTable.h"
#include "CellComplex/FaceTable.h"
#include "CellComplex/StarTable.h"
#include "CellComplex/VertexStar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace isthmus::testing
{

/// The id in a handle, in the integer type of the brute-force search.
template <typename Handle>
std::int64_t Number(Handle handle)
{
  return static_cast<std::int64_t>(handle.Value);
}

template <typename Map>
Pair Ends(const Map& map, typename Map::Dart dart)
{
  return { Number(map.StartVertex(dart)), Number(map.EndVertex(dart)) };
}

template <typename Map>
Corners GetCorners(const Map& map, typename Map::HalfFace half)
{
  Corners corners;
  for (const auto dart : map.Darts(half))
  {
    corners.push_back(Number(map.StartVertex(dart)));
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// beta1 is a permutation, beta2, beta3 and beta1 o beta3 are involutions.
template <typename Map>
void CheckAxioms(const Map& map)
{
  std::size_t darts = 0;
  std::set<std::size_t> places;
  for (std::size_t c = 0; c < map.NumberOfCells(); ++c)
  {
    for (const auto dart : map.Darts(typename Map::Cell(static_cast<typename Map::IdType>(c))))
    {
      ++darts;
      places.insert(map.GetIndex(dart));
      ASSERT_EQ(map.Beta1Inverse(map.Beta1(dart)), dart);
      ASSERT_NE(map.Beta2(dart), dart);
      ASSERT_EQ(map.Beta2(map.Beta2(dart)), dart);
      ASSERT_EQ(Ends(map, map.Beta2(dart)), Pair(Ends(map, dart).second, Ends(map, dart).first));
      ASSERT_EQ(map.StartVertex(map.Beta1(dart)), map.EndVertex(dart));
      const auto across = map.Beta3(dart);
      if (map.IsOutside(across))
      {
        ASSERT_EQ(map.GetHalfFace(map.GetDart(map.GetBoundaryFace(across))), map.GetHalfFace(dart));
        continue;
      }
      ASSERT_EQ(map.Beta3(across), dart);
      ASSERT_EQ(Ends(map, across), Pair(Ends(map, dart).second, Ends(map, dart).first));
      ASSERT_EQ(map.Beta1(map.Beta3(map.Beta1(across))), dart);
    }
  }
  ASSERT_EQ(darts, map.NumberOfDarts());
  ASSERT_EQ(places.size(), darts);
}

/// The order of a fan: the face by which each cell is left is that by which the next is entered;
/// the face of a dart is the one of its cell that lies ahead, that of its beta2 the one behind. At
/// the boundary a fan begins and ends with a face of one cell, and a pinched edge has several.
template <typename Map>
void CheckFanOrder(const Map& map, const BruteForce& truth, const Pair& ends,
  const std::vector<typename Map::Dart>& fan)
{
  std::size_t fans = 0;
  Corners first,
    ahead; // of the current fan: its first dart, and the dart by which the last cell was left
  const auto isBorder = [&truth](const Corners& face)
  { return truth.CellsOfFace.at(face).size() == 1; };
  for (const auto dart : fan)
  {
    const Corners in = GetCorners(map, map.GetHalfFace(map.Beta2(dart)));
    const Corners out = GetCorners(map, map.GetHalfFace(dart));
    const std::set<Corners> both{ in, out };
    ASSERT_EQ(both, FacesAtEdge(truth, ends, Number(map.GetCell(dart))));
    if (fans == 0 || in != ahead)
    {
      ASSERT_TRUE(fans == 0 || ahead == first || isBorder(ahead)) << "a fan breaks off";
      ++fans;
      first = in;
    }
    ahead = out;
  }
  ASSERT_TRUE(ahead == first || isBorder(ahead));
  ASSERT_TRUE(ahead == first || isBorder(first)) << "a fan begins in the middle";
  ASSERT_EQ(fans, truth.FansOfEdge(ends));
}

template <typename Map>
void CheckEdges(const Map& map, const BruteForce& truth)
{
  const auto& edges = map.Edges();
  using Id = typename Map::IdType;
  ASSERT_EQ(edges.Size(), truth.CellsOfEdge.size());
  auto expected = truth.CellsOfEdge.begin(); // std::map is sorted in the required order of edges
  for (std::size_t e = 0; e < edges.Size(); ++e, ++expected)
  {
    const typename Map::Edge edge(static_cast<Id>(e));
    ASSERT_EQ(Ends(map, edges.GetDart(edge)), expected->first);
    ASSERT_EQ(edges.IsBoundary(edge), truth.BoundaryEdges.count(expected->first) == 1);
    Numbers cells;
    std::vector<typename Map::Dart> fan;
    for (const auto dart : edges.Fan(edge))
    {
      ASSERT_EQ(Ends(map, dart), expected->first);
      ASSERT_TRUE(cells.insert(Number(map.GetCell(dart))).second);
      fan.push_back(dart);
    }
    ASSERT_EQ(cells, expected->second);
    CheckFanOrder(map, truth, expected->first, fan);
    if (::testing::Test::HasFatalFailure())
    {
      return;
    }
  }
}

template <typename Map>
void CheckFaces(const Map& map, const BruteForce& truth)
{
  const auto& faces = map.Faces();
  using Id = typename Map::IdType;
  ASSERT_EQ(faces.Size(), truth.CellsOfFace.size());
  ASSERT_EQ(map.NumberOfFaces(), truth.CellsOfFace.size());
  auto expected = truth.CellsOfFace.begin();
  for (std::size_t f = 0; f < faces.Size(); ++f, ++expected)
  {
    const typename Map::Face face(static_cast<Id>(f));
    ASSERT_EQ(GetCorners(map, faces.GetHalfFace(face)), expected->first);
    ASSERT_EQ(faces.IsBoundary(face), expected->second.size() == 1);
    std::vector<std::int64_t> cells;
    cells.push_back(Number(map.GetCell(faces.GetDart(face))));
    if (!faces.IsBoundary(face))
    {
      cells.push_back(Number(map.GetCell(faces.Across(face))));
    }
    ASSERT_EQ(cells, expected->second);
  }
}

/// Dart to edge and face, cell to neighbours, over all cells.
template <typename Map>
void CheckCells(const Map& map, const BruteForce& truth)
{
  using Id = typename Map::IdType;
  for (std::size_t c = 0; c < map.NumberOfCells(); ++c)
  {
    const typename Map::Cell cell(static_cast<Id>(c));
    ASSERT_EQ(map.CellEdges().Find(cell).size(), map.EdgeDarts(cell).size());
    for (const auto dart : map.Darts(cell))
    {
      const auto edge = map.Edges().GetDart(map.Edges().Find(dart));
      ASSERT_EQ(map.CellEdges().Find(dart), map.Edges().Find(dart));
      ASSERT_EQ(map.CellEdges().Find(cell)[(map.LocalDart(dart) - 1) / 2], map.Edges().Find(dart));
      ASSERT_EQ(Ends(map, edge), Pair(std::minmax(Ends(map, dart).first, Ends(map, dart).second)));
      const auto half = map.Faces().GetHalfFace(map.Faces().Find(dart));
      ASSERT_EQ(GetCorners(map, half), GetCorners(map, map.GetHalfFace(dart)));
    }
    Numbers neighbours;
    for (const auto across : map.Neighbours(cell))
    {
      if (!map.IsOutside(across))
      {
        neighbours.insert(Number(map.GetCell(across)));
      }
    }
    ASSERT_EQ(neighbours, truth.NeighboursOfCell[c]);
  }
}

template <typename Map>
void CheckStars(const Map& map, const BruteForce& truth)
{
  using Id = typename Map::IdType;
  const auto find = [](const auto& table, std::int64_t key)
  {
    const auto found = table.find(key);
    return found == table.end() ? typename std::decay_t<decltype(table)>::mapped_type{}
                                : found->second;
  };
  VertexStar<Id> star(map);
  for (std::size_t v = 0; v < map.NumberOfVertices(); ++v)
  {
    const typename Map::Vertex vertex(static_cast<Id>(v));
    const auto number = static_cast<std::int64_t>(v);
    ASSERT_EQ(map.IsBoundary(vertex), truth.BoundaryVertices.count(number) == 1);
    Numbers cells, neighbours;
    for (const auto dart : star.Gather(vertex))
    {
      ASSERT_EQ(map.StartVertex(dart), vertex);
      ASSERT_TRUE(cells.insert(Number(map.GetCell(dart))).second);
    }
    ASSERT_EQ(cells, find(truth.CellsOfVertex, number));
    cells.clear();
    for (const auto dart : map.Stars().Find(vertex))
    {
      ASSERT_EQ(map.StartVertex(dart), vertex);
      ASSERT_TRUE(cells.insert(Number(map.GetCell(dart))).second);
    }
    ASSERT_EQ(cells, find(truth.CellsOfVertex, number));
    const auto edges = star.EdgeDarts();
    for (const auto dart : edges)
    {
      neighbours.insert(Number(map.EndVertex(dart)));
    }
    ASSERT_EQ(neighbours, find(truth.NeighboursOfVertex, number));
    ASSERT_EQ(neighbours.size(), edges.size());
    std::set<Corners> faces, link;
    const auto halves = star.HalfFaces();
    for (const auto half : halves)
    {
      faces.insert(GetCorners(map, half));
    }
    ASSERT_EQ(faces, find(truth.FacesOfVertex, number));
    ASSERT_EQ(faces.size(), halves.size());
    for (const auto half : star.LinkHalfFaces())
    {
      link.insert(GetCorners(map, half));
    }
    ASSERT_EQ(link, find(truth.LinkOfVertex, number));
    std::set<Pair> linkEdges;
    const auto linkDarts = star.LinkEdgeDarts();
    for (const auto dart : linkDarts)
    {
      linkEdges.insert(std::minmax(Ends(map, dart).first, Ends(map, dart).second));
    }
    ASSERT_EQ(linkEdges.size(), linkDarts.size());
  }
}

template <typename Map>
void CheckEverything(const Map& map, const CellList& mesh)
{
  const BruteForce truth(mesh);
  CheckAxioms(map);
  CheckEdges(map, truth);
  CheckFaces(map, truth);
  CheckCells(map, truth);
  CheckStars(map, truth);
}

/// Vertices in cells - edges + faces - cells.
template <typename Map>
std::int64_t EulerNumber(const Map& map)
{
  std::int64_t vertices = 0;
  for (std::size_t v = 0; v < map.NumberOfVertices(); ++v)
  {
    using Id = typename Map::IdType;
    vertices += map.IsOutside(map.GetDart(typename Map::Vertex(static_cast<Id>(v)))) ? 0 : 1;
  }
  return vertices - static_cast<std::int64_t>(map.Edges().Size()) +
    static_cast<std::int64_t>(map.NumberOfFaces()) - static_cast<std::int64_t>(map.NumberOfCells());
}

}

#endif
