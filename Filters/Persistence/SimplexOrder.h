/**
 * @file SimplexOrder.h
 * @brief The order in which simplices enter, by a radix sort of their values.
 */
#ifndef isthmus_SimplexOrder_h
#define isthmus_SimplexOrder_h

#include "Progress.h"
#include "vtkIsthmusModule.h" // for the export macro

#include <cstdint>
#include <vector>

namespace isthmus
{

/**
 * Ids 0..n-1 of simplices in ascending (first, value, id); `rank` becomes the inverse.
 *
 * `first` marks simplices that come before all others (one flag each, or none); no value is NaN.
 * Bits of doubles, turned round below zero, stand in the order of their values: the 32 leading ones
 * in which the values differ are sorted by three stable passes of 11, and runs of equal ones by the
 * value itself. O(n), parallel, the same on any number of threads; 16 bytes a simplex while it
 * runs.
 */
VTKISTHMUS_EXPORT std::vector<std::int32_t> SimplexOrder(const std::vector<double>& value,
  const std::vector<char>& first, std::vector<std::int32_t>& rank,
  const ProgressCallback& progress = {});

}

#endif
