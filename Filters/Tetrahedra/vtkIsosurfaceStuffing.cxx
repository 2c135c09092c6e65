#include "vtkIsosurfaceStuffing.h"

#include "Contouring/AutomaticLevel.h"
#include "Contouring/ClosedLevelSet.h"
#include "Core/AlgorithmGuard.h"
#include "Core/Geometry.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/MemoryBudget.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/RangeChecks.h"
#include "Core/TetrahedralMesh.h"
#include "Core/TrilinearField.h"
#include "Tetrahedra/TetrahedralGrid.h"

#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix3x3.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkIsosurfaceStuffing);

const std::vector<isthmus::OutputArray>& vtkIsosurfaceStuffing::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Cells, "RegionId", 1, "", ArrayChoice::None, "1 inside, 0 outside" },
    { 0, ArrayPlace::Points, "OnSurface", 1, "", ArrayChoice::None, "1 on the level set" },
    { 0, ArrayPlace::Field, "Level", 1, "of the scalars", ArrayChoice::None, "the level used" },
    { 0, ArrayPlace::Field, "LevelSource", 1, "", ArrayChoice::None,
      "where the level is from, as text" },
    { 0, ArrayPlace::Field, "KeptPoints", 1, "", ArrayChoice::None,
      "places where the level set turned within a cell" },
  };
  return table;
}

namespace
{

/// Mesh of the level set in the frame of the grid.
template <typename T>
isthmus::IsosurfaceStuffingResult Stuff(const isthmus::GridView<const T>& grid, double level,
  bool insideIsHigher, const isthmus::StuffingParameters& parameters,
  const isthmus::ProgressCallback& progress)
{
  isthmus::CheckFinite(grid);
  const auto [least, most] = std::minmax_element(grid.Data, grid.Data + grid.Size());
  const auto low = static_cast<double>(*least);
  const auto high = static_cast<double>(*most);
  constexpr double largest = 1e150;
  isthmus::RequireRange("Level", level, -largest, largest);
  isthmus::RequireRange("The smallest value of the volume", low, -largest, largest);
  isthmus::RequireRange("The largest value of the volume", high, -largest, largest);
  // The outside value is the extreme inside value mirrored at the level, so that the surface is
  // closed half way between nodes.
  const double outside =
    insideIsHigher ? std::min(low, 2.0 * level - high) : std::max(high, 2.0 * level - low);
  isthmus::Bounds3 bounds;
  for (std::size_t a = 0; a < 3; ++a)
  {
    bounds.Min[a] = -grid.Spacing[a];
    bounds.Max[a] = grid.Spacing[a] * static_cast<double>(grid.Dimensions[a]);
  }
  const isthmus::TrilinearField<T> values{ grid, outside };
  const double sign = insideIsHigher ? 1.0 : -1.0;
  return isthmus::IsosurfaceStuffing([&values, sign, level](const isthmus::Point3& p)
    { return sign * (values(p) - level); },
    bounds, parameters, progress);
}

void ToWorld(vtkImageData* image, isthmus::TetrahedralMesh& mesh)
{
  isthmus::TriangleMesh points;
  points.Points.swap(mesh.Points);
  isthmus::ToWorld(image, points);
  points.Points.swap(mesh.Points);
  if (image->GetDirectionMatrix()->Determinant() < 0.0)
  {
    for (isthmus::Tetrahedron& t : mesh.Tetrahedra)
    {
      std::swap(t[2], t[3]);
    }
  }
}

void AddFlags(const isthmus::IsosurfaceStuffingResult& result, vtkUnstructuredGrid* grid)
{
  grid->GetPointData()->RemoveArray("OriginalPointId"); // there are none
  isthmus::AddColumn<vtkUnsignedCharArray>(grid->GetPointData(), "OnSurface", result.OnSurface);
  isthmus::AddColumn<vtkIdTypeArray>(grid->GetFieldData(), "KeptPoints", { result.KeptPoints });
}

}

vtkIsosurfaceStuffing::vtkIsosurfaceStuffing()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkIsosurfaceStuffing::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkIsosurfaceStuffing::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // The lattice is one for all of the volume.
  isthmus::RequestWholeExtent(input[0]->GetInformationObject(0));
  return 1;
}

int vtkIsosurfaceStuffing::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* image = vtkImageData::GetData(input[0]);
  auto* grid = vtkUnstructuredGrid::GetData(output);
  return isthmus::RunGuarded(this, output,
    [&]
    {
      isthmus::Check(this->Parameters);
      isthmus::RequireRange(
        "MemoryLimit", this->MemoryLimit, 0, isthmus::Unlimited, "It is in MiB.");
      isthmus::RequireWholeExtent(input[0]->GetInformationObject(0));
      if (image->GetNumberOfPoints() == 0 ||
        !isthmus::IsProducedOnThisRank(input[0]->GetInformationObject(0)))
      {
        return;
      }
      const int* n = image->GetDimensions();
      if (n[0] < 2 || n[1] < 2 || n[2] < 2)
      {
        throw std::invalid_argument("The volume has fewer than two nodes along an axis.");
      }
      isthmus::StuffingParameters parameters = this->Parameters;
      if (parameters.CellSize == 0.0)
      {
        const double* h = image->GetSpacing();
        parameters.CellSize = std::min({ h[0], h[1], h[2] });
      }
      parameters.Memory = isthmus::MemoryBudget::ForMachine(this->MemoryLimit);
      const auto progress = isthmus::MakeProgress(this);
      isthmus::IsosurfaceStuffingResult result;
      vtkDataArray* scalars = isthmus::ChosenScalars(this, image);
      const isthmus::ChosenLevel chosen = isthmus::ChooseLevel(
        this->AutomaticLevel, this->Level, image, scalars, this->InsideIsHigher);
      isthmus::UseScalars(image, scalars,
        [&](const auto& values)
        { result = Stuff(values, chosen.Level, this->InsideIsHigher, parameters, progress); });
      ToWorld(image, result.Mesh);
      isthmus::SetGrid(result.Mesh, grid);
      grid->GetFieldData()->PassData(image->GetFieldData());
      isthmus::AddLevel(chosen, grid);
      AddFlags(result, grid);
      if (result.Mesh.Tetrahedra.empty())
      {
        vtkWarningMacro(<< isthmus::JoinText("Nothing is inside Level ", chosen.Level, "."));
      }
    });
}

void vtkIsosurfaceStuffing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "AutomaticLevel: " << this->AutomaticLevel << "\n";
  os << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n";
  os << indent << "Side: " << this->GetSide() << "\n";
  os << indent << "CellSize: " << this->Parameters.CellSize << "\n";
  os << indent << "GradingLevels: " << this->Parameters.GradingLevels << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
