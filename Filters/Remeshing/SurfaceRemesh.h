/**
 * @file SurfaceRemesh.h
 * @brief Remeshing of a surface to triangles of even size and good angles, and simplification.
 *
 * Remeshing: M. Botsch, L. Kobbelt, Symp. Geometry Processing 2004, doi:10.1145/1057432.1057457.
 * Simplification: P. Lindstrom, G. Turk, IEEE Visualization 1998, doi:10.1109/VISUAL.1998.745314.
 * Both as in CGAL.
 */
#ifndef isthmus_SurfaceRemesh_h
#define isthmus_SurfaceRemesh_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersRemeshingModule.h"

namespace isthmus
{

/// The position of a point of the new surface on the old one.
struct SurfaceLocation
{
  std::int64_t Triangle = 0;
  std::array<double, 3> Weights{ 1.0, 0.0, 0.0 }; ///< of its corners; they add up to 1
};

struct RemeshedSurface
{
  TriangleMesh Mesh;
  std::vector<SurfaceLocation> Locations; ///< for each point: the nearest on the old surface
};

/// For RemeshSurface() and DelaunayRemesh().
struct SurfaceRemeshParameters
{
  double EdgeLength =
    1.0; ///< target of RemeshSurface(), bound of DelaunayRemesh(); in units of the data
  double FeatureAngle =
    60.0; ///< edges whose triangles' normals differ by more, in degrees, are kept
  int NumberOfIterations = 5; ///< of RemeshSurface(), each: split, collapse, flip, relax, project

  // Of DelaunayRemesh().
  double MinimumAngle = 25.0;             ///< of triangles away from features, degrees, at most 30
  double MaximumDistance = 0.0;           ///< of triangles from the surface; 0: EdgeLength / 10
  std::int64_t MaximumPoints = 5'000'000; ///< refinement beyond it is an error
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSREMESHING_EXPORT void Check(const SurfaceRemeshParameters& parameters);

/**
 * Isotropic remeshing of `mesh`. New points lie on the old surface. Boundaries and feature edges
 * keep their shape to a thousandth of the edge length: they are split, and merged only where they
 * are straight.
 *
 * @pre manifold and oriented, without triangles that have no area; boundaries are fine.
 * @throws std::invalid_argument otherwise, with the triangles concerned, when EdgeLength is not
 * positive or would give more than 50 million triangles, and for points whose edges are all shorter
 * than 2^-50 of the largest coordinate; Cancelled. Progress is reported, and cancelling is
 * possible, at each projected point. O(n log n) an iteration.
 */
VTKISTHMUSFILTERSREMESHING_EXPORT RemeshedSurface RemeshSurface(const SurfaceView& mesh,
  const SurfaceRemeshParameters& parameters, const ProgressCallback& progress = {});

/**
 * Simplifies `mesh` by edge collapse to about this number of triangles. Boundaries keep their shape
 * as above. Sharp edges inside cost more than others, so that they go last, but they go if the
 * number requires it. The result may have more triangles if a collapse would change a boundary,
 * flip a triangle or change the topology. Preconditions and errors are as above. O(n log n) where
 * few triangles meet at a point. Where k do, as in the fans that close a cylinder in CAD files,
 * O(k^3). Cancelling is possible after every 16 collapses.
 */
VTKISTHMUSFILTERSREMESHING_EXPORT RemeshedSurface SimplifySurface(
  const SurfaceView& mesh, std::int64_t triangles, const ProgressCallback& progress = {});

/// The nearest place on `old` for each point. O(n log n).
VTKISTHMUSFILTERSREMESHING_EXPORT std::vector<SurfaceLocation> LocateOn(
  const SurfaceView& old, const std::vector<Point3>& points);

/// Mean length of the sides of all triangles; 0 if there are none.
VTKISTHMUSFILTERSREMESHING_EXPORT double MeanEdgeLength(const SurfaceView& mesh);

}

#endif
