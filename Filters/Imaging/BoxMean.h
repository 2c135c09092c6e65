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

/// Replaces each value by the mean over the `window` nodes around it along every axis; near the
/// grid's ends the window is moved inwards until it fits (and is all of a shorter axis), so that it
/// always holds that many values as measured. O(nodes), whatever the window.
template <typename T>
void BoxMean(const std::array<std::int64_t, 3>& dimensions, int window, T* values);

}

#endif
