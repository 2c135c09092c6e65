/**
 * @file SolventExcludedSurface.h
 * @brief The solvent-excluded surface, in the form of a flow's result, to set beside it.
 */
#ifndef isthmus_SolventExcludedSurface_h
#define isthmus_SolventExcludedSurface_h

#include "Core/Progress.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h"

#include <vector>

namespace isthmus
{

/// On the grid that the flow would have, for a probe of ProbeRadius (0: the balls themselves); see
/// SolventExcludedDistance.h. Throws as SurfaceFlow does.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT SurfaceFlowResult SolventExcludedSurface(
  const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters,
  const ProgressCallback& progress = {});

}

#endif
