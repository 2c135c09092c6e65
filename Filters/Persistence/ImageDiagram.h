/**
 * @file ImageDiagram.h
 * @brief The pairs of an image's scalars, computed once for the same values.
 */
#ifndef isthmus_ImageDiagram_h
#define isthmus_ImageDiagram_h

#include "Core/Progress.h"
#include "Persistence/CubicalPairs.h"
#include "Persistence/VolumeView.h"

#include <vtkType.h>

#include <array>
#include <optional>

class vtkDataArray;
class vtkImageData;

namespace isthmus
{

/// The values as they lie in memory. Throws std::invalid_argument for arrays that are not plain
/// numbers in one piece.
VolumeView VolumeOf(vtkDataArray* scalars, vtkImageData* image);

/// Statistics and pairs of the scalars asked for last. Thresholds do not enter, so that moving one
/// is answered at once; changed values, another sign or other levels make them anew.
class ImageDiagram
{
public:
  /// Forgets all if these are not the values known.
  const VolumeStatistics& Statistics(vtkDataArray* scalars, const VolumeView& volume);

  /// Of the values last given to Statistics.
  const CubicalDiagram& Pairs(const VolumeView& volume, const CubicalParameters& parameters,
    const ProgressCallback& progress);

private:
  const void* Scalars = nullptr;
  vtkMTimeType Time = 0;
  std::array<std::int64_t, 3> Dimensions{ -1, -1, -1 };
  VolumeStatistics Measured;
  CubicalParameters Asked;
  std::optional<CubicalDiagram> Found;
};

}

#endif
