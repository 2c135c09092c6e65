/**
 * @file FlowSteps.h
 * @brief Steps of a flow and of redistancing on a whole field.
 */
#ifndef isthmus_FlowSteps_h
#define isthmus_FlowSteps_h

#include "MolecularSurfaces/FlowGrid.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h"

namespace isthmus
{

/// One explicit step of dt = `lambda` squared spacings, at most 0.25; see FlowLoops.h. Distances
/// end up between floor and ceiling.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void Advance(FlowField& field, double lambda);

/// Makes distances of the values in the band, the surface staying where it is, and moves the band
/// along. Each iteration carries the distance 0.45 spacings further from the surface. Values next
/// to the surface are made distances as well, or where `trusted` taken as such.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void Redistance(
  FlowField& field, int iterations, bool trusted = false);

}

#endif
