#include "vtkIsosurfaceStuffing.h"

#include "Contouring/ClosedLevelSet.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ArrayMemory.h"
#include "Core/Geometry.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/MemoryBudget.h"
#include "Core/NumberText.h"
#include "Core/TetrahedralMesh.h"
#include "Core/TrilinearField.h"
#include "Tetrahedra/IsosurfaceStuffing.h"
#include "Tetrahedra/TetrahedralGrid.h"

#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkIsosurfaceStuffing);

namespace
{

isthmus::StuffingParameters ParametersOf(vtkIsosurfaceStuffing* filter, vtkImageData* image)
{
  const double* h = image->GetSpacing();
  isthmus::StuffingParameters parameters;
  parameters.CellSize =
    filter->GetCellSize() == 0.0 ? std::min({ h[0], h[1], h[2] }) : filter->GetCellSize();
  parameters.GradingLevels = filter->GetGradingLevels();
  parameters.Side = static_cast<isthmus::MeshedSide>(filter->GetSide());
  parameters.Memory = isthmus::MemoryBudget::OfMachine(filter->GetMemoryLimit());
  return parameters;
}

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
  if (!(std::abs(level) < largest) || low < -largest || high > largest)
  {
    throw std::invalid_argument("Level and values must be numbers between -1e150 and 1e150.");
  }
  // As far beyond the level as the inside goes at most, so that it is closed half way.
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
  vtkNew<vtkUnsignedCharArray> onSurface;
  onSurface->SetName("OnSurface");
  isthmus::SizeArray(onSurface, grid->GetNumberOfPoints());
  std::copy(result.OnSurface.begin(), result.OnSurface.end(), onSurface->GetPointer(0));
  grid->GetPointData()->RemoveArray("OriginalPointId"); // there are none
  grid->GetPointData()->AddArray(onSurface);
  vtkNew<vtkIdTypeArray> kept;
  kept->SetName("KeptPoints");
  kept->InsertNextValue(result.KeptPoints);
  grid->GetFieldData()->AddArray(kept);
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
  return isthmus::Guarded(this, output,
    [&]
    {
      isthmus::RequireWholeExtent(input[0]->GetInformationObject(0));
      if (image->GetNumberOfPoints() == 0 ||
        !isthmus::IsMadeHere(input[0]->GetInformationObject(0)))
      {
        return;
      }
      const int* n = image->GetDimensions();
      if (n[0] < 2 || n[1] < 2 || n[2] < 2)
      {
        throw std::invalid_argument("The volume has fewer than two nodes along an axis.");
      }
      const auto progress = isthmus::ProgressOf(this);
      isthmus::IsosurfaceStuffingResult result;
      isthmus::UseScalars(image, isthmus::ChosenScalars(this, image),
        [&](const auto& scalars)
        {
          result =
            Stuff(scalars, this->Level, this->InsideIsHigher, ParametersOf(this, image), progress);
        });
      ToWorld(image, result.Mesh);
      isthmus::SetGrid(result.Mesh, grid);
      grid->GetFieldData()->PassData(image->GetFieldData());
      AddFlags(result, grid);
      if (result.Mesh.Tetrahedra.empty())
      {
        vtkWarningMacro(<< isthmus::TextOf("Nothing is inside Level ", this->Level, "."));
      }
    });
}

void vtkIsosurfaceStuffing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n";
  os << indent << "Side: " << this->Side << "\n";
  os << indent << "CellSize: " << this->CellSize << "\n";
  os << indent << "GradingLevels: " << this->GradingLevels << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
