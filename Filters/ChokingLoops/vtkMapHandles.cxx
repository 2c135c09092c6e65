#include "vtkMapHandles.h"

#include "ChokingLoops/ChokingLoopArrays.h"
#include "ChokingLoops/MapHandles.h"
#include "Contouring/AutomaticLevel.h"
#include "Contouring/ClosedLevelSet.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/InnerAlgorithm.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"
#include "Core/SameNodes.h"
#include "Imaging/HalfMapAgreement.h"
#include "Persistence/CubicalPersistence.h"
#include "Persistence/PersistenceCache.h"
#include "vtkChokingLoops.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMapHandles);

const std::vector<isthmus::OutputArray>& vtkMapHandles::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "FeatureId", 1, "", ArrayChoice::None,
      "of the class, as in Scalar Persistence with the same settings" },
    { 0, ArrayPlace::Points, "Dimension", 1, "", ArrayChoice::None, "of the class" },
    { 0, ArrayPlace::Points, "Birth", 1, "of the scalars", ArrayChoice::None,
      "level at which the class appears" },
    { 0, ArrayPlace::Points, "Death", 1, "of the scalars", ArrayChoice::None,
      "level at which it disappears" },
    { 0, ArrayPlace::Points, "Persistence", 1, "of the scalars", ArrayChoice::None,
      "length of the interval, within the range" },
    { 0, ArrayPlace::Points, "Level", 1, "of the scalars", ArrayChoice::None,
      "value of the saddle" },
    { 0, ArrayPlace::Points, "From", 1, "of the scalars", ArrayChoice::None,
      "lowest level at which it exists, within the range" },
    { 0, ArrayPlace::Points, "To", 1, "of the scalars", ArrayChoice::None,
      "highest level at which it exists, within the range" },
    { 0, ArrayPlace::Points, "IsThere", 1, "", ArrayChoice::None,
      "1: it exists at the chosen level" },
    { 0, ArrayPlace::Points, "BootstrapSupport", 1, "", ArrayChoice::None,
      "fraction of resamples in which it is found again, persisting above the threshold; with "
      "half maps" },
    { 0, ArrayPlace::Points, "PValue", 1, "", ArrayChoice::None,
      "for the hypothesis that the object does not have it at the chosen level; with half maps" },
    { 1, ArrayPlace::Points, "FeatureId", 1, "", ArrayChoice::None,
      "of the class, as in Scalar Persistence with the same settings" },
    { 1, ArrayPlace::Points, "Dimension", 1, "", ArrayChoice::None, "of the class" },
    { 1, ArrayPlace::Points, "Birth", 1, "of the scalars", ArrayChoice::None,
      "level at which the class appears" },
    { 1, ArrayPlace::Points, "Death", 1, "of the scalars", ArrayChoice::None,
      "level at which it disappears" },
    { 1, ArrayPlace::Points, "Persistence", 1, "of the scalars", ArrayChoice::None,
      "length of the interval, within the range" },
    { 1, ArrayPlace::Points, "Level", 1, "of the scalars", ArrayChoice::None,
      "value of the saddle" },
    { 1, ArrayPlace::Points, "From", 1, "of the scalars", ArrayChoice::None,
      "lowest level at which it exists, within the range" },
    { 1, ArrayPlace::Points, "To", 1, "of the scalars", ArrayChoice::None,
      "highest level at which it exists, within the range" },
    { 1, ArrayPlace::Points, "IsThere", 1, "", ArrayChoice::None,
      "1: it exists at the chosen level" },
    { 1, ArrayPlace::Points, "BootstrapSupport", 1, "", ArrayChoice::None,
      "fraction of resamples in which it is found again, persisting above the threshold; with "
      "half maps" },
    { 1, ArrayPlace::Points, "PValue", 1, "", ArrayChoice::None,
      "for the hypothesis that the object does not have it at the chosen level; with half maps" },
    { 2, ArrayPlace::Rows, "Level", 1, "of the scalars", ArrayChoice::None, "of the row" },
    { 2, ArrayPlace::Rows, "Beta0", 1, "", ArrayChoice::None,
      "components of the persistent features" },
    { 2, ArrayPlace::Rows, "Beta1", 1, "", ArrayChoice::None,
      "tunnels of the persistent features" },
    { 2, ArrayPlace::Rows, "Beta2", 1, "", ArrayChoice::None,
      "cavities of the persistent features" },
    { 2, ArrayPlace::Rows, "StableLevel", 1, "", ArrayChoice::None,
      "Beta1 in the row of that level, else NaN: a single mark in a chart" },
    { 2, ArrayPlace::Rows, "RecommendedLevel", 1, "", ArrayChoice::None,
      "Beta1 in the row of that level, else NaN" },
    { 3, ArrayPlace::Rows, "From", 1, "of the scalars", ArrayChoice::None,
      "lower end of the interval" },
    { 3, ArrayPlace::Rows, "To", 1, "of the scalars", ArrayChoice::None,
      "upper end of the interval" },
    { 3, ArrayPlace::Rows, "Middle", 1, "of the scalars", ArrayChoice::None,
      "middle of the interval; that of the first row is the stable level" },
    { 3, ArrayPlace::Rows, "Length", 1, "of the scalars", ArrayChoice::None, "of the interval" },
    { 3, ArrayPlace::Rows, "Beta0", 1, "", ArrayChoice::None, "components within the interval" },
    { 3, ArrayPlace::Rows, "Beta1", 1, "", ArrayChoice::None, "tunnels within the interval" },
    { 3, ArrayPlace::Rows, "Beta2", 1, "", ArrayChoice::None, "cavities within the interval" },
    ISTHMUS_LOOP_ARRAY_ROWS(5),
    ISTHMUS_CHOKE_POINT_ARRAY_ROWS(6),
    { -1, ArrayPlace::Field, "Level", 1, "of the scalars", ArrayChoice::None, "the level used" },
    { -1, ArrayPlace::Field, "LevelSource", 1, "", ArrayChoice::None,
      "where the level is from, as text" },
    { -1, ArrayPlace::Field, "StableLevel", 1, "of the scalars", ArrayChoice::None,
      "middle of the longest stable interval" },
    { -1, ArrayPlace::Field, "RecommendedLevel", 1, "of the scalars", ArrayChoice::None,
      "that of the input, if it has one" },
    { -1, ArrayPlace::Field, "HalfMapCorrelation", 1, "", ArrayChoice::None,
      "Pearson's, of means over blocks of 4^3 nodes without those where the halves are equal; "
      "with half maps" },
  };
  return table;
}

namespace isthmus
{
namespace
{

/// Beta1 in the row whose level is nearest to `level`, not a number elsewhere: one mark in a chart.
std::vector<double> Mark(const BettiCurves& curves, double level)
{
  std::vector<double> marks(curves.Levels.size(), std::numeric_limits<double>::quiet_NaN());
  if (!std::isnan(level))
  {
    const auto nearest = std::min_element(curves.Levels.begin(), curves.Levels.end(),
      [level](double a, double b) { return std::abs(a - level) < std::abs(b - level); });
    const auto row = static_cast<std::size_t>(nearest - curves.Levels.begin());
    marks[row] = static_cast<double>(curves.Filtered[1][row]);
  }
  return marks;
}

/// The bridges, or the windows, of `handles` as points at the nodes of `image`, with the arrays of
/// the first two outputs. `level` is the chosen level (for `IsThere`); `support`: null without half
/// maps.
void WriteHandles(const std::vector<MapHandle>& handles, bool bridges, const FeatureList& features,
  vtkImageData* image, double level, const HandleSupport* support, vtkPolyData* output)
{
  std::vector<MapHandle> wanted;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < handles.size(); ++i)
  {
    if (handles[i].IsBridge == bridges)
    {
      wanted.push_back(handles[i]);
      rows.push_back(i);
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const MapHandle& handle : wanted)
  {
    double place[3];
    image->GetPoint(static_cast<vtkIdType>(handle.Node), place);
    const vtkIdType at = points->InsertNextPoint(place);
    vertices->InsertNextCell(1, &at);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  vtkPointData* data = output->GetPointData();
  const auto featureOf = [&features](const MapHandle& handle) -> const ScalarFeature&
  { return features.Features[static_cast<std::size_t>(handle.Feature)]; };
  AddComputedColumn<vtkIdTypeArray>(data, "FeatureId", wanted,
    [](const MapHandle& handle) { return static_cast<vtkIdType>(handle.Feature); });
  AddComputedColumn<vtkIntArray>(data, "Dimension", wanted,
    [&](const MapHandle& handle) { return featureOf(handle).Pair.Dimension; });
  const auto add = [&](const char* name, const auto& of)
  { AddComputedColumn<vtkDoubleArray>(data, name, wanted, of); };
  add("Birth", [&](const MapHandle& handle) { return featureOf(handle).Birth; });
  add("Death", [&](const MapHandle& handle) { return featureOf(handle).Death; });
  add("Persistence", [&](const MapHandle& handle) { return featureOf(handle).Persistence; });
  add("Level", [](const MapHandle& handle) { return handle.Level; });
  add("From", [](const MapHandle& handle) { return handle.Interval[0]; });
  add("To", [](const MapHandle& handle) { return handle.Interval[1]; });
  AddComputedColumn<vtkIntArray>(data, "IsThere", wanted,
    [level](const MapHandle& handle)
    { return handle.Interval[0] <= level && level <= handle.Interval[1] ? 1 : 0; });
  if (support)
  {
    AddComputedColumn<vtkDoubleArray>(
      data, "BootstrapSupport", rows, [support](std::size_t i) { return support->Support[i]; });
    AddComputedColumn<vtkDoubleArray>(
      data, "PValue", rows, [support](std::size_t i) { return support->PValue[i]; });
  }
  data->SetActiveScalars("Level");
}

/// One row per level: Betti numbers of the persistent features, and Beta1 again in the rows nearest
/// to the stable and to the recommended level (NaN: none).
void FillLevels(const BettiCurves& curves, double stable, double recommended, vtkTable* table)
{
  vtkDataSetAttributes* rows = table->GetRowData();
  AddColumn<vtkDoubleArray>(rows, "Level", curves.Levels);
  for (std::size_t d = 0; d < 3; ++d)
  {
    AddColumn<vtkIdTypeArray>(rows, "Beta" + std::to_string(d), curves.Filtered[d]);
  }
  AddColumn<vtkDoubleArray>(rows, "StableLevel", Mark(curves, stable));
  AddColumn<vtkDoubleArray>(rows, "RecommendedLevel", Mark(curves, recommended));
}

/// One row per interval, in their order.
void FillIntervals(const std::vector<StableInterval>& intervals, vtkTable* table)
{
  vtkDataSetAttributes* rows = table->GetRowData();
  const auto add = [&](const char* name, const auto& of)
  { AddComputedColumn<vtkDoubleArray>(rows, name, intervals, of); };
  add("From", [](const StableInterval& interval) { return interval.Low; });
  add("To", [](const StableInterval& interval) { return interval.High; });
  add("Middle", [](const StableInterval& interval) { return interval.Middle(); });
  add("Length", [](const StableInterval& interval) { return interval.High - interval.Low; });
  for (std::size_t d = 0; d < 3; ++d)
  {
    AddComputedColumn<vtkIdTypeArray>(rows, "Beta" + std::to_string(d), intervals,
      [d](const StableInterval& interval) { return interval.Betti[d]; });
  }
}

}
}

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

enum Port
{
  BridgesPort,
  WindowsPort,
  LevelsPort,
  IntervalsPort,
  ContourPort,
  LoopsPort,
  ChokePointsPort,
  PortCount
};

/// The noise as NoiseBootstrap uses it; 0 where it does not fit into a float.
std::vector<float> CopyNoise(vtkDataArray* difference)
{
  std::vector<float> noise(static_cast<std::size_t>(difference->GetNumberOfTuples()));
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    const auto value = static_cast<float>(difference->GetComponent(static_cast<vtkIdType>(i), 0));
    noise[i] = std::isfinite(value) ? value : 0.0F;
  }
  if (std::all_of(noise.begin(), noise.end(), [](float value) { return value == 0.0F; }))
  {
    throw std::invalid_argument("The difference of the half maps is outside the range of single "
                                "precision: multiply both maps by a factor.");
  }
  return noise;
}

}

/// Data of one run.
class vtkMapHandles::vtkInternals
{
public:
  vtkImageData* Image = nullptr;
  vtkDataArray* Scalars = nullptr;
  isthmus::VolumeView Volume;
  isthmus::FeatureParameters Parameters;
  isthmus::FeatureList Features;
  std::vector<isthmus::StableInterval> Intervals;
  isthmus::ChosenLevel Level;
  double RecommendedLevel = NotANumber; ///< of the map's depositors
  vtkSmartPointer<vtkImageData> Mean;   ///< of the half maps
  std::vector<float> Noise;             ///< empty: only one map is given
  double Correlation = NotANumber;      ///< of the half maps
};

vtkMapHandles::vtkMapHandles()
  : Cache(std::make_unique<isthmus::PersistenceCache>())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(PortCount);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkMapHandles::~vtkMapHandles() = default;

void vtkMapHandles::SetOtherHalfData(vtkImageData* half)
{
  this->SetInputData(1, half);
}

int vtkMapHandles::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkMapHandles::FillOutputPortInformation(int port, vtkInformation* info)
{
  const bool isTable = port == LevelsPort || port == IntervalsPort;
  info->Set(vtkDataObject::DATA_TYPE_NAME(), isTable ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkMapHandles::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // A bridge can be anywhere, so the whole map is needed whatever part is requested.
  isthmus::RequestWholeExtent(inputVector[0]->GetInformationObject(0));
  if (vtkInformation* other = inputVector[1]->GetInformationObject(0))
  {
    isthmus::RequestWholeExtent(other);
  }
  return 1;
}

void vtkMapHandles::TakeMaps(vtkInternals& work, vtkImageData* other)
{
  work.Scalars = isthmus::ChosenScalars(this, work.Image);
  if (other)
  {
    vtkDataArray* others = other->GetPointData()->GetArray(work.Scalars->GetName());
    others = others ? others : other->GetPointData()->GetScalars();
    if (!others || others->GetNumberOfComponents() != 1 ||
      others->GetNumberOfTuples() != other->GetNumberOfPoints())
    {
      throw std::invalid_argument("The other half map has no scalars of one number at each node.");
    }
    isthmus::RequireUsualValues(others);
    isthmus::RequireSameNodes(work.Image, other);
    // The resamples are as noisy as a half.
    isthmus::RequireCubicalMemory(isthmus::MakeVolumeView(work.Scalars, work.Image),
      this->InsideIsHigher,
      static_cast<double>(work.Image->GetNumberOfPoints()) *
        (isthmus::FitsFloat(work.Scalars) ? 36.0 : 44.0));
    int n[3];
    work.Image->GetDimensions(n);
    const isthmus::HalfMapAgreement agreement =
      isthmus::CompareHalfMaps({ n[0], n[1], n[2] }, work.Scalars, others);
    if (!agreement.Message().empty())
    {
      vtkWarningMacro(<< agreement.Message());
    }
    work.Correlation = agreement.Correlation;
    const isthmus::HalfMapMean halves =
      isthmus::AverageHalfMaps(work.Scalars, isthmus::RemoveLinearDifference(agreement, others));
    work.Noise = CopyNoise(halves.HalfDifference);
    work.Mean = vtkSmartPointer<vtkImageData>::New();
    work.Mean->CopyStructure(work.Image);
    work.Mean->GetPointData()->SetScalars(halves.Mean);
    work.Image = work.Mean;
    work.Scalars = halves.Mean;
  }
  work.Volume = isthmus::MakeVolumeView(work.Scalars, work.Image);
}

void vtkMapHandles::CheckParameters() const
{
  isthmus::Check(this->Parameters);
  isthmus::RequireLevels(this->NumberOfLevels, this->AutomaticRange ? nullptr : this->Range);
}

void vtkMapHandles::FindFeatures(vtkInternals& work)
{
  const auto& statistics = this->Cache->Statistics(work.Scalars, work.Volume);
  isthmus::FeatureParameters& wanted = work.Parameters;
  wanted.Superlevel = this->InsideIsHigher;
  wanted.MinimumPersistence = this->MinimumPersistence;
  wanted.PersistenceUnit = isthmus::FeatureParameters::StandardDeviations;
  wanted.Range = !this->AutomaticRange ? std::array<double, 2>{ this->Range[0], this->Range[1] }
    : this->InsideIsHigher ? std::array<double, 2>{ statistics.Mean, statistics.Maximum }
                           : std::array<double, 2>{ statistics.Minimum, statistics.Mean };
  if (!(wanted.Range[0] < wanted.Range[1]))
  {
    throw std::invalid_argument(
      "The map has the same value everywhere, so there is no level to choose.");
  }
  isthmus::CubicalParameters parameters;
  parameters.Superlevel = this->InsideIsHigher;
  const auto& pairs = this->Cache->Pairs(
    work.Volume, parameters, isthmus::Between(isthmus::MakeProgress(this), 0.0, 0.3));
  work.Features = isthmus::ScalarFeatures(work.Volume, statistics, pairs, wanted);
  work.Intervals =
    isthmus::StableIntervals(work.Features, this->InsideIsHigher, work.Parameters.Range);
}

void vtkMapHandles::ChooseLevel(vtkInternals& work)
{
  this->StableLevel = work.Intervals.empty() ? NotANumber : work.Intervals.front().Middle();
  if (work.Intervals.empty())
  {
    vtkWarningMacro("No feature of the map persists in the range of levels, so there is no stable "
                    "level: lower MinimumPersistence, or widen Range.");
  }
  work.Level = isthmus::ChooseLevel(
    this->AutomaticLevel, this->Level, work.Image, work.Scalars, this->InsideIsHigher);
}

void vtkMapHandles::FillTables(const vtkInternals& work, vtkInformationVector* outputVector)
{
  const auto handles = isthmus::MapHandles(work.Volume, work.Features, work.Parameters);
  isthmus::HandleSupport support;
  if (!work.Noise.empty())
  {
    isthmus::SupportParameters bootstrap = this->Parameters;
    bootstrap.Level = work.Level.Level;
    support = isthmus::ComputeSupport(handles, work.Volume, work.Parameters,
      work.Features.Threshold, work.Noise, bootstrap,
      isthmus::Between(isthmus::MakeProgress(this), 0.3, this->Loops ? 0.6 : 0.95));
  }
  for (const int port : { BridgesPort, WindowsPort })
  {
    isthmus::WriteHandles(handles, port == BridgesPort, work.Features, work.Image, work.Level.Level,
      work.Noise.empty() ? nullptr : &support, vtkPolyData::GetData(outputVector, port));
  }
  const auto curves = isthmus::CountBetti(work.Features, this->InsideIsHigher,
    isthmus::EvenLevels(work.Parameters.Range[0], work.Parameters.Range[1], this->NumberOfLevels));
  isthmus::FillLevels(
    curves, this->StableLevel, work.RecommendedLevel, vtkTable::GetData(outputVector, LevelsPort));
  isthmus::FillIntervals(work.Intervals, vtkTable::GetData(outputVector, IntervalsPort));
}

void vtkMapHandles::FillSurfaces(const vtkInternals& work, vtkInformationVector* outputVector)
{
  isthmus::ClosedLevelSet level =
    isthmus::CloseLevelSet(work.Image, work.Scalars, work.Level.Level, this->InsideIsHigher);
  isthmus::ToWorld(work.Image, level.Guide);
  vtkPolyData* contour = vtkPolyData::GetData(outputVector, ContourPort);
  isthmus::SetMesh(level.Guide, contour);
  const auto progress = isthmus::MakeProgress(this);
  const double begun = work.Noise.empty() ? 0.4 : 0.6;
  isthmus::Report(progress, begun);
  if (!this->Loops)
  {
    return;
  }
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(contour);
  vtkNew<vtkChokingLoops> loops;
  loops->SetInputData(surface);
  loops->SetContainerAlgorithm(this); // aborted together with this filter
  std::string complaint;              // bridges, windows and levels are valid without the loops
  const auto complain = [&](const std::string& message)
  { complaint += (complaint.empty() ? "" : " ") + message; };
  try
  {
    isthmus::UpdateInner(loops, isthmus::Between(progress, begun, 1.0), complain);
  }
  catch (const isthmus::Cancelled&)
  {
    throw;
  }
  catch (const std::runtime_error& error)
  {
    complain(error.what());
  }
  isthmus::Report(progress, 1.0); // returns at the abort
  if (!complaint.empty())
  {
    vtkWarningMacro(<< isthmus::JoinText("The choking loops of the contour: ", complaint));
  }
  vtkPolyData::GetData(outputVector, LoopsPort)->ShallowCopy(loops->GetOutputDataObject(0));
  vtkPolyData::GetData(outputVector, ChokePointsPort)->ShallowCopy(loops->GetOutputDataObject(2));
}

int vtkMapHandles::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      isthmus::RequireWholeExtent(inputVector[0]->GetInformationObject(0));
      vtkInternals work;
      work.Image = vtkImageData::GetData(inputVector[0], 0);
      if (!work.Image || work.Image->GetNumberOfPoints() == 0 ||
        !isthmus::IsFirstPiece(outputVector->GetInformationObject(BridgesPort)))
      {
        return;
      }
      this->StableLevel = NotANumber;
      this->CheckParameters();
      vtkInformation* other = inputVector[1]->GetInformationObject(0);
      if (other)
      {
        isthmus::RequireWholeExtent(other);
      }
      work.RecommendedLevel = isthmus::RecommendedLevel(work.Image).value_or(NotANumber);
      this->TakeMaps(work, other ? vtkImageData::GetData(other) : nullptr);
      this->FindFeatures(work);
      this->ChooseLevel(work);
      this->FillTables(work, outputVector);
      this->FillSurfaces(work, outputVector);
      for (int port = 0; port < PortCount; ++port)
      {
        vtkDataObject* output = vtkDataObject::GetData(outputVector, port);
        vtkFieldData* const data = output->GetFieldData();
        isthmus::AddColumn<vtkDoubleArray>(data, "StableLevel", { this->StableLevel });
        isthmus::AddLevel(work.Level, output);
        if (work.Mean)
        {
          isthmus::AddColumn<vtkDoubleArray>(data, "HalfMapCorrelation", { work.Correlation });
        }
        if (!std::isnan(work.RecommendedLevel))
        {
          isthmus::AddColumn<vtkDoubleArray>(data, "RecommendedLevel", { work.RecommendedLevel });
        }
      }
      isthmus::Report(isthmus::MakeProgress(this), 1.0);
    });
}

void vtkMapHandles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n";
  os << indent << "MinimumPersistence: " << this->MinimumPersistence << "\n";
  os << indent << "AutomaticRange: " << this->AutomaticRange << "\n";
  os << indent << "Range: " << this->Range[0] << " " << this->Range[1] << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "AutomaticLevel: " << this->AutomaticLevel << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "Loops: " << this->Loops << "\n";
  os << indent << "NumberOfResamples: " << this->GetNumberOfResamples() << "\n";
  os << indent << "Seed: " << this->GetSeed() << "\n";
  os << indent << "StableLevel: " << this->StableLevel << "\n";
}
