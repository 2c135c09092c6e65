/**
 * @file DelaunayIsosurface.h
 * @brief A level set as a surface of well-shaped triangles, by Delaunay refinement.
 *
 * J.-D. Boissonnat, S. Oudot, Graph. Models 67 (2005) 405, doi:10.1016/j.gmod.2005.01.004, in
 * CGAL's Mesh_3.
 */
#ifndef isthmus_DelaunayIsosurface_h
#define isthmus_DelaunayIsosurface_h

#include "Core/Geometry.h"
#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersContouringModule.h"

#include <functional>
#include <string>

namespace isthmus
{

/// Value at a point.
using ScalarField = std::function<double(const Point3&)>;

struct DelaunayIsosurfaceParameters
{
  double Level = 0.0;
  bool InsideIsHigher = true;
  double Angle = 30.0; ///< smallest angle of a triangle, degrees, at most 30
  /// radius of a triangle's surface Delaunay ball at most; 0: see SetAutomaticSizes
  double Radius = 0.0;
  /// its center to the triangle's circumcenter at most; 0: see SetAutomaticSizes
  double Distance = 0.0;
  std::int64_t MaximumNumberOfPoints = 5'000'000; ///< refinement beyond it is an error
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSCONTOURING_EXPORT void Check(const DelaunayIsosurfaceParameters& parameters);

/// Replaces a Radius of 0 by 1.5 times the (smallest) grid spacing, and a Distance of 0 by a
/// quarter of it.
VTKISTHMUSFILTERSCONTOURING_EXPORT void SetAutomaticSizes(
  double spacing, DelaunayIsosurfaceParameters& parameters);

struct DelaunayIsosurfaceResult
{
  TriangleMesh Surface; ///< closed, manifold, facing away from the inside
  /// Where topology differs from that of the guide, one message; else empty.
  std::string Warning;
};

/**
 * The surface of `field` at the level, within `bounds` (beyond which everything is outside).
 *
 * `guide` is a closed surface of the same level set, as from marching cubes: refinement starts from
 * at least four points on each of its components, so that none is lost. If the initial points of a
 * component were not sufficient, refinement is restarted from all of its points; a component for
 * which this fails, too, is listed in Warning with its position and size. Points of the result lie
 * on the level set to 1e-7 of the diagonal of the bounds.
 *
 * @throws std::invalid_argument on parameters that can't be met, e.g. sizes of 0;
 * std::runtime_error if refinement does not end below MaximumNumberOfPoints (as at a level where
 * the level set is not a manifold); Cancelled. Time: linear in the points of the result.
 */
VTKISTHMUSFILTERSCONTOURING_EXPORT DelaunayIsosurfaceResult DelaunayIsosurface(
  const ScalarField& field, const Bounds3& bounds, const SurfaceView& guide,
  const DelaunayIsosurfaceParameters& parameters, const ProgressCallback& progress = {});

}

#endif
