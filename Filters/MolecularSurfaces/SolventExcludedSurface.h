/**
 * @file SolventExcludedSurface.h
 * @brief The solvent-excluded surface of balls for a probe, as a distance on a grid.
 *
 * The probe's center stays out of the balls of radius r_i + p; what the probe can't touch is
 * inside:
 *
 *   phi(x) = p - (distance from x to where the center can be)          within those balls,
 *
 * two distances, one after the other (F. M. Richards, Annu. Rev. Biophys. Bioeng. 6 (1977) 151).
 * The second distance is computed exactly: the nearest place is on the sphere in which x lies
 * deepest, if that sphere is free there (convex patches), otherwise on the circles in which two
 * spheres intersect (saddles), or at their ends, where three spheres intersect (concave triangles).
 */
#ifndef isthmus_SolventExcludedSurface_h
#define isthmus_SolventExcludedSurface_h

#include "Core/Progress.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h"

#include <vector>

namespace isthmus
{

/**
 * Writes phi, in spacings and clamped to FlowGrid::Band, to the array `to` (one value for each
 * node); `probe` is in angstrom. It is exact on convex patches, and accurate to (spacing / 4)^2 /
 * (8 probe) elsewhere outside the surface. Time O(balls x neighbours + nodes near the surface x
 * neighbours).
 */
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void SolventExcludedDistance(const FlowGrid& grid,
  const std::vector<Ball>& balls, double probe, std::vector<float>& to,
  const ProgressCallback& progress = {});

/// The surface in the form of the result of a flow, for comparison, on the grid that the flow would
/// have. The probe has radius ProbeRadius (0: the balls themselves). Throws as SurfaceFlow does.
SurfaceFlowResult SolventExcludedSurface(const std::vector<Ball>& balls,
  const SurfaceFlowParameters& parameters, const ProgressCallback& progress = {});

}

#endif
