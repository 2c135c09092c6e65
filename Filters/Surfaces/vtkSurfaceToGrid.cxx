#include "vtkSurfaceToGrid.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/MemoryBudget.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/PipelineInputs.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"
#include "Surfaces/GridDistance.h"
#include "Surfaces/GridImages.h"
#include "Surfaces/LevelCrossings.h"
#include "Surfaces/SurfaceCleaning.h"
#include "Surfaces/SurfaceCrossings.h"

#include <vtkDataSetAttributes.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSurfaceToGrid);

namespace
{

using isthmus::GridCrossing;
using isthmus::GridShape;
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Memory of the arrays of the output and of the distance while it is computed.
constexpr double BytesPerNode = 45.0;

/// Nodes a grid may have: more could not be numbered by the extents of a vtkImageData.
constexpr double MostNodesAlongAnAxis = 2147483000.0;

}

const std::vector<isthmus::OutputArray>& vtkSurfaceToGrid::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Inside", 1, "", ArrayChoice::On, "1 inside, 0 outside" },
    { 0, ArrayPlace::Points, "Irregular", 1, "", ArrayChoice::On,
      "1 for nodes with one of their six neighbours on the other side" },
    { 0, ArrayPlace::Points, "SignedDistance", 1, "length", ArrayChoice::On, "negative inside" },
    { 1, ArrayPlace::Points, "Normals", 3, "", ArrayChoice::None,
      "unit; outwards for volumes, on the side from which triangles are counter-clockwise for "
      "surfaces" },
    { 1, ArrayPlace::Points, "Node", 1, "", ArrayChoice::None,
      "id of the node below the crossing on its line" },
    { 1, ArrayPlace::Points, "Axis", 1, "", ArrayChoice::None,
      "0, 1, 2: the line is along x, y, z of the grid" },
    { 1, ArrayPlace::Points, "Fraction", 1, "", ArrayChoice::None,
      "part of the spacing from that node" },
  };
  return table;
}

vtkSurfaceToGrid::vtkSurfaceToGrid()
  : OutputArrays(this, OutputArrayTable())
  , Advance(std::make_unique<isthmus::InputInAdvance>(this))
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkSurfaceToGrid::~vtkSurfaceToGrid() = default;

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

void vtkSurfaceToGrid::CheckParameters() const
{
  isthmus::RequireRange("Spacing", this->Spacing, 0.0, isthmus::Unlimited,
    "It is a length; 0 stands for 1/64 of the surface's longest side.");
  isthmus::RequireRange("Padding", this->Padding, 0, 10000);
  isthmus::RequireRange(
    "Level", this->Level, -isthmus::Unlimited, isthmus::Unlimited, "It is a value of the volume.");
  isthmus::RequireChoice<int>("NormalMode", this->NormalMode, PointNormals);
  isthmus::RequireRange("BandWidth", this->BandWidth, 1.0, 1000.0, "It is in grid spacings.");
}

void vtkSurfaceToGrid::GridAround(vtkPolyData* surface, vtkImageData* grid)
{
  this->CheckParameters();
  double box[6];
  if (!isthmus::ComputePolygonBounds(surface, box))
  {
    surface->GetBounds(box); // vertices and lines
  }
  const double longest = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
  const double h = this->Spacing > 0.0 ? this->Spacing : longest / 64.0;
  if (!(h > 0.0) || std::isinf(h))
  {
    throw std::invalid_argument(
      "The surface has no finite size, so there is no grid around it: connect an image.");
  }
  int size[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double nodes =
      std::ceil((box[2 * axis + 1] - box[2 * axis]) / h) + 1.0 + 2.0 * this->Padding;
    if (nodes > MostNodesAlongAnAxis)
    {
      throw std::invalid_argument("A Spacing of " + isthmus::FormatNumber(h) +
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
  // The extent of the grid must be reported now, and depends on the surface, so it is updated.
  this->Advance->Update();
  isthmus::SetImageInformation(outInfo,
    [&](vtkImageData* grid)
    {
      const auto surface =
        isthmus::GatherSurface(this, vtkPolyData::GetData(info), isthmus::GatherOn::EachRank);
      if (surface &&
        surface->GetNumberOfPoints() >
          0) // otherwise empty, or blocks that are processed one by one
      {
        this->GridAround(surface, grid);
      }
    });
  return 1;
}

int vtkSurfaceToGrid::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Even-odd counting and distances need all of the grid and of the volume.
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* info = inputVector[port]->GetInformationObject(0);
    // Not of a surface, whose pieces are put together here.
    if (info && vtkImageData::GetData(info) && info->Has(Pipeline::WHOLE_EXTENT()))
    {
      int whole[6];
      info->Get(Pipeline::WHOLE_EXTENT(), whole);
      info->Set(Pipeline::UPDATE_EXTENT(), whole, 6);
      isthmus::RequestAll(info);
    }
  }
  return 1;
}

/// If the surface is not closed, tries again with the cracks between its facets closed.
void vtkSurfaceToGrid::FromSurfaceOrJoined(
  vtkPolyData* surface, vtkImageData* output, vtkPolyData* crossings)
{
  try
  {
    this->FromSurface(surface, output, crossings);
  }
  catch (const std::invalid_argument&)
  {
    isthmus::CleanedSurface cleaned = isthmus::CleanSurface(isthmus::ToTriangleMesh(surface));
    if (cleaned.Message.empty())
    {
      throw;
    }
    vtkNew<vtkPolyData> joined;
    isthmus::SetMesh(cleaned.Mesh, joined);
    vtkWarningMacro(<< cleaned.Message);
    crossings->Initialize();
    this->FromSurface(joined, output, crossings);
  }
}

int vtkSurfaceToGrid::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector, 0);
  vtkPolyData* crossings = vtkPolyData::GetData(outputVector, 1);
  isthmus::ClearOutputs(outputVector);
  const int result = isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      this->CheckParameters();
      this->OutputArrays.Check();
      isthmus::RequireWholeExtent(inputVector[0]->GetInformationObject(0));
      isthmus::RequireWholeExtent(inputVector[1]->GetInformationObject(0));
      if (auto* image = vtkImageData::GetData(inputVector[0], 0))
      {
        output->ShallowCopy(image);
        if (image->GetNumberOfPoints() > 0)
        {
          this->FromImage(image, output, crossings);
        }
        return;
      }
      const auto surface = isthmus::GatherSurface(
        this, vtkPolyData::GetData(inputVector[0], 0), isthmus::GatherOn::EachRank);
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
        this->FromSurfaceOrJoined(surface, output, crossings);
      }
    });
  if (output->GetNumberOfPoints() == 0 || !isthmus::OnFirstRank())
  {
    crossings->Initialize();
  }
  if (isthmus::NumberOfRanks() > 1 && output->GetNumberOfPoints() > 0)
  {
    // All ranks have all of the grid: each keeps its piece.
    isthmus::Extent all{};
    output->GetExtent(all.data());
    isthmus::CropTo(output, isthmus::GetPieceExtent(outputVector->GetInformationObject(0), all));
  }
  return result;
}

void vtkSurfaceToGrid::FromSurface(
  vtkPolyData* surface, vtkImageData* output, vtkPolyData* crossings)
{
  const GridShape shape = isthmus::GetGridShape(output);
  isthmus::MemoryBudget().RequireGrid(
    shape.Dimensions, BytesPerNode, "choose a larger Spacing or a coarser grid");
  const isthmus::PolyDataTriangles triangles(isthmus::InGridAxes(surface, output));
  const isthmus::SurfaceView mesh = triangles.View();
  const auto progress = isthmus::MakeProgress(this);
  auto found = isthmus::SurfaceCrossings(mesh, shape,
    static_cast<isthmus::CrossingNormal>(this->NormalMode), isthmus::Between(progress, 0.05, 0.2));
  if (output->GetDirectionMatrix()->Determinant() < 0.0)
  {
    // In a mirrored frame, counter-clockwise triangles are clockwise.
    for (GridCrossing& crossing : found)
    {
      for (double& component : crossing.Normal)
      {
        component = -component;
      }
    }
  }
  isthmus::FillCrossings(found, output, crossings);
  if (!this->OutputArrays.HasAny({ "Inside", "Irregular", "SignedDistance" }))
  {
    return;
  }
  const auto inside = isthmus::NodesInside(mesh, shape, isthmus::MakeWorldTransform(output));
  isthmus::Report(progress, 0.3);
  if (this->OutputArrays.Has("Inside"))
  {
    isthmus::AddFlags(output, "Inside", inside);
  }
  if (this->OutputArrays.Has("Irregular"))
  {
    isthmus::AddFlags(output, "Irregular", isthmus::IrregularNodes(inside, shape));
  }
  if (this->OutputArrays.Has("SignedDistance"))
  {
    isthmus::AddSignedDistance(
      output, inside, this->Distance(mesh, shape, isthmus::Between(progress, 0.35, 1.0)));
  }
}

std::vector<double> vtkSurfaceToGrid::Distance(const isthmus::SurfaceView& mesh,
  const GridShape& shape, const isthmus::ProgressCallback& progress)
{
  const double h = *std::max_element(shape.Spacing.begin(), shape.Spacing.end());
  return this->ExactEverywhere
    ? isthmus::ExactDistanceToSurface(mesh, shape, progress)
    : isthmus::DistanceToSurface(mesh, shape, this->BandWidth * h, progress);
}

void vtkSurfaceToGrid::FromImage(vtkImageData* image, vtkImageData* output, vtkPolyData* crossings)
{
  const GridShape shape = isthmus::GetGridShape(image);
  isthmus::MemoryBudget().RequireGrid(
    shape.Dimensions, BytesPerNode, "crop or subsample the volume");
  vtkSmartPointer<vtkDataArray> scalars = isthmus::ChosenScalars(this, image);
  if (scalars->GetDataType() == VTK_BIT) // VTK computes neither range nor contour of bit arrays
  {
    const auto bytes =
      isthmus::ArrayOfType(VTK_UNSIGNED_CHAR, scalars->GetName(), scalars->GetNumberOfTuples());
    for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
    {
      bytes->SetComponent(i, 0, scalars->GetComponent(i, 0));
    }
    scalars = bytes;
  }
  double range[2];
  scalars->GetFiniteRange(range);
  if (!(range[0] < this->Level && this->Level < range[1]))
  {
    vtkWarningMacro(<< isthmus::JoinText("There is no surface at Level ", this->Level,
                      ", so SignedDistance is infinite: the volume has values from ", range[0],
                      " to ", range[1], ". Choose a level between these."));
  }
  const auto progress = isthmus::MakeProgress(this);
  std::vector<unsigned char> inside(static_cast<std::size_t>(shape.Size()));
  isthmus::UseScalars(image, scalars,
    [&](const auto& grid)
    {
      using T = std::remove_const_t<std::remove_pointer_t<decltype(grid.Data)>>;
      const isthmus::LevelView<T> level{ grid, this->Level, this->InsideIsHigher };
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
      isthmus::FillCrossings(found, image, crossings);
    });
  if (this->OutputArrays.Has("Inside"))
  {
    isthmus::AddFlags(output, "Inside", inside);
  }
  if (this->OutputArrays.Has("Irregular"))
  {
    isthmus::AddFlags(output, "Irregular", isthmus::IrregularNodes(inside, shape));
  }
  if (this->OutputArrays.Has("SignedDistance"))
  {
    const isthmus::PolyDataTriangles triangles(
      isthmus::IsosurfaceInGridAxes(image, scalars, this->Level));
    isthmus::AddSignedDistance(output, inside,
      this->Distance(triangles.View(), shape, isthmus::Between(progress, 0.35, 1.0)));
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
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n";
  os << indent << "NormalMode: " << this->NormalMode << "\n";
  this->OutputArrays.Print(os, indent);
  os << indent << "BandWidth: " << this->BandWidth << "\n";
  os << indent << "ExactEverywhere: " << this->ExactEverywhere << "\n";
}
