#include "vtkDualContouring.h"

#include "Contouring/AutomaticLevel.h"
#include "Contouring/ClosedLevelSet.h"
#include "Contouring/DualContouring.h"
#include "Contouring/ENOCrossings.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ArrayMemory.h"
#include "Core/GatherRanks.h"
#include "Core/Geometry.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/MemoryBudget.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"

#include <vtkCellArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkDualContouring);

const std::vector<isthmus::OutputArray>& vtkDualContouring::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Field, "Level", 1, "of the scalars", ArrayChoice::None,
      "the level used; of an image" },
    { 0, ArrayPlace::Field, "LevelSource", 1, "", ArrayChoice::None,
      "where the level is from, as text; of an image" },
  };
  return table;
}

namespace
{

using isthmus::operator+;
using isthmus::operator-;

template <typename T>
isthmus::HermiteGrid MakeHermiteGrid(
  const isthmus::LevelView<T>& level, const isthmus::ProgressCallback& progress)
{
  isthmus::CheckFinite(level.Grid);
  isthmus::HermiteGrid grid;
  grid.Shape = { level.Grid.Dimensions, level.Grid.Spacing };
  grid.Inside.resize(static_cast<std::size_t>(level.Grid.Size()));
  std::transform(level.Grid.Data, level.Grid.Data + level.Grid.Size(), grid.Inside.begin(),
    [&level](T value) { return level.IsInside(static_cast<double>(value)) ? 1 : 0; });
  std::vector<std::vector<isthmus::GridCrossing>> layers(
    static_cast<std::size_t>(level.Grid.Dimensions[2]));
  isthmus::ParallelFor(
    0, level.Grid.Dimensions[2], 4,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        isthmus::AppendENOCrossings(level, k, layers[static_cast<std::size_t>(k)]);
      }
    },
    progress);
  for (const auto& layer : layers)
  {
    grid.Crossings.insert(grid.Crossings.end(), layer.begin(), layer.end());
  }
  return grid;
}

/// Edges of a grid with this spacing that a surface crosses: its area in projection along each
/// axis. Exact on average over shifts of the grid.
double ExpectedCrossings(const isthmus::SurfaceView& surface, double spacing)
{
  double area = 0.0;
  for (const isthmus::Triangle& t : surface.Triangles)
  {
    const isthmus::Point3& p = surface.Point(t[0]);
    const isthmus::Point3 n = isthmus::Cross(surface.Point(t[1]) - p, surface.Point(t[2]) - p);
    area += 0.5 * (std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]));
  }
  return area / (spacing * spacing);
}

/// A surface in the frame of a grid that extends two layers beyond it.
struct MovedSurface
{
  std::vector<isthmus::Point3> Points;
  isthmus::SurfaceView View;
  isthmus::GridShape Shape;
  isthmus::Point3 Origin;
};

MovedSurface Move(const isthmus::SurfaceView& surface, double spacing)
{
  isthmus::RequireRange("Spacing", spacing, 0.0, isthmus::Unlimited,
    "It is a length; 0 stands for 1/64 of the longest side.");
  const isthmus::Point3& first = surface.Point(surface.Corners(0)[0]);
  isthmus::Bounds3 box{ first, first };
  for (const isthmus::Triangle& corners : surface.Triangles)
  {
    for (const vtkIdType point : corners)
    {
      box.Add(surface.Point(point));
    }
  }
  const isthmus::Point3 size = box.Max - box.Min;
  const double h = spacing > 0.0 ? spacing : *std::max_element(size.begin(), size.end()) / 64.0;
  constexpr double mostNodes = 2e9;
  double nodes = 1.0;
  MovedSurface moved;
  for (std::size_t a = 0; a < 3; ++a)
  {
    // Shifted by part of a spacing, so that flat sides do not coincide with nodes.
    constexpr double layers = 2.37;
    moved.Origin[a] = box.Min[a] - layers * h;
    const double count = std::ceil(size[a] / h + 2.0 * layers) + 1.0;
    nodes *= count;
    moved.Shape.Dimensions[a] = count < mostNodes ? static_cast<std::int64_t>(count) : 0;
    moved.Shape.Spacing[a] = h;
  }
  if (!(h > 0.0) || !(nodes < mostNodes))
  {
    throw std::invalid_argument("The surface has no size, or the spacing results in more than two "
                                "thousand million nodes: choose a larger spacing.");
  }
  // Measured on a torus with 4e4 to 1e6 crossed cells: 650 bytes per crossing, 900 with Tolerance
  // and FreeOfCrossings, and 1 byte per node.
  constexpr double bytesPerNode = 3.0;
  constexpr double bytesPerCrossing = 1000.0;
  isthmus::MemoryBudget().Require(
    bytesPerNode * nodes + bytesPerCrossing * ExpectedCrossings(surface, h),
    "A grid with a Spacing of " + isthmus::FormatNumber(h), "choose a larger Spacing");
  moved.Points = isthmus::TranslatedPoints(moved.Origin, surface);
  moved.View = { moved.Points, surface.Triangles };
  return moved;
}

isthmus::HermiteGrid MakeHermiteGrid(
  const MovedSurface& moved, double featureThreshold, const isthmus::ProgressCallback& progress)
{
  isthmus::HermiteGrid grid;
  grid.Shape = moved.Shape;
  grid.Crossings = isthmus::SurfaceCrossings(
    moved.View, moved.Shape, isthmus::CrossingNormal::Triangles, progress);
  grid.Inside = isthmus::NodesInside(
    moved.View, moved.Shape, [&moved](const isthmus::Point3& p) { return p + moved.Origin; });
  grid.Sharp =
    isthmus::FindSharpEdges(moved.View, isthmus::SharpCosine(std::max(0.07, featureThreshold)));
  return grid;
}

isthmus::DualContour ComputeContour(vtkImageData* image, vtkDataArray* scalars, double value,
  bool insideIsHigher, isthmus::DualContouringParameters parameters,
  const isthmus::ProgressCallback& progress)
{
  parameters.ToWorld = [image](std::vector<isthmus::Point3>& points)
  {
    isthmus::TriangleMesh mesh{ std::move(points), {} };
    isthmus::ToWorld(image, mesh);
    points = std::move(mesh.Points);
  };
  isthmus::DualContour contour;
  isthmus::UseScalars(image, scalars,
    [&](const auto& grid)
    {
      using T = std::remove_const_t<std::remove_pointer_t<decltype(grid.Data)>>;
      const isthmus::LevelView<T> level{ grid, value, insideIsHigher };
      contour =
        isthmus::DualContouring(MakeHermiteGrid(level, isthmus::Between(progress, 0.0, 0.3)),
          parameters, isthmus::Between(progress, 0.3, 1.0));
    });
  return contour;
}

isthmus::DualContour ComputeContour(const isthmus::SurfaceView& surface, double spacing,
  isthmus::DualContouringParameters parameters, const isthmus::ProgressCallback& progress)
{
  const MovedSurface moved = Move(surface, spacing);
  parameters.ToWorld = [&moved](std::vector<isthmus::Point3>& points)
  {
    for (isthmus::Point3& p : points)
    {
      p = p + moved.Origin;
    }
  };
  return isthmus::DualContouring(
    MakeHermiteGrid(moved, parameters.FeatureThreshold, isthmus::Between(progress, 0.0, 0.3)),
    parameters, isthmus::Between(progress, 0.3, 1.0));
}

void SetContour(const isthmus::DualContour& contour, bool mirrored, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  isthmus::SizePoints(points, static_cast<vtkIdType>(contour.Points.size()));
  for (std::size_t i = 0; i < contour.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), contour.Points[i].data());
  }
  vtkNew<vtkCellArray> cells;
  const auto polygons = static_cast<vtkIdType>(contour.Polygons.size());
  isthmus::ReserveCells(cells, polygons, 4 * polygons);
  for (const auto& polygon : contour.Polygons)
  {
    std::array<vtkIdType, 4> ids{ polygon[0], polygon[1], polygon[2], polygon[3] };
    const vtkIdType count = ids[3] < 0 ? 3 : 4;
    if (mirrored)
    {
      std::reverse(ids.begin(), ids.begin() + count);
    }
    cells->InsertNextCell(count, ids.data());
  }
  output->SetPoints(points);
  output->SetPolys(cells);
}

}

vtkDualContouring::vtkDualContouring()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkDualContouring::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkDualContouring::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  isthmus::RequestWholeExtent(input[0]->GetInformationObject(0));
  return 1;
}

int vtkDualContouring::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* image = vtkImageData::GetData(input[0]);
  auto* piece = vtkPolyData::GetData(input[0]);
  auto* result = vtkPolyData::GetData(output);
  return isthmus::RunGuarded(this, output,
    [&]
    {
      const auto surface = isthmus::GatherSurface(this, piece);
      isthmus::DualContour contour;
      bool isMirrored = false;
      isthmus::RequireWholeExtent(input[0]->GetInformationObject(0));
      if (image && image->GetNumberOfPoints() > 0 &&
        isthmus::IsProducedOnThisRank(input[0]->GetInformationObject(0)))
      {
        vtkDataArray* scalars = isthmus::ChosenScalars(this, image);
        const isthmus::ChosenLevel chosen = isthmus::ChooseLevel(
          this->AutomaticLevel, this->Level, image, scalars, this->InsideIsHigher);
        contour = ComputeContour(image, scalars, chosen.Level, this->InsideIsHigher,
          this->Parameters, isthmus::MakeProgress(this));
        isMirrored = image->GetDirectionMatrix()->Determinant() < 0.0;
        result->GetFieldData()->PassData(image->GetFieldData());
        isthmus::AddLevel(chosen, result);
      }
      if (surface && surface->GetNumberOfCells() > 0)
      {
        const isthmus::PolyDataTriangles triangles(surface);
        if (triangles.View().NumberOfTriangles() > 0)
        {
          contour = ComputeContour(
            triangles.View(), this->Spacing, this->Parameters, isthmus::MakeProgress(this));
          result->GetFieldData()->PassData(surface->GetFieldData());
        }
      }
      SetContour(contour, isMirrored, result);
      constexpr double large = 0.01;
      if (contour.ThinWalls > large)
      {
        vtkWarningMacro(<< isthmus::JoinText(
                          "Walls thinner than the Spacing have holes or are lost: ",
                          isthmus::FormatNumber(100.0 * contour.ThinWalls, 2),
                          " % of the crossings with the grid lie in pairs between two nodes. "
                          "Choose a smaller Spacing."));
      }
      if (contour.Crossing > 0)
      {
        vtkWarningMacro(<< isthmus::JoinText(contour.Crossing,
                          " triangles still cross each other, where the level leaves the volume."));
      }
    });
}

void vtkDualContouring::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "AutomaticLevel: " << this->AutomaticLevel << "\n";
  os << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "FeatureThreshold: " << this->Parameters.FeatureThreshold << "\n";
  os << indent << "Reach: " << this->Parameters.Reach << "\n";
  os << indent << "Quadrilaterals: " << this->Parameters.Quadrilaterals << "\n";
  os << indent << "Tolerance: " << this->Parameters.Tolerance << "\n";
  os << indent << "FreeOfCrossings: " << this->Parameters.FreeOfCrossings << "\n";
}
