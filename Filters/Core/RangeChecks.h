/**
 * @file RangeChecks.h
 * @brief Numbers that no algorithm should meet are refused here, with a sentence, before
 * third-party code sees them: properties out of their range, frames of images, coordinates.
 */
#ifndef isthmus_RangeChecks_h
#define isthmus_RangeChecks_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <string>

class vtkImageData;

namespace isthmus
{

/// Lengths and coordinates that are worked with: beyond, products of a few of them are no doubles.
constexpr double SmallestLength = 1e-100;
constexpr double LargestLength = 1e100;

/// A number as sentences show it: six digits at most, and NaN in words.
VTKISTHMUSFILTERSCORE_EXPORT std::string FormatNumber(double value);

/// @throws std::invalid_argument, with the property's name, value and range, unless
/// low <= value <= high. NaN is refused. `meaning` ends the sentence.
VTKISTHMUSFILTERSCORE_EXPORT void RequireRange(
  const char* property, double value, double low, double high, const char* meaning = "");

/// The same for low < value <= high.
VTKISTHMUSFILTERSCORE_EXPORT void RequireAbove(
  const char* property, double value, double low, double high, const char* meaning = "");

/// @throws std::invalid_argument, with the axis, unless origin, spacing and direction are finite,
/// spacings not 0, and all coordinates and spacings between SmallestLength and LargestLength.
VTKISTHMUSFILTERSCORE_EXPORT void RequireImageGeometry(vtkImageData* image);

}

#endif
