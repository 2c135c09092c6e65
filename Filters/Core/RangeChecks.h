/**
 * @file RangeChecks.h
 * @brief Refuses properties and image geometry that are out of range with an error message, before
 * they reach algorithms and third-party code. Coordinates: UnitScale.h.
 */
#ifndef isthmus_RangeChecks_h
#define isthmus_RangeChecks_h

#include "Core/NumberText.h"
#include "vtkIsthmusFiltersCoreModule.h"

#include <limits>
#include <string>

class vtkDataArray;
class vtkDataObject;
class vtkImageData;

namespace isthmus
{

/// Range of valid lengths and coordinates: beyond it, products of a few of them overflow or
/// underflow.
constexpr double SmallestLength = 1e-100;
constexpr double LargestLength = 1e100;

/// Range of the largest absolute value of an image: beyond it, differences of values of single
/// precision, or products of a few values of double precision, overflow or underflow.
constexpr double SmallestPeak = 1e-36;
constexpr double LargestPeak = 1e36;

/// As the upper end of a range: any finite number.
constexpr double Unlimited = std::numeric_limits<double>::max();

/// @throws std::invalid_argument, with the property's name, value and range, unless low <= value <=
/// high. NaN is refused. `meaning` is the end of the message.
VTKISTHMUSFILTERSCORE_EXPORT void RequireRange(
  const char* property, double value, double low, double high, const char* meaning = "");

/// The same for low < value <= high.
VTKISTHMUSFILTERSCORE_EXPORT void RequireAbove(
  const char* property, double value, double low, double high, const char* meaning = "");

/// The same for an enumeration whose values are 0 to `last`.
template <typename Enum>
void RequireChoice(const char* property, Enum value, Enum last)
{
  RequireRange(property, static_cast<double>(value), 0.0, static_cast<double>(last));
}

/// @throws std::invalid_argument "<property> is <value>, but <condition>." unless `holds`.
VTKISTHMUSFILTERSCORE_EXPORT void RequireThat(
  bool holds, const char* property, double value, const char* condition);

/// The largest absolute value of all that are finite; 0 if there is none. O(values), on all
/// threads.
double LargestMagnitude(vtkDataArray* values);

/// @throws std::invalid_argument, with the array and its largest absolute value, unless that is 0
/// or from SmallestPeak to LargestPeak. Values that are not finite are ignored. O(values).
VTKISTHMUSFILTERSCORE_EXPORT void RequireUsualValues(vtkDataArray* values);

/// @throws std::invalid_argument, with the point, if a coordinate of a point set or a graph is
/// finite and exceeds LargestLength, or if there are several points and all their coordinates are
/// below SmallestLength but not 0. `name`: "input 0". Points that no cell uses are ignored where
/// there are cells. O(points).
void RequireUsualCoordinates(vtkDataObject* data, const std::string& name);

/// @throws std::invalid_argument, with the axis, unless origin, spacing and direction are finite,
/// spacings not 0, and all coordinates and spacings between SmallestLength and LargestLength.
VTKISTHMUSFILTERSCORE_EXPORT void RequireImageGeometry(vtkImageData* image);

}

#endif
