#include "vtkTetrahedralMesher.h"

#include "AlgorithmGuard.h"
#include "PolyDataMesh.h"
#include "SurfaceRepair.h"
#include "TetrahedralMesher.h"
#include "WholeSurface.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <unistd.h>

vtkStandardNewMacro(vtkTetrahedralMesher);

namespace
{

std::uint64_t ThreeQuartersOfMemory()
{
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) / 4 * 3 *
    static_cast<std::uint64_t>(sysconf(_SC_PAGE_SIZE));
}

isthmus::TetrahedralParameters ParametersOf(vtkTetrahedralMesher* filter)
{
  isthmus::TetrahedralParameters parameters;
  parameters.Library = static_cast<isthmus::TetrahedralLibrary>(filter->GetLibrary());
  parameters.Side = static_cast<isthmus::MeshedSide>(filter->GetSide());
  parameters.BoxMargin = filter->GetBoxMargin();
  const std::uint64_t bytes = filter->GetMemoryLimit() > 0
    ? static_cast<std::uint64_t>(filter->GetMemoryLimit()) << 20
    : ThreeQuartersOfMemory();
  parameters.TetGen = { filter->GetKeepSurface(), filter->GetRadiusEdgeRatio(),
    filter->GetMinimumDihedralAngle(), filter->GetMaximumVolume(), filter->GetTetGenCommand(),
    { filter->GetTimeLimit(), bytes } };
  parameters.CGAL.FacetAngle = filter->GetFacetAngle();
  parameters.CGAL.FacetSize = filter->GetFacetSize();
  parameters.CGAL.FacetDistance = filter->GetFacetDistance();
  parameters.CGAL.CellRadiusEdgeRatio = filter->GetCellRadiusEdgeRatio();
  parameters.CGAL.CellSize = filter->GetCellSize();
  return parameters;
}

void SetGrid(const isthmus::TetrahedralMesh& mesh, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Points.size()));
  vtkNew<vtkIdTypeArray> original;
  original->SetName("OriginalPointId");
  original->SetNumberOfValues(points->GetNumberOfPoints());
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
    original->SetValue(static_cast<vtkIdType>(i), mesh.OriginalPoints[i]);
  }
  const auto count = static_cast<vtkIdType>(mesh.Tetrahedra.size());
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(count, 4 * count);
  vtkNew<vtkIntArray> regions;
  regions->SetName("RegionId");
  regions->SetNumberOfValues(count);
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    const isthmus::Tetrahedron& t = mesh.Tetrahedra[i];
    cells->InsertNextCell({ t[0], t[1], t[2], t[3] });
    regions->SetValue(static_cast<vtkIdType>(i), mesh.Regions[i]);
  }
  grid->SetPoints(points);
  grid->SetCells(VTK_TETRA, cells);
  grid->GetPointData()->AddArray(original);
  grid->GetCellData()->SetScalars(regions);
}

}

int vtkTetrahedralMesher::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkTetrahedralMesher::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  const auto surface = isthmus::WholeSurface(vtkPolyData::GetData(input[0]));
  auto* grid = vtkUnstructuredGrid::GetData(output);
  return isthmus::Guarded(this, grid,
    [&]
    {
      isthmus::TetrahedralParameters parameters = ParametersOf(this);
      const auto progress = isthmus::ProgressOf(this);
      isthmus::TriangleMesh mesh = isthmus::MeshOf(surface);
      isthmus::RepairedSurface repaired;
      if (this->Repair && !mesh.Triangles.empty())
      {
        repaired = isthmus::RepairSurface(mesh, isthmus::Between(progress, 0.0, 0.2));
        mesh = repaired.Mesh;
        parameters.Repaired = true;
      }
      isthmus::TetrahedralMesh result =
        isthmus::MeshTetrahedra(mesh, parameters, isthmus::Between(progress, 0.2, 1.0));
      for (std::int64_t& id : result.OriginalPoints)
      {
        id = id < 0 || repaired.Mesh.Points.empty()
          ? id
          : repaired.OriginalPoints[static_cast<std::size_t>(id)];
      }
      SetGrid(result, grid);
      grid->GetFieldData()->PassData(surface->GetFieldData());
      if (!repaired.Changes.empty())
      {
        vtkNew<vtkStringArray> changes;
        changes->SetName("Repair");
        changes->InsertNextValue(repaired.Changes);
        grid->GetFieldData()->AddArray(changes);
        vtkWarningMacro(<< repaired.Changes);
      }
    });
}

void vtkTetrahedralMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Library: " << (this->Library == TETGEN ? "TetGen" : "CGAL") << "\n";
  os << indent << "Side: " << this->Side << "\n";
  os << indent << "BoxMargin: " << this->BoxMargin << "\n";
  os << indent << "Repair: " << this->Repair << "\n";
  os << indent << "KeepSurface: " << this->KeepSurface << "\n";
  os << indent << "RadiusEdgeRatio: " << this->RadiusEdgeRatio << "\n";
  os << indent << "MinimumDihedralAngle: " << this->MinimumDihedralAngle << "\n";
  os << indent << "MaximumVolume: " << this->MaximumVolume << "\n";
  os << indent << "TetGenCommand: " << this->TetGenCommand << "\n";
  os << indent << "TimeLimit: " << this->TimeLimit << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "FacetAngle: " << this->FacetAngle << "\n";
  os << indent << "FacetSize: " << this->FacetSize << "\n";
  os << indent << "FacetDistance: " << this->FacetDistance << "\n";
  os << indent << "CellRadiusEdgeRatio: " << this->CellRadiusEdgeRatio << "\n";
  os << indent << "CellSize: " << this->CellSize << "\n";
}
