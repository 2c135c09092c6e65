#include "Pockets/TrackedData.h"
#include "Core/NamedColumns.h"

#include "Pockets/FeatureInput.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

/// Whether any feature has a kind.
bool AreLoops(const std::vector<TrackFrame>& frames)
{
  const auto hasKind = [](const TrackedFeature& feature) { return feature.Kind >= 0; };
  return std::any_of(frames.begin(), frames.end(),
    [&](const TrackFrame& frame) { return std::any_of(frame.begin(), frame.end(), hasKind); });
}

}

void TrackedData::Add(vtkDataObject* features, vtkTable* lining)
{
  TrackFrame& frame = this->Frames.emplace_back();
  auto& values = this->Values.emplace_back();
  auto& numbers = this->Numbers.emplace_back();
  for (InputFeature& feature : ReadFeatures(features, lining))
  {
    frame.push_back(std::move(feature.Feature));
    values.push_back(feature.Values);
    numbers.push_back(feature.Number);
  }
}

void TrackedData::Clear()
{
  this->Frames.clear();
  this->Values.clear();
  this->Numbers.clear();
}

void TrackedData::FillTable(const Tracks& places, vtkTable* table) const
{
  auto* track = AddArray<vtkIntArray>(table->GetRowData(), "Track", 0);
  auto* time = AddArray<vtkDoubleArray>(table->GetRowData(), "Time", 0);
  auto* feature = AddArray<vtkIntArray>(table->GetRowData(), "FeatureId", 0);
  std::array<vtkDoubleArray*, 6> numbers;
  const char* names[] = { "X", "Y", "Z", "Radius", "Volume", "Score" };
  for (std::size_t k = 0; k < numbers.size(); ++k)
  {
    numbers[k] = AddArray<vtkDoubleArray>(table->GetRowData(), names[k], 0);
  }
  const bool areLoops = AreLoops(this->Frames);
  auto* kind = areLoops ? AddArray<vtkIntArray>(table->GetRowData(), "Kind", 0) : nullptr;
  auto* side = areLoops ? AddArray<vtkIntArray>(table->GetRowData(), "Side", 0) : nullptr;
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    for (const Place& place : places[n])
    {
      if (areLoops)
      {
        kind->InsertNextValue(this->Frames[place.Frame][place.Feature].Kind);
        side->InsertNextValue(this->Frames[place.Frame][place.Feature].Side);
      }
      track->InsertNextValue(static_cast<int>(n) + 1);
      time->InsertNextValue(this->GetTime(place.Frame));
      feature->InsertNextValue(static_cast<int>(this->Numbers[place.Frame][place.Feature]));
      for (std::size_t k = 0; k < 3; ++k)
      {
        numbers[k]->InsertNextValue(this->Frames[place.Frame][place.Feature].Place[k]);
        numbers[k + 3]->InsertNextValue(this->Values[place.Frame][place.Feature][k]);
      }
    }
  }
}

void TrackedData::FillChart(
  const Tracks& places, const std::vector<std::size_t>& order, int charted, vtkTable* chart) const
{
  const auto add = [&](const std::string& name, const std::vector<double>& values)
  { AddColumn<vtkDoubleArray>(chart->GetRowData(), name, values); };
  std::vector<double> times;
  for (std::size_t t = 0; t < this->Frames.size(); ++t)
  {
    times.push_back(this->GetTime(t));
  }
  add("Time", times);
  for (const std::size_t n : order)
  {
    std::vector<double> values(this->Frames.size(), Unknown);
    for (const Place& place : places[n])
    {
      values[place.Frame] =
        this->Values[place.Frame][place.Feature][static_cast<std::size_t>(charted)];
    }
    add("Track " + std::to_string(n + 1), values);
  }
}

void TrackedData::FillPaths(
  const Tracks& places, const std::vector<std::size_t>& order, vtkPolyData* paths) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  const auto track = NamedArray<vtkIntArray>("Track");
  const auto time = NamedArray<vtkDoubleArray>("Time");
  const auto radius = NamedArray<vtkDoubleArray>("Radius");
  for (const std::size_t n : order)
  {
    lines->InsertNextCell(static_cast<int>(places[n].size()));
    for (const Place& place : places[n])
    {
      lines->InsertCellPoint(
        points->InsertNextPoint(this->Frames[place.Frame][place.Feature].Place.data()));
      track->InsertNextValue(static_cast<int>(n) + 1);
      time->InsertNextValue(this->GetTime(place.Frame));
      radius->InsertNextValue(this->Values[place.Frame][place.Feature][0]);
    }
  }
  paths->SetPoints(points);
  paths->SetLines(lines);
  paths->GetPointData()->SetScalars(track);
  paths->GetPointData()->AddArray(time);
  paths->GetPointData()->AddArray(radius);
}

void TrackedData::FillEvents(const std::vector<TrackEvent>& events, vtkTable* table) const
{
  auto* kind = AddArray<vtkStringArray>(table->GetRowData(), "Event", 0);
  auto* time = AddArray<vtkDoubleArray>(table->GetRowData(), "Time", 0);
  auto* track = AddArray<vtkIntArray>(table->GetRowData(), "Track", 0);
  auto* other = AddArray<vtkIntArray>(table->GetRowData(), "Other", 0);
  for (const TrackEvent& event : events)
  {
    kind->InsertNextValue(event.Kind == TrackEventKind::Merge ? "merge" : "split");
    time->InsertNextValue(this->GetTime(event.Frame));
    track->InsertNextValue(event.Track + 1);
    other->InsertNextValue(event.Other + 1);
  }
}

}
