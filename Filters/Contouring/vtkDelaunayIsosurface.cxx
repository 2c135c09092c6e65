#include "vtkDelaunayIsosurface.h"

#include "Contouring/AutomaticLevel.h"
#include "Contouring/ClosedLevelSet.h"
#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkDelaunayIsosurface);

const std::vector<isthmus::OutputArray>& vtkDelaunayIsosurface::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Field, "Level", 1, "of the scalars", ArrayChoice::None, "the level used" },
    { 0, ArrayPlace::Field, "LevelSource", 1, "", ArrayChoice::None,
      "where the level is from, as text" },
  };
  return table;
}

namespace
{

/// A power of two that brings spacings of 1e-100 or 1e100 to about 1; 1 for usual ones.
double ChooseUnitScale(vtkImageData* image)
{
  const double* h = image->GetSpacing();
  int exponent = 0;
  std::frexp(std::max({ h[0], h[1], h[2] }), &exponent);
  constexpr int usual = 20;
  return std::abs(exponent) > usual ? std::ldexp(1.0, -exponent) : 1.0;
}

}

vtkDelaunayIsosurface::vtkDelaunayIsosurface()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkDelaunayIsosurface::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkDelaunayIsosurface::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // Refinement needs all of the surface at once, so every rank would need the whole volume.
  isthmus::RequestWholeExtent(input[0]->GetInformationObject(0));
  return 1;
}

int vtkDelaunayIsosurface::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* image = vtkImageData::GetData(input[0]);
  auto* surface = vtkPolyData::GetData(output);
  return isthmus::RunGuarded(this, output,
    [&]
    {
      isthmus::RequireWholeExtent(input[0]->GetInformationObject(0));
      // Each rank has all of the volume; the surface is computed once.
      if (image->GetNumberOfPoints() == 0 ||
        !isthmus::IsProducedOnThisRank(input[0]->GetInformationObject(0)))
      {
        return;
      }
      vtkDataArray* scalars = isthmus::ChosenScalars(this, image);
      isthmus::RequireSpacing(image);
      isthmus::RequireImageGeometry(image);
      const double factor = ChooseUnitScale(image);
      vtkNew<vtkImageData> scaled;
      scaled->CopyStructure(image);
      const double* own = image->GetSpacing();
      scaled->SetSpacing(factor * own[0], factor * own[1], factor * own[2]);
      const double* h = scaled->GetSpacing();
      const double spacing = std::min({ h[0], h[1], h[2] });
      isthmus::DelaunayIsosurfaceParameters parameters = this->Parameters;
      const isthmus::ChosenLevel chosen = isthmus::ChooseLevel(
        this->AutomaticLevel, this->Level, image, scalars, parameters.InsideIsHigher);
      parameters.Level = chosen.Level;
      isthmus::Check(parameters);
      parameters.Radius *= factor;
      parameters.Distance *= factor;
      isthmus::SetAutomaticSizes(spacing, parameters);

      const auto progress = isthmus::MakeProgress(this);
      const isthmus::ClosedLevelSet level =
        isthmus::CloseLevelSet(scaled, scalars, chosen.Level, parameters.InsideIsHigher);
      isthmus::Report(progress, 0.05);
      if (level.Guide.Triangles.empty())
      {
        vtkWarningMacro(<< isthmus::JoinText("Nothing is inside Level ", chosen.Level,
                          ": the volume has values from ", level.Range[0], " to ", level.Range[1],
                          "."));
      }
      isthmus::DelaunayIsosurfaceResult result = isthmus::DelaunayIsosurface(
        level.Field, level.Bounds, level.Guide, parameters, isthmus::Between(progress, 0.05, 1.0));
      for (isthmus::Point3& p : result.Surface.Points)
      {
        std::transform(p.begin(), p.end(), p.begin(), [factor](double x) { return x / factor; });
      }
      isthmus::ToWorld(image, result.Surface);
      isthmus::SetMesh(result.Surface, surface);
      surface->GetFieldData()->PassData(image->GetFieldData());
      isthmus::AddLevel(chosen, surface);
      if (!result.Warning.empty())
      {
        vtkWarningMacro(<< result.Warning);
      }
    });
}

void vtkDelaunayIsosurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "AutomaticLevel: " << this->AutomaticLevel << "\n";
  os << indent << "InsideIsHigher: " << this->Parameters.InsideIsHigher << "\n";
  os << indent << "Angle: " << this->Parameters.Angle << "\n";
  os << indent << "Radius: " << this->Parameters.Radius << "\n";
  os << indent << "Distance: " << this->Parameters.Distance << "\n";
  os << indent << "MaximumNumberOfPoints: " << this->Parameters.MaximumNumberOfPoints << "\n";
}
