/**
 * @file PolyDataTriangles.h
 * @brief Converts vtkPolyData to triangles, and back.
 */
#ifndef isthmus_PolyDataTriangles_h
#define isthmus_PolyDataTriangles_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersCoreModule.h"

#include <vtkPolyData.h>

#include <utility>
#include <vector>

namespace isthmus
{

/**
 * Conversion of a vtkPolyData to triangles: a copy of its polygons and strips, in the order of its
 * cells, and of all its points, whose ids do not change.
 *
 * Polygons of four and more corners are split by vtkPolygon, since algorithms work on triangles;
 * vertices and lines have no area and are dropped. Memory: 24 bytes for each point and for each
 * triangle, and 8 more for each triangle if some cells are not triangles.
 */
class VTKISTHMUSFILTERSCORE_EXPORT PolyDataTriangles
{
public:
  /// Treatment of invalid point ids, coordinates that are not finite, and polygons that cannot be
  /// split.
  enum class Damage
  {
    Refused,
    Kept ///< for code that finds (SurfaceDefects.h) or repairs defects; polygons that cannot be
         ///< split lack triangles. Even with defects kept, the corners of polygons to be split must
         ///< be valid points.
  };

  /// @throws std::invalid_argument, with the number of the cell or point, for a corner that is not
  /// a point of the surface, for a used point with a coordinate that is not finite, and for a
  /// polygon that can't be split.
  explicit PolyDataTriangles(vtkPolyData* surface, Damage damage = Damage::Refused);

  /// @pre This object outlives the view.
  SurfaceView View() const { return this->Mesh; }

  /// Moves the triangles out so that they can be changed; this object is empty afterwards.
  TriangleMesh TakeMesh() { return std::move(this->Mesh); }

  /// Cell of the vtkPolyData that `triangle` is part of.
  vtkIdType GetCellId(vtkIdType triangle) const
  {
    return this->Cells.empty() ? this->FirstCell + triangle : this->Cells[At(triangle)];
  }

private:
  void CopyTriangles(vtkPolyData* surface);
  void AddPolygons(vtkPolyData* surface);
  void AddStrips(vtkPolyData* surface);
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell);
  void CheckCorners(const vtkIdType* corners, vtkIdType count, vtkIdType cell) const;
  void CheckPoints() const;
  /// The first triangle with a corner for which isWrong(point) holds, or their number.
  template <typename Wrong>
  vtkIdType FindFirstTriangle(const Wrong& isWrong) const;

  TriangleMesh Mesh;
  vtkIdType FirstCell = 0;      ///< that has an area
  std::vector<vtkIdType> Cells; ///< of triangles; empty where all cells are triangles
  Damage OnDamage;
};

/// The triangles of `surface`, converted as by PolyDataTriangles but with defects kept, for code
/// that finds (SurfaceDefects.h) or repairs them.
/// @throws std::invalid_argument, naming the cell, for an invalid point id, if some cells are not
/// triangles.
VTKISTHMUSFILTERSCORE_EXPORT TriangleMesh ToTriangleMesh(vtkPolyData* surface);

/// Sets `surface` to the points (double) and triangles of `mesh`.
VTKISTHMUSFILTERSCORE_EXPORT void SetMesh(const SurfaceView& mesh, vtkPolyData* surface);

}

#endif
