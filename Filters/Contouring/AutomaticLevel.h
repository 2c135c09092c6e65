/**
 * @file AutomaticLevel.h
 * @brief The level at which filters contour a volume: automatic unless given.
 */
#ifndef isthmus_AutomaticLevel_h
#define isthmus_AutomaticLevel_h

#include "vtkIsthmusFiltersContouringModule.h"

#include <optional>

class vtkDataArray;
class vtkDataObject;
class vtkImageData;

namespace isthmus
{

/// Where a level comes from.
enum class LevelSource
{
  Given,
  Natural,     ///< of a quantity whose surface has a fixed value: 0 of a signed distance
  Recommended, ///< by the depositors of the map: field data RecommendedLevel, set by the reader
  Estimated    ///< EstimateLevel() of the values
};

struct ChosenLevel
{
  double Level = 0.0;
  LevelSource Source = LevelSource::Given;
};

/**
 * The level of a volume by the one policy of all filters that contour one: `level` unless
 * `isAutomatic`, or else the natural level of the quantity, or else the recommended one of the map,
 * or else an estimate.
 *
 * Quantities with a natural level are signed distances, known by their gradient of length 1
 * (IsSignedDistance()) or by the name `SignedDistance`, with level 0; and `S`, `Inside` and `Side`,
 * known by these names and values from 0 to 1, with level 1/2. The estimate costs one sample of at
 * most 2^20 values, without those of nodes that have no data.
 * @throws std::invalid_argument if the level is not finite, or no value of the volume is.
 */
VTKISTHMUSFILTERSCONTOURING_EXPORT ChosenLevel ChooseLevel(
  bool isAutomatic, double level, vtkImageData* image, vtkDataArray* scalars, bool insideIsHigher);

/// The flags of nodes without data, the array `NoData` that vtkMRCMapReader adds; null: all have
/// data.
const unsigned char* NoDataMask(vtkImageData* image);

/// The level that the depositors of the map recommend: field data `RecommendedLevel`.
VTKISTHMUSFILTERSCONTOURING_EXPORT std::optional<double> RecommendedLevel(vtkImageData* image);

/// Writes the level that is automatic, whichever is used, into the field data of an output:
/// `AutomaticLevel`, and `AutomaticLevelSource` as text. Nothing if no value is finite.
VTKISTHMUSFILTERSCONTOURING_EXPORT void AddAutomaticLevel(const ChosenLevel& used,
  vtkImageData* image, vtkDataArray* scalars, bool insideIsHigher, vtkDataObject* output);

/// Writes the level into the field data of an output: `Level`, and `LevelSource` as text.
VTKISTHMUSFILTERSCONTOURING_EXPORT void AddLevel(const ChosenLevel& level, vtkDataObject* output);

}

#endif
