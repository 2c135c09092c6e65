/**
 * @file MapSurface.h
 * @brief Post-processing of the level set of a map: small components (dust) removed, normals.
 */
#ifndef isthmus_MapSurface_h
#define isthmus_MapSurface_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersContouringModule.h"

#include <cstdint>

namespace isthmus
{

/// Criteria for the components of a surface: one that fails any of the three is removed.
struct DustParameters
{
  double MinimumComponentArea = 0.0;  ///< length^2
  double MinimumComponentShare = 0.0; ///< of the area of the largest component, from 0 to 1
  int LargestComponents = 0;          ///< number of components to keep; 0: all
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSCONTOURING_EXPORT void Check(const DustParameters& parameters);

struct DustResult
{
  TriangleMesh Surface;                 ///< what remains, in its original order
  std::vector<std::int64_t> Components; ///< of each triangle, 0 for the largest
  std::vector<double> Areas;            ///< of each component that stays, largest first
  std::int64_t Found = 0;               ///< components before
};

/**
 * `mesh` without its small components (triangles connected by points), the others ranked by area,
 * equal ones by their first triangle. O(triangles), two passes.
 * @throws std::invalid_argument for parameters out of range.
 */
VTKISTHMUSFILTERSCONTOURING_EXPORT DustResult HideDust(
  TriangleMesh mesh, const DustParameters& parameters);

/// Outward unit normals at the points: the mean of the normals of the triangles, weighted by area.
/// 0 for a point that no triangle uses.
VTKISTHMUSFILTERSCONTOURING_EXPORT std::vector<Point3> PointNormals(const SurfaceView& mesh);

}

#endif
