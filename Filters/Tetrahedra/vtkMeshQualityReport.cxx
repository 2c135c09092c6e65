#include "vtkMeshQualityReport.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Tetrahedra/MeshQuality.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkCommunicator.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

vtkStandardNewMacro(vtkMeshQualityReport);

const std::vector<isthmus::OutputArray>& vtkMeshQualityReport::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Cells, "SmallestAngle", 1, "degrees", ArrayChoice::None,
      "of a triangle; dihedral, of a tetrahedron" },
    { 0, ArrayPlace::Cells, "LargestAngle", 1, "degrees", ArrayChoice::None,
      "of a triangle; dihedral, of a tetrahedron" },
    { 0, ArrayPlace::Cells, "RadiusEdgeRatio", 1, "", ArrayChoice::None,
      "circumradius / shortest edge: 0.577 for the equilateral triangle, 0.612 for the regular "
      "tetrahedron; infinite for cells without area or volume" },
    { 0, ArrayPlace::Cells, "Volume", 1, "length^3", ArrayChoice::None,
      "of a tetrahedron; positive in VTK's order of the corners" },
    { 0, ArrayPlace::Field, "QualitySummary", 1, "", ArrayChoice::None, "one line" },
    { 0, ArrayPlace::Field, "QualityMeasures", 0, "", ArrayChoice::None,
      "components: smallest angle, largest angle, largest radius-edge ratio, slivers (a "
      "dihedral angle below 5 degrees), inverted tetrahedra" },
    { 1, ArrayPlace::Rows, "Angle", 1, "degrees", ArrayChoice::None, "middle of the bin" },
    { 1, ArrayPlace::Rows, "Count", 1, "", ArrayChoice::None, "angles in the bin" },
    { 1, ArrayPlace::Rows, "Fraction", 1, "", ArrayChoice::None, "of all angles" },
  };
  return table;
}

namespace
{

/// All cells of `mesh`, which must be of that type. Throws std::invalid_argument, with the cell,
/// where one is not, or names a point that does not exist.
template <std::size_t Corners>
std::vector<std::array<vtkIdType, Corners>> CollectCells(vtkPointSet* mesh, int type)
{
  std::vector<std::array<vtkIdType, Corners>> cells(
    static_cast<std::size_t>(mesh->GetNumberOfCells()));
  vtkNew<vtkIdList> ids;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    if (mesh->GetCellType(id) != type)
    {
      throw std::invalid_argument("Cell " + std::to_string(i) + " is a " +
        mesh->GetCell(id)->GetClassName() +
        ", but only triangles (poly data) and tetrahedra (unstructured grids) are measured: pass "
        "the mesh through Triangulate or Tetrahedralize first.");
    }
    mesh->GetCellPoints(id, ids);
    for (std::size_t c = 0; c < Corners; ++c)
    {
      const vtkIdType corner = ids->GetId(static_cast<vtkIdType>(c));
      if (corner < 0 || corner >= mesh->GetNumberOfPoints())
      {
        throw std::invalid_argument("Cell " + std::to_string(i) + " has the corner " +
          std::to_string(corner) + ", but the mesh has " +
          std::to_string(mesh->GetNumberOfPoints()) + " points: the mesh is damaged.");
      }
      cells[i][c] = corner;
    }
  }
  return cells;
}

std::vector<isthmus::Point3> CollectPoints(vtkPointSet* mesh)
{
  std::vector<isthmus::Point3> points(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mesh->GetPoint(static_cast<vtkIdType>(i), points[i].data());
    for (const double coordinate : points[i])
    {
      if (!std::isfinite(coordinate))
      {
        throw std::invalid_argument("Point " + std::to_string(i) +
          " has a coordinate that is not a finite number: remove or correct it first.");
      }
    }
  }
  return points;
}

/// Flags of the cells that other ranks also have.
isthmus::View<unsigned char> GetGhosts(vtkPointSet* mesh)
{
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  return ghosts ? isthmus::View<unsigned char>(
                    ghosts->GetPointer(0), static_cast<std::size_t>(ghosts->GetNumberOfTuples()))
                : isthmus::View<unsigned char>();
}

std::string Line(const isthmus::QualitySummary& s, bool tetrahedra)
{
  using isthmus::FixedNumber;
  return isthmus::JoinText(s.Cells, tetrahedra ? " tetrahedra, volume " : " triangles, area ",
    isthmus::FormatNumber(s.TotalSize, 8), tetrahedra ? ", dihedral angles " : ", angles ",
    FixedNumber(s.SmallestAngle, 2), " to ", FixedNumber(s.LargestAngle, 2),
    " degrees, radius-edge ratio up to ", FixedNumber(s.LargestRadiusEdge, 3),
    tetrahedra ? isthmus::JoinText(", ", s.Slivers, " slivers, ", s.Inverted, " inverted")
               : std::string());
}

void FillHistogram(const isthmus::QualitySummary& summary, vtkTable* table)
{
  vtkFieldData* const data = table->GetRowData();
  const auto all = static_cast<double>(
    std::accumulate(summary.Bins.begin(), summary.Bins.end(), std::int64_t{ 0 }));
  const double width = 180.0 / static_cast<double>(summary.Bins.size());
  isthmus::AddComputedColumn<vtkDoubleArray>(data, "Angle", summary.Bins.size(),
    [width](std::size_t bin) { return width * (static_cast<double>(bin) + 0.5); });
  isthmus::AddColumn<vtkIdTypeArray>(data, "Count", summary.Bins);
  isthmus::AddComputedColumn<vtkDoubleArray>(data, "Fraction", summary.Bins,
    [all](std::int64_t count) { return all > 0.0 ? static_cast<double>(count) / all : 0.0; });
}

/// The combined summary of all ranks.
isthmus::QualitySummary CombineRanks(vtkAlgorithm* filter, const isthmus::QualitySummary& own)
{
  isthmus::RequireNoBlocks(filter);
  if (isthmus::NumberOfRanks() == 1)
  {
    return own;
  }
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  isthmus::QualitySummary all = own;
  std::vector<vtkIdType> mine(own.Bins.begin(), own.Bins.end());
  mine.insert(mine.end(), { own.Cells, own.Slivers, own.Inverted });
  std::vector<vtkIdType> counts(mine.size());
  controller->AllReduce(
    mine.data(), counts.data(), static_cast<vtkIdType>(mine.size()), vtkCommunicator::SUM_OP);
  all.Inverted = counts.back();
  all.Slivers = counts[counts.size() - 2];
  all.Cells = counts[counts.size() - 3];
  all.Bins.assign(counts.begin(), counts.end() - 3);
  controller->AllReduce(&own.TotalSize, &all.TotalSize, 1, vtkCommunicator::SUM_OP);
  controller->AllReduce(&own.SmallestAngle, &all.SmallestAngle, 1, vtkCommunicator::MIN_OP);
  controller->AllReduce(&own.LargestAngle, &all.LargestAngle, 1, vtkCommunicator::MAX_OP);
  controller->AllReduce(&own.LargestRadiusEdge, &all.LargestRadiusEdge, 1, vtkCommunicator::MAX_OP);
  return all;
}

void AddSummary(const isthmus::QualitySummary& s, const std::string& line, vtkFieldData* data)
{
  isthmus::AddColumn<vtkStringArray>(data, "QualitySummary", { line });
  auto* numbers = isthmus::AddTuple<vtkDoubleArray>(data, "QualityMeasures",
    std::array<double, 5>{ s.SmallestAngle, s.LargestAngle, s.LargestRadiusEdge,
      static_cast<double>(s.Slivers), static_cast<double>(s.Inverted) });
  const char* const names[] = { "SmallestAngle", "LargestAngle", "LargestRadiusEdgeRatio",
    "Slivers", "Inverted" };
  for (int c = 0; c < 5; ++c)
  {
    numbers->SetComponentName(c, names[c]);
  }
}

}

vtkMeshQualityReport::vtkMeshQualityReport()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkMeshQualityReport::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkMeshQualityReport::FillOutputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPointSet" : "vtkTable");
  return 1;
}

int vtkMeshQualityReport::RequestDataObject(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkDataObject* mesh = vtkDataObject::GetData(input[0]);
  vtkInformation* marked = output->GetInformationObject(0);
  vtkDataObject* present = vtkDataObject::GetData(marked);
  if (mesh && (!present || !present->IsA(mesh->GetClassName())))
  {
    marked->Set(vtkDataObject::DATA_OBJECT(), vtk::TakeSmartPointer(mesh->NewInstance()));
  }
  if (!vtkTable::GetData(output, 1))
  {
    output->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), vtkNew<vtkTable>());
  }
  return mesh ? 1 : 0;
}

int vtkMeshQualityReport::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* mesh = vtkPointSet::GetData(input[0]);
  auto* marked = vtkPointSet::GetData(output, 0);
  auto* histogram = vtkTable::GetData(output, 1);
  this->Summary.clear();
  return isthmus::RunGuarded(this, output,
    [&]
    {
      const auto progress = isthmus::MakeProgress(this);
      const bool tetrahedra = mesh->IsA("vtkUnstructuredGrid") != 0;
      const auto points = CollectPoints(mesh);
      std::vector<isthmus::CellAngles> cells;
      const isthmus::View<unsigned char> ghosts = GetGhosts(mesh);
      const isthmus::QualitySummary own = tetrahedra
        ? isthmus::MeasureQuality(
            points, CollectCells<4>(mesh, VTK_TETRA), this->NumberOfBins, cells, progress, ghosts)
        : isthmus::MeasureQuality({ points, CollectCells<3>(mesh, VTK_TRIANGLE) },
            this->NumberOfBins, cells, progress, ghosts);
      if (!own.InvertedCellsMessage.empty())
      {
        vtkWarningMacro(<< own.InvertedCellsMessage);
      }
      const isthmus::QualitySummary summary = CombineRanks(this, own);
      marked->ShallowCopy(mesh);
      if (summary.Cells == 0)
      {
        return;
      }
      this->Summary = Line(summary, tetrahedra);
      const auto add = [&](const char* name, double isthmus::CellAngles::*member)
      {
        isthmus::AddComputedColumn<vtkDoubleArray>(marked->GetCellData(), name, cells,
          [member](const isthmus::CellAngles& cell) { return cell.*member; });
      };
      add("SmallestAngle", &isthmus::CellAngles::Smallest);
      add("LargestAngle", &isthmus::CellAngles::Largest);
      add("RadiusEdgeRatio", &isthmus::CellAngles::RadiusEdge);
      if (tetrahedra)
      {
        add("Volume", &isthmus::CellAngles::Size);
      }
      marked->GetCellData()->SetActiveScalars("SmallestAngle");
      AddSummary(summary, this->Summary, marked->GetFieldData());
      if (isthmus::OnFirstRank())
      {
        FillHistogram(summary, histogram);
      }
    });
}

void vtkMeshQualityReport::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
  os << indent << "Summary: " << this->Summary << "\n";
}
