/**
 * @file SurfaceTopology.h
 * @brief Components, Euler characteristic and enclosed volume of a triangle surface.
 */
#ifndef isthmus_SurfaceTopology_h
#define isthmus_SurfaceTopology_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

namespace isthmus
{

/**
 * Connected components (triangles that share an edge), numbered from 0 by their first triangle:
 * one number for each triangle. @pre the mesh has no invalid triangles.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<int> Components(const SurfaceView& mesh);

/// Volume enclosed by a closed surface, (1/6) sum of v0.(v1 x v2) (thesis, eq. 4.41 corrected):
/// positive when its triangles are counter-clockwise seen from outside.
VTKISTHMUSFILTERSSURFACES_EXPORT double SignedVolume(const SurfaceView& mesh);

/// Euler characteristic V - E + F of a closed surface, over the points that triangles use.
VTKISTHMUSFILTERSSURFACES_EXPORT std::int64_t EulerCharacteristic(const SurfaceView& mesh);

}

#endif
