/**
 * @file SurfaceCheck.h
 * @brief Is a triangle surface closed, manifold and oriented, and if not, where not?
 */
#ifndef isthmus_SurfaceCheck_h
#define isthmus_SurfaceCheck_h

#include "Progress.h"
#include "SurfaceDefects.h"
#include "SurfaceView.h"
#include "vtkIsthmusModule.h"

namespace isthmus
{

/// Defects of `mesh`. O(n) for points of bounded valence, in parallel; some 35 bytes a triangle.
VTKISTHMUS_EXPORT SurfaceDefects FindDefects(
  const SurfaceView& mesh, const ProgressCallback& progress = {});

}

#endif
