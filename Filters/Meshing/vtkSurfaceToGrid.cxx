#include "vtkSurfaceToGrid.h"

#include "AlgorithmGuard.h"
#include "GridDistance.h"
#include "ImageScalars.h"
#include "LevelCrossings.h"
#include "PolyDataTriangles.h"
#include "SurfaceCrossings.h"

#include <vtkAlgorithmOutput.h>
#include <vtkCellArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSurfaceToGrid);

namespace
{

using isthmus::GridCrossing;
using isthmus::GridShape;
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Nodes a grid may have: more could not be numbered by the extents of a vtkImageData.
constexpr double MostNodesAlongAnAxis = 2147483000.0;

GridShape ShapeOf(vtkImageData* image)
{
  GridShape shape;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    shape.Dimensions[axis] = image->GetDimensions()[axis];
    shape.Spacing[axis] = image->GetSpacing()[axis];
    if (!(shape.Spacing[axis] > 0.0))
    {
      throw std::invalid_argument("The grid has the spacing " +
        std::to_string(shape.Spacing[axis]) + " along " + "xyz"[axis] +
        ", but spacings must be positive.");
    }
    if (shape.Dimensions[axis] < 2)
    {
      throw std::invalid_argument(std::string("The grid has a single layer of nodes along ") +
        "xyz"[axis] + ": it must have two or more along each axis.");
    }
  }
  return shape;
}

/// The surface with its points in lengths along the grid's axes from the grid's first node.
vtkSmartPointer<vtkPolyData> InGridAxes(vtkPolyData* surface, vtkImageData* grid)
{
  const int* const extent = grid->GetExtent();
  const double* const h = grid->GetSpacing();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(surface->GetNumberOfPoints());
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

/// The image's isosurface, in lengths along its axes from its first node.
vtkSmartPointer<vtkPolyData> IsosurfaceInGridAxes(
  vtkImageData* image, vtkDataArray* scalars, double level)
{
  vtkNew<vtkImageData> plain;
  plain->SetDimensions(image->GetDimensions());
  plain->SetSpacing(image->GetSpacing());
  plain->GetPointData()->SetScalars(scalars);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(plain);
  contour->SetValue(0, level);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

void AddFlags(vtkImageData* output, const char* name, const std::vector<unsigned char>& flags)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(flags.size()));
  std::copy(flags.begin(), flags.end(), array->GetPointer(0));
  output->GetPointData()->AddArray(array);
}

void AddSignedDistance(vtkImageData* output, const std::vector<unsigned char>& inside,
  const std::vector<double>& distance)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("SignedDistance");
  array->SetNumberOfValues(static_cast<vtkIdType>(distance.size()));
  std::transform(distance.begin(), distance.end(), inside.begin(), array->GetPointer(0),
    [](double value, unsigned char isInside) { return isInside ? -value : value; });
  output->GetPointData()->AddArray(array);
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
  vtkNew<vtkDoubleArray> normals, fractions;
  vtkNew<vtkIdTypeArray> nodes, offsets, corners;
  vtkNew<vtkIntArray> axes;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  fractions->SetName("Fraction");
  fractions->SetNumberOfValues(count);
  nodes->SetName("Node");
  nodes->SetNumberOfValues(count);
  axes->SetName("Axis");
  axes->SetNumberOfValues(count);
  corners->SetNumberOfValues(count);
  const int* const size = grid->GetDimensions();
  const int* const extent = grid->GetExtent();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const GridCrossing& crossing = crossings[static_cast<std::size_t>(i)];
    const std::int64_t row = crossing.Node / size[0];
    double index[3] = { static_cast<double>(extent[0] + crossing.Node % size[0]),
      static_cast<double>(extent[2] + row % size[1]),
      static_cast<double>(extent[4] + row / size[1]) };
    index[crossing.Axis] += crossing.Fraction;
    double position[3], normal[3];
    grid->TransformContinuousIndexToPhysicalPoint(index, position);
    TurnToWorld(grid->GetDirectionMatrix(), crossing.Normal, normal);
    points->SetPoint(i, position);
    normals->SetTuple(i, normal);
    fractions->SetValue(i, crossing.Fraction);
    nodes->SetValue(i, crossing.Node);
    axes->SetValue(i, crossing.Axis);
    corners->SetValue(i, i);
  }
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(1, corners);
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->AddArray(nodes);
  output->GetPointData()->AddArray(axes);
  output->GetPointData()->AddArray(fractions);
}

}

vtkSurfaceToGrid::vtkSurfaceToGrid()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkSurfaceToGrid::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkSurfaceToGrid::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkImageData" : "vtkPolyData");
  return 1;
}

void vtkSurfaceToGrid::GridAround(vtkPolyData* surface, vtkImageData* grid)
{
  if (!(this->Spacing >= 0.0) || std::isinf(this->Spacing))
  {
    throw std::invalid_argument("Spacing is " + std::to_string(this->Spacing) +
      ", but it is a length: give a positive one, or 0 for 1/64 of the surface's longest side.");
  }
  double box[6];
  surface->GetBounds(box);
  const double longest = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
  const double h = this->Spacing > 0.0 ? this->Spacing : longest / 64.0;
  if (!(h > 0.0) || std::isinf(h))
  {
    throw std::invalid_argument("The surface has no size, or not a finite one, so there is no grid "
                                "around it: give an image.");
  }
  int size[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double nodes =
      std::ceil((box[2 * axis + 1] - box[2 * axis]) / h) + 1.0 + 2.0 * this->Padding;
    if (nodes > MostNodesAlongAnAxis)
    {
      throw std::invalid_argument("A Spacing of " + std::to_string(h) +
        " would make more than 2^31 nodes along an axis: choose a larger one.");
    }
    size[axis] = std::max(2, static_cast<int>(nodes));
  }
  const double pad = this->Padding * h;
  grid->SetDimensions(size);
  grid->SetOrigin(box[0] - pad, box[2] - pad, box[4] - pad);
  grid->SetSpacing(h, h, h);
}

int vtkSurfaceToGrid::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkInformation* gridInfo = inputVector[1]->GetInformationObject(0);
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  if (vtkImageData::GetData(info))
  {
    gridInfo = info;
  }
  if (gridInfo)
  {
    outInfo->CopyEntry(gridInfo, Pipeline::WHOLE_EXTENT());
    outInfo->CopyEntry(gridInfo, vtkDataObject::ORIGIN());
    outInfo->CopyEntry(gridInfo, vtkDataObject::SPACING());
    outInfo->CopyEntry(gridInfo, vtkDataObject::DIRECTION());
    return 1;
  }
  // The extent of the grid has to be told now, and it is that of the surface: so make the surface.
  this->GetInputAlgorithm(0, 0)->Update(this->GetInputConnection(0, 0)->GetIndex());
  vtkPolyData* surface = vtkPolyData::GetData(info);
  vtkNew<vtkImageData> grid;
  grid->SetExtent(0, -1, 0, -1, 0, -1);
  const int result = isthmus::Guarded(this, grid,
    [&]()
    {
      if (surface && surface->GetNumberOfPoints() > 0)
      {
        this->GridAround(surface, grid);
      }
    });
  outInfo->Set(Pipeline::WHOLE_EXTENT(), grid->GetExtent(), 6);
  outInfo->Set(vtkDataObject::ORIGIN(), grid->GetOrigin(), 3);
  outInfo->Set(vtkDataObject::SPACING(), grid->GetSpacing(), 3);
  return result;
}

int vtkSurfaceToGrid::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Even-odd counting and distances need all of the grid and of the volume.
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* info = inputVector[port]->GetInformationObject(0);
    if (info && info->Has(Pipeline::WHOLE_EXTENT()))
    {
      int whole[6];
      info->Get(Pipeline::WHOLE_EXTENT(), whole);
      info->Set(Pipeline::UPDATE_EXTENT(), whole, 6);
    }
  }
  return 1;
}

int vtkSurfaceToGrid::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector, 0);
  vtkPolyData* crossings = vtkPolyData::GetData(outputVector, 1);
  output->Initialize();
  crossings->Initialize();
  const int result = isthmus::Guarded(this, output,
    [&]()
    {
      if (auto* image = vtkImageData::GetData(inputVector[0], 0))
      {
        output->ShallowCopy(image);
        if (image->GetNumberOfPoints() > 0)
        {
          this->FromImage(image, output, crossings);
        }
        return;
      }
      auto* surface = vtkPolyData::GetData(inputVector[0], 0);
      if (auto* grid = vtkImageData::GetData(inputVector[1], 0))
      {
        output->CopyStructure(grid);
      }
      else if (surface->GetNumberOfPoints() > 0)
      {
        this->GridAround(surface, output);
      }
      if (output->GetNumberOfPoints() > 0)
      {
        this->FromSurface(surface, output, crossings);
      }
    });
  if (output->GetNumberOfPoints() == 0)
  {
    crossings->Initialize();
  }
  return result;
}

void vtkSurfaceToGrid::FromSurface(
  vtkPolyData* surface, vtkImageData* output, vtkPolyData* crossings)
{
  const GridShape shape = ShapeOf(output);
  const isthmus::PolyDataTriangles triangles(InGridAxes(surface, output));
  const isthmus::SurfaceView mesh = triangles.View();
  const auto progress = isthmus::ProgressOf(this);
  const auto found = isthmus::SurfaceCrossings(mesh, shape,
    static_cast<isthmus::CrossingNormal>(this->NormalMode), isthmus::Between(progress, 0.05, 0.2));
  FillCrossings(found, output, crossings);
  if (!this->GenerateInside && !this->GenerateSignedDistance)
  {
    return;
  }
  const auto inside = isthmus::NodesInside(mesh, shape);
  isthmus::Report(progress, 0.3);
  if (this->GenerateInside)
  {
    AddFlags(output, "Inside", inside);
    AddFlags(output, "Irregular", isthmus::IrregularNodes(inside, shape));
  }
  if (this->GenerateSignedDistance)
  {
    const double h = *std::max_element(shape.Spacing.begin(), shape.Spacing.end());
    AddSignedDistance(output, inside,
      isthmus::DistanceToSurface(
        mesh, shape, this->BandWidth * h, isthmus::Between(progress, 0.35, 1.0)));
  }
}

void vtkSurfaceToGrid::FromImage(vtkImageData* image, vtkImageData* output, vtkPolyData* crossings)
{
  const GridShape shape = ShapeOf(image);
  vtkDataArray* scalars = isthmus::ChosenScalars(this, image);
  const auto progress = isthmus::ProgressOf(this);
  std::vector<unsigned char> inside(static_cast<std::size_t>(shape.Size()));
  isthmus::UseScalars(image, scalars,
    [&](const auto& grid)
    {
      using T = std::remove_const_t<std::remove_pointer_t<decltype(grid.Data)>>;
      const isthmus::LevelView<T> level{ grid, this->IsoValue, this->InsideIsHigher != 0 };
      isthmus::CheckFinite(grid);
      std::transform(grid.Data, grid.Data + shape.Size(), inside.begin(),
        [&](T value) { return level.IsInside(static_cast<double>(value)); });
      std::vector<GridCrossing> found;
      for (std::int64_t k = 0; k < shape.Dimensions[2]; ++k)
      {
        isthmus::AppendLevelCrossings(level, k, found);
        isthmus::Report(
          progress, 0.3 * static_cast<double>(k) / static_cast<double>(shape.Dimensions[2]));
      }
      FillCrossings(found, image, crossings);
    });
  if (this->GenerateInside)
  {
    AddFlags(output, "Inside", inside);
    AddFlags(output, "Irregular", isthmus::IrregularNodes(inside, shape));
  }
  if (this->GenerateSignedDistance)
  {
    const isthmus::PolyDataTriangles triangles(
      IsosurfaceInGridAxes(image, scalars, this->IsoValue));
    const double h = *std::max_element(shape.Spacing.begin(), shape.Spacing.end());
    AddSignedDistance(output, inside,
      isthmus::DistanceToSurface(
        triangles.View(), shape, this->BandWidth * h, isthmus::Between(progress, 0.35, 1.0)));
  }
}

vtkPolyData* vtkSurfaceToGrid::GetCrossings()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

void vtkSurfaceToGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Padding: " << this->Padding << "\n";
  os << indent << "IsoValue: " << this->IsoValue << "\n";
  os << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n";
  os << indent << "NormalMode: " << this->NormalMode << "\n";
  os << indent << "GenerateInside: " << this->GenerateInside << "\n";
  os << indent << "GenerateSignedDistance: " << this->GenerateSignedDistance << "\n";
  os << indent << "BandWidth: " << this->BandWidth << "\n";
}
