/**
 * @file ImageScalars.h
 * @brief The scalars of a vtkImageData: choice of the array, its precision, and its values as a
 * GridView of float or double.
 */
#ifndef isthmus_ImageScalars_h
#define isthmus_ImageScalars_h

#include "Core/GridView.h"
#include "Core/NumberText.h"
#include "vtkIsthmusFiltersCoreModule.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <stdexcept>
#include <string>

class vtkAlgorithm;

namespace isthmus
{

/// The array that the filter's input array 0 names; the active scalars if it names none, since a
/// panel without data sends an empty name.
/// @throws std::invalid_argument, listing the available arrays, unless it has one number per node;
/// for values out of range (RequireUsualValues() in RangeChecks.h). O(nodes).
VTKISTHMUSFILTERSCORE_EXPORT vtkDataArray* ChosenScalars(vtkAlgorithm* filter, vtkImageData* image);

/// Whether float holds all values of the type of `array`: float and integers of up to 16 bits.
VTKISTHMUSFILTERSCORE_EXPORT bool FitsFloat(vtkDataArray* array);

/// `array` itself, or a copy of type double of integers of more than 16 bits.
VTKISTHMUSFILTERSCORE_EXPORT vtkSmartPointer<vtkDataArray> WideIntegersAsDouble(
  vtkDataArray* array);

/// @throws std::invalid_argument, with the axis, unless all spacings are positive and finite.
inline void RequireSpacing(vtkImageData* image)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = image->GetSpacing()[axis];
    if (!(spacing > 0.0) || std::isinf(spacing))
    {
      throw std::invalid_argument("The image has the spacing " + FormatNumber(spacing) + " along " +
        "xyz"[axis] + ", but spacings must be positive and finite: set another one.");
    }
  }
}

/// @throws std::invalid_argument, with the node, unless all values are finite numbers.
template <typename T>
void CheckFinite(const GridView<const T>& grid)
{
  for (std::int64_t node = 0; node < grid.Size(); ++node)
  {
    if (!std::isfinite(static_cast<double>(grid.Data[node])))
    {
      const std::int64_t row = node / grid.Dimensions[0];
      throw std::invalid_argument("The value at node (" +
        std::to_string(node % grid.Dimensions[0]) + ", " +
        std::to_string(row % grid.Dimensions[1]) + ", " + std::to_string(row / grid.Dimensions[1]) +
        ") of the image is not a finite number. Crop the image or replace the value.");
    }
  }
}

/// Calls `use(grid)` with a GridView<const float> or, for all other types, GridView<const double>;
/// a copy is made if the values are stored in another way.
template <typename Use>
void UseScalars(vtkImageData* image, vtkDataArray* scalars, Use&& use)
{
  RequireSpacing(image);
  int dimensions[3];
  double spacing[3];
  image->GetDimensions(dimensions);
  image->GetSpacing(spacing);
  const auto fill = [&](auto grid, const auto* values)
  {
    grid.Data = values;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      grid.Dimensions[axis] = dimensions[axis];
      grid.Spacing[axis] = spacing[axis];
    }
    use(grid);
  };
  if (auto* floats = vtkArrayDownCast<vtkFloatArray>(scalars))
  {
    fill(GridView<const float>{}, floats->GetPointer(0));
    return;
  }
  vtkSmartPointer<vtkDoubleArray> doubles = vtkArrayDownCast<vtkDoubleArray>(scalars);
  if (!doubles)
  {
    doubles = vtkSmartPointer<vtkDoubleArray>::New();
    doubles->DeepCopy(scalars);
  }
  fill(GridView<const double>{}, doubles->GetPointer(0));
}

}

#endif
