#include "Core/ImageCrop.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>

namespace isthmus
{
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

/// The elements of `array` in `to`, row by row; those in `from` are all it has.
void CopyRows(vtkAbstractArray* array, const Extent& from, const Extent& to, vtkAbstractArray* part)
{
  const vtkIdType rowOfAll = from[1] - from[0] + 1;
  const vtkIdType rowsOfAll = from[3] - from[2] + 1;
  const vtkIdType row = to[1] - to[0] + 1;
  part->SetNumberOfTuples(NodeCount(to));
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

/// Makes `data`, of the elements in `from`, that of the elements in `to`. By hand, since
/// CopyStructuredData goes value by value, as vtkImageData::Crop does.
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
