/**
 * @file RangeChecks.h
 * @brief Refuses properties and image geometry that are out of range with an error message, before
 * they reach algorithms and third-party code. Coordinates: UnitScale.h.
 */
#ifndef isthmus_RangeChecks_h
#define isthmus_RangeChecks_h

#include "Core/NumberText.h"
#include "vtkIsthmusFiltersCoreModule.h"

#include <string>

class vtkImageData;

namespace isthmus
{

/// Range of valid lengths and coordinates: beyond it, products of a few of them overflow or
/// underflow.
constexpr double SmallestLength = 1e-100;
constexpr double LargestLength = 1e100;

/// @throws std::invalid_argument, with the property's name, value and range, unless low <= value <=
/// high. NaN is refused. `meaning` is the end of the message.
VTKISTHMUSFILTERSCORE_EXPORT void RequireRange(
  const char* property, double value, double low, double high, const char* meaning = "");

/// The same for low < value <= high.
VTKISTHMUSFILTERSCORE_EXPORT void RequireAbove(
  const char* property, double value, double low, double high, const char* meaning = "");

/// @throws std::invalid_argument "<property> is <value>, but <condition>." unless `holds`.
VTKISTHMUSFILTERSCORE_EXPORT void RequireThat(
  bool holds, const char* property, double value, const char* condition);

/// @throws std::invalid_argument, with the axis, unless origin, spacing and direction are finite,
/// spacings not 0, and all coordinates and spacings between SmallestLength and LargestLength.
VTKISTHMUSFILTERSCORE_EXPORT void RequireImageGeometry(vtkImageData* image);

}

#endif
