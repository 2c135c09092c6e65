#include "vtkMapHandles.h"

#include "AlgorithmGuard.h"
#include "ChosenScalars.h"
#include "ClosedLevelSet.h"
#include "ImageDiagram.h"
#include "MapHandles.h"
#include "PolyDataMesh.h"
#include "vtkChokingLoops.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
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
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkMapHandles);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;
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

template <typename Array>
Array* AddArray(vtkFieldData* data, const std::string& name)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  data->AddArray(array);
  return array;
}

void AddFact(vtkDataObject* output, const char* name, double value)
{
  AddArray<vtkDoubleArray>(output->GetFieldData(), name)->InsertNextValue(value);
}

/// Hands the progress of the loops on, and a stop back to them.
void FollowProgress(vtkObject* caller, unsigned long, void* client, void* fraction)
{
  const auto& progress = *static_cast<const isthmus::ProgressCallback*>(client);
  if (!progress(*static_cast<double*>(fraction)))
  {
    static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
  }
}

/// What the loops complain about is told as a warning: bridges, windows and levels stand without.
void KeepComplaint(vtkObject*, unsigned long, void* client, void* text)
{
  *static_cast<std::string*>(client) += static_cast<const char*>(text);
}

/// The row whose level is nearest.
std::size_t RowOf(const std::vector<double>& levels, double level)
{
  const auto at = std::min_element(levels.begin(), levels.end(),
    [level](double a, double b) { return std::abs(a - level) < std::abs(b - level); });
  return static_cast<std::size_t>(at - levels.begin());
}

/// Points with what is known of each saddle.
void FillHandles(const std::vector<isthmus::MapHandle>& handles, bool bridges,
  const isthmus::FeatureList& features, vtkImageData* image, double level, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkPointData* data = output->GetPointData();
  auto* ids = AddArray<vtkIdTypeArray>(data, "FeatureId");
  auto* dimensions = AddArray<vtkIntArray>(data, "Dimension");
  vtkDoubleArray* numbers[6];
  const char* names[] = { "Birth", "Death", "Persistence", "Level", "From", "To" };
  for (std::size_t i = 0; i < 6; ++i)
  {
    numbers[i] = AddArray<vtkDoubleArray>(data, names[i]);
  }
  auto* isThere = AddArray<vtkIntArray>(data, "IsThere");
  for (const isthmus::MapHandle& handle : handles)
  {
    if (handle.IsBridge != bridges)
    {
      continue;
    }
    const auto& feature = features.Features[static_cast<std::size_t>(handle.Feature)];
    double place[3];
    image->GetPoint(static_cast<vtkIdType>(handle.Node), place);
    const vtkIdType at = points->InsertNextPoint(place);
    vertices->InsertNextCell(1, &at);
    ids->InsertNextValue(static_cast<vtkIdType>(handle.Feature));
    dimensions->InsertNextValue(feature.Pair.Dimension);
    const double values[] = { feature.Birth, feature.Death, feature.Persistence, handle.Level,
      handle.Interval[0], handle.Interval[1] };
    for (std::size_t i = 0; i < 6; ++i)
    {
      numbers[i]->InsertNextValue(values[i]);
    }
    isThere->InsertNextValue(handle.Interval[0] <= level && level <= handle.Interval[1] ? 1 : 0);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  data->SetActiveScalars("Level");
}

}

/// What one run works with.
struct vtkMapHandles::Work
{
  vtkImageData* Image = nullptr;
  vtkDataArray* Scalars = nullptr;
  isthmus::VolumeView Volume;
  isthmus::FeatureParameters Parameters;
  isthmus::FeatureList Features;
  std::vector<isthmus::StableInterval> Intervals;
  double Level = 0.0;
};

vtkMapHandles::vtkMapHandles()
  : Last(new isthmus::ImageDiagram)
{
  this->SetNumberOfOutputPorts(PortCount);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkMapHandles::~vtkMapHandles() = default;

int vtkMapHandles::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
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
  // A bridge can be anywhere, so all of the map is needed whatever part is asked for.
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  int whole[6];
  input->Get(Pipeline::WHOLE_EXTENT(), whole);
  input->Set(Pipeline::UPDATE_EXTENT(), whole, 6);
  return 1;
}

void vtkMapHandles::CheckParameters() const
{
  if (this->NumberOfLevels < 2 || this->NumberOfLevels > 1000000)
  {
    throw std::invalid_argument("NumberOfLevels is " + std::to_string(this->NumberOfLevels) +
      ", but a curve has from 2 to a million levels.");
  }
  if (this->UseRange &&
    !(std::isfinite(this->Range[0]) && std::isfinite(this->Range[1]) &&
      this->Range[0] < this->Range[1]))
  {
    throw std::invalid_argument("Range goes from " + std::to_string(this->Range[0]) + " to " +
      std::to_string(this->Range[1]) + ", but the first has to be below the second.");
  }
  if (!this->UseStableLevel && !std::isfinite(this->Level))
  {
    throw std::invalid_argument("Level is " + std::to_string(this->Level) +
      ": give a value of the map, or switch UseStableLevel on.");
  }
  if (this->UseRecommendedLevel && !std::isfinite(this->RecommendedLevel))
  {
    throw std::invalid_argument("RecommendedLevel is " + std::to_string(this->RecommendedLevel) +
      ": give a value of the map, or switch UseRecommendedLevel off.");
  }
}

void vtkMapHandles::FindFeatures(Work& work)
{
  const auto& statistics = this->Last->Statistics(work.Scalars, work.Volume);
  isthmus::FeatureParameters& wanted = work.Parameters;
  wanted.Superlevel = this->Superlevel;
  wanted.MinimumPersistence = this->MinimumPersistence;
  wanted.PersistenceUnit = isthmus::FeatureParameters::StandardDeviations;
  wanted.Range = this->UseRange ? std::array<double, 2>{ this->Range[0], this->Range[1] }
    : this->Superlevel          ? std::array<double, 2>{ statistics.Mean, statistics.Maximum }
                                : std::array<double, 2>{ statistics.Minimum, statistics.Mean };
  if (!(wanted.Range[0] < wanted.Range[1]))
  {
    throw std::invalid_argument("The map has one value everywhere, so it has no levels.");
  }
  isthmus::CubicalParameters parameters;
  parameters.Superlevel = this->Superlevel;
  const auto& pairs = this->Last->Pairs(
    work.Volume, parameters, isthmus::Between(isthmus::ProgressOf(this), 0.0, 0.3));
  work.Features = isthmus::ScalarFeatures(work.Volume, statistics, pairs, wanted);
  work.Intervals = isthmus::StableIntervals(work.Features, this->Superlevel, work.Parameters.Range);
}

double vtkMapHandles::ChooseLevel(const Work& work)
{
  this->StableLevel = work.Intervals.empty() ? NotANumber : work.Intervals.front().Middle();
  if (this->UseStableLevel && work.Intervals.empty())
  {
    throw std::invalid_argument("Nothing of the map persists in the range of levels, so there is "
                                "no stable level: lower MinimumPersistence, widen Range, or give a "
                                "Level.");
  }
  return this->UseStableLevel ? this->StableLevel : this->Level;
}

void vtkMapHandles::FillPoints(const Work& work, vtkInformationVector* outputVector)
{
  const auto handles = isthmus::MapHandles(work.Volume, work.Features, work.Parameters);
  for (const int port : { BridgesPort, WindowsPort })
  {
    FillHandles(handles, port == BridgesPort, work.Features, work.Image, work.Level,
      vtkPolyData::GetData(outputVector, port));
  }
}

void vtkMapHandles::FillLevels(const Work& work, vtkInformationVector* outputVector)
{
  const auto curves = isthmus::CountBetti(work.Features, this->Superlevel,
    isthmus::EvenLevels(work.Parameters.Range[0], work.Parameters.Range[1], this->NumberOfLevels));
  vtkDataSetAttributes* rows = vtkTable::GetData(outputVector, LevelsPort)->GetRowData();
  auto* levels = AddArray<vtkDoubleArray>(rows, "Level");
  vtkIdTypeArray* betti[3];
  for (std::size_t d = 0; d < 3; ++d)
  {
    betti[d] = AddArray<vtkIdTypeArray>(rows, "Beta" + std::to_string(d));
  }
  auto* stable = AddArray<vtkDoubleArray>(rows, "StableLevel");
  auto* recommended = AddArray<vtkDoubleArray>(rows, "RecommendedLevel");
  const std::size_t stableRow = RowOf(curves.Levels, this->StableLevel);
  const std::size_t recommendedRow = RowOf(curves.Levels, this->RecommendedLevel);
  for (std::size_t i = 0; i < curves.Levels.size(); ++i)
  {
    levels->InsertNextValue(curves.Levels[i]);
    for (std::size_t d = 0; d < 3; ++d)
    {
      betti[d]->InsertNextValue(curves.Filtered[d][i]);
    }
    const auto loops = static_cast<double>(curves.Filtered[1][i]);
    stable->InsertNextValue(!std::isnan(this->StableLevel) && i == stableRow ? loops : NotANumber);
    recommended->InsertNextValue(
      this->UseRecommendedLevel && i == recommendedRow ? loops : NotANumber);
  }
  vtkDataSetAttributes* intervals = vtkTable::GetData(outputVector, IntervalsPort)->GetRowData();
  const char* names[] = { "From", "To", "Middle", "Length" };
  vtkDoubleArray* ends[4];
  for (std::size_t i = 0; i < 4; ++i)
  {
    ends[i] = AddArray<vtkDoubleArray>(intervals, names[i]);
  }
  for (std::size_t d = 0; d < 3; ++d)
  {
    betti[d] = AddArray<vtkIdTypeArray>(intervals, "Beta" + std::to_string(d));
  }
  for (const isthmus::StableInterval& interval : work.Intervals)
  {
    const double values[] = { interval.Low, interval.High, interval.Middle(),
      interval.High - interval.Low };
    for (std::size_t i = 0; i < 4; ++i)
    {
      ends[i]->InsertNextValue(values[i]);
    }
    for (std::size_t d = 0; d < 3; ++d)
    {
      betti[d]->InsertNextValue(interval.Betti[d]);
    }
  }
}

void vtkMapHandles::FillSurfaces(const Work& work, vtkInformationVector* outputVector)
{
  isthmus::ClosedLevelSet level =
    isthmus::CloseLevelSet(work.Image, work.Scalars, work.Level, this->Superlevel);
  isthmus::ToWorld(work.Image, level.Guide);
  vtkPolyData* contour = vtkPolyData::GetData(outputVector, ContourPort);
  isthmus::SetMesh(level.Guide, contour);
  const auto progress = isthmus::ProgressOf(this);
  isthmus::Report(progress, 0.4);
  if (!this->Loops)
  {
    return;
  }
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(contour);
  vtkNew<vtkChokingLoops> loops;
  loops->SetInputData(surface);
  isthmus::ProgressCallback listener = isthmus::Between(progress, 0.4, 1.0);
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(FollowProgress);
  observer->SetClientData(&listener);
  loops->AddObserver(vtkCommand::ProgressEvent, observer);
  vtkNew<vtkCallbackCommand> complaints;
  std::string complaint;
  complaints->SetCallback(KeepComplaint);
  complaints->SetClientData(&complaint);
  loops->AddObserver(vtkCommand::ErrorEvent, complaints);
  loops->AddObserver(vtkCommand::WarningEvent, complaints);
  loops->Update();
  if (loops->GetAbortExecute())
  {
    throw isthmus::Cancelled();
  }
  if (!complaint.empty())
  {
    vtkWarningMacro(<< "The choking loops of the contour: " << complaint);
  }
  vtkPolyData::GetData(outputVector, LoopsPort)->ShallowCopy(loops->GetOutputDataObject(0));
  vtkPolyData::GetData(outputVector, ChokePointsPort)->ShallowCopy(loops->GetOutputDataObject(2));
}

int vtkMapHandles::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto clear = [&]()
  {
    for (int port = 0; port < PortCount; ++port)
    {
      vtkDataObject::GetData(outputVector, port)->Initialize();
    }
  };
  clear();
  Work work;
  work.Image = vtkImageData::GetData(inputVector[0], 0);
  vtkInformation* info = outputVector->GetInformationObject(BridgesPort);
  const bool isFirst =
    !info->Has(Pipeline::UPDATE_PIECE_NUMBER()) || info->Get(Pipeline::UPDATE_PIECE_NUMBER()) <= 0;
  if (!work.Image || work.Image->GetNumberOfPoints() == 0 || !isFirst)
  {
    return 1;
  }
  bool whole = false;
  const int result = isthmus::Guarded(this, vtkDataObject::GetData(outputVector, BridgesPort),
    [&]()
    {
      this->StableLevel = NotANumber;
      this->CheckParameters();
      work.Scalars = isthmus::ChosenScalars(this, work.Image);
      work.Volume = isthmus::VolumeOf(work.Scalars, work.Image);
      this->FindFeatures(work);
      work.Level = this->ChooseLevel(work);
      this->FillPoints(work, outputVector);
      this->FillLevels(work, outputVector);
      this->FillSurfaces(work, outputVector);
      for (int port = 0; port < PortCount; ++port)
      {
        vtkDataObject* output = vtkDataObject::GetData(outputVector, port);
        AddFact(output, "StableLevel", this->StableLevel);
        AddFact(output, "ChosenLevel", work.Level);
        if (this->UseRecommendedLevel)
        {
          AddFact(output, "RecommendedLevel", this->RecommendedLevel);
        }
      }
      isthmus::Report(isthmus::ProgressOf(this), 1.0);
      whole = true;
    });
  if (!whole)
  {
    clear();
  }
  return result;
}

void vtkMapHandles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Superlevel: " << this->Superlevel << "\n";
  os << indent << "MinimumPersistence: " << this->MinimumPersistence << "\n";
  os << indent << "UseRange: " << this->UseRange << "\n";
  os << indent << "Range: " << this->Range[0] << " " << this->Range[1] << "\n";
  os << indent << "UseStableLevel: " << this->UseStableLevel << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "UseRecommendedLevel: " << this->UseRecommendedLevel << "\n";
  os << indent << "RecommendedLevel: " << this->RecommendedLevel << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "Loops: " << this->Loops << "\n";
  os << indent << "StableLevel: " << this->StableLevel << "\n";
}
