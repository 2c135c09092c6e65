#include "Curvature/CurvatureOfImage.h"

#include "Core/ArrayMemory.h"
#include "Core/LargePages.h"
#include "Curvature/SurfaceTypeNames.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkTypeTraits.h>

#include <cmath>

namespace isthmus
{
namespace
{

/// `array` itself if its values lie one after the other in memory, else such a copy.
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

/// Memory of a new array in the point data, or null where it isn't wanted.
template <typename T>
T* NewArray(bool wanted, const char* name, int components, vtkIdType tuples, vtkDataSet* output)
{
  if (!wanted)
  {
    return nullptr;
  }
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(vtkTypeTraits<T>::VTK_TYPE_ID));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  SizeArray(array, tuples);
  AdviseLargePages(array.Get());
  output->GetPointData()->AddArray(array);
  return static_cast<T*>(array->GetVoidPointer(0));
}

template <typename T>
CurvatureArrays<T> NewArrays(const CurvatureSelection& wanted, vtkIdType places, vtkDataSet* output)
{
  const auto array = [&](bool on, const char* name, int components = 1)
  { return NewArray<T>(on, name, components, places, output); };
  CurvatureArrays<T> arrays;
  arrays.Gaussian = array(wanted.Gaussian, "GaussianCurvature");
  arrays.Mean = array(wanted.Mean, "MeanCurvature");
  arrays.Maximum = array(wanted.Maximum, "MaximumCurvature");
  arrays.Minimum = array(wanted.Minimum, "MinimumCurvature");
  arrays.ShapeIndex = array(wanted.ShapeIndex, "ShapeIndex");
  arrays.Curvedness = array(wanted.Curvedness, "Curvedness");
  arrays.Direction1 = array(wanted.Direction1, "PrincipalDirection1", 3);
  arrays.Direction2 = array(wanted.Direction2, "PrincipalDirection2", 3);
  arrays.SurfaceType =
    NewArray<unsigned char>(wanted.SurfaceType, "SurfaceType", 1, places, output);
  arrays.Valid = NewArray<unsigned char>(true, "CurvatureValid", 1, places, output);
  if (wanted.SurfaceType)
  {
    AddSurfaceTypeNames(output->GetFieldData());
  }
  return arrays;
}

template <typename T>
GridView<const T> ViewOf(vtkImageData* image, const T* values)
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

/// The image's direction matrix, with the axis of a negative spacing turned round.
std::array<double, 9> AxesOf(vtkImageData* image)
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
PointSource SourceOf(vtkImageData* image, const P* xyz)
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

PointSource SourceOf(vtkImageData* image, vtkDataArray* coordinates)
{
  return coordinates->GetDataType() == VTK_FLOAT
    ? SourceOf(image, static_cast<const float*>(coordinates->GetVoidPointer(0)))
    : SourceOf(image, static_cast<const double*>(coordinates->GetVoidPointer(0)));
}

}

void AddCurvatureAtNodes(vtkImageData* image, vtkDataArray* scalars, const Extent& box,
  HessianCurvatureOptions options, const CurvatureSelection& selection, vtkDataSet* output,
  const ProgressCallback& progress)
{
  options.Axes = AxesOf(image);
  NodeBox nodes;
  for (int axis = 0; axis < 3; ++axis)
  {
    nodes.First[axis] = box[2 * axis] - image->GetExtent()[2 * axis];
    nodes.Size[axis] = box[2 * axis + 1] - box[2 * axis] + 1;
  }
  const vtkIdType count = nodes.Size[0] * nodes.Size[1] * nodes.Size[2];
  const vtkSmartPointer<vtkDataArray> values = Contiguous(scalars);
  switch (values->GetDataType())
  {
    vtkTemplateMacro(
      HessianCurvatureAtNodes(ViewOf(image, static_cast<const VTK_TT*>(values->GetVoidPointer(0))),
        nodes, options, NewArrays<ResultType<VTK_TT>>(selection, count, output), progress));
  }
}

void AddCurvatureAtPoints(vtkImageData* image, vtkDataArray* scalars, vtkPoints* points,
  HessianCurvatureOptions options, const CurvatureSelection& selection, vtkDataSet* output,
  const ProgressCallback& progress)
{
  options.Axes = AxesOf(image);
  const vtkSmartPointer<vtkDataArray> coordinates = Coordinates(points);
  const PointSource source = SourceOf(image, coordinates);
  const vtkIdType count = points->GetNumberOfPoints();
  const vtkSmartPointer<vtkDataArray> values = Contiguous(scalars);
  switch (values->GetDataType())
  {
    vtkTemplateMacro(
      HessianCurvatureAtPoints(ViewOf(image, static_cast<const VTK_TT*>(values->GetVoidPointer(0))),
        count, source, options, NewArrays<ResultType<VTK_TT>>(selection, count, output), progress));
  }
}

void AddNoCurvature(const CurvatureSelection& selection, vtkDataSet* output)
{
  NewArrays<float>(selection, 0, output);
}

}
