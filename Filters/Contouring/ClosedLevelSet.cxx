#include "Contouring/ClosedLevelSet.h"

#include "Core/ArrayMemory.h"
#include "Core/ImageScalars.h"
#include "Core/InnerAlgorithm.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Core/TrilinearField.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace isthmus
{
namespace
{

template <typename T>
std::array<double, 2> FiniteRange(const GridView<const T>& grid)
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::int64_t i = 0; i < grid.Size(); ++i)
  {
    const auto value = static_cast<double>(grid.Data[i]);
    if (!std::isfinite(value))
    {
      throw std::invalid_argument("Value " + std::to_string(i) +
        " of the volume is not a finite number: replace or crop such values first.");
    }
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return { low, high };
}

/// A level set of a mask has a corner at each node, which no triangle resolves.
template <typename T>
void RejectMask(const GridView<const T>& grid, double low, double high)
{
  const bool mask = low < high &&
    std::all_of(grid.Data, grid.Data + grid.Size(),
      [low, high](T value)
      { return static_cast<double>(value) == low || static_cast<double>(value) == high; });
  if (mask)
  {
    throw std::invalid_argument("The volume has only the two values " + FormatNumber(low) +
      " and " + FormatNumber(high) +
      ", so its level sets have a corner at every node and refinement would not end: smooth it "
      "first (Denoise Map, Gaussian sum of Molecular Density), or use Contour.");
  }
}

/// `grid` with a layer of `outside` around it, as an image in the frame of the grid.
template <typename Array, typename T>
vtkSmartPointer<vtkImageData> PadImage(const GridView<const T>& grid, double outside)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const auto& n = grid.Dimensions;
  const auto& h = grid.Spacing;
  image->SetDimensions(
    static_cast<int>(n[0] + 2), static_cast<int>(n[1] + 2), static_cast<int>(n[2] + 2));
  image->SetSpacing(h[0], h[1], h[2]);
  image->SetOrigin(-h[0], -h[1], -h[2]);
  vtkNew<Array> values;
  using Value = typename Array::ValueType;
  SizeArray(values, image->GetNumberOfPoints());
  values->Fill(outside);
  const GridView<Value> wide{ values->GetPointer(0), { n[0] + 2, n[1] + 2, n[2] + 2 }, h };
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        wide(i + 1, j + 1, k + 1) = static_cast<Value>(grid(i, j, k));
      }
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

template <typename T>
GridView<const T> MakeGrid(const T* values, vtkImageData* image)
{
  const int* n = image->GetDimensions();
  const double* h = image->GetSpacing();
  return { values, { n[0], n[1], n[2] }, { h[0], h[1], h[2] } };
}

template <typename T>
ClosedLevelSet Close(const GridView<const T>& grid, double level, bool insideIsHigher)
{
  const auto [low, high] = FiniteRange(grid);
  // The outside value is the extreme inside value mirrored at the level, so that the surface is
  // closed half way between nodes.
  const double outside =
    insideIsHigher ? std::min(low, 2.0 * level - high) : std::max(high, 2.0 * level - low);
  ClosedLevelSet result;
  for (std::size_t a = 0; a < 3; ++a)
  {
    result.Bounds.Min[a] = -grid.Spacing[a];
    result.Bounds.Max[a] = grid.Spacing[a] * static_cast<double>(grid.Dimensions[a]);
  }
  result.Range = { low, high };
  if (insideIsHigher ? high <= level : low >= level)
  {
    return result; // nothing is inside
  }
  RejectMask(grid, low, high);
  result.Field = TrilinearField<T>{ grid, outside };
  // Integers of more than 16 bits are not all numbers of type float.
  constexpr bool isWide = std::is_same_v<T, double> || (std::is_integral_v<T> && sizeof(T) > 2);
  using Array = std::conditional_t<isWide, vtkDoubleArray, vtkFloatArray>;
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(PadImage<Array>(grid, outside));
  edges->SetValue(0, level);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  UpdateInner(edges);
  result.Guide = ToTriangleMesh(edges->GetOutput());
  return result;
}

}

ClosedLevelSet CloseLevelSet(
  vtkImageData* image, vtkDataArray* scalars, double level, bool insideIsHigher)
{
  RequireSpacing(image);
  // GetVoidPointer copies arrays that are not plain into a buffer that they keep.
  const int* n = image->GetDimensions();
  if (n[0] < 2 || n[1] < 2 || n[2] < 2)
  {
    throw std::invalid_argument("The volume has fewer than two nodes along an axis.");
  }
  const void* values = scalars->GetVoidPointer(0);
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(
      return Close(MakeGrid(static_cast<const VTK_TT*>(values), image), level, insideIsHigher));
    default:
      throw std::invalid_argument("The scalars are not numbers.");
  }
}

void ToWorld(vtkImageData* image, TriangleMesh& mesh)
{
  const double* h = image->GetSpacing();
  const int* extent = image->GetExtent();
  for (Point3& p : mesh.Points)
  {
    const Point3 index{ p[0] / h[0] + extent[0], p[1] / h[1] + extent[2], p[2] / h[2] + extent[4] };
    image->TransformContinuousIndexToPhysicalPoint(index.data(), p.data());
  }
  if (image->GetDirectionMatrix()->Determinant() < 0.0)
  {
    for (Triangle& t : mesh.Triangles)
    {
      std::swap(t[1], t[2]);
    }
  }
}

}
