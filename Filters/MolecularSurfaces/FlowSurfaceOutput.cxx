#include "MolecularSurfaces/FlowSurfaceOutput.h"

#include "Core/InnerAlgorithm.h"
#include "Core/NamedColumns.h"
#include "Core/ParallelFor.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// `value`, but at a distance of at least `least` from `level`, on its side.
float KeepFromLevel(float value, float level, float least)
{
  const float by = value - level;
  return std::abs(by) < least ? (by > 0.0F ? level + least : level - least) : value;
}

template <typename Value>
void Fill(vtkFloatArray* to, const Value& value)
{
  float* values = to->GetPointer(0);
  ParallelFor(0, to->GetNumberOfValues(), 1 << 18,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        values[node] = value(static_cast<std::size_t>(node));
      }
    });
}

}

void SetImageGeometry(const DensityGrid& grid, vtkImageData* image)
{
  image->SetDimensions(static_cast<int>(grid.Dimensions[0]), static_cast<int>(grid.Dimensions[1]),
    static_cast<int>(grid.Dimensions[2]));
  image->SetOrigin(grid.Origin.data());
  image->SetSpacing(grid.Spacing, grid.Spacing, grid.Spacing);
}

void FillImage(const SurfaceFlowResult& result, double distance, vtkImageData* image)
{
  SetImageGeometry(result.Grid, image);
  const auto h = static_cast<float>(result.Grid.Spacing);
  const auto level = static_cast<float>(distance);
  const float least = 1e-3F * h;
  const auto nodes = static_cast<std::size_t>(image->GetNumberOfPoints());
  vtkFloatArray* distances =
    AddArray<vtkFloatArray>(image->GetPointData(), "SignedDistance", nodes);
  Fill(distances,
    [&](std::size_t node) { return KeepFromLevel(result.Distance[node], level, least); });
  const float width = 2.0F * static_cast<float>(HalfWidthOfS) * h;
  const float* at = distances->GetPointer(0);
  vtkFloatArray* s = AddArray<vtkFloatArray>(image->GetPointData(), "S", nodes);
  if (result.S.empty())
  {
    Fill(s, [=](std::size_t node) { return std::clamp(0.5F - at[node] / width, 0.0F, 1.0F); });
  }
  else
  {
    const auto ofS = static_cast<float>(0.5 - distance / static_cast<double>(width));
    Fill(s, [&](std::size_t node) { return KeepFromLevel(result.S[node], ofS, 1e-4F); });
  }
  image->GetPointData()->SetActiveScalars("SignedDistance");
}

void ContourImage(
  vtkImageData* image, bool ofS, double level, double distance, vtkPolyData* surface)
{
  // The inside has to be the higher side, for triangles and normals to face outwards.
  vtkNew<vtkImageData> inverted;
  inverted->CopyStructure(image);
  vtkDataArray* from = image->GetPointData()->GetArray(ofS ? "S" : "SignedDistance");
  if (ofS)
  {
    inverted->GetPointData()->SetScalars(from);
  }
  else
  {
    const float* values = vtkFloatArray::SafeDownCast(from)->GetPointer(0);
    const auto depth =
      NamedArray<vtkFloatArray>("Depth", static_cast<std::size_t>(image->GetNumberOfPoints()));
    Fill(depth, [=](std::size_t node) { return -values[node]; });
    inverted->GetPointData()->SetScalars(depth);
  }
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(inverted);
  contour->SetValue(0, ofS ? level : -distance);
  contour->ComputeNormalsOn();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  UpdateInner(contour);
  surface->ShallowCopy(contour->GetOutput());
}

void FillHistory(
  const SurfaceFlowResult& result, double tension, double pressure, vtkTable* history)
{
  vtkFieldData* const data = history->GetRowData();
  AddComputedColumn<vtkDoubleArray>(
    data, "Time", result.History, [](const FlowRecord& r) { return r.Time; });
  AddComputedColumn<vtkDoubleArray>(
    data, "Spacing", result.History, [](const FlowRecord& r) { return r.Spacing; });
  AddComputedColumn<vtkDoubleArray>(
    data, "Area", result.History, [](const FlowRecord& r) { return r.Area; });
  AddComputedColumn<vtkDoubleArray>(
    data, "Volume", result.History, [](const FlowRecord& r) { return r.Volume; });
  AddComputedColumn<vtkDoubleArray>(data, "Energy", result.History,
    [=](const FlowRecord& r) { return tension * r.Area + pressure * r.Volume; });
}

}
