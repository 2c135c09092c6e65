#include "Core/RangeChecks.h"
#include "Core/NumberText.h"

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

[[noreturn]] void Refuse(
  const char* property, double value, const std::string& range, const char* meaning)
{
  throw std::invalid_argument(std::string(property) + " is " + FormatNumber(value) +
    ", but it must be " + range + "." + (*meaning ? " " : "") + meaning);
}

}

void RequireRange(const char* property, double value, double low, double high, const char* meaning)
{
  if (!(value >= low && value <= high))
  {
    Refuse(property, value, "from " + FormatNumber(low) + " to " + FormatNumber(high), meaning);
  }
}

void RequireAbove(const char* property, double value, double low, double high, const char* meaning)
{
  if (!(value > low && value <= high))
  {
    Refuse(property, value, "above " + FormatNumber(low) + " and at most " + FormatNumber(high),
      meaning);
  }
}

void RequireThat(bool holds, const char* property, double value, const char* condition)
{
  if (!holds)
  {
    throw std::invalid_argument(
      std::string(property) + " is " + FormatNumber(value) + ", but " + condition + ".");
  }
}

void RequireImageGeometry(vtkImageData* image)
{
  const int* extent = image->GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = std::abs(image->GetSpacing()[axis]);
    const double origin = image->GetOrigin()[axis];
    const std::string along = std::string(" of the image along ") + "xyz"[axis];
    RequireRange(
      ("The spacing" + along).c_str(), spacing, SmallestLength, LargestLength, "Set another one.");
    RequireRange(
      ("The origin" + along).c_str(), origin, -LargestLength, LargestLength, "Set another one.");
    const double far = spacing *
      std::max(std::abs(double(extent[2 * axis])), std::abs(double(extent[2 * axis + 1])));
    RequireRange(("The farthest node" + along).c_str(), far, 0.0, LargestLength,
      "Choose another unit of length.");
    for (int row = 0; row < 3; ++row)
    {
      RequireRange("An entry of the image's direction matrix",
        image->GetDirectionMatrix()->GetElement(row, axis), -2.0, 2.0,
        "Set a direction matrix that is a rotation.");
    }
  }
}

}
