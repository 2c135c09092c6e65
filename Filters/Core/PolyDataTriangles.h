/**
 * @file PolyDataTriangles.h
 * @brief From vtkPolyData to triangles, and back.
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
 * The one way from a vtkPolyData to triangles: a copy of its polygons and strips, in the order of
 * its cells, and of all its points, whose ids stay.
 *
 * Polygons of four and more corners are split by vtkPolygon, the thesis' surfaces being triangles;
 * vertices and lines have no area and are left out. Memory: 24 bytes a point, 24 a triangle, and 8
 * a triangle where some cells are not triangles.
 */
class VTKISTHMUSFILTERSCORE_EXPORT PolyDataTriangles
{
public:
  /// What is done where corners are no points, coordinates not finite, polygons not to be split.
  enum class Damage
  {
    Refused,
    Kept ///< for what looks for it (SurfaceDefects.h) or mends it; polygons that can't be split
         ///< lack triangles. Corners of what must be split have to be points even so.
  };

  /// @throws std::invalid_argument, with the number of the cell or point, for a corner that is not
  /// a point of the surface, for a used point with a coordinate that is not finite, and for a
  /// polygon that can't be split.
  explicit PolyDataTriangles(vtkPolyData* surface, Damage damage = Damage::Refused);

  /// @pre This object outlives the view.
  SurfaceView View() const { return this->Mesh; }

  /// The triangles for what changes them; nothing is left here.
  TriangleMesh TakeMesh() { return std::move(this->Mesh); }

  /// Cell of the vtkPolyData that `triangle` belongs to.
  vtkIdType CellOf(vtkIdType triangle) const
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

  TriangleMesh Mesh;
  vtkIdType FirstCell = 0;      ///< that has an area
  std::vector<vtkIdType> Cells; ///< of triangles; empty where all cells are triangles
  Damage OnDamage;
};

/// The triangles of `surface` as PolyDataTriangles makes them, damage kept: for what looks for it
/// (SurfaceDefects.h) or mends it.
/// @throws std::invalid_argument, with the cell, for a corner that is no point, where some cells
/// are not triangles.
VTKISTHMUSFILTERSCORE_EXPORT TriangleMesh MeshOf(vtkPolyData* surface);

/// Makes `surface` the points (double) and triangles of `mesh`.
VTKISTHMUSFILTERSCORE_EXPORT void SetMesh(const SurfaceView& mesh, vtkPolyData* surface);

}

#endif
