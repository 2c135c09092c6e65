/**
 * @file BoxMean.h
 * @brief Mean over a cubic window around every node.
 */
#ifndef isthmus_BoxMean_h
#define isthmus_BoxMean_h

#include <array>
#include <cstdint>

namespace isthmus
{

/// Replaces each value by the mean of those at most (window - 1)/2 nodes away along every axis;
/// beyond the grid's ends the outermost values are repeated. O(nodes), whatever the window.
template <typename T>
void BoxMean(const std::array<std::int64_t, 3>& dimensions, int window, T* values);

}

#endif
