#include "vtkMapSurface.h"

#include "Contouring/AutomaticLevel.h"
#include "Contouring/ClosedLevelSet.h"
#include "Contouring/DelaunayIsosurface.h"
#include "Contouring/LevelEstimate.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>

vtkStandardNewMacro(vtkMapSurface);

namespace
{

isthmus::TriangleMesh DelaunaySurface(vtkMapSurface* self, vtkImageData* image,
  vtkDataArray* scalars, double level, const isthmus::ProgressCallback& progress)
{
  const isthmus::ClosedLevelSet set =
    isthmus::CloseLevelSet(image, scalars, level, self->GetInsideIsHigher());
  const double* h = image->GetSpacing();
  const double spacing = std::min({ h[0], h[1], h[2] });
  isthmus::DelaunayIsosurfaceParameters parameters;
  parameters.Level = level;
  parameters.InsideIsHigher = self->GetInsideIsHigher();
  isthmus::SetAutomaticSizes(spacing, parameters);
  isthmus::DelaunayIsosurfaceResult result =
    isthmus::DelaunayIsosurface(set.Field, set.Bounds, set.Guide, parameters, progress);
  if (!result.Warning.empty())
  {
    vtkWarningWithObjectMacro(self, << result.Warning);
  }
  return std::move(result.Surface);
}

isthmus::TriangleMesh CubesSurface(vtkImageData* image, vtkDataArray* scalars, double level,
  isthmus::MarchingCubesParameters parameters, const isthmus::ProgressCallback& progress)
{
  parameters.Level = level;
  isthmus::TriangleMesh mesh;
  isthmus::UseScalars(image, scalars,
    [&](const auto& grid) { mesh = isthmus::MarchingCubes(grid, parameters, progress); });
  return mesh;
}

void AddNormals(const isthmus::SurfaceView& mesh, vtkPolyData* surface)
{
  const auto normals = isthmus::NamedArray<vtkFloatArray>("Normals", mesh.Points.size(), 3);
  float* out = normals->GetPointer(0);
  for (const isthmus::Point3& normal : isthmus::PointNormals(mesh))
  {
    out = std::transform(
      normal.begin(), normal.end(), out, [](double value) { return static_cast<float>(value); });
  }
  surface->GetPointData()->SetNormals(normals);
}

void AddComponents(const isthmus::DustResult& result, vtkPolyData* surface)
{
  vtkFieldData* const data = surface->GetFieldData();
  isthmus::AddColumn<vtkIdTypeArray>(surface->GetCellData(), "Component", result.Components);
  isthmus::AddColumn<vtkDoubleArray>(data, "ComponentsFound", { result.Found });
  isthmus::AddColumn<vtkDoubleArray>(data, "ComponentArea", result.Areas);
}

}

const std::vector<isthmus::OutputArray>& vtkMapSurface::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Normals", 3, "", ArrayChoice::On,
      "unit normals, for smooth shading" },
    { 0, ArrayPlace::Cells, "Component", 1, "", ArrayChoice::None,
      "0 for the component with the largest area" },
    { 0, ArrayPlace::Field, "Level", 1, "of the scalars", ArrayChoice::None, "the level used" },
    { 0, ArrayPlace::Field, "LevelSource", 1, "", ArrayChoice::None,
      "where the level is from, as text" },
    { 0, ArrayPlace::Field, "AutomaticLevel", 1, "of the scalars", ArrayChoice::None,
      "the automatic level, also while another one is used" },
    { 0, ArrayPlace::Field, "AutomaticLevelSource", 1, "", ArrayChoice::None,
      "where the automatic level is from, as text" },
    { 0, ArrayPlace::Field, "ComponentsFound", 1, "", ArrayChoice::None,
      "components before dust was hidden" },
    { 0, ArrayPlace::Field, "ComponentArea", 1, "length^2", ArrayChoice::None,
      "of each remaining component, largest first" },
    { 0, ArrayPlace::Field, "InvertedContrast", 1, "", ArrayChoice::None,
      "1 if an automatic level was used but density seems to be darker than the background; "
      "otherwise missing" },
  };
  return table;
}

vtkMapSurface::vtkMapSurface()
  : OutputArrays(this, OutputArrayTable())
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkMapSurface::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkMapSurface::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // Components can only be determined on the whole surface.
  isthmus::RequestWholeExtent(input[0]->GetInformationObject(0));
  return 1;
}

namespace
{

/// Whether all nodes on the border of the volume, of two or more layers along each axis, are
/// inside.
bool IsBorderInside(vtkImageData* image, vtkDataArray* scalars, double level, bool insideIsHigher)
{
  const int* const n = image->GetDimensions();
  vtkIdType node = 0;
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i, ++node)
      {
        const bool isOuter =
          i == 0 || j == 0 || k == 0 || i == n[0] - 1 || j == n[1] - 1 || k == n[2] - 1;
        const double value = isOuter ? scalars->GetComponent(node, 0) : level;
        if (isOuter && !(insideIsHigher ? value > level : value < level))
        {
          return false;
        }
      }
    }
  }
  return n[0] > 1 && n[1] > 1 && n[2] > 1;
}

}

/// Whether density is darker than the background; warns if so.
bool vtkMapSurface::IsInverted(vtkImageData* image, vtkDataArray* scalars)
{
  isthmus::MapContrast contrast;
  isthmus::UseScalars(image, scalars,
    [&](const auto& grid)
    { contrast = isthmus::MeasureContrast(grid, isthmus::NoDataMask(image)); });
  if (contrast.IsInverted())
  {
    vtkWarningMacro(<< isthmus::JoinText(
                      "The contrast of the map seems to be inverted, with density darker than the "
                      "background (skewness ",
                      contrast.Skewness,
                      ", low values away from the border): the surface is likely to be specks of "
                      "noise. Switch InsideIsHigher off."));
  }
  return contrast.IsInverted();
}

void vtkMapSurface::MakeSurface(vtkImageData* image, vtkPolyData* surface)
{
  isthmus::RequireChoice<int>("Quality", this->Quality, Delaunay);
  isthmus::Check(this->Parameters);
  isthmus::RequireThat(this->Quality == Cubes || this->Contour.CloseAtBorder, "CloseAtBorder", 0.0,
    "a Delaunay surface is always closed: switch it on, or choose the quality Cubes");
  vtkDataArray* scalars = isthmus::ChosenScalars(this, image);
  const isthmus::ChosenLevel chosen = isthmus::ChooseLevel(
    this->AutomaticLevel, this->Level, image, scalars, this->Contour.InsideIsHigher);
  const double level = chosen.Level;
  const bool isInverted = chosen.Source == isthmus::LevelSource::Estimated &&
    this->Contour.InsideIsHigher && this->IsInverted(image, scalars);

  if (!isInverted && IsBorderInside(image, scalars, level, this->Contour.InsideIsHigher))
  {
    vtkWarningMacro(<< isthmus::JoinText("The whole border of the volume is inside the level of ",
                      level,
                      ", so the surface is that of the space around an object, or of the "
                      "volume itself. Signed distances that grow outwards, and density darker than "
                      "the background, need InsideIsHigher ",
                      this->Contour.InsideIsHigher ? "off." : "on."));
  }

  const auto progress = isthmus::MakeProgress(this);
  const auto extracting = isthmus::Between(progress, 0.0, 0.7);
  isthmus::TriangleMesh mesh = this->Quality == Delaunay
    ? DelaunaySurface(this, image, scalars, level, extracting)
    : CubesSurface(image, scalars, level, this->Contour, extracting);
  isthmus::DustResult result = isthmus::HideDust(std::move(mesh), this->Parameters);
  isthmus::Report(progress, 0.8);
  isthmus::ToWorld(image, result.Surface);
  isthmus::SetMesh(result.Surface, surface);
  if (this->OutputArrays.Has("Normals"))
  {
    AddNormals(result.Surface, surface);
  }
  surface->GetFieldData()->PassData(image->GetFieldData());
  isthmus::AddLevel(chosen, surface);
  isthmus::AddAutomaticLevel(chosen, image, scalars, this->Contour.InsideIsHigher, surface);
  AddComponents(result, surface);
  if (isInverted)
  {
    isthmus::AddColumn<vtkDoubleArray>(surface->GetFieldData(), "InvertedContrast", { 1.0 });
  }
  if (result.Surface.Triangles.empty())
  {
    double range[2];
    scalars->GetFiniteRange(range, 0);
    vtkWarningMacro(
      << isthmus::JoinText(
           (result.Found > 0
               ? "All components of the surface count as dust: lower MinimumComponentArea."
               : "Nothing is inside the level: choose another one."),
           " The level is ", level, ", the map has values from ", range[0], " to ", range[1], "."));
  }
}

int vtkMapSurface::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* image = vtkImageData::GetData(input[0]);
  auto* surface = vtkPolyData::GetData(output);
  return isthmus::RunGuarded(this, output,
    [&]
    {
      this->OutputArrays.Check();
      isthmus::RequireWholeExtent(input[0]->GetInformationObject(0));
      if (image->GetNumberOfPoints() > 0 &&
        isthmus::IsProducedOnThisRank(input[0]->GetInformationObject(0)))
      {
        this->MakeSurface(image, surface);
      }
    });
}

void vtkMapSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "AutomaticLevel: " << this->AutomaticLevel << "\n";
  os << indent << "InsideIsHigher: " << this->Contour.InsideIsHigher << "\n";
  os << indent << "MinimumComponentArea: " << this->Parameters.MinimumComponentArea << "\n";
  os << indent << "MinimumComponentShare: " << this->Parameters.MinimumComponentShare << "\n";
  os << indent << "LargestComponents: " << this->Parameters.LargestComponents << "\n";
  os << indent << "CloseAtBorder: " << this->Contour.CloseAtBorder << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  this->OutputArrays.Print(os, indent);
}
