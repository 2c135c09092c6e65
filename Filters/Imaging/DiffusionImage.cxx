#include "Imaging/DiffusionImage.h"
#include "Core/LargePages.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArrayRange.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// Copies the nodes of extent `part` from an array of extent `from` to one of extent `to`.
template <typename Source, typename T>
void CopyPart(
  const Source& source, const Extent& from, const Extent& part, T* target, const Extent& to)
{
  auto offset = [](const Extent& extent, std::int64_t i, std::int64_t j, std::int64_t k)
  {
    const std::int64_t nx = extent[1] - extent[0] + 1, ny = extent[3] - extent[2] + 1;
    return i - extent[0] + nx * (j - extent[2] + ny * (k - extent[4]));
  };
  ParallelFor(part[4], part[5] + 1, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        for (std::int64_t j = part[2]; j <= part[3]; ++j)
        {
          auto in = source.begin() + offset(from, part[0], j, k);
          T* out = target + offset(to, part[0], j, k);
          std::transform(in, in + (part[1] - part[0] + 1), out,
            [](auto value) { return static_cast<T>(value); });
        }
      }
    });
}

Extent ReadExtent(vtkImageData* image)
{
  Extent extent;
  image->GetExtent(extent.data());
  return extent;
}

}

template <typename T>
DiffusionImage<T>::DiffusionImage(vtkImageData* input, vtkImageData* output,
  const DomainDecomposition& parts, bool voxelUnits, ProgressCallback progress)
  : Input(input)
  , Output(output)
  , Parts(parts)
  , Progress(std::move(progress))
{
  const Extent& local = parts.Local();
  double smallest = std::numeric_limits<double>::max();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Grid.Dimensions[axis] = std::max(0, local[2 * axis + 1] - local[2 * axis] + 1);
    this->Grid.OwnedBegin[axis] = parts.Owned()[2 * axis] - local[2 * axis];
    this->Grid.OwnedEnd[axis] = parts.Owned()[2 * axis + 1] - local[2 * axis] + 1;
    this->Grid.GlobalBegin[axis] = local[2 * axis] - parts.WholeExtent()[2 * axis];
    this->Grid.GlobalDimensions[axis] =
      parts.WholeExtent()[2 * axis + 1] - parts.WholeExtent()[2 * axis] + 1;
    const double spacing = input->GetSpacing()[axis];
    if (!(spacing > 0.0) && this->Grid.Dimensions[axis] > 1)
    {
      throw std::invalid_argument("The image's spacing is not positive along an axis with more "
                                  "than one node: set it first.");
    }
    // A single node has no neighbour along this axis: any length is valid.
    this->Grid.Spacing[axis] = spacing > 0.0 ? spacing : 1.0;
    smallest = std::min(smallest, this->Grid.Spacing[axis]);
  }
  if (voxelUnits)
  {
    for (double& spacing : this->Grid.Spacing)
    {
      spacing /= smallest;
    }
  }
  if (parts.Distributed())
  {
    this->Grid.ExchangeHalo = [&parts](T* values) { parts.ExchangeHalo(values); };
    this->Grid.SumOverRanks = [&parts](double* values, int count) { parts.Sum(values, count); };
  }
}

template <typename T>
vtkSmartPointer<typename DiffusionImage<T>::Array> DiffusionImage<T>::NewVolume(
  const std::string& name) const
{
  vtkSmartPointer<Array> volume =
    NamedArray<Array>(name, static_cast<std::size_t>(this->Grid.Size()));
  AdviseLargePages(volume.Get());
  return volume;
}

template <typename T>
vtkSmartPointer<typename DiffusionImage<T>::Array> DiffusionImage<T>::Copy(
  vtkDataArray* array, bool mask)
{
  this->CheckArray(array);
  auto volume = this->NewVolume(array && array->GetName() ? array->GetName() : "ImageScalars");
  const Extent from = ReadExtent(this->Input);
  auto copy = [&](auto* typed)
  {
    CopyPart(vtk::DataArrayValueRange<1>(typed), from, Intersection(from, this->Parts.Local()),
      volume->GetPointer(0), this->Parts.Local());
  };
  if (array && !vtkArrayDispatch::Dispatch::Execute(array, copy))
  {
    copy(array);
  }
  this->Grid.Exchange(volume->GetPointer(0));
  if (mask)
  {
    this->Mask(volume->GetPointer(0));
  }
  else
  {
    this->RefuseInvalid(volume->GetPointer(0));
  }
  return volume;
}

template <typename T>
vtkSmartPointer<typename DiffusionImage<T>::Array> DiffusionImage<T>::Duplicate(
  Array* volume, const std::string& name) const
{
  auto duplicate = this->NewVolume(name);
  std::copy_n(volume->GetPointer(0), this->Grid.Size(), duplicate->GetPointer(0));
  return duplicate;
}

template <typename T>
void DiffusionImage<T>::CheckArray(vtkDataArray* array) const
{
  if (this->Input->GetNumberOfPoints() == 0)
  {
    return; // a rank without nodes
  }
  if (!array)
  {
    throw std::invalid_argument("The input lacks the chosen array: choose one that it has.");
  }
  if (array->GetNumberOfTuples() != this->Input->GetNumberOfPoints() ||
    array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument(JoinText("The array '", array->GetName() ? array->GetName() : "",
      "' has ", array->GetNumberOfTuples(), " tuples of ", array->GetNumberOfComponents(),
      " components, but the image has ", this->Input->GetNumberOfPoints(),
      " nodes and needs one number at each."));
  }
}

template <typename T>
void DiffusionImage<T>::RefuseInvalid(const T* values) const
{
  std::int64_t count = 0, first = -1;
  const auto sums = SumRows<1>(this->Grid,
    [values](std::int64_t begin, std::int64_t end, std::array<double, 1>& sum)
    {
      sum[0] += static_cast<double>(
        std::count_if(values + begin, values + end, [](T value) { return !std::isfinite(value); }));
    });
  count = static_cast<std::int64_t>(sums[0]);
  if (count == 0)
  {
    return;
  }
  first = std::find_if(
            values, values + this->Grid.Size(), [](T value) { return !std::isfinite(value); }) -
    values;
  std::string text = JoinText(count, " of the image's values are not finite");
  if (first < this->Grid.Size())
  {
    const auto& n = this->Grid.Dimensions;
    int node[3] = { int(first % n[0]), int(first / n[0] % n[1]), int(first / n[0] / n[1]) };
    double index[3], position[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      node[axis] += this->Parts.Local()[2 * static_cast<std::size_t>(axis)];
      index[axis] = node[axis];
    }
    this->Input->TransformContinuousIndexToPhysicalPoint(index, position);
    text += JoinText(", the first at node (", node[0], ", ", node[1], ", ", node[2],
      "), position (", position[0], ", ", position[1], ", ", position[2], ")");
  }
  throw std::invalid_argument(text + ": repair them, or switch MaskInvalid on to leave them out.");
}

template <typename T>
void DiffusionImage<T>::Mask(T* values)
{
  const std::int64_t size = this->Grid.Size();
  this->Invalid.clear();
  for (std::int64_t node = 0; node < size; ++node)
  {
    if (!std::isfinite(values[node]))
    {
      this->Invalid.push_back({ node, values[node] });
    }
  }
  const auto sums = SumRows<2>(this->Grid,
    [values](std::int64_t begin, std::int64_t end, std::array<double, 2>& sum)
    {
      for (std::int64_t node = begin; node < end; ++node)
      {
        const bool finite = std::isfinite(values[node]);
        sum[0] += finite ? static_cast<double>(values[node]) : 0.0;
        sum[1] += finite;
      }
    });
  const T mean = sums[1] > 0.0 ? static_cast<T>(sums[0] / sums[1]) : T(0);
  // All replacements are computed from the original values and then stored at once, so the result
  // does not depend on the order.
  std::vector<T> filled(this->Invalid.size(), mean);
  const auto& n = this->Grid.Dimensions;
  for (std::size_t m = 0; m < filled.size(); ++m)
  {
    const std::int64_t node = this->Invalid[m].Node;
    const std::array<std::int64_t, 3> at{ node % n[0], node / n[0] % n[1], node / n[0] / n[1] };
    const std::array<std::int64_t, 3> step{ 1, n[0], n[0] * n[1] };
    double sum = 0.0, count = 0.0;
    for (std::size_t side = 0; side < 6; ++side)
    {
      const std::size_t axis = side / 2;
      const std::int64_t sign = side % 2 == 0 ? -1 : 1;
      if (at[axis] + sign >= 0 && at[axis] + sign < n[axis] &&
        std::isfinite(values[node + sign * step[axis]]))
      {
        sum += static_cast<double>(values[node + sign * step[axis]]);
        count += 1.0;
      }
    }
    filled[m] = count > 0.0 ? static_cast<T>(sum / count) : mean;
  }
  for (std::size_t m = 0; m < filled.size(); ++m)
  {
    values[this->Invalid[m].Node] = filled[m];
  }
  this->Grid.Exchange(values);
}

template <typename T>
void DiffusionImage<T>::AddResult(Array* volume, bool active)
{
  for (const Masked& masked : this->Invalid)
  {
    volume->SetValue(masked.Node, masked.Value);
  }
  vtkSmartPointer<Array> result = volume;
  const Extent extent = ReadExtent(this->Output);
  if (extent != this->Parts.Local())
  {
    result = NamedArray<Array>(
      volume->GetName(), static_cast<std::size_t>(this->Output->GetNumberOfPoints()));
    AdviseLargePages(result.Get());
    CopyPart(vtk::DataArrayValueRange<1>(volume), this->Parts.Local(), extent,
      result->GetPointer(0), extent);
  }
  this->Output->GetPointData()->AddArray(result);
  if (active)
  {
    this->Output->GetPointData()->SetActiveScalars(result->GetName());
  }
}

template <typename T>
void DiffusionImage<T>::AddFieldData(const std::string& name, const std::vector<double>& values)
{
  AddColumn<vtkDoubleArray>(this->Output->GetFieldData(), name, values);
}

template <typename T>
void DiffusionImage<T>::AddFieldText(const std::string& name, const std::string& text)
{
  AddColumn<vtkStringArray>(this->Output->GetFieldData(), name, { text });
}

template class DiffusionImage<float>;
template class DiffusionImage<double>;

}
