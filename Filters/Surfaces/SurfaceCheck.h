/**
 * @file SurfaceCheck.h
 * @brief Is a triangle surface closed, manifold and oriented, and if not, where not?
 */
#ifndef isthmus_SurfaceCheck_h
#define isthmus_SurfaceCheck_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "Surfaces/SurfaceDefects.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

namespace isthmus
{

/// Defects of `mesh`. O(n) for points of bounded valence, in parallel; some 35 bytes a triangle.
VTKISTHMUSFILTERSSURFACES_EXPORT SurfaceDefects FindDefects(
  const SurfaceView& mesh, const ProgressCallback& progress = {});

/// @throws std::invalid_argument, with the point, for one whose edges are all below what
/// coordinates as large as the largest resolve: new triangles there would be flat, and what lies
/// there gone without a word; with one point at 1e18, all of an ordinary surface. Corners must be
/// points. O(n).
VTKISTHMUSFILTERSSURFACES_EXPORT void DemandResolved(const SurfaceView& mesh);

}

#endif
