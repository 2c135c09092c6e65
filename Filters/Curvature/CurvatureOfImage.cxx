#include "Curvature/CurvatureOfImage.h"

#include "Core/LargePages.h"
#include "Core/NamedColumns.h"
#include "Core/ParallelFor.h"
#include "Curvature/SurfaceTypeNames.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkTypeTraits.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace isthmus
{
namespace
{

/// `array` itself if its values are contiguous in memory, otherwise a contiguous copy.
vtkSmartPointer<vtkDataArray> Contiguous(vtkDataArray* array)
{
  if (array->HasStandardMemoryLayout() && array->GetDataType() != VTK_BIT)
  {
    return array;
  }
  vtkSmartPointer<vtkDataArray> copy;
  copy.TakeReference(vtkDataArray::CreateDataArray(
    array->GetDataType() == VTK_BIT ? VTK_UNSIGNED_CHAR : array->GetDataType()));
  copy->DeepCopy(array);
  return copy;
}

/// Memory of a new array in the point data, or null if it was not requested.
template <typename T>
T* AddIf(bool wanted, const char* name, int components, vtkIdType tuples, vtkDataSet* output)
{
  if (!wanted)
  {
    return nullptr;
  }
  const auto array = ArrayOfType(vtkTypeTraits<T>::VTK_TYPE_ID, name, tuples, components);
  AdviseLargePages(array.Get());
  output->GetPointData()->AddArray(array);
  return static_cast<T*>(array->GetVoidPointer(0));
}

template <typename T>
CurvatureArrays<T> NewArrays(const CurvatureSelection& wanted, vtkIdType places, vtkDataSet* output)
{
  const auto array = [&](bool on, const char* name, int components = 1)
  { return AddIf<T>(on, name, components, places, output); };
  CurvatureArrays<T> arrays;
  arrays.Gaussian = array(wanted.Gaussian, "GaussianCurvature");
  arrays.Mean = array(wanted.Mean || wanted.Error, "MeanCurvature");
  arrays.Maximum = array(wanted.Maximum, "MaximumCurvature");
  arrays.Minimum = array(wanted.Minimum, "MinimumCurvature");
  arrays.ShapeIndex = array(wanted.ShapeIndex, "ShapeIndex");
  arrays.Curvedness = array(wanted.Curvedness, "Curvedness");
  arrays.Direction1 = array(wanted.Direction1, "PrincipalDirection1", 3);
  arrays.Direction2 = array(wanted.Direction2, "PrincipalDirection2", 3);
  arrays.SurfaceType = AddIf<unsigned char>(wanted.SurfaceType, "SurfaceType", 1, places, output);
  arrays.Normal = array(wanted.Normal, "GaussMap", 3);
  array(wanted.Error, "CurvatureScale");
  arrays.Gradient = array(wanted.Error, "CurvatureError"); // later overwritten by the errors
  arrays.Valid = AddIf<unsigned char>(true, "CurvatureValid", 1, places, output);
  if (wanted.SurfaceType)
  {
    AddSurfaceTypeNames(output->GetFieldData());
  }
  return arrays;
}

template <typename T>
GridView<const T> MakeGridView(vtkImageData* image, const T* values)
{
  GridView<const T> grid;
  grid.Data = values;
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Dimensions[axis] = image->GetDimensions()[axis];
    grid.Spacing[axis] = std::abs(image->GetSpacing()[axis]);
  }
  return grid;
}

/// The image's direction matrix, with the axis of a negative spacing reversed.
std::array<double, 9> GetAxes(vtkImageData* image)
{
  std::array<double, 9> axes{};
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      axes[3 * row + axis] = std::copysign(1.0, image->GetSpacing()[axis]) *
        image->GetDirectionMatrix()->GetElement(row, axis);
    }
  }
  return axes;
}

/// Node positions of points stored as `xyz`, in node units from the first node of the image.
template <typename P>
PointSource MakePointSource(vtkImageData* image, const P* xyz)
{
  std::array<double, 16> m{};
  vtkMatrix4x4::DeepCopy(m.data(), image->GetPhysicalToIndexMatrix());
  for (int axis = 0; axis < 3; ++axis)
  {
    m[4 * axis + 3] -= image->GetExtent()[2 * axis];
  }
  return [m, xyz](std::int64_t first, std::int64_t count, std::array<double, 3>* indices)
  {
    for (std::int64_t i = 0; i < count; ++i)
    {
      const P* p = xyz + 3 * (first + i);
      for (int axis = 0; axis < 3; ++axis)
      {
        const double* row = m.data() + 4 * axis;
        indices[i][axis] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
      }
    }
  };
}

/// Coordinates as floats or doubles, one after the other.
vtkSmartPointer<vtkDataArray> Coordinates(vtkPoints* points)
{
  vtkDataArray* data = points->GetData();
  if (data->GetDataType() == VTK_FLOAT || data->GetDataType() == VTK_DOUBLE)
  {
    return Contiguous(data);
  }
  vtkSmartPointer<vtkDataArray> copy = vtkSmartPointer<vtkDoubleArray>::New();
  copy->DeepCopy(data);
  return copy;
}

NodeBox GetNodeBox(vtkImageData* image, const Extent& extent)
{
  NodeBox nodes;
  for (int axis = 0; axis < 3; ++axis)
  {
    nodes.First[axis] = extent[2 * axis] - image->GetExtent()[2 * axis];
    nodes.Size[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
  }
  return nodes;
}

/// Values of an array in the point data, if it exists.
template <typename T>
T* FindValues(vtkDataSet* output, const char* name)
{
  vtkDataArray* array = output->GetPointData()->GetArray(name);
  return array ? static_cast<T*>(array->GetVoidPointer(0)) : nullptr;
}

PointSource MakePointSource(vtkImageData* image, vtkDataArray* coordinates)
{
  return coordinates->GetDataType() == VTK_FLOAT
    ? MakePointSource(image, static_cast<const float*>(coordinates->GetVoidPointer(0)))
    : MakePointSource(image, static_cast<const double*>(coordinates->GetVoidPointer(0)));
}

constexpr int referenceAccuracy = 4;

/// Mean curvature by differences of fourth order, into `out`; `mean` if there are none.
template <typename T>
void WriteMean(vtkImageData* image, vtkDataArray* scalars, const Extent& box, vtkPoints* points,
  HessianCurvatureOptions options, const ResultType<T>* mean, vtkIdType count, ResultType<T>* out,
  const ProgressCallback& progress)
{
  options.Accuracy = referenceAccuracy;
  std::vector<unsigned char> valid(static_cast<std::size_t>(count));
  CurvatureArrays<ResultType<T>> arrays;
  arrays.Mean = out;
  arrays.Valid = valid.data();
  const vtkSmartPointer<vtkDataArray> values = Contiguous(scalars);
  const auto grid = MakeGridView(image, static_cast<const T*>(values->GetVoidPointer(0)));
  if (points)
  {
    const vtkSmartPointer<vtkDataArray> coordinates = Coordinates(points);
    HessianCurvatureAtPoints(
      grid, count, MakePointSource(image, coordinates), options, arrays, progress);
  }
  else
  {
    HessianCurvatureAtNodes(grid, GetNodeBox(image, box), options, arrays, progress);
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    out[i] = valid[static_cast<std::size_t>(i)] ? out[i] : mean[i];
  }
}

template <typename T>
void WriteErrors(vtkImageData* image, vtkDataArray* scalars, const Extent& box, vtkPoints* points,
  const HessianCurvatureOptions& options, const CurvatureScale& scale, vtkDataSet* output,
  const ProgressCallback& progress)
{
  using Result = ResultType<T>;
  const vtkIdType count = output->GetNumberOfPoints();
  const auto* mean = FindValues<Result>(output, "MeanCurvature");
  const auto* valid = FindValues<unsigned char>(output, "CurvatureValid");
  auto* scales = FindValues<Result>(output, "CurvatureScale");
  auto* errors = FindValues<Result>(output, "CurvatureError");
  std::vector<Result> next(static_cast<std::size_t>(count));
  WriteMean<T>(image, scalars, box, points, options, mean, count, next.data(), progress);
  constexpr std::int64_t grain = 16384;
  ParallelFor(0, count, grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t i = first; i < last; ++i)
      {
        const double change =
          static_cast<double>(mean[i]) - 2.0 * scales[i] + next[static_cast<std::size_t>(i)];
        scales[i] = static_cast<Result>(scale.Scale);
        errors[i] =
          valid[i] ? static_cast<Result>(scale.Error(mean[i], change, errors[i])) : Result(0);
      }
    });
}

}

void AddCurvatureAtNodes(vtkImageData* image, vtkDataArray* scalars, const Extent& box,
  HessianCurvatureOptions options, const CurvatureSelection& selection, vtkDataSet* output,
  const ProgressCallback& progress)
{
  options.Axes = GetAxes(image);
  const NodeBox nodes = GetNodeBox(image, box);
  const vtkIdType count = nodes.Size[0] * nodes.Size[1] * nodes.Size[2];
  const vtkSmartPointer<vtkDataArray> values = Contiguous(scalars);
  switch (values->GetDataType())
  {
    vtkTemplateMacro(HessianCurvatureAtNodes(
      MakeGridView(image, static_cast<const VTK_TT*>(values->GetVoidPointer(0))), nodes, options,
      NewArrays<ResultType<VTK_TT>>(selection, count, output), progress));
  }
}

void AddCurvatureAtPoints(vtkImageData* image, vtkDataArray* scalars, vtkPoints* points,
  HessianCurvatureOptions options, const CurvatureSelection& selection, vtkDataSet* output,
  const ProgressCallback& progress)
{
  options.Axes = GetAxes(image);
  const vtkSmartPointer<vtkDataArray> coordinates = Coordinates(points);
  const PointSource source = MakePointSource(image, coordinates);
  const vtkIdType count = points->GetNumberOfPoints();
  const vtkSmartPointer<vtkDataArray> values = Contiguous(scalars);
  switch (values->GetDataType())
  {
    vtkTemplateMacro(HessianCurvatureAtPoints(
      MakeGridView(image, static_cast<const VTK_TT*>(values->GetVoidPointer(0))), count, source,
      options, NewArrays<ResultType<VTK_TT>>(selection, count, output), progress));
  }
}

CurvatureScale ChooseImageScale(vtkImageData* image, vtkDataArray* scalars, const Extent& whole,
  const double spacing[3], int accuracy, const MaximumOverRanks& combine,
  const ProgressCallback& progress)
{
  const auto choose = [&](auto part)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      part.Whole[axis] = std::int64_t(whole[2 * axis + 1]) - whole[2 * axis] + 1;
      part.First[axis] =
        scalars ? image->GetExtent()[2 * static_cast<int>(axis)] - whole[2 * axis] : 0;
      part.Values.Spacing[axis] = std::abs(spacing[axis]);
    }
    return ChooseCurvatureScale(part, accuracy, combine, progress);
  };
  if (!scalars)
  {
    return choose(GridPart<float>{});
  }
  const vtkSmartPointer<vtkDataArray> values = Contiguous(scalars);
  if (values->GetDataType() == VTK_DOUBLE)
  {
    return choose(
      GridPart<double>{ MakeGridView(image, static_cast<double*>(values->GetVoidPointer(0))) });
  }
  vtkSmartPointer<vtkDataArray> floats = values;
  if (values->GetDataType() != VTK_FLOAT)
  {
    floats = vtkSmartPointer<vtkFloatArray>::New();
    floats->DeepCopy(values);
  }
  return choose(
    GridPart<float>{ MakeGridView(image, static_cast<float*>(floats->GetVoidPointer(0))) });
}

void AddReferenceCurvature(vtkImageData* image, vtkDataArray* scalars, const Extent& box,
  vtkPoints* points, const HessianCurvatureOptions& options, vtkDataSet* output,
  const ProgressCallback& progress)
{
  const vtkSmartPointer<vtkDataArray> values = Contiguous(scalars);
  switch (values->GetDataType())
  {
    vtkTemplateMacro({
      using Result = ResultType<VTK_TT>;
      const auto* mean = FindValues<Result>(output, "MeanCurvature");
      auto* reference =
        FindValues<Result>(output, "CurvatureScale"); // released once the scale is written
      if (options.Accuracy == referenceAccuracy)
      {
        std::copy_n(mean, output->GetNumberOfPoints(), reference);
      }
      else
      {
        WriteMean<VTK_TT>(image, values, box, points, options, mean, output->GetNumberOfPoints(),
          reference, progress);
      }
    });
  }
}

void AddErrors(vtkImageData* image, vtkDataArray* next, const Extent& box, vtkPoints* points,
  const HessianCurvatureOptions& options, const CurvatureSelection& selection,
  const CurvatureScale& scale, vtkDataSet* output, const ProgressCallback& progress)
{
  const vtkSmartPointer<vtkDataArray> values = Contiguous(next);
  switch (values->GetDataType())
  {
    vtkTemplateMacro(
      WriteErrors<VTK_TT>(image, values, box, points, options, scale, output, progress));
  }
  if (!selection.Mean)
  {
    output->GetPointData()->RemoveArray("MeanCurvature");
  }
}

void AddNoCurvature(const CurvatureSelection& selection, vtkDataSet* output)
{
  NewArrays<float>(selection, 0, output);
}

}
