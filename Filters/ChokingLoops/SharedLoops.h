/**
 * @file SharedLoops.h
 * @brief Narrowings beside each other that have one loop between them.
 */
#ifndef isthmus_SharedLoops_h
#define isthmus_SharedLoops_h

#include "ChokingLoops/LoopFeature.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/// A feature and its geometry.
struct ShownFeature
{
  std::size_t Index; ///< in ChokingLoops::Diagram().Features
  const LoopFeature* Geometry;
  std::ptrdiff_t SharedWith = -1; ///< Index of the feature that has the same loops; -1: none
};

/**
 * Sets SharedWith, and Geometry to that of the feature named.
 *
 * As where a wall between two chambers has two windows, the membrane of either takes in the other,
 * and both have one loop. To the first feature, in the order given, of the same side whose loops
 * coincide: as many of them, of lengths that differ by less than 2 %, and no point of either
 * farther than a tenth of the smaller radius from the other. And a feature that nothing on M holds
 * a loop of takes the shortest one of another feature that belongs to its choke point, too
 * (Belongs()), with a membrane within 0.3 of its radius of that.
 *
 * Cost: pairs of similar loops times their points squared.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void FindShared(
  const ChokingLoops& loops, std::vector<ShownFeature>& features);

}

#endif
