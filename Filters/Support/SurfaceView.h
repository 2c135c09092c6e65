/**
 * @file SurfaceView.h
 * @brief A triangle surface as the algorithms see it: coordinates and corner ids.
 */
#ifndef isthmus_SurfaceView_h
#define isthmus_SurfaceView_h

#include <vtkType.h>

namespace isthmus
{

/**
 * View of a triangle surface; it owns nothing.
 *
 * Triangles are counter-clockwise seen from outside. Lengths are in the units of the data (angstrom
 * for molecular surfaces). Every corner id lies in [0, NumberOfPoints) and all coordinates of
 * points that triangles use are finite: PolyDataTriangles sees to both.
 */
struct SurfaceView
{
  const double* Points = nullptr; ///< #points x 3, x y z of one point after the other.
  vtkIdType NumberOfPoints = 0;
  const vtkIdType* Triangles = nullptr; ///< #triangles x 3.
  vtkIdType NumberOfTriangles = 0;

  const double* Point(vtkIdType point) const { return this->Points + 3 * point; }
  const vtkIdType* Triangle(vtkIdType triangle) const { return this->Triangles + 3 * triangle; }
};

}

#endif
