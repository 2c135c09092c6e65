/**
 * @file Assignment.h
 * @brief Who goes with whom at least cost.
 */
#ifndef isthmus_Assignment_h
#define isthmus_Assignment_h

#include "vtkIsthmusFiltersPocketsModule.h"

#include <vector>

namespace isthmus
{

/**
 * For each row of `costs` its column, or -1: each column once, the sum of costs the least, where a
 * row without a column costs `alone`. So no pair costs more than that. HUGE_VAL: can't be a pair.
 *
 * Shortest augmenting paths with potentials (J. Munkres, J. SIAM 5 (1957) 32; R. Jonker and A.
 * Volgenant, Computing 38 (1987) 325). O(rows^2 (rows + columns)). @pre rows of `columns` numbers,
 * none negative or NaN.
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT std::vector<int> AssignAtLeastCost(
  const std::vector<std::vector<double>>& costs, std::size_t columns, double alone);

}

#endif
