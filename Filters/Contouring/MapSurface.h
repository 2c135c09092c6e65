/**
 * @file MapSurface.h
 * @brief What turns the triangles of a map's level into a surface to look at: no dust, normals.
 */
#ifndef isthmus_MapSurface_h
#define isthmus_MapSurface_h

#include "Contouring/MapSurfaceParameters.h"
#include "Core/GridView.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersContouringModule.h"

namespace isthmus
{

/**
 * `mesh` without its small components (triangles connected by points), the others ranked by area,
 * equal ones by their first triangle. O(triangles), two passes.
 * @throws std::invalid_argument for parameters out of range.
 */
VTKISTHMUSFILTERSCONTOURING_EXPORT DustResult HideDust(
  TriangleMesh mesh, const DustParameters& parameters);

/// Unit normals at the points, outwards: the mean of the triangles' weighted by area. 0 for a point
/// that no triangle uses.
VTKISTHMUSFILTERSCONTOURING_EXPORT std::vector<Point3> PointNormals(const SurfaceView& mesh);

/// A fair sample of at most 2^20 of the grid's values that are finite, for SensibleLevel.
template <typename T>
VTKISTHMUSFILTERSCONTOURING_EXPORT std::vector<double> SampleValues(const GridView<const T>& grid);

}

#endif
