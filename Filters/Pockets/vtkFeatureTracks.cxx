#include "vtkFeatureTracks.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/RangeChecks.h"
#include "Pockets/TrackedData.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <algorithm>

vtkStandardNewMacro(vtkFeatureTracks);

const std::vector<isthmus::OutputArray>& vtkFeatureTracks::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Rows, "Track", 1, "", ArrayChoice::None, "number of the track, from 1" },
    { 0, ArrayPlace::Rows, "Time", 1, "", ArrayChoice::None, "of the time step" },
    { 0, ArrayPlace::Rows, "FeatureId", 1, "", ArrayChoice::None,
      "row or point in the input, from 1, or the id of the group" },
    { 0, ArrayPlace::Rows, "X", 1, "length", ArrayChoice::None, "center of the feature" },
    { 0, ArrayPlace::Rows, "Y", 1, "length", ArrayChoice::None, "center of the feature" },
    { 0, ArrayPlace::Rows, "Z", 1, "length", ArrayChoice::None, "center of the feature" },
    { 0, ArrayPlace::Rows, "Radius", 1, "", ArrayChoice::None, "of the input; NaN: not known" },
    { 0, ArrayPlace::Rows, "Volume", 1, "", ArrayChoice::None, "of the input; NaN: not known" },
    { 0, ArrayPlace::Rows, "Score", 1, "", ArrayChoice::None, "of the input; NaN: not known" },
    { 0, ArrayPlace::Rows, "Kind", 1, "", ArrayChoice::None,
      "as in Choking Loops; of choking loops" },
    { 0, ArrayPlace::Rows, "Side", 1, "", ArrayChoice::None,
      "as in Choking Loops; of choking loops" },
    { 1, ArrayPlace::Rows, "Time", 1, "", ArrayChoice::None, "of the time step" },
    { 1, ArrayPlace::Rows, "Track NAME", 1, "", ArrayChoice::None,
      "Track 1, Track 2, ...: Radius, Volume or Score, by Charted; NaN: the track does not "
      "exist at that time" },
    { 2, ArrayPlace::Points, "Track", 1, "", ArrayChoice::None, "number of the track" },
    { 2, ArrayPlace::Points, "Time", 1, "", ArrayChoice::None, "of the time step" },
    { 2, ArrayPlace::Points, "Radius", 1, "", ArrayChoice::None, "of the input; NaN: not known" },
    { 3, ArrayPlace::Rows, "Event", 1, "", ArrayChoice::None, "merge or split" },
    { 3, ArrayPlace::Rows, "Time", 1, "", ArrayChoice::None, "of the time step" },
    { 3, ArrayPlace::Rows, "Track", 1, "", ArrayChoice::None, "number of the track" },
    { 3, ArrayPlace::Rows, "Other", 1, "", ArrayChoice::None,
      "number of the track that it merges with, or splits from" },
  };
  return table;
}

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkFeatureTracks::vtkFeatureTracks()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

vtkFeatureTracks::~vtkFeatureTracks() = default;

vtkTable* vtkFeatureTracks::GetChart()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

vtkPolyData* vtkFeatureTracks::GetPaths()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(2));
}

vtkTable* vtkFeatureTracks::GetEvents()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(3));
}

int vtkFeatureTracks::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  if (port == 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  }
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkFeatureTracks::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 2 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkFeatureTracks::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Collected = std::make_unique<isthmus::TrackedData>();
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  if (input->Has(Pipeline::TIME_STEPS()))
  {
    const double* times = input->Get(Pipeline::TIME_STEPS());
    this->Collected->Times.assign(times, times + input->Length(Pipeline::TIME_STEPS()));
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    // The output covers all times.
    outputVector->GetInformationObject(port)->Remove(Pipeline::TIME_STEPS());
    outputVector->GetInformationObject(port)->Remove(Pipeline::TIME_RANGE());
  }
  return 1;
}

int vtkFeatureTracks::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  const std::size_t next = this->Collected ? this->Collected->Frames.size() : 0;
  for (int port = 0; this->Collected && next < this->Collected->Times.size() && port < 2; ++port)
  {
    if (vtkInformation* input = inputVector[port]->GetInformationObject(0))
    {
      input->Set(Pipeline::UPDATE_TIME_STEP(), this->Collected->Times[next]);
    }
  }
  return 1;
}

int vtkFeatureTracks::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const bool done = isthmus::Succeeds(this, outputVector,
    [&]()
    {
      this->Collected->Add(
        vtkDataObject::GetData(inputVector[0], 0), vtkTable::GetData(inputVector[1], 0));
      const double seen = static_cast<double>(this->Collected->Frames.size());
      isthmus::Report(isthmus::MakeProgress(this),
        0.9 * seen / std::max(seen, static_cast<double>(this->Collected->Times.size())));
      if (this->Collected->Frames.size() < this->Collected->Times.size())
      {
        request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
        return;
      }
      request->Remove(Pipeline::CONTINUE_EXECUTING());
      const auto& frames = this->Collected->Frames;
      const bool none =
        std::all_of(frames.begin(), frames.end(), [](const auto& frame) { return frame.empty(); });
      if (!none || isthmus::OnFirstRank()) // frames without features are reported once
      {
        this->Finish(outputVector);
      }
      isthmus::Report(isthmus::MakeProgress(this), 1.0);
      this->Collected->Clear();
    });
  if (!done)
  {
    this->Collected->Clear();
    request->Remove(Pipeline::CONTINUE_EXECUTING());
  }
  return 1;
}

void vtkFeatureTracks::Finish(vtkInformationVector* outputs)
{
  isthmus::RequireRange(
    "MinimumLength", this->MinimumLength, 0, VTK_INT_MAX, "It is a number of features.");
  isthmus::RequireRange("Charted", this->Charted, Radius, Score);
  const isthmus::TrackedData& data = *this->Collected;
  const auto tracks = isthmus::TrackFeatures(data.Frames, this->Parameters);
  isthmus::TrackedData::Tracks places(static_cast<std::size_t>(tracks.NumberOfTracks));
  for (std::size_t t = 0; t < data.Frames.size(); ++t)
  {
    for (std::size_t i = 0; i < data.Frames[t].size(); ++i)
    {
      places[static_cast<std::size_t>(tracks.TrackOf[t][i])].push_back({ t, i });
    }
  }
  data.FillTable(places, vtkTable::GetData(outputs, 0));
  std::vector<std::size_t> order;
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    if (places[n].size() >= static_cast<std::size_t>(this->MinimumLength))
    {
      order.push_back(n);
    }
  }
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return places[a].size() > places[b].size(); });
  data.FillChart(places, order, this->Charted, vtkTable::GetData(outputs, 1));
  data.FillPaths(places, order, vtkPolyData::GetData(outputs, 2));
  data.FillEvents(tracks.Events, vtkTable::GetData(outputs, 3));
}

void vtkFeatureTracks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumDistance: " << this->GetMaximumDistance() << "\n";
  os << indent << "MaximumGap: " << this->GetMaximumGap() << "\n";
  os << indent << "Charted: " << this->Charted << "\n";
  os << indent << "MinimumLength: " << this->MinimumLength << "\n";
}
