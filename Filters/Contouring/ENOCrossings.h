/**
 * @file ENOCrossings.h
 * @brief Crossings and normals of a level of a volume with a discontinuous gradient.
 *
 * Around a sharp edge of a level set, the values are piecewise smooth, and have a kink along a grid
 * line that passes from one piece to another. Differences across the kink would mix the normals of
 * both sides. Here each difference is taken on one side, after A. Harten and others (essentially
 * non-oscillatory schemes, J. Comput. Phys. 71 (1987) 231; subcell resolution, 83 (1989) 148). With
 * second differences along a line, in the unit of the values,
 *
 *     d_j = v_{j-1} - 2 v_j + v_{j+1},
 *
 * the slope jumps by |d_j + d_{j+1}| where the kink is between nodes j and j+1. It is taken for one
 * where that is three times the two d beyond it, on the side that is then used, and 24 times the
 * lower quartile of |d| around the crossing, so that noise has none.
 * - Slope at a node: (v_1 - v_{-1}) / 2; where a kink is on one side of it, of second order on the
 *   other.
 * - Crossing between nodes 0 and 1: of the parabola through both with the smaller one of d_0 and
 *   d_1; where a kink lies between them, of the greater (jump > 0) or smaller one of the two
 *   parabolas that end there.
 * - Normal: slopes interpolated between both nodes, or extrapolated along the parabola that
 *   crosses; a node whose slope is taken across a kink does not count where the other's is not.
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

/// Like AppendLevelCrossings (LevelCrossings.h), but from more nodes: O(layer), and about 1 us for
/// each crossing. T is float or double.
template <typename T>
void AppendENOCrossings(
  const LevelView<T>& level, std::int64_t k, std::vector<GridCrossing>& crossings);

}

#endif
