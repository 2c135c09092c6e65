/**
 * @file FastMarching.h
 * @brief First-order fast marching: distances computed from nodes with known distances.
 */
#ifndef isthmus_FastMarching_h
#define isthmus_FastMarching_h

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/**
 * Solves |grad d| = 1 on a grid with cells of side `spacing`, by upwind differences (J. A. Sethian,
 * PNAS 93, 1996). `values` holds the distances of the nodes in `known`; the others are computed,
 * up to `greatest`. Error O(spacing log spacing). O(n log n).
 */
void FastMarch(const std::array<std::int64_t, 3>& dimensions, double spacing,
  const std::vector<std::int64_t>& known, float greatest, std::vector<float>& values);

}

#endif
