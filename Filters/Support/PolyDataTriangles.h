/**
 * @file PolyDataTriangles.h
 * @brief The triangles of a vtkPolyData, ready for the algorithms on surfaces.
 */
#ifndef isthmus_PolyDataTriangles_h
#define isthmus_PolyDataTriangles_h

#include "SurfaceView.h"
#include "vtkIsthmusModule.h" // for the export macro

#include <vector>

class vtkPolyData;

namespace isthmus
{

/**
 * Copy of the polygons and strips of a vtkPolyData as triangles, in the order of its cells.
 *
 * Point ids are those of the vtkPolyData. Polygons of four and more corners are split by
 * vtkPolygon, the thesis' surfaces being triangles; vertices and lines have no area and are left
 * out. Memory: 24 bytes a point, 32 a triangle.
 */
class VTKISTHMUS_EXPORT PolyDataTriangles
{
public:
  /// @throws std::invalid_argument, with the number of the cell or point, for a corner that is not
  /// a point of the surface, for a used point with a coordinate that is not finite, and for a
  /// polygon that can't be split.
  explicit PolyDataTriangles(vtkPolyData* surface);

  SurfaceView View() const;

  /// Cell of the vtkPolyData that `triangle` belongs to.
  vtkIdType CellOf(vtkIdType triangle) const;

private:
  void AddPolygons(vtkPolyData* surface);
  void AddStrips(vtkPolyData* surface);
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell);
  void CheckCorner(vtkIdType corner, vtkIdType cell) const;
  void CheckPoints() const;

  std::vector<double> Points;
  std::vector<vtkIdType> Triangles;
  std::vector<vtkIdType> Cells;
};

}

#endif
