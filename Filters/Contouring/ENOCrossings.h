/**
 * @file ENOCrossings.h
 * @brief Crossings and normals of a level of a volume with a discontinuous gradient.
 *
 * Around a sharp edge of a level set, the values are piecewise smooth, and have a kink along a grid
 * line that passes from one piece to another. Each difference is taken on one side of a kink, so
 * that the normals of both sides are not mixed, after A. Harten and others (essentially
 * non-oscillatory schemes, J. Comput. Phys. 71 (1987) 231; subcell resolution, 83 (1989) 148). A
 * kink is a jump of the slope of at least three times the second differences beyond it and 24 times
 * the lower quartile of those around the crossing, so that noise has none.
 *
 * The result is exact for planes whose pieces are at least three nodes wide along the axes, i.e.
 * except within two spacings of corners. Elsewhere normals are of second order and crossings of
 * third.
 */
#ifndef isthmus_ENOCrossings_h
#define isthmus_ENOCrossings_h

#include "Surfaces/LevelCrossings.h"

namespace isthmus
{

/// Like AppendLevelCrossings (LevelCrossings.h), but from more nodes: O(nodes of the layer). T is
/// float or double.
template <typename T>
void AppendENOCrossings(
  const LevelView<T>& level, std::int64_t k, std::vector<GridCrossing>& crossings);

}

#endif
