/**
 * @file Assignment.h
 * @brief The assignment problem: pairs of rows and columns of least total cost.
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
 *
 * Why not Boost.Graph: maximum_weighted_matching is for general graphs; on 20 random rows it took
 * 70 times the CPU time and, with weights of doubles, missed the optimum (Boost 1.74).
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT std::vector<int> AssignAtLeastCost(
  const std::vector<std::vector<double>>& costs, std::size_t columns, double alone);

}

#endif
