#include "vtkTetrahedralMesher.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/MemoryBudget.h"
#include "Core/NamedColumns.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"
#include "Core/TetrahedralMesh.h"
#include "Remeshing/SurfaceRepair.h"
#include "Surfaces/SurfaceCleaning.h"
#include "Tetrahedra/AutomaticMesher.h"
#include "Tetrahedra/TetrahedralGrid.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

vtkStandardNewMacro(vtkTetrahedralMesher);

const std::vector<isthmus::OutputArray>& vtkTetrahedralMesher::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Cells, "RegionId", 1, "", ArrayChoice::None,
      "solids 1, 2, ..., exterior 0, cavities -1, -2, ...; by stuffing 1 in solids, else 0" },
    { 0, ArrayPlace::Points, "OriginalPointId", 1, "", ArrayChoice::None,
      "point of the surface; -1: a new point" },
    { 0, ArrayPlace::Field, "Repair", 1, "", ArrayChoice::None,
      "what a repair changed; missing without one" },
    { 0, ArrayPlace::Field, "UnmetBounds", 1, "", ArrayChoice::None,
      "by how much tetrahedra exceed the bounds; missing if none does" },
    { 0, ArrayPlace::Field, "Engine", 1, "", ArrayChoice::None,
      "the backend used; with Automatic" },
    { 0, ArrayPlace::Field, "EngineReport", 1, "", ArrayChoice::None,
      "why that backend, and how far the surface moved; with Automatic" },
    { 0, ArrayPlace::Field, "HausdorffDistance", 1, "length", ArrayChoice::None,
      "by which the surface moved; with Automatic" },
    { 0, ArrayPlace::Field, "VolumeBefore", 1, "length^3", ArrayChoice::None,
      "of the solids; with Automatic" },
    { 0, ArrayPlace::Field, "VolumeAfter", 1, "length^3", ArrayChoice::None,
      "of the solids; with Automatic" },
    { 0, ArrayPlace::Field, "VolumeIsDoubtful", 1, "", ArrayChoice::None,
      "1 where they differ by more than a hundredth, else 0; with Automatic" },
  };
  return table;
}

namespace
{

/// The default limit of Automatic, which tries again with less after a failure.
constexpr double AutomaticBytes = 8.0 * 1024 * 1024 * 1024;

void AddReport(const isthmus::AutomaticMesh& made, vtkFieldData* fields)
{
  static const char* const names[] = { "TetGen", "TetGen after repair", "CGAL after repair",
    "Stuffing" };
  isthmus::AddColumn<vtkStringArray>(fields, "Engine", { names[static_cast<int>(made.Backend)] });
  isthmus::AddColumn<vtkStringArray>(fields, "EngineReport", { made.Report });
  if (!made.Changes.empty())
  {
    isthmus::AddColumn<vtkStringArray>(fields, "Repair", { made.Changes });
  }
  isthmus::AddColumn<vtkDoubleArray>(fields, "HausdorffDistance", { made.Hausdorff });
  isthmus::AddColumn<vtkDoubleArray>(fields, "VolumeBefore", { made.VolumeBefore });
  isthmus::AddColumn<vtkDoubleArray>(fields, "VolumeAfter", { made.VolumeAfter });
  isthmus::AddColumn<vtkDoubleArray>(fields, "VolumeIsDoubtful", { made.IsDoubtful ? 1.0 : 0.0 });
}

/// Replaces ids of points of a surface by those of the input surface; -1 stays.
void RenameOriginals(const std::vector<std::int64_t>& original, isthmus::TetrahedralMesh& mesh)
{
  for (std::int64_t& id : mesh.OriginalPoints)
  {
    id = id < 0 ? id : original[static_cast<std::size_t>(id)];
  }
}

/// Adds the field data `UnmetBounds` if there are any, and returns `warning` with them appended.
std::string AddUnmetBounds(const std::string& warning, const isthmus::TetrahedralMesh& mesh,
  const isthmus::TetrahedralParameters& parameters, vtkUnstructuredGrid* grid)
{
  const std::string unmet = isthmus::UnmetBounds(mesh, parameters);
  if (!unmet.empty())
  {
    isthmus::AddColumn<vtkStringArray>(grid->GetFieldData(), "UnmetBounds", { unmet });
  }
  return warning + (warning.empty() || unmet.empty() ? "" : " ") + unmet;
}

/// Fills `grid` by the first method that succeeds; returns the warning.
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
  return AddUnmetBounds(warning, made.Mesh, parameters, grid);
}

/// Fills `grid` by the chosen library, after repair if requested; returns the warning.
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
    isthmus::AddColumn<vtkStringArray>(grid->GetFieldData(), "Repair", { repaired.Changes });
  }
  return AddUnmetBounds(repaired.Changes, result, parameters, grid);
}

}

isthmus::TetrahedralParameters vtkTetrahedralMesher::ResolvedParameters() const
{
  isthmus::RequireChoice<int>("Library", this->Library, Automatic);
  isthmus::RequireRange("MemoryLimit", this->MemoryLimit, 0, isthmus::Unlimited, "It is in MiB.");
  isthmus::TetrahedralParameters parameters = this->Parameters;
  isthmus::MemoryBudget memory = isthmus::MemoryBudget::ForMachine(this->MemoryLimit);
  if (this->Library != Automatic)
  {
    parameters.Library = static_cast<isthmus::TetrahedralLibrary>(this->Library);
  }
  else if (this->MemoryLimit == 0)
  {
    memory = memory.AtMost(AutomaticBytes);
  }
  parameters.TetGen.Limits.Bytes = memory.WholeBytes();
  return parameters;
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
  return isthmus::RunGuarded(this, output,
    [&]
    {
      const isthmus::TetrahedralParameters parameters = this->ResolvedParameters();
      const auto surface = isthmus::GatherSurface(this, vtkPolyData::GetData(input[0]));
      const isthmus::CleanedSurface taken = isthmus::CleanSurface(isthmus::ToTriangleMesh(surface));
      if (!taken.Message.empty())
      {
        vtkWarningMacro(<< taken.Message);
      }
      const auto progress = isthmus::MakeProgress(this);
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
  os << indent << "Side: " << this->GetSide() << "\n";
  os << indent << "BoxMargin: " << this->Parameters.BoxMargin << "\n";
  os << indent << "Repair: " << this->Repair << "\n";
  os << indent << "PreserveSurface: " << this->Parameters.TetGen.PreserveSurface << "\n";
  os << indent << "RadiusEdgeRatio: " << this->Parameters.TetGen.RadiusEdgeRatio << "\n";
  os << indent << "MinimumDihedralAngle: " << this->Parameters.TetGen.MinimumDihedralAngle << "\n";
  os << indent << "MaximumVolume: " << this->Parameters.TetGen.MaximumVolume << "\n";
  os << indent << "TetGenCommand: " << this->Parameters.TetGen.TetGenCommand << "\n";
  os << indent << "TimeLimit: " << this->Parameters.TetGen.Limits.TimeLimit << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "FacetAngle: " << this->Parameters.CGAL.FacetAngle << "\n";
  os << indent << "FacetSize: " << this->Parameters.CGAL.FacetSize << "\n";
  os << indent << "FacetDistance: " << this->Parameters.CGAL.FacetDistance << "\n";
  os << indent << "CellRadiusEdgeRatio: " << this->Parameters.CGAL.CellRadiusEdgeRatio << "\n";
  os << indent << "CellSize: " << this->Parameters.CGAL.CellSize << "\n";
  os << indent << "LloydIterations: " << this->Parameters.CGAL.LloydIterations << "\n";
  os << indent << "ODTIterations: " << this->Parameters.CGAL.ODTIterations << "\n";
  os << indent << "OptimisationTimeLimit: " << this->Parameters.CGAL.OptimisationTimeLimit << "\n";
  os << indent << "PerturbTimeLimit: " << this->Parameters.CGAL.PerturbTimeLimit << "\n";
  os << indent << "Exude: " << this->Parameters.CGAL.Exude << "\n";
}
