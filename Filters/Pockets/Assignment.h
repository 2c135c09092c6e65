/**
 * @file Assignment.h
 * @brief The assignment problem: pairs of rows and columns of least total cost.
 */
#ifndef isthmus_Assignment_h
#define isthmus_Assignment_h

#include <vector>

namespace isthmus
{

/**
 * Returns for each row of `costs` its column, or -1 if it has none. Each column is used at most
 * once, and the total cost is minimal, where a row without a column costs `alone`, so no pair costs
 * more than that. HUGE_VAL marks pairs that are not allowed.
 *
 * Shortest augmenting paths with potentials (J. Munkres, J. SIAM 5 (1957) 32; R. Jonker and A.
 * Volgenant, Computing 38 (1987) 325). O(rows^2 (rows + columns)). @pre rows of `columns` numbers,
 * none negative or NaN.
 *
 * Boost.Graph is not used: its maximum_weighted_matching is for general graphs and, with double
 * weights, can miss the optimum (Boost 1.74).
 */
std::vector<int> AssignAtLeastCost(
  const std::vector<std::vector<double>>& costs, std::size_t columns, double alone);

}

#endif
