/**
 * @file FaceTable.h
 * @brief Numbered faces of a combinatorial map: tables F2D and V2F.
 *
 * Source: X. Feng, "Geometric and topological modeling techniques for large and complex shapes",
 * 3.3.2.5; faces with the same three smallest vertices are ordered by all of them.
 */
#ifndef isthmus_FaceTable_h
#define isthmus_FaceTable_h

#include "CellComplex/DartMap.h"
#include "Core/Progress.h"
#include "vtkIsthmusFiltersCellComplexModule.h"

#include <algorithm>

namespace isthmus
{

/**
 * F2D holds, for each face, the first dart of its half face in the cell with the smaller number.
 * Faces are ordered by their vertices, ascending; V2F holds the index of the first face of each
 * smallest vertex. Built in parallel in time linear in the number of cells; memory n2 + n0 + 1 ids,
 * and n2 more during construction.
 */
template <typename Id>
class VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT FaceTable
{
public:
  using Map = DartMap<Id>;
  using Vertex = typename Map::Vertex;
  using Face = typename Map::Face;
  using HalfFace = typename Map::HalfFace;
  using Dart = typename Map::Dart;

  explicit FaceTable(const Map& map, const ProgressCallback& progress = {});

  std::size_t Size() const { return this->F2D.size(); }
  Dart GetDart(Face face) const { return this->F2D[face.Value]; }
  HalfFace GetHalfFace(Face face) const { return this->Mesh.GetHalfFace(this->GetDart(face)); }
  /// A dart in the face's second cell, outside for a boundary face.
  Dart Across(Face face) const { return this->Mesh.Across(this->GetHalfFace(face)); }
  bool IsBoundary(Face face) const { return this->Mesh.IsOutside(this->Across(face)); }

  Face Find(HalfFace half) const
  {
    const Dart leader = this->Leader(half);
    Id face = this->V2F[this->SmallestVertex(half).Value];
    while (this->F2D[face] != leader)
    {
      ++face;
    }
    return Face(face);
  }
  /// The face of any dart.
  Face Find(Dart dart) const { return this->Find(this->Mesh.GetHalfFace(dart)); }

  /// The faces whose smallest vertex is `vertex`.
  auto StartingAt(Vertex vertex) const
  {
    const Id first = this->V2F[vertex.Value];
    return IndexRange(static_cast<std::size_t>(this->V2F[vertex.Value + std::size_t(1)] - first),
      [first](std::size_t i) { return Face(static_cast<Id>(first + i)); });
  }

  void AppendMemory(std::vector<TableMemory>& report) const;

private:
  /// The first dart of the half face that represents the face of `half`.
  Dart Leader(HalfFace half) const
  {
    const Dart across = this->Mesh.Across(half);
    if (!this->Mesh.IsOutside(across))
    {
      const HalfFace other = this->Mesh.GetHalfFace(across);
      half = other < half ? other : half;
    }
    return this->Mesh.FirstDart(half);
  }
  Vertex SmallestVertex(HalfFace half) const
  {
    Vertex smallest = this->Mesh.StartVertex(this->Mesh.FirstDart(half));
    for (const Dart dart : this->Mesh.Darts(half))
    {
      smallest = std::min(smallest, this->Mesh.StartVertex(dart));
    }
    return smallest;
  }
  template <typename Visit>
  void ForEachLeader(const ProgressCallback& progress, Visit&& visit) const;
  void SortVertexFaces(std::size_t vertex);

  const Map& Mesh;
  std::vector<Dart> F2D;
  std::vector<Id> V2F; // n0 + 1 places
};

}

#endif
