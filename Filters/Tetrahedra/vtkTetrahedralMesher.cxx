#include "vtkTetrahedralMesher.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/MemoryBudget.h"
#include "Core/PolyDataTriangles.h"
#include "Core/TetrahedralMesh.h"
#include "Remeshing/SurfaceRepair.h"
#include "Surfaces/SurfaceCleaning.h"
#include "Tetrahedra/AutomaticMesher.h"
#include "Tetrahedra/TetrahedralGrid.h"
#include "Tetrahedra/TetrahedralMesher.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

vtkStandardNewMacro(vtkTetrahedralMesher);

namespace
{

/// What Automatic may use when nobody says otherwise: it tries again with less after a failure.
constexpr double AutomaticBytes = 8.0 * 1024 * 1024 * 1024;

isthmus::TetrahedralParameters ParametersOf(vtkTetrahedralMesher* filter)
{
  isthmus::TetrahedralParameters parameters;
  const bool automatic = filter->GetLibrary() == vtkTetrahedralMesher::Automatic;
  if (!automatic)
  {
    parameters.Library = static_cast<isthmus::TetrahedralLibrary>(filter->GetLibrary());
  }
  parameters.Side = static_cast<isthmus::MeshedSide>(filter->GetSide());
  parameters.BoxMargin = filter->GetBoxMargin();
  isthmus::MemoryBudget memory = isthmus::MemoryBudget::OfMachine(filter->GetMemoryLimit());
  if (automatic && filter->GetMemoryLimit() == 0)
  {
    memory = memory.AtMost(AutomaticBytes);
  }
  parameters.TetGen = { filter->GetKeepSurface(), filter->GetRadiusEdgeRatio(),
    filter->GetMinimumDihedralAngle(), filter->GetMaximumVolume(), filter->GetTetGenCommand(),
    { filter->GetTimeLimit(), memory.WholeBytes() } };
  parameters.CGAL.FacetAngle = filter->GetFacetAngle();
  parameters.CGAL.FacetSize = filter->GetFacetSize();
  parameters.CGAL.FacetDistance = filter->GetFacetDistance();
  parameters.CGAL.CellRadiusEdgeRatio = filter->GetCellRadiusEdgeRatio();
  parameters.CGAL.CellSize = filter->GetCellSize();
  parameters.CGAL.LloydIterations = filter->GetLloydIterations();
  parameters.CGAL.ODTIterations = filter->GetODTIterations();
  parameters.CGAL.OptimisationSeconds = filter->GetOptimisationTimeLimit();
  parameters.CGAL.PerturbSeconds = filter->GetPerturbTimeLimit();
  parameters.CGAL.Exude = filter->GetExude();
  return parameters;
}

void AddNumber(vtkFieldData* fields, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  fields->AddArray(array);
}

void AddText(vtkFieldData* fields, const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  fields->AddArray(array);
}

void AddReport(const isthmus::AutomaticMesh& made, vtkFieldData* fields)
{
  static const char* const names[] = { "TetGen", "TetGen after repair", "CGAL after repair",
    "Stuffing" };
  AddText(fields, "Engine", names[static_cast<int>(made.Backend)]);
  AddText(fields, "EngineReport", made.Report);
  if (!made.Changes.empty())
  {
    AddText(fields, "Repair", made.Changes);
  }
  AddNumber(fields, "HausdorffDistance", made.Hausdorff);
  AddNumber(fields, "VolumeBefore", made.VolumeBefore);
  AddNumber(fields, "VolumeAfter", made.VolumeAfter);
  AddNumber(fields, "VolumeIsDoubtful", made.IsDoubtful ? 1.0 : 0.0);
}

/// From ids of points of a surface to those of what it was made of; -1 stays.
void RenameOriginals(const std::vector<std::int64_t>& original, isthmus::TetrahedralMesh& mesh)
{
  for (std::int64_t& id : mesh.OriginalPoints)
  {
    id = id < 0 ? id : original[static_cast<std::size_t>(id)];
  }
}

/// Adds the field data `UnmetBounds` where there are some; returns them behind `warning`.
std::string WithUnmetBounds(const std::string& warning, const isthmus::TetrahedralMesh& mesh,
  const isthmus::TetrahedralParameters& parameters, vtkUnstructuredGrid* grid)
{
  const std::string unmet = isthmus::UnmetBounds(mesh, parameters);
  if (!unmet.empty())
  {
    AddText(grid->GetFieldData(), "UnmetBounds", unmet);
  }
  return warning + (warning.empty() || unmet.empty() ? "" : " ") + unmet;
}

/// Fills `grid` by whatever way works; returns what the user should be warned of.
std::string FillByAnyWay(const isthmus::CleanedSurface& surface,
  isthmus::TetrahedralParameters parameters, const isthmus::ProgressCallback& progress,
  vtkUnstructuredGrid* grid)
{
  isthmus::AutomaticMesh made = isthmus::AutomaticTetrahedra(surface.Mesh, parameters, progress);
  RenameOriginals(surface.OriginalPoints, made.Mesh);
  isthmus::SetGrid(made.Mesh, grid);
  if (!made.Mesh.Tetrahedra.empty())
  {
    AddReport(made, grid->GetFieldData());
  }
  std::string warning = made.Hausdorff > 0.0 || made.IsDoubtful ? made.Report : std::string();
  if (made.Backend == isthmus::MeshingBackend::Stuffing)
  {
    return warning;
  }
  parameters.Library = made.Backend == isthmus::MeshingBackend::RepairedCGAL
    ? isthmus::TetrahedralLibrary::CGAL
    : isthmus::TetrahedralLibrary::TetGen;
  return WithUnmetBounds(warning, made.Mesh, parameters, grid);
}

/// Fills `grid` by the library asked for, after repair if that is wanted; returns likewise.
std::string FillByLibrary(const isthmus::CleanedSurface& surface, bool repair,
  isthmus::TetrahedralParameters parameters, const isthmus::ProgressCallback& progress,
  vtkUnstructuredGrid* grid)
{
  isthmus::RepairedSurface repaired;
  parameters.Repaired = repair && !surface.Mesh.Triangles.empty();
  if (parameters.Repaired)
  {
    repaired = isthmus::RepairSurface(surface.Mesh, isthmus::Between(progress, 0.0, 0.2));
  }
  isthmus::TetrahedralMesh result =
    isthmus::MeshTetrahedra(parameters.Repaired ? repaired.Mesh : surface.Mesh, parameters,
      isthmus::Between(progress, 0.2, 1.0));
  if (parameters.Repaired)
  {
    RenameOriginals(repaired.OriginalPoints, result);
  }
  RenameOriginals(surface.OriginalPoints, result);
  isthmus::SetGrid(result, grid);
  if (!repaired.Changes.empty())
  {
    AddText(grid->GetFieldData(), "Repair", repaired.Changes);
  }
  return WithUnmetBounds(repaired.Changes, result, parameters, grid);
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
  auto* grid = vtkUnstructuredGrid::GetData(output);
  return isthmus::Guarded(this, output,
    [&]
    {
      const auto surface = isthmus::GatherSurface(this, vtkPolyData::GetData(input[0]));
      const isthmus::CleanedSurface taken = isthmus::CleanSurface(isthmus::MeshOf(surface));
      if (!taken.Message.empty())
      {
        vtkWarningMacro(<< taken.Message);
      }
      const isthmus::TetrahedralParameters parameters = ParametersOf(this);
      const auto progress = isthmus::ProgressOf(this);
      grid->GetFieldData()->PassData(surface->GetFieldData());
      const std::string warning = this->Library == Automatic
        ? FillByAnyWay(taken, parameters, progress, grid)
        : FillByLibrary(taken, this->Repair, parameters, progress, grid);
      if (!warning.empty())
      {
        vtkWarningMacro(<< warning);
      }
    });
}

void vtkTetrahedralMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Library: "
     << (this->Library == TetGen    ? "TetGen"
            : this->Library == CGAL ? "CGAL"
                                    : "Automatic")
     << "\n";
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
  os << indent << "LloydIterations: " << this->LloydIterations << "\n";
  os << indent << "ODTIterations: " << this->ODTIterations << "\n";
  os << indent << "OptimisationTimeLimit: " << this->OptimisationTimeLimit << "\n";
  os << indent << "PerturbTimeLimit: " << this->PerturbTimeLimit << "\n";
  os << indent << "Exude: " << this->Exude << "\n";
}
