/**
 * @file FlowMemory.h
 * @brief What a surface flow needs of memory, told before it is taken.
 */
#ifndef isthmus_FlowMemory_h
#define isthmus_FlowMemory_h

#include "Atoms/Ball.h"
#include "Atoms/MolecularDensity.h"

#include <vector>

namespace isthmus
{

/// Bytes for a flow on `grid`, result and output included: 36 a node, and 24 for each of the
/// margin's.
double FlowBytes(const DensityGrid& grid);

/// Throws std::runtime_error with the size that `grid` would need unless it is available; names the
/// atom that lies far from the others, if there is one.
void CheckFlowMemory(const std::vector<Ball>& balls, const DensityGrid& grid);

}

#endif
