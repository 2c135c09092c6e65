#include "Surfaces/GridImages.h"

#include "Core/ArrayMemory.h"
#include "Core/ImageScalars.h"
#include "Core/InnerAlgorithm.h"
#include "Core/MemoryBudget.h"
#include "Core/NamedColumns.h"
#include "Core/PolyDataTriangles.h"
#include "Surfaces/ShellNesting.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace isthmus
{

GridShape GetGridShape(vtkImageData* image)
{
  RequireSpacing(image);
  GridShape shape;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    shape.Dimensions[axis] = image->GetDimensions()[axis];
    shape.Spacing[axis] = image->GetSpacing()[axis];
    if (shape.Dimensions[axis] < 2)
    {
      throw std::invalid_argument(std::string("The grid has a single layer of nodes along ") +
        "xyz"[axis] + ": it must have two or more along each axis.");
    }
  }
  return shape;
}

vtkSmartPointer<vtkPolyData> InGridAxes(vtkPolyData* surface, vtkImageData* grid)
{
  const int* const extent = grid->GetExtent();
  const double* const h = grid->GetSpacing();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  SizePoints(points, surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3], index[3];
    surface->GetPoint(i, x);
    grid->TransformPhysicalPointToContinuousIndex(x, index);
    points->SetPoint(i, (index[0] - extent[0]) * h[0], (index[1] - extent[2]) * h[1],
      (index[2] - extent[4]) * h[2]);
  }
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->SetPoints(points);
  moved->SetPolys(surface->GetPolys());
  moved->SetStrips(surface->GetStrips());
  return moved;
}

PlaceInWorld MakeWorldTransform(vtkImageData* grid)
{
  return [grid](const Point3& place)
  {
    const int* const extent = grid->GetExtent();
    double index[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      index[a] = place[a] / grid->GetSpacing()[a] + extent[2 * a];
    }
    Point3 world;
    grid->TransformContinuousIndexToPhysicalPoint(index, world.data());
    return world;
  };
}

bool ComputePolygonBounds(vtkPolyData* surface, double box[6])
{
  const PolyDataTriangles triangles(surface);
  if (triangles.View().NumberOfTriangles() == 0)
  {
    return false;
  }
  const Bounds3 bounds = ComputeBounds(triangles.View());
  for (std::size_t a = 0; a < 3; ++a)
  {
    box[2 * a] = bounds.Min[a];
    box[2 * a + 1] = bounds.Max[a];
  }
  return true;
}

namespace
{

/// `scalars` in a type that vtkFlyingEdges3D supports: it finds no contour of bits, and takes
/// differences of values in their own type, which wrap around for unsigned int and larger ones.
vtkSmartPointer<vtkDataArray> Contourable(vtkDataArray* scalars)
{
  if (scalars->GetDataType() != VTK_BIT)
  {
    return WideIntegersAsDouble(scalars);
  }
  auto doubles = vtkSmartPointer<vtkDoubleArray>::New();
  SizeArray(doubles, scalars->GetNumberOfTuples());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    doubles->SetValue(i, scalars->GetComponent(i, 0));
  }
  return doubles;
}

}

vtkSmartPointer<vtkPolyData> IsosurfaceInGridAxes(
  vtkImageData* image, vtkDataArray* scalars, double level)
{
  const vtkSmartPointer<vtkDataArray> values = Contourable(scalars);
  vtkNew<vtkImageData> plain;
  plain->SetDimensions(image->GetDimensions());
  plain->SetSpacing(image->GetSpacing());
  plain->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(plain);
  contour->SetValue(0, level);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  UpdateInner(contour);
  return contour->GetOutput();
}

void AddFlags(vtkImageData* output, const char* name, const std::vector<unsigned char>& flags)
{
  AddColumn<vtkUnsignedCharArray>(output->GetPointData(), name, flags);
}

void AddSignedDistance(vtkImageData* output, const std::vector<unsigned char>& inside,
  const std::vector<double>& distance)
{
  AddComputedColumn<vtkDoubleArray>(output->GetPointData(), "SignedDistance", distance.size(),
    [&](std::size_t i) { return inside[i] ? -distance[i] : distance[i]; });
  output->GetPointData()->SetActiveScalars(
    "SignedDistance"); // SetScalars would drop a volume's own
}

void TurnToWorld(vtkMatrix3x3* direction, const std::array<double, 3>& local, double world[3])
{
  direction->MultiplyPoint(local.data(), world);
}

void FillCrossings(
  const std::vector<GridCrossing>& crossings, vtkImageData* grid, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(crossings.size());
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdTypeArray> offsets, corners;
  const auto normals = NamedArray<vtkDoubleArray>("Normals", crossings.size(), 3);
  points->SetDataTypeToDouble();
  SizePoints(points, count);
  SizeArray(corners, count);
  SizeArray(offsets, count + 1); // vtkCellArray creates them if they are missing, and may abort
  const int* const size = grid->GetDimensions();
  const int* const extent = grid->GetExtent();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const GridCrossing& crossing = crossings[static_cast<std::size_t>(i)];
    const std::int64_t row = crossing.Node / size[0];
    const std::int64_t layer = row / size[1];
    double index[3] = { static_cast<double>(extent[0] + crossing.Node % size[0]),
      static_cast<double>(extent[2] + row % size[1]), static_cast<double>(extent[4] + layer) };
    index[crossing.Axis] += crossing.Fraction;
    double position[3], normal[3];
    grid->TransformContinuousIndexToPhysicalPoint(index, position);
    TurnToWorld(grid->GetDirectionMatrix(), crossing.Normal, normal);
    points->SetPoint(i, position);
    normals->SetTuple(i, normal);
    corners->SetValue(i, i);
    offsets->SetValue(i, i);
  }
  offsets->SetValue(count, count);
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(offsets, corners);
  output->SetPoints(points);
  output->SetVerts(vertices);
  vtkPointData* const data = output->GetPointData();
  data->SetNormals(normals);
  AddComputedColumn<vtkIdTypeArray>(
    data, "Node", crossings, [](const GridCrossing& c) { return c.Node; });
  AddComputedColumn<vtkIntArray>(
    data, "Axis", crossings, [](const GridCrossing& c) { return c.Axis; });
  AddComputedColumn<vtkDoubleArray>(
    data, "Fraction", crossings, [](const GridCrossing& c) { return c.Fraction; });
}

}
