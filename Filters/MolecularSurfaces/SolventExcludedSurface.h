/**
 * @file SolventExcludedSurface.h
 * @brief The solvent-excluded surface of balls and a probe, as a distance on a grid.
 *
 * The probe's centre stays out of the balls of radius r_i + p; what the probe can't touch is
 * inside:
 *
 *   phi(x) = p - (distance from x to where the centre can be)          within those balls,
 *
 * two distances, one after the other (F. M. Richards, Annu. Rev. Biophys. Bioeng. 6 (1977) 151).
 * The second one is computed exactly: the nearest place is on the sphere that x lies deepest in, if
 * the sphere is free there (convex patches), else on the circles in which two spheres meet
 * (saddles) or at their ends, where three do (concave triangles).
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
 * Writes phi, in spacings and cut at FlowGrid::Band, to `to` (one value a node); `probe` in
 * angstrom. It is exact on convex patches, and to (spacing / 4)^2 / (8 probe) elsewhere outside of
 * the surface. Time O(balls x neighbours + nodes near the surface x neighbours).
 */
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void SolventExcludedDistance(const FlowGrid& grid,
  const std::vector<Ball>& balls, double probe, std::vector<float>& to,
  const ProgressCallback& progress = {});

/// The surface in the form of a flow's result, to compare with one: on the grid that the flow would
/// have, for a probe of ProbeRadius (0: the balls themselves). Throws as SurfaceFlow does.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT SurfaceFlowResult SolventExcludedSurface(
  const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters,
  const ProgressCallback& progress = {});

}

#endif
