#include "vtkChokingLoops.h"

#include "ChokingLoops/ChokingLoopArrays.h"
#include "ChokingLoops/ChokingLoopsOutput.h"
#include "ChokingLoops/LoopDrawing.h"
#include "ChokingLoops/MeshLoops.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "Core/AlgorithmGuard.h"
#include "Core/Cached.h"
#include "Core/GatherRanks.h"
#include "Core/MemoryBudget.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Remeshing/SurfaceRepair.h"
#include "Surfaces/ShellNesting.h"

#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkLogger.h>
#include <vtkObjectFactory.h>
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

}

class vtkChokingLoops::vtkInternals
{
public:
  /// Surface, mesh and what the analysis depends on.
  using Key = std::tuple<isthmus::ObjectState, isthmus::ObjectState, isthmus::LoopFiltration,
    isthmus::MeshFunction, std::string, double, double, bool, bool, int>;
  struct Analysis
  {
    std::unique_ptr<isthmus::ChokingLoops> Loops;
    isthmus::DrawnFeatures Geometry; ///< by Method
    isthmus::MembraneMethod Method = isthmus::MembraneMethod::Automatic;
  };
  isthmus::Cached<Key, Analysis> Cache;

  /// The analysis of this execution.
  Analysis& Current() { return *this->Cache.Last(); }
};

const std::vector<isthmus::OutputArray>& vtkChokingLoops::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    ISTHMUS_LOOP_ARRAY_ROWS(0),
    { 0, ArrayPlace::Field, "Repaired", 1, "", ArrayChoice::None,
      "number of triangles changed by a repair; missing without one" },
    { 0, ArrayPlace::Field, "RepairedPlaces", 3, "length", ArrayChoice::None, "their centers" },
    { 1, ArrayPlace::Cells, "FeatureId", 1, "", ArrayChoice::None, "of the loop" },
    { 1, ArrayPlace::Cells, "Area", 1, "length^2", ArrayChoice::None, "of the membrane" },
    { 1, ArrayPlace::Cells, "Radius", 1, "length", ArrayChoice::None,
      "of the ball that gets stuck" },
    { 1, ArrayPlace::Cells, "Birth", 1, "length", ArrayChoice::None, "equal to Radius" },
    { 1, ArrayPlace::Cells, "Death", 1, "length", ArrayChoice::None,
      "radius at which the space behind the narrowing is filled" },
    { 1, ArrayPlace::Cells, "Persistence", 1, "length", ArrayChoice::None, "Death - Birth" },
    { 1, ArrayPlace::Cells, "Kind", 1, "", ArrayChoice::None, "0 handle, 1 tunnel, 2 additional" },
    { 1, ArrayPlace::Cells, "Method", 1, "", ArrayChoice::None,
      "by which the membrane was computed: 0 if the chosen method found none; unless "
      "MembraneMethod is Automatic" },
    { 1, ArrayPlace::Cells, "GrowthCost", 1, "length", ArrayChoice::None,
      "sum of the path costs of the growth, before shortening; 0 for another method; with Greedy" },
    ISTHMUS_CHOKE_POINT_ARRAY_ROWS(2),
    { 3, ArrayPlace::Rows, "FeatureId", 1, "", ArrayChoice::None, "number of the feature" },
    { 3, ArrayPlace::Rows, "Dimension", 1, "", ArrayChoice::None, "of the homology class" },
    { 3, ArrayPlace::Rows, "Side", 1, "", ArrayChoice::None, "0 inside, 1 outside" },
    { 3, ArrayPlace::Rows, "Radius", 1, "length", ArrayChoice::None,
      "of the ball that gets stuck" },
    { 3, ArrayPlace::Rows, "Birth", 1, "length", ArrayChoice::None, "equal to Radius" },
    { 3, ArrayPlace::Rows, "Death", 1, "length", ArrayChoice::None,
      "radius at which the space behind the narrowing is filled" },
    { 3, ArrayPlace::Rows, "Persistence", 1, "length", ArrayChoice::None, "Death - Birth" },
    { 3, ArrayPlace::Rows, "Kind", 1, "", ArrayChoice::None,
      "0 handle, 1 tunnel, 2 additional, 3 noise, or the surface itself" },
  };
  return table;
}

vtkChokingLoops::vtkChokingLoops()
  : Internals(std::make_unique<vtkInternals>())
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
  const isthmus::LoopSearchParameters& p = this->Parameters;
  const vtkInternals::Key key{ isthmus::GetState(surface), isthmus::GetState(grid), p.Filtration,
    p.MorseFunction, p.MorseArrayName, p.SampleSpacing, p.Accuracy, p.AllowSelfIntersections,
    p.CapHoles, p.MemoryLimit };
  this->Internals->Cache.Get(key,
    [&]
    {
      vtkInternals::Analysis made;
      made.Loops = this->AnalyseSurface(surface, grid);
      this->Report(*made.Loops);
      return made;
    });
}

std::unique_ptr<isthmus::ChokingLoops> vtkChokingLoops::AnalyseSurface(
  vtkPolyData* surface, vtkDataObject* grid)
{
  isthmus::RequireFinitePositions(vtkPointSet::SafeDownCast(grid), "the mesh");
  std::fill_n(this->StageTimes, 5, 0.0);
  const auto progress = isthmus::Between(isthmus::MakeProgress(this), 0.0, AnalysisPart);
  isthmus::TriangleMesh triangles = isthmus::ToTriangleMesh(surface);
  if (triangles.Triangles.empty())
  {
    throw std::invalid_argument("The surface has " + std::to_string(triangles.Points.size()) +
      " points but no triangles: choking loops need a closed surface. Create one from the points "
      "(Alpha Shape, Contour).");
  }
  const bool isDelaunay = this->Parameters.Filtration == isthmus::LoopFiltration::Delaunay;
  if (this->Parameters.CapHoles)
  {
    isthmus::RepairedSurface repaired =
      isthmus::RepairSurface(triangles, isthmus::Between(progress, 0.0, 0.0));
    triangles = std::move(repaired.Mesh);
    if (!repaired.Changes.empty())
    {
      vtkWarningMacro(<< repaired.Changes);
    }
  }
  if (isDelaunay)
  {
    return std::make_unique<isthmus::ChokingLoops>(
      std::move(triangles), this->Parameters, progress);
  }
  return isthmus::AnalyseOnTetrahedra(
    std::move(triangles), vtkUnstructuredGrid::SafeDownCast(grid), this->Parameters,
    [this](const std::string& text) { vtkWarningMacro(<< text); }, progress);
}

void vtkChokingLoops::Report(const isthmus::ChokingLoops& analysis)
{
  if (!analysis.Repairs().Message.empty())
  {
    vtkWarningMacro(<< analysis.Repairs().Message);
  }
  // With TrustedOnly, this note would concern features that are not reported.
  if (!analysis.Remark().empty() && !this->Parameters.TrustedOnly)
  {
    vtkWarningMacro(<< analysis.Remark());
  }
  const isthmus::ChokingLoopTimes& t = analysis.Times();
  const double times[] = { t.Check, t.Sampling, t.Filtration, t.Pairing, t.Features };
  std::copy_n(times, 5, this->StageTimes);
}

int vtkChokingLoops::RoundsOfShortening() const
{
  const isthmus::LoopSearchParameters& p = this->Parameters;
  return p.Shortening == isthmus::ShorteningMode::None ? 0
    : p.Shortening == isthmus::ShorteningMode::Rounds  ? p.ShorteningRounds
                                                       : ManyRounds;
}

std::vector<isthmus::ShownFeature> vtkChokingLoops::DrawLoops()
{
  isthmus::ChokingLoops& analysis = *this->Internals->Current().Loops;
  const int rounds = this->RoundsOfShortening();
  const std::vector<std::size_t> chosen = analysis.Select(this->Parameters);
  const isthmus::MembraneMethod method = this->Parameters.MembraneMethod;
  if (this->Internals->Current().Method != method)
  {
    this->Internals->Current().Geometry.clear();
    this->Internals->Current().Method = method;
  }
  if (method == isthmus::MembraneMethod::Greedy &&
    this->Parameters.Filtration == isthmus::LoopFiltration::Delaunay)
  {
    vtkWarningMacro(
      << "Greedy membranes need the filtration Tetrahedral mesh: all points of the Delaunay "
         "filtration lie on the surface. The automatic membranes are used instead.");
  }
  const auto progress = isthmus::Between(isthmus::MakeProgress(this), AnalysisPart, 1.0);
  isthmus::DrawFeatures(
    analysis, chosen, rounds, this->Internals->Current().Geometry, progress, method);
  std::vector<isthmus::ShownFeature> shown;
  for (const std::size_t feature : chosen)
  {
    const isthmus::LoopFeature& geometry =
      this->Internals->Current().Geometry.at({ feature, rounds });
    if (!geometry.Loops.empty()) // features without a loop are neither drawn nor counted
    {
      shown.push_back({ feature, &geometry });
    }
  }
  isthmus::FindShared(analysis, shown);
  isthmus::ApplyLimits(analysis, this->Parameters, shown);
  return shown;
}

void vtkChokingLoops::AddCounts(std::size_t shown, vtkPolyData* output)
{
  const isthmus::ChokingLoops& analysis = *this->Internals->Current().Loops;
  isthmus::FeatureSelection selection = this->Parameters;
  selection.TrustedOnly = false;
  selection.MaximumNumberOfLoops = 0;
  std::size_t all = 0, untrusted = 0;
  for (const std::size_t feature : analysis.Select(selection))
  {
    const auto drawn =
      this->Internals->Current().Geometry.find({ feature, this->RoundsOfShortening() });
    if (drawn == this->Internals->Current().Geometry.end() || !drawn->second.Loops.empty())
    {
      ++all;
      untrusted += analysis.Diagram().Features[feature].Trusted ? 0 : 1;
    }
  }
  vtkFieldData* const data = output->GetFieldData();
  isthmus::AddColumn<vtkIdTypeArray>(data, "NumberOfFeatures", { all });
  isthmus::AddColumn<vtkIdTypeArray>(data, "NumberOfUntrustedFeatures", { untrusted });
  isthmus::AddColumn<vtkIdTypeArray>(data, "NumberOfShownFeatures", { shown });
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
      isthmus::Check(this->Parameters);
      this->Analyse(surface, mesh);
      if (this->Parameters.AllowSelfIntersections)
      {
        vtkWarningMacro(
          << "The surface was not checked for self-intersections: where it crosses itself, inside "
             "and outside are not defined and the counts are not guaranteed.");
      }
      const std::vector<isthmus::ShownFeature> shown = this->DrawLoops();
      const isthmus::ChokingLoops& analysis = *this->Internals->Current().Loops;
      isthmus::FillLoops(analysis, shown, loops);
      isthmus::FillMembranes(analysis, shown, this->Internals->Current().Method, membranes);
      isthmus::FillChokePoints(analysis, shown, points);
      isthmus::FillDiagram(analysis, diagram);
      isthmus::AddAnalysisFieldData(analysis, shown, loops);
      this->AddCounts(shown.size(), loops);
    });
}

void vtkChokingLoops::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Side: " << this->GetSide() << "\n";
  os << indent << "MaximumRadius: " << this->GetMaximumRadius() << "\n";
  os << indent << "MaximumRadiusUnit: " << this->GetMaximumRadiusUnit() << "\n";
  os << indent << "MinimumPersistence: " << this->GetMinimumPersistence() << "\n";
  os << indent << "MinimumPersistenceUnit: " << this->GetMinimumPersistenceUnit() << "\n";
  os << indent << "ThresholdMode: " << this->GetThresholdMode() << "\n";
  os << indent << "MaximumNumberOfLoops: " << this->GetMaximumNumberOfLoops() << "\n";
  os << indent << "TrustedOnly: " << this->GetTrustedOnly() << "\n";
  os << indent << "MaximumLength: " << this->GetMaximumLength() << "\n";
  os << indent << "MaximumReach: " << this->GetMaximumReach() << "\n";
  os << indent << "LoopOrder: " << this->GetLoopOrder() << "\n";
  os << indent << "IncludeHandles: " << this->GetIncludeHandles() << "\n";
  os << indent << "IncludeTunnels: " << this->GetIncludeTunnels() << "\n";
  os << indent << "IncludeBottlenecks: " << this->GetIncludeBottlenecks() << "\n";
  os << indent << "AlwaysIncludeHandles: " << this->GetAlwaysIncludeHandles() << "\n";
  os << indent << "Filtration: " << this->GetFiltration() << "\n";
  os << indent << "MorseFunction: " << this->GetMorseFunction() << "\n";
  os << indent << "MorseArrayName: " << this->GetMorseArrayName() << "\n";
  os << indent << "SampleSpacing: " << this->GetSampleSpacing() << "\n";
  os << indent << "Accuracy: " << this->GetAccuracy() << "\n";
  os << indent << "Shortening: " << this->GetShortening() << "\n";
  os << indent << "ShorteningRounds: " << this->GetShorteningRounds() << "\n";
  os << indent << "MembraneMethod: " << this->GetMembraneMethod() << "\n";
  os << indent << "AllowSelfIntersections: " << this->GetAllowSelfIntersections() << "\n";
  os << indent << "CapHoles: " << this->GetCapHoles() << "\n";
  os << indent << "MemoryLimit: " << this->GetMemoryLimit() << "\n";
}
