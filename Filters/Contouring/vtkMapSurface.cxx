#include "vtkMapSurface.h"

#include "Contouring/AutomaticLevel.h"
#include "Contouring/ClosedLevelSet.h"
#include "Contouring/DelaunayIsosurface.h"
#include "Contouring/LevelEstimate.h"
#include "Contouring/MapSurface.h"
#include "Contouring/MarchingCubes.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ArrayMemory.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"

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
#include <cmath>
#include <stdexcept>

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
  parameters.Radius = 1.5 * spacing;
  parameters.Distance = 0.25 * spacing;
  isthmus::DelaunayIsosurfaceResult result =
    isthmus::DelaunayIsosurface(set.Field, set.Bounds, set.Guide, parameters, progress);
  if (!result.Warning.empty())
  {
    vtkWarningWithObjectMacro(self, << result.Warning);
  }
  return std::move(result.Surface);
}

isthmus::TriangleMesh CubesSurface(vtkMapSurface* self, vtkImageData* image, vtkDataArray* scalars,
  double level, const isthmus::ProgressCallback& progress)
{
  isthmus::MarchingCubesParameters parameters;
  parameters.Level = level;
  parameters.InsideIsHigher = self->GetInsideIsHigher();
  parameters.CloseAtBorder = self->GetCloseAtBorder();
  isthmus::TriangleMesh mesh;
  isthmus::UseScalars(image, scalars,
    [&](const auto& grid) { mesh = isthmus::MarchingCubes(grid, parameters, progress); });
  return mesh;
}

void AddNormals(const isthmus::SurfaceView& mesh, vtkPolyData* surface)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  isthmus::SizeArray(normals, static_cast<vtkIdType>(mesh.Points.size()));
  float* out = normals->GetPointer(0);
  for (const isthmus::Point3& normal : isthmus::PointNormals(mesh))
  {
    out = std::transform(
      normal.begin(), normal.end(), out, [](double value) { return static_cast<float>(value); });
  }
  surface->GetPointData()->SetNormals(normals);
}

void AddFieldData(const char* name, const std::vector<double>& values, vtkPolyData* surface)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  surface->GetFieldData()->AddArray(array);
}

void AddComponents(const isthmus::DustResult& result, vtkPolyData* surface)
{
  vtkNew<vtkIdTypeArray> components;
  components->SetName("Component");
  isthmus::SizeArray(components, static_cast<vtkIdType>(result.Components.size()));
  std::copy(result.Components.begin(), result.Components.end(), components->GetPointer(0));
  surface->GetCellData()->AddArray(components);
  AddFieldData("ComponentsFound", { static_cast<double>(result.Found) }, surface);
  AddFieldData("ComponentArea", result.Areas, surface);
}

}

vtkMapSurface::vtkMapSurface()
  : LevelOfMap(new isthmus::AutomaticLevel)
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkMapSurface::~vtkMapSurface() = default;

void vtkMapSurface::SetLevel(double level)
{
  this->SetLevelOnly(level);
  this->SetAutomaticLevel(false);
}

void vtkMapSurface::SetLevelOnly(double level)
{
  if (this->Level != level) // true for what is not a number, too
  {
    this->Level = level;
    this->Modified();
  }
}

int vtkMapSurface::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkMapSurface::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // Components are known only from all of the surface.
  isthmus::RequestWholeExtent(input[0]->GetInformationObject(0));
  return 1;
}

/// Warns where an automatic level looks for high values and the density is darker than the
/// background.
bool vtkMapSurface::IsSuspectedOfInversion(vtkImageData* image, vtkDataArray* scalars)
{
  if (!this->AutomaticLevel || !this->InsideIsHigher ||
    image->GetFieldData()->GetArray("RecommendedLevel"))
  {
    return false;
  }
  isthmus::MapContrast contrast;
  isthmus::UseScalars(
    image, scalars, [&](const auto& grid) { contrast = isthmus::ContrastOf(grid); });
  if (contrast.IsInverted())
  {
    vtkWarningMacro(<< isthmus::TextOf(
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
  if (this->Quality != Cubes && this->Quality != Delaunay)
  {
    throw std::invalid_argument("Quality must be 0 (cubes) or 1 (Delaunay).");
  }
  if (this->Quality == Delaunay && !this->CloseAtBorder)
  {
    throw std::invalid_argument(
      "A Delaunay surface is always closed: switch CloseAtBorder on, or choose the quality Cubes.");
  }
  vtkDataArray* scalars = isthmus::ChosenScalars(this, image);
  const double level =
    this->AutomaticLevel ? this->LevelOfMap->Of(image, scalars, this->InsideIsHigher) : this->Level;
  if (!std::isfinite(level))
  {
    throw std::invalid_argument("Level must be a finite number.");
  }
  this->UsedLevel = level;
  const bool isInverted = this->IsSuspectedOfInversion(image, scalars);

  const auto progress = isthmus::ProgressOf(this);
  const auto extracting = isthmus::Between(progress, 0.0, 0.7);
  isthmus::TriangleMesh mesh = this->Quality == Delaunay
    ? DelaunaySurface(this, image, scalars, level, extracting)
    : CubesSurface(this, image, scalars, level, extracting);
  const isthmus::DustParameters parameters{ this->MinimumComponentArea, this->MinimumComponentShare,
    this->LargestComponents };
  isthmus::DustResult result = isthmus::HideDust(std::move(mesh), parameters);
  isthmus::Report(progress, 0.8);
  isthmus::ToWorld(image, result.Surface);
  isthmus::SetMesh(result.Surface, surface);
  if (this->GenerateNormals)
  {
    AddNormals(result.Surface, surface);
  }
  surface->GetFieldData()->PassData(image->GetFieldData());
  AddFieldData("Level", { level }, surface);
  AddComponents(result, surface);
  if (isInverted)
  {
    AddFieldData("InvertedContrast", { 1.0 }, surface);
  }
  if (result.Surface.Triangles.empty())
  {
    double range[2];
    scalars->GetFiniteRange(range, 0);
    vtkWarningMacro(
      << isthmus::TextOf(
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
  return isthmus::Guarded(this, output,
    [&]
    {
      isthmus::RequireWholeExtent(input[0]->GetInformationObject(0));
      if (image->GetNumberOfPoints() > 0 && isthmus::IsMadeHere(input[0]->GetInformationObject(0)))
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
  os << indent << "UsedLevel: " << this->UsedLevel << "\n";
  os << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n";
  os << indent << "MinimumComponentArea: " << this->MinimumComponentArea << "\n";
  os << indent << "MinimumComponentShare: " << this->MinimumComponentShare << "\n";
  os << indent << "LargestComponents: " << this->LargestComponents << "\n";
  os << indent << "CloseAtBorder: " << this->CloseAtBorder << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "GenerateNormals: " << this->GenerateNormals << "\n";
}
