/**
 * @file FlowResult.h
 * @brief From a flow's field to its result.
 */
#ifndef isthmus_FlowResult_h
#define isthmus_FlowResult_h

#include "MolecularSurfaces/FlowGrid.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"

#include <vector>

namespace isthmus
{

/// `factor` times the values of the grid's nodes without its margin, plus `shift`.
std::vector<float> InnerValues(
  const FlowGrid& grid, const std::vector<float>& values, float factor, float shift);

/// Fills in the distances, in angstrom.
void StoreDistances(const FlowField& field, SurfaceFlowResult& result);

/// Adds the field's area and volume to the history.
void Record(const FlowField& field, double time, SurfaceFlowResult& result);

}

#endif
