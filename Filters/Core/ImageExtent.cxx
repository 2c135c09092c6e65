#include "Core/ImageExtent.h"
#include "Core/ArrayMemory.h"

#include "Core/GatherRanks.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkExtentTranslator.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// `index` as an integer within [low, high]; NaN gives `low`.
int ClampIndex(double index, int low, int high)
{
  return index > low ? (index < high ? static_cast<int>(index) : high) : low;
}

}

Extent ReadExtent(vtkInformation* info, vtkInformationIntegerVectorKey* key)
{
  Extent extent{ 0, -1, 0, -1, 0, -1 };
  if (info->Has(key))
  {
    info->Get(key, extent.data());
  }
  return extent;
}

Extent GetPieceExtent(vtkInformation* request, const Extent& all)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int pieces = Pipeline::GetUpdateNumberOfPieces(request);
  if (pieces <= 1)
  {
    return all;
  }
  Extent whole = all;
  Extent piece{ 0, -1, 0, -1, 0, -1 };
  vtkNew<vtkExtentTranslator> translator;
  translator->PieceToExtentThreadSafe(Pipeline::GetUpdatePiece(request), pieces,
    Pipeline::GetUpdateGhostLevel(request), whole.data(), piece.data(),
    vtkExtentTranslator::BLOCK_MODE, 0);
  return piece;
}

void RequestAll(vtkInformation* request)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  request->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  request->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  request->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

void RequestWholeExtent(vtkInformation* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
    // Otherwise, a source that can produce a part produces that of this rank for any extent.
    RequestAll(input);
  }
}

void SetImageInformation(vtkInformation* output, vtkImageData* image)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  output->Set(Pipeline::WHOLE_EXTENT(), image->GetExtent(), 6);
  output->Set(vtkDataObject::ORIGIN(), image->GetOrigin(), 3);
  output->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
}

void SetImageInformation(vtkInformation* output, const std::function<void(vtkImageData*)>& make)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(0, -1, 0, -1, 0, -1);
  try
  {
    make(image);
  }
  catch (const std::exception&)
  {
    image->SetExtent(0, -1, 0, -1, 0, -1);
  }
  SetImageInformation(output, image);
}

bool IsFirstPiece(vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  return !output->Has(Pipeline::UPDATE_PIECE_NUMBER()) ||
    output->Get(Pipeline::UPDATE_PIECE_NUMBER()) <= 0;
}

void RequireWholeExtent(vtkInformation* info)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkImageData* image = info ? vtkImageData::GetData(info) : nullptr;
  // Blocks of composite data come without a whole extent of their own.
  if (!image || !info->Has(Pipeline::WHOLE_EXTENT()))
  {
    return;
  }
  Extent delivered{};
  image->GetExtent(delivered.data());
  if (!Contains(delivered, ReadExtent(info, Pipeline::WHOLE_EXTENT())))
  {
    throw std::runtime_error("Only a part of the image is on this rank, and all of it is needed: "
                             "run on one rank, or read the image with a reader that provides the "
                             "extent that each rank requests.");
  }
}

bool IsProducedOnThisRank(vtkInformation* info)
{
  return OnFirstRank() || !info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
}

bool IsEmpty(const Extent& extent)
{
  return extent[1] < extent[0] || extent[3] < extent[2] || extent[5] < extent[4];
}

Extent GrowExtent(const Extent& extent, const std::array<int, 3>& reach, const Extent& whole)
{
  if (IsEmpty(extent))
  {
    return extent;
  }
  Extent grown{};
  for (int axis = 0; axis < 3; ++axis)
  {
    // Doubles, since a reach may be as large as an int.
    const int low = whole[2 * axis];
    const int high = whole[2 * axis + 1];
    grown[2 * axis] = ClampIndex(static_cast<double>(extent[2 * axis]) - reach[axis], low, high);
    grown[2 * axis + 1] =
      ClampIndex(static_cast<double>(extent[2 * axis + 1]) + reach[axis], low, high);
  }
  return grown;
}

std::int64_t NodeCount(const Extent& extent)
{
  std::int64_t count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    count *= std::max<std::int64_t>(0, std::int64_t(extent[2 * axis + 1]) - extent[2 * axis] + 1);
  }
  return count;
}

Extent Intersection(const Extent& a, const Extent& b)
{
  Extent both;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    both[2 * axis] = std::max(a[2 * axis], b[2 * axis]);
    both[2 * axis + 1] = std::min(a[2 * axis + 1], b[2 * axis + 1]);
  }
  return both;
}

bool Contains(const Extent& outer, const Extent& inner)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (inner[2 * axis] < outer[2 * axis] || inner[2 * axis + 1] > outer[2 * axis + 1])
    {
      return IsEmpty(inner);
    }
  }
  return true;
}

int LayersBetween(const Extent& inner, const Extent& outer)
{
  int layers = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    layers = std::max(
      { layers, inner[2 * axis] - outer[2 * axis], outer[2 * axis + 1] - inner[2 * axis + 1] });
  }
  return layers;
}

Extent CoverBounds(
  vtkImageData* image, const double bounds[6], const std::array<int, 3>& reach, const Extent& whole)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{ infinity, infinity, infinity };
  std::array<double, 3> high{ -infinity, -infinity, -infinity };
  for (int corner = 0; corner < 8; ++corner)
  {
    const double point[3] = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
      bounds[4 + (corner >> 2)] };
    double index[3];
    image->TransformPhysicalPointToContinuousIndex(point, index);
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], index[axis]);
      high[axis] = std::max(high[axis], index[axis]);
    }
  }
  Extent cells{};
  for (int axis = 0; axis < 3; ++axis)
  {
    cells[2 * axis] = ClampIndex(std::floor(low[axis]), whole[2 * axis], whole[2 * axis + 1]);
    cells[2 * axis + 1] = ClampIndex(std::ceil(high[axis]), whole[2 * axis], whole[2 * axis + 1]);
  }
  return GrowExtent(cells, reach, whole);
}

namespace
{

/// The cells of an image of `whole` between the nodes of `part`; a flat part has those above it, or
/// the last ones.
Extent CellsBetween(const Extent& part, const Extent& whole)
{
  if (IsEmpty(part))
  {
    return part;
  }
  Extent cells{};
  for (std::size_t first = 0; first < 6; first += 2)
  {
    const std::size_t last = first + 1;
    const int highest = std::max(whole[first], whole[last] - 1);
    cells[first] = std::min(part[first], highest);
    cells[last] = std::max(cells[first], part[last] - 1);
  }
  return cells;
}

/// The elements of `array` in `to`, row by row; it has exactly those in `from`.
void CopyRows(vtkAbstractArray* array, const Extent& from, const Extent& to, vtkAbstractArray* part)
{
  const vtkIdType rowOfAll = from[1] - from[0] + 1;
  const vtkIdType rowsOfAll = from[3] - from[2] + 1;
  const vtkIdType row = to[1] - to[0] + 1;
  SizeArray(part, NodeCount(to));
  vtkIdType next = 0;
  for (int k = to[4]; k <= to[5]; ++k)
  {
    for (int j = to[2]; j <= to[3]; ++j, next += row)
    {
      const vtkIdType start =
        ((k - from[4]) * rowsOfAll + j - from[2]) * rowOfAll + to[0] - from[0];
      part->InsertTuples(next, row, start, array);
    }
  }
}

/// Crops `data` from the elements in `from` to those in `to`. Not by CopyStructuredData or
/// vtkImageData::Crop, which copy value by value.
template <typename Attributes>
void Crop(Attributes* data, const Extent& from, const Extent& to)
{
  vtkNew<Attributes> part;
  part->CopyAllOn();
  part->CopyAllocate(data, NodeCount(to));
  for (int a = 0; a < data->GetNumberOfArrays() && !IsEmpty(to); ++a)
  {
    CopyRows(data->GetAbstractArray(a), from, to, part->GetAbstractArray(a));
  }
  data->ShallowCopy(part);
}

}

void CropTo(vtkImageData* image, const Extent& extent)
{
  Extent from{};
  image->GetExtent(from.data());
  Extent to = Intersection(from, extent);
  if (from == to)
  {
    return;
  }
  if (IsEmpty(to))
  {
    to = { 0, -1, 0, -1, 0, -1 };
  }
  Crop(image->GetPointData(), from, to);
  Crop(image->GetCellData(), CellsBetween(from, from), CellsBetween(to, from));
  image->SetExtent(to.data());
}

}
