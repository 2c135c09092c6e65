#include "Core/RangeChecks.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGraph.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace isthmus
{
namespace
{

[[noreturn]] void Reject(
  const char* property, double value, const std::string& range, const char* meaning)
{
  throw std::invalid_argument(std::string(property) + " is " + FormatNumber(value) +
    ", but it must be " + range + "." + (*meaning ? " " : "") + meaning);
}

struct Largest
{
  double Value = 0.0;
  Largest& operator+=(const Largest& other)
  {
    this->Value = std::max(this->Value, other.Value);
    return *this;
  }
};

/// `at(i)`: value i of `count`.
template <typename T, typename Access>
double FindLargest(vtkIdType count, const Access& at)
{
  return ParallelReduce(count, 65536, Largest(),
    [&](Largest& part, std::int64_t begin, std::int64_t end)
    {
      T most = 0;
      for (std::int64_t i = begin; i < end; ++i)
      {
        const T size = std::abs(at(i));
        most = size > most && size <= std::numeric_limits<T>::max() ? size : most;
      }
      part.Value = std::max(part.Value, static_cast<double>(most));
    })
    .Value;
}

std::string QuotedName(vtkDataArray* values)
{
  return values->GetName() ? "Array '" + std::string(values->GetName()) + "'" : "The array";
}

/// All of them if there are no cells.
std::vector<bool> PointsOfCells(vtkPointSet* set, vtkIdType points)
{
  const bool hasCells = set && set->GetNumberOfCells() > 0;
  std::vector<bool> used(static_cast<std::size_t>(points), !hasCells);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; hasCells && cell < set->GetNumberOfCells(); ++cell)
  {
    set->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      if (ids->GetId(i) >= 0 && ids->GetId(i) < points)
      {
        used[static_cast<std::size_t>(ids->GetId(i))] = true;
      }
    }
  }
  return used;
}

}

double LargestMagnitude(vtkDataArray* values)
{
  const vtkIdType count = values->GetNumberOfValues();
  if (auto* const floats = vtkArrayDownCast<vtkFloatArray>(values))
  {
    const float* const first = floats->GetPointer(0);
    return FindLargest<float>(count, [first](std::int64_t i) { return first[i]; });
  }
  if (auto* const doubles = vtkArrayDownCast<vtkDoubleArray>(values))
  {
    const double* const first = doubles->GetPointer(0);
    return FindLargest<double>(count, [first](std::int64_t i) { return first[i]; });
  }
  const int components = values->GetNumberOfComponents();
  return FindLargest<double>(count,
    [values, components](std::int64_t i)
    { return values->GetComponent(i / components, static_cast<int>(i % components)); });
}

void RequireUsualValues(vtkDataArray* values)
{
  const int type = values->GetDataType();
  if (type != VTK_FLOAT && type != VTK_DOUBLE)
  {
    return; // no integer is out of range
  }
  const double largest = LargestMagnitude(values);
  if (largest != 0.0 && !(largest >= SmallestPeak && largest <= LargestPeak))
  {
    throw std::invalid_argument(QuotedName(values) + " has the largest absolute value " +
      FormatNumber(largest) + ", but it must be from " + FormatNumber(SmallestPeak) + " to " +
      FormatNumber(LargestPeak) + ", since products of values are computed. Divide the map by a " +
      "number (Calculator), or replace values that stand for missing ones.");
  }
}

void RequireUsualCoordinates(vtkDataObject* data, const std::string& name)
{
  auto* const set = vtkPointSet::SafeDownCast(data);
  auto* const graph = vtkGraph::SafeDownCast(data);
  vtkPoints* const points = set ? set->GetPoints() : graph ? graph->GetPoints() : nullptr;
  if (!points || points->GetDataType() != VTK_DOUBLE)
  {
    return; // no number of single precision is out of range
  }
  const double largest = LargestMagnitude(points->GetData());
  const vtkIdType count = points->GetNumberOfPoints();
  if (largest > 0.0 && largest < SmallestLength && count > 1)
  {
    throw std::invalid_argument("The largest coordinate of " + name + " is " +
      FormatNumber(largest) + ": it should be at least " + FormatNumber(SmallestLength) +
      ". Choose another unit of length (Transform).");
  }
  if (!(largest > LargestLength))
  {
    return;
  }
  const std::vector<bool> used = PointsOfCells(set, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    for (const double x : p)
    {
      if (used[static_cast<std::size_t>(i)] && std::isfinite(x) && std::abs(x) > LargestLength)
      {
        throw std::invalid_argument("Point " + std::to_string(i) + " of " + name +
          " has the coordinate " + FormatNumber(x) + ": at most " + FormatNumber(LargestLength) +
          " is supported. Remove the point, or choose another unit of length.");
      }
    }
  }
}

void RequireRange(const char* property, double value, double low, double high, const char* meaning)
{
  if (!(value >= low && value <= high))
  {
    const std::string range = high < Unlimited
      ? "from " + FormatNumber(low) + " to " + FormatNumber(high)
      : "a finite number of at least " + FormatNumber(low);
    Reject(property, value, range, meaning);
  }
}

void RequireAbove(const char* property, double value, double low, double high, const char* meaning)
{
  if (!(value > low && value <= high))
  {
    const std::string range = high < Unlimited
      ? "above " + FormatNumber(low) + " and at most " + FormatNumber(high)
      : "a finite number above " + FormatNumber(low);
    Reject(property, value, range, meaning);
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
