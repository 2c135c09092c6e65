#include "vtkChokingLoops.h"

#include "ChokingLoops/ChokingLoopsOutput.h"
#include "ChokingLoops/LoopDrawing.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/MemoryBudget.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"
#include "Persistence/SurfaceDistance.h"
#include "Remeshing/SurfaceRepair.h"
#include "Surfaces/ShellNesting.h"
#include "Surfaces/SurfaceCleaning.h"
#include "Tetrahedra/TetrahedralMesher.h"

#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>

vtkStandardNewMacro(vtkChokingLoops);

namespace
{

constexpr double AnalysisPart = 0.9; ///< of the progress bar
constexpr int ManyRounds = 1000;     ///< in practice, until nothing gets shorter

/// Seconds in words, rounded up to tenths.
std::string SecondsText(double seconds)
{
  return isthmus::FormatNumber(0.1 * std::ceil(10.0 * seconds)) + " s";
}

constexpr const char* Unsettled = ", including handles or tunnels on the surface's own triangles, "
                                  "which the samples do not resolve.";

void TellDrawing(const isthmus::DrawingCost& cost)
{
  vtkLog(INFO, << isthmus::TextOf("Choking loops: ", cost.Loops, " features still to be drawn, ",
                 "about ", SecondsText(cost.Seconds), "."));
}

/// Logs the minimum memory of an analysis; its time depends on the shape.
void TellEstimate(const isthmus::SurfaceView& surface, double spacing)
{
  // Halved edges are three quarters of the spacing long, on average.
  const double asked =
    spacing > 0.0 ? 2.0 * std::pow(isthmus::EdgeLengthFor(surface, 1.0) / spacing, 2.0) : 20000.0;
  const double samples = std::max(static_cast<double>(surface.Points.size()), asked);
  const auto whole = [](double x) { return x < 1e15 ? static_cast<vtkIdType>(std::ceil(x)) : -1; };
  vtkLog(INFO, << isthmus::TextOf("Choking loops of at least ", whole(samples),
                 " samples: at least ", whole(50.0 + samples / 400.0), " MiB."));
}

/// The analysis' parameters; `memoryLimit` in MiB. The cost of each round is logged.
isthmus::ChokingLoopParameters ParametersOf(
  double sampleSpacing, bool allowSelfIntersections, double memoryLimit)
{
  isthmus::ChokingLoopParameters parameters;
  parameters.SampleSpacing = sampleSpacing;
  parameters.AllowSelfIntersections = allowSelfIntersections;
  parameters.MemoryLimit = memoryLimit * 1048576.0;
  parameters.Estimated = [](const isthmus::AnalysisCost& cost)
  {
    if (cost.Seconds < 0.0)
    {
      vtkLog(INFO, << isthmus::TextOf("Choking loops: ", cost.Samples, " samples, about ",
                     isthmus::MemoryText(cost.Bytes), "."));
      return;
    }
    vtkLog(INFO, << isthmus::TextOf("Choking loops: from sampling to features about ",
                   SecondsText(cost.Seconds), " in all", (cost.Own > 0 ? Unsettled : ".")));
  };
  return parameters;
}

/// All points and cells of `grid`. Throws std::invalid_argument if there are none, or for a cell
/// that is not a tetrahedron, with its number.
isthmus::TetrahedralMesh TetrahedraOf(vtkUnstructuredGrid* grid)
{
  isthmus::TetrahedralMesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    grid->GetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) != VTK_TETRA)
    {
      throw std::invalid_argument("Cell " + std::to_string(c) +
        " of the tetrahedral mesh is not a tetrahedron: tetrahedralize the mesh first.");
    }
    vtkIdType count = 0;
    const vtkIdType* p = nullptr;
    grid->GetCellPoints(c, count, p);
    mesh.Tetrahedra.push_back({ p[0], p[1], p[2], p[3] });
  }
  if (mesh.Tetrahedra.empty())
  {
    throw std::invalid_argument("The second input has no tetrahedra: give a mesh of one side of "
                                "the surface or both, or leave it empty.");
  }
  return mesh;
}

/// Tetrahedra of both sides of a surface, small enough for about 200,000.
isthmus::TetrahedralParameters MeshAround(const isthmus::TriangleMesh& surface)
{
  constexpr double tetrahedra = 2e5;
  isthmus::TetrahedralParameters parameters;
  parameters.Side = isthmus::MeshedSide::Both;
  parameters.BoxMargin = 0.1;
  using isthmus::operator-;
  const isthmus::Bounds3 box = isthmus::BoundsOf(surface);
  const isthmus::Point3 size = box.Max - box.Min;
  const double margin = 2.0 * parameters.BoxMargin * box.Diagonal();
  parameters.TetGen.MaximumVolume =
    (size[0] + margin) * (size[1] + margin) * (size[2] + margin) / tetrahedra;
  return parameters;
}

/// The surface with its triangles split to the size of the tetrahedra: TetGen keeps the surface,
/// and next to a triangle as large as the face of a cube it would create a million tetrahedra, none
/// of them small.
isthmus::TriangleMesh SplitFor(
  const isthmus::TetrahedralParameters& parameters, const isthmus::TriangleMesh& surface)
{
  double edge = std::cbrt(6.0 * std::sqrt(2.0) * parameters.TetGen.MaximumVolume);
  return isthmus::FirstSamples(surface, edge);
}

}

/// The analysis and its input.
struct vtkChokingLoops::Cache
{
  using Key = std::tuple<vtkDataObject*, vtkMTimeType, vtkDataObject*, vtkMTimeType, int, int,
    std::string, double, bool, bool, int>;
  Key MadeOf;
  std::unique_ptr<isthmus::ChokingLoops> Loops;
  isthmus::DrawnFeatures Geometry; ///< by Method
  isthmus::MembraneMethod Method = isthmus::MembraneMethod::Automatic;
};

vtkChokingLoops::vtkChokingLoops()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

vtkChokingLoops::~vtkChokingLoops() = default;

int vtkChokingLoops::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkUnstructuredGrid");
  information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkChokingLoops::FillOutputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == 3 ? "vtkTable" : "vtkPolyData");
  return 1;
}

void vtkChokingLoops::Analyse(vtkPolyData* surface, vtkDataObject* grid)
{
  const Cache::Key key{ surface, surface->GetMTime(), grid, grid ? grid->GetMTime() : 0,
    this->Filtration, this->MorseFunction, this->MorseArrayName, this->SampleSpacing,
    this->AllowSelfIntersections, this->CapHoles, this->MemoryLimit };
  if (this->Kept && this->Kept->MadeOf == key)
  {
    return;
  }
  this->Kept.reset();
  isthmus::RequirePlaces(vtkPointSet::SafeDownCast(grid), "the mesh");
  std::fill_n(this->StageTimes, 5, 0.0);
  const auto progress = isthmus::Between(isthmus::ProgressOf(this), 0.0, AnalysisPart);
  auto made = std::make_unique<Cache>();
  made->MadeOf = key;
  isthmus::TriangleMesh triangles = isthmus::MeshOf(surface);
  if (triangles.Triangles.empty())
  {
    throw std::invalid_argument("The surface has " + std::to_string(triangles.Points.size()) +
      " points but no triangles: choking loops need a closed surface. Create one from the points "
      "(Alpha Shape, Contour).");
  }
  TellEstimate(triangles, this->Filtration == Delaunay ? this->SampleSpacing : 0.0);
  if (this->CapHoles)
  {
    isthmus::RepairedSurface repaired =
      isthmus::RepairSurface(triangles, isthmus::Between(progress, 0.0, 0.0));
    triangles = std::move(repaired.Mesh);
    if (!repaired.Changes.empty())
    {
      vtkWarningMacro(<< repaired.Changes);
    }
  }
  if (this->Filtration == Delaunay)
  {
    const isthmus::ChokingLoopParameters parameters =
      ParametersOf(this->SampleSpacing, this->AllowSelfIntersections, this->MemoryLimit);
    made->Loops =
      std::make_unique<isthmus::ChokingLoops>(std::move(triangles), parameters, progress);
  }
  else
  {
    made->Loops = this->AnalyseMesh(std::move(triangles), vtkUnstructuredGrid::SafeDownCast(grid));
  }
  this->Keep(std::move(made));
}

std::unique_ptr<isthmus::ChokingLoops> vtkChokingLoops::AnalyseMesh(
  isthmus::TriangleMesh triangles, vtkUnstructuredGrid* given)
{
  const auto progress = isthmus::Between(isthmus::ProgressOf(this), 0.0, AnalysisPart);
  const isthmus::CleanedSurface cleaned = isthmus::CleanSurface(std::move(triangles));
  if (!cleaned.Message.empty())
  {
    vtkWarningMacro(<< cleaned.Message);
  }
  const isthmus::TriangleMesh surface =
    given ? cleaned.Mesh : SplitFor(MeshAround(cleaned.Mesh), cleaned.Mesh);
  const isthmus::TetrahedralMesh mesh = given
    ? TetrahedraOf(given)
    : isthmus::MeshTetrahedra(
        surface, MeshAround(cleaned.Mesh), isthmus::Between(progress, 0.0, 0.4));
  const std::vector<double> values = this->MorseValues(surface, mesh, given);
  std::optional<std::vector<double>> errors;
  if (this->MorseFunction != PointArray)
  {
    errors.emplace();
  }
  if (errors && this->MorseFunction != ClosestPoint)
  {
    *errors = isthmus::MorseValues(surface, mesh, isthmus::MorseFunction::ClosestPoint);
    std::transform(values.begin(), values.end(), errors->begin(), errors->begin(),
      [](double value, double exact) { return std::abs(value - exact); });
  }
  return std::make_unique<isthmus::ChokingLoops>(
    surface, mesh, values, errors, isthmus::Between(progress, 0.5, 1.0));
}

void vtkChokingLoops::Keep(std::unique_ptr<Cache> made)
{
  if (!made->Loops->Repairs().Message.empty())
  {
    vtkWarningMacro(<< made->Loops->Repairs().Message);
  }
  // With TrustedOnly the remark would be about features that are not reported.
  if (!made->Loops->Remark().empty() && !this->TrustedOnly)
  {
    vtkWarningMacro(<< made->Loops->Remark());
  }
  const isthmus::ChokingLoopTimes& t = made->Loops->Times();
  const double times[] = { t.Check, t.Sampling, t.Filtration, t.Pairing, t.Features };
  std::copy_n(times, 5, this->StageTimes);
  this->Kept = std::move(made);
}

std::vector<double> vtkChokingLoops::MorseValues(const isthmus::SurfaceView& surface,
  const isthmus::TetrahedralMesh& mesh, vtkUnstructuredGrid* given)
{
  if (this->MorseFunction == PointArray)
  {
    vtkDataArray* array =
      given ? given->GetPointData()->GetArray(this->MorseArrayName.c_str()) : nullptr;
    if (!array || array->GetNumberOfComponents() != 1)
    {
      throw std::invalid_argument("The tetrahedral mesh on the second input has no point array '" +
        this->MorseArrayName + "' of one component: choose one, or another Morse function.");
    }
    std::vector<double> values(mesh.Points.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = array->GetTuple1(static_cast<vtkIdType>(i));
    }
    return values;
  }
  const auto progress = isthmus::Between(isthmus::ProgressOf(this), 0.0, AnalysisPart);
  return isthmus::MorseValues(surface, mesh,
    static_cast<isthmus::MorseFunction>(this->MorseFunction), isthmus::Between(progress, 0.4, 0.5));
}

isthmus::FeatureSelection vtkChokingLoops::Selection() const
{
  isthmus::FeatureSelection selection;
  selection.Inside = this->Side != Outside;
  selection.Outside = this->Side != Inside;
  selection.MaximumRadius = { this->MaximumRadius, this->MaximumRadiusUnit == Percent };
  selection.MinimumPersistence = { this->MinimumPersistence,
    this->MinimumPersistenceUnit == Percent };
  selection.Threshold = this->ThresholdMode == LargestGap ? isthmus::ThresholdMode::LargestGap
                                                          : isthmus::ThresholdMode::Given;
  selection.AlwaysReportHandles = this->AlwaysReportHandles;
  selection.TrustedOnly = this->TrustedOnly;
  selection.MaximumNumber = static_cast<std::size_t>(this->MaximumNumberOfLoops);
  return selection;
}

int vtkChokingLoops::RoundsOfShortening() const
{
  return this->Shortening == None ? 0
    : this->Shortening == Rounds  ? this->ShorteningRounds
                                  : ManyRounds;
}

std::vector<isthmus::ShownFeature> vtkChokingLoops::DrawLoops()
{
  isthmus::ChokingLoops& analysis = *this->Kept->Loops;
  const int rounds = this->RoundsOfShortening();
  const std::vector<std::size_t> chosen = analysis.Select(this->Selection());
  const auto method = static_cast<isthmus::MembraneMethod>(this->MembraneMethod);
  if (this->Kept->Method != method)
  {
    this->Kept->Geometry.clear();
    this->Kept->Method = method;
  }
  if (method == isthmus::MembraneMethod::Greedy && this->Filtration == Delaunay)
  {
    vtkWarningMacro(
      << "Greedy membranes need the filtration Tetrahedral mesh: all points of the Delaunay "
         "filtration lie on the surface. The automatic membranes are used instead.");
  }
  const auto progress = isthmus::Between(isthmus::ProgressOf(this), AnalysisPart, 1.0);
  isthmus::DrawFeatures(
    analysis, chosen, rounds, this->Kept->Geometry, TellDrawing, progress, method);
  std::vector<isthmus::ShownFeature> shown;
  for (const std::size_t feature : chosen)
  {
    const isthmus::LoopFeature& geometry = this->Kept->Geometry.at({ feature, rounds });
    if (!geometry.Loops.empty()) // features without a loop are neither drawn nor counted
    {
      shown.push_back({ feature, &geometry });
    }
  }
  isthmus::FindShared(analysis, shown);
  isthmus::ApplyLimits(
    analysis, { this->MaximumLength, this->MaximumReach, this->LoopOrder == ByLength }, shown);
  return shown;
}

void vtkChokingLoops::AddCounts(std::size_t shown, vtkPolyData* output)
{
  const isthmus::ChokingLoops& analysis = *this->Kept->Loops;
  isthmus::FeatureSelection selection = this->Selection();
  selection.TrustedOnly = false;
  selection.MaximumNumber = 0;
  std::size_t all = 0, untrusted = 0;
  for (const std::size_t feature : analysis.Select(selection))
  {
    const auto drawn = this->Kept->Geometry.find({ feature, this->RoundsOfShortening() });
    if (drawn == this->Kept->Geometry.end() || !drawn->second.Loops.empty())
    {
      ++all;
      untrusted += analysis.Diagram().Features[feature].Trusted ? 0 : 1;
    }
  }
  const auto add = [output](const char* name, std::size_t count)
  {
    vtkNew<vtkIdTypeArray> array;
    array->SetName(name);
    array->InsertNextValue(static_cast<vtkIdType>(count));
    output->GetFieldData()->AddArray(array);
  };
  add("NumberOfFeatures", all);
  add("NumberOfUntrustedFeatures", untrusted);
  add("NumberOfShownFeatures", shown);
}

int vtkChokingLoops::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkSmartPointer<vtkPolyData> whole;
  const auto gather = [&] { whole = isthmus::GatherSurface(this, vtkPolyData::GetData(input[0])); };
  if (isthmus::Succeeds(this, output, gather))
  {
    this->FindLoops(whole, vtkDataObject::GetData(input[1]), output);
  }
  return 1;
}

bool vtkChokingLoops::FindLoops(
  vtkPolyData* surface, vtkDataObject* mesh, vtkInformationVector* output)
{
  auto* loops = vtkPolyData::GetData(output, 0);
  auto* membranes = vtkPolyData::GetData(output, 1);
  auto* points = vtkPolyData::GetData(output, 2);
  auto* diagram = vtkTable::GetData(output, 3);
  if (surface && surface->GetNumberOfPoints() == 0)
  {
    return true;
  }
  return isthmus::Succeeds(this, output,
    [&]
    {
      isthmus::RequireThat(!std::isnan(this->MaximumRadius), "MaximumRadius", this->MaximumRadius,
        "it must be a number");
      isthmus::RequireThat(!std::isnan(this->MinimumPersistence), "MinimumPersistence",
        this->MinimumPersistence, "it must be a number");
      isthmus::RequireThat(!std::isnan(this->MaximumLength), "MaximumLength", this->MaximumLength,
        "it must be a number");
      isthmus::RequireThat(
        !std::isnan(this->MaximumReach), "MaximumReach", this->MaximumReach, "it must be a number");
      this->Analyse(surface, mesh);
      if (this->AllowSelfIntersections)
      {
        vtkWarningMacro(
          << "The surface was not checked for self-intersections: where it crosses itself, inside "
             "and outside are not defined and the counts are not guaranteed.");
      }
      const std::vector<isthmus::ShownFeature> shown = this->DrawLoops();
      const isthmus::ChokingLoops& analysis = *this->Kept->Loops;
      isthmus::FillLoops(analysis, shown, loops);
      isthmus::FillMembranes(analysis, shown, this->Kept->Method, membranes);
      isthmus::FillChokePoints(analysis, shown, points);
      isthmus::FillDiagram(analysis, diagram);
      isthmus::AddAnalysisFieldData(analysis, shown, loops);
      this->AddCounts(shown.size(), loops);
    });
}

void vtkChokingLoops::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Side: " << this->Side << "\n";
  os << indent << "MaximumRadius: " << this->MaximumRadius << "\n";
  os << indent << "MaximumRadiusUnit: " << this->MaximumRadiusUnit << "\n";
  os << indent << "MinimumPersistence: " << this->MinimumPersistence << "\n";
  os << indent << "MinimumPersistenceUnit: " << this->MinimumPersistenceUnit << "\n";
  os << indent << "ThresholdMode: " << this->ThresholdMode << "\n";
  os << indent << "MaximumNumberOfLoops: " << this->MaximumNumberOfLoops << "\n";
  os << indent << "TrustedOnly: " << this->TrustedOnly << "\n";
  os << indent << "MaximumLength: " << this->MaximumLength << "\n";
  os << indent << "MaximumReach: " << this->MaximumReach << "\n";
  os << indent << "LoopOrder: " << this->LoopOrder << "\n";
  os << indent << "AlwaysReportHandles: " << this->AlwaysReportHandles << "\n";
  os << indent << "Filtration: " << this->Filtration << "\n";
  os << indent << "MorseFunction: " << this->MorseFunction << "\n";
  os << indent << "MorseArrayName: " << this->MorseArrayName << "\n";
  os << indent << "SampleSpacing: " << this->SampleSpacing << "\n";
  os << indent << "Shortening: " << this->Shortening << "\n";
  os << indent << "ShorteningRounds: " << this->ShorteningRounds << "\n";
  os << indent << "MembraneMethod: " << this->MembraneMethod << "\n";
  os << indent << "AllowSelfIntersections: " << this->AllowSelfIntersections << "\n";
  os << indent << "CapHoles: " << this->CapHoles << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
