/**
 * @file BruteForceIncidence.h
 * @brief Incidences computed from the cells alone, without darts and without code shared with the
 * map.
 */
#ifndef isthmus_BruteForceIncidence_h
#define isthmus_BruteForceIncidence_h

#include "CellComplex/CellType.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace isthmus::testing
{

using Numbers = std::set<std::int64_t>;
using Pair = std::pair<std::int64_t, std::int64_t>;
using Corners = std::vector<std::int64_t>; // ascending

/// Incidences computed from the cells alone.
struct BruteForce
{
  std::map<Pair, Numbers> CellsOfEdge;
  std::map<Corners, std::vector<std::int64_t>> CellsOfFace;
  std::map<Pair, std::set<Corners>> FacesOfEdge;
  std::map<std::int64_t, Numbers> CellsOfVertex, NeighboursOfVertex;
  std::map<std::int64_t, std::set<Corners>> FacesOfVertex, LinkOfVertex;
  std::set<Pair> BoundaryEdges;
  Numbers BoundaryVertices;
  std::vector<Numbers> NeighboursOfCell;

  explicit BruteForce(const CellList& mesh)
  {
    const std::int64_t* next = mesh.CellVertices.begin();
    std::int64_t cell = 0;
    for (const CellRun& run : mesh.Runs)
    {
      const CellType& type = mesh.Types[run.Type];
      for (std::int64_t i = 0; i < run.NumberOfCells; ++i, next += type.NumberOfVertices())
      {
        this->AddCell(cell++, type, next);
      }
    }
    this->NeighboursOfCell.resize(static_cast<std::size_t>(cell));
    this->LookAtFaces();
  }

  /// Number of components of the cells around an edge, where cells are adjacent if they share a
  /// face at the edge.
  std::size_t FansOfEdge(const Pair& edge) const
  {
    const Numbers& cells = this->CellsOfEdge.at(edge);
    std::map<std::int64_t, std::int64_t> piece;
    for (const std::int64_t cell : cells)
    {
      piece[cell] = cell;
    }
    for (const Corners& face : this->FacesOfEdge.at(edge))
    {
      const std::vector<std::int64_t>& sides = this->CellsOfFace.at(face);
      if (sides.size() == 2)
      {
        const std::int64_t from = piece.at(sides[0]), to = piece.at(sides[1]);
        for (auto& entry : piece)
        {
          entry.second = entry.second == from ? to : entry.second;
        }
      }
    }
    Numbers pieces;
    for (const auto& entry : piece)
    {
      pieces.insert(entry.second);
    }
    return pieces.size();
  }

  /// Vertices - edges + faces of the boundary.
  std::int64_t BoundaryEuler() const
  {
    std::int64_t euler = static_cast<std::int64_t>(this->BoundaryVertices.size()) -
      static_cast<std::int64_t>(this->BoundaryEdges.size());
    for (const auto& face : this->CellsOfFace)
    {
      euler += face.second.size() == 1 ? 1 : 0;
    }
    return euler;
  }

  /// Whether the boundary is not a manifold: more than two faces at an edge, or several fans at a
  /// vertex, which then has more edges than a single fan of its faces.
  bool IsPinched() const
  {
    std::map<Pair, int> facesOfEdge;
    std::map<std::int64_t, std::map<std::int64_t, Numbers>> around; // vertex: neighbour: neighbours
    for (const auto& [corners, cells] : this->CellsOfFace)
    {
      if (cells.size() == 1)
      {
        std::map<std::int64_t, std::vector<std::int64_t>> inFace;
        for (const Pair& side : this->Sides.at(corners))
        {
          ++facesOfEdge[side];
          inFace[side.first].push_back(side.second);
          inFace[side.second].push_back(side.first);
        }
        for (const auto& [vertex, two] : inFace)
        {
          around[vertex][two[0]].insert(two[1]);
          around[vertex][two[1]].insert(two[0]);
        }
      }
    }
    const auto isOneFan = [](const std::map<std::int64_t, Numbers>& links)
    {
      std::vector<std::int64_t> queue{ links.begin()->first };
      Numbers reached(queue.begin(), queue.end());
      for (std::size_t next = 0; next < queue.size(); ++next)
      {
        for (const std::int64_t other : links.at(queue[next]))
        {
          if (reached.insert(other).second)
          {
            queue.push_back(other);
          }
        }
      }
      return reached.size() == links.size();
    };
    return std::any_of(facesOfEdge.begin(), facesOfEdge.end(),
             [](const auto& edge) { return edge.second != 2; }) ||
      std::any_of(
        around.begin(), around.end(), [&](const auto& vertex) { return !isOneFan(vertex.second); });
  }

private:
  void AddCell(std::int64_t cell, const CellType& type, const std::int64_t* vertices)
  {
    const Numbers all(vertices, vertices + type.NumberOfVertices());
    for (const std::int64_t vertex : all)
    {
      this->CellsOfVertex[vertex].insert(cell);
    }
    for (const std::vector<int>& face : type.Faces())
    {
      Corners corners;
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        const std::int64_t a = vertices[face[i]], b = vertices[face[(i + 1) % face.size()]];
        corners.push_back(a);
        this->CellsOfEdge[std::minmax(a, b)].insert(cell);
        this->NeighboursOfVertex[a].insert(b);
        this->NeighboursOfVertex[b].insert(a);
      }
      std::sort(corners.begin(), corners.end());
      this->CellsOfFace[corners].push_back(cell);
      for (const std::int64_t vertex : all)
      {
        const bool touches = std::binary_search(corners.begin(), corners.end(), vertex);
        (touches ? this->FacesOfVertex : this->LinkOfVertex)[vertex].insert(corners);
      }
      this->Sides[corners].clear();
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        const Pair side = std::minmax(vertices[face[i]], vertices[face[(i + 1) % face.size()]]);
        this->Sides[corners].push_back(side);
        this->FacesOfEdge[side].insert(corners);
      }
    }
  }

  void LookAtFaces()
  {
    for (const auto& [corners, cells] : this->CellsOfFace)
    {
      if (cells.size() == 2)
      {
        this->NeighboursOfCell[static_cast<std::size_t>(cells[0])].insert(cells[1]);
        this->NeighboursOfCell[static_cast<std::size_t>(cells[1])].insert(cells[0]);
        continue;
      }
      this->BoundaryVertices.insert(corners.begin(), corners.end());
      this->BoundaryEdges.insert(this->Sides[corners].begin(), this->Sides[corners].end());
    }
  }

  std::map<Corners, std::vector<Pair>> Sides;
};

/// The two faces of a cell that meet at an edge, by their corners; found without darts.
inline std::set<Corners> FacesAtEdge(const BruteForce& truth, const Pair& edge, std::int64_t cell)
{
  std::set<Corners> faces;
  for (const Corners& corners : truth.FacesOfEdge.at(edge))
  {
    const std::vector<std::int64_t>& cells = truth.CellsOfFace.at(corners);
    if (std::find(cells.begin(), cells.end(), cell) != cells.end())
    {
      faces.insert(corners);
    }
  }
  return faces;
}

}

#endif
