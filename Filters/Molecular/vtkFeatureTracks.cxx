#include "vtkFeatureTracks.h"

#include "AlgorithmGuard.h"
#include "FeatureTracks.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

vtkStandardNewMacro(vtkFeatureTracks);

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Features of all time steps so far, and what is carried along: Radius, Volume, Score.
struct vtkFeatureTracks::Collected
{
  std::vector<double> Times;
  std::vector<isthmus::TrackFrame> Frames;
  std::vector<std::vector<std::array<double, 3>>> Values;

  /// One feature of one frame.
  struct Place
  {
    std::size_t Frame;
    std::size_t Feature;
  };
  using Tracks = std::vector<std::vector<Place>>;

  double TimeOf(std::size_t frame) const { return this->Times.empty() ? 0.0 : this->Times[frame]; }
  void FillTable(const Tracks& places, vtkTable* table) const;
  void FillChart(const Tracks& places, const std::vector<std::size_t>& order, int charted,
    vtkTable* chart) const;
  void FillPaths(
    const Tracks& places, const std::vector<std::size_t>& order, vtkPolyData* paths) const;
  void FillEvents(const std::vector<isthmus::TrackEvent>& events, vtkTable* table) const;
};

namespace
{

constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();
constexpr const char* ValueNames[] = { "Radius", "Volume", "Score" };

vtkDataArray* NumbersOf(vtkDataSetAttributes* data, const std::string& name)
{
  return vtkDataArray::SafeDownCast(data->GetAbstractArray(name.c_str()));
}

/// Where the features of a table or of points are.
std::vector<isthmus::Point3> PlacesOf(vtkDataObject* input)
{
  std::vector<isthmus::Point3> places;
  if (auto* points = vtkPointSet::SafeDownCast(input))
  {
    places.resize(static_cast<std::size_t>(points->GetNumberOfPoints()));
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      points->GetPoint(static_cast<vtkIdType>(i), places[i].data());
    }
    return places;
  }
  auto* table = vtkTable::SafeDownCast(input);
  for (const char* prefix : { "Center", "Bottleneck" })
  {
    vtkDataArray* columns[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      columns[k] = NumbersOf(table->GetRowData(), std::string(prefix) + static_cast<char>('X' + k));
    }
    if (columns[0] && columns[1] && columns[2])
    {
      for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
      {
        places.push_back({ columns[0]->GetComponent(row, 0), columns[1]->GetComponent(row, 0),
          columns[2]->GetComponent(row, 0) });
      }
      return places;
    }
  }
  if (table->GetNumberOfRows() > 0)
  {
    throw std::invalid_argument("The table has no columns CenterX, CenterY, CenterZ (nor "
                                "BottleneckX, ...): take the Ranking of Molecular Pockets, the "
                                "Pores of Pore Profile, or points.");
  }
  return places;
}

vtkDataSetAttributes* AttributesOf(vtkDataObject* input)
{
  auto* points = vtkPointSet::SafeDownCast(input);
  return points ? static_cast<vtkDataSetAttributes*>(points->GetPointData())
                : vtkTable::SafeDownCast(input)->GetRowData();
}

/// Gives each feature the residues that the lining table has under its number.
void AddLining(vtkTable* lining, isthmus::TrackFrame& frame)
{
  vtkDataArray* owner = NumbersOf(lining->GetRowData(), "PocketId");
  owner = owner ? owner : NumbersOf(lining->GetRowData(), "PoreId");
  for (vtkIdType row = 0; owner && row < lining->GetNumberOfRows(); ++row)
  {
    const auto feature = static_cast<std::size_t>(owner->GetComponent(row, 0)) - 1;
    std::string name;
    for (const char* column : { "Chain", "ResidueId", "InsertionCode", "ResidueName" })
    {
      name += lining->GetValueByName(row, column).ToString() + "|";
    }
    if (feature < frame.size())
    {
      frame[feature].Lining.push_back(name);
    }
  }
  for (isthmus::TrackedFeature& feature : frame)
  {
    std::sort(feature.Lining.begin(), feature.Lining.end());
  }
}

template <typename Array>
Array* AddColumn(vtkTable* table, const std::string& name)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  table->AddColumn(array);
  return array;
}

}

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
  this->Data = std::make_unique<Collected>();
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  if (input->Has(Pipeline::TIME_STEPS()))
  {
    const double* times = input->Get(Pipeline::TIME_STEPS());
    this->Data->Times.assign(times, times + input->Length(Pipeline::TIME_STEPS()));
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    // The output is that of all times.
    outputVector->GetInformationObject(port)->Remove(Pipeline::TIME_STEPS());
    outputVector->GetInformationObject(port)->Remove(Pipeline::TIME_RANGE());
  }
  return 1;
}

int vtkFeatureTracks::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  const std::size_t next = this->Data ? this->Data->Frames.size() : 0;
  for (int port = 0; this->Data && next < this->Data->Times.size() && port < 2; ++port)
  {
    if (vtkInformation* input = inputVector[port]->GetInformationObject(0))
    {
      input->Set(Pipeline::UPDATE_TIME_STEP(), this->Data->Times[next]);
    }
  }
  return 1;
}

int vtkFeatureTracks::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto clear = [&]()
  {
    for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
    {
      vtkDataObject::GetData(outputVector, port)->Initialize();
    }
    this->Data->Frames.clear();
    this->Data->Values.clear();
    request->Remove(Pipeline::CONTINUE_EXECUTING());
  };
  const bool done = isthmus::Succeeds(this, vtkDataObject::GetData(outputVector, 0),
    [&]()
    {
      vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
      isthmus::TrackFrame frame;
      auto& values = this->Data->Values.emplace_back();
      const auto places = PlacesOf(input);
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        auto& value = values.emplace_back();
        for (std::size_t k = 0; k < value.size(); ++k)
        {
          vtkDataArray* array = NumbersOf(AttributesOf(input), ValueNames[k]);
          value[k] = array ? array->GetComponent(static_cast<vtkIdType>(i), 0) : Unknown;
        }
        frame.push_back({ places[i], value[0], {} });
      }
      if (vtkTable* lining = vtkTable::GetData(inputVector[1], 0))
      {
        AddLining(lining, frame);
      }
      this->Data->Frames.push_back(std::move(frame));
      const double seen = static_cast<double>(this->Data->Frames.size());
      isthmus::Report(isthmus::ProgressOf(this),
        0.9 * seen / std::max(seen, static_cast<double>(this->Data->Times.size())));
      if (this->Data->Frames.size() < this->Data->Times.size())
      {
        request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
        return;
      }
      request->Remove(Pipeline::CONTINUE_EXECUTING());
      this->Finish(outputVector);
      this->Data->Frames.clear();
      this->Data->Values.clear();
    });
  if (!done || this->GetAbortExecute())
  {
    clear();
  }
  return 1;
}

void vtkFeatureTracks::Finish(vtkInformationVector* outputs)
{
  if (this->MinimumLength < 0)
  {
    throw std::invalid_argument("MinimumLength is negative, but it is a number of features.");
  }
  const Collected& data = *this->Data;
  const auto tracks =
    isthmus::TrackFeatures(data.Frames, { this->MaximumDistance, this->MaximumGap });
  Collected::Tracks places(static_cast<std::size_t>(tracks.NumberOfTracks));
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

void vtkFeatureTracks::Collected::FillTable(const Tracks& places, vtkTable* table) const
{
  auto* track = AddColumn<vtkIntArray>(table, "Track");
  auto* time = AddColumn<vtkDoubleArray>(table, "Time");
  auto* feature = AddColumn<vtkIntArray>(table, "FeatureId");
  std::array<vtkDoubleArray*, 6> numbers;
  const char* names[] = { "X", "Y", "Z", "Radius", "Volume", "Score" };
  for (std::size_t k = 0; k < numbers.size(); ++k)
  {
    numbers[k] = AddColumn<vtkDoubleArray>(table, names[k]);
  }
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    for (const Place& place : places[n])
    {
      track->InsertNextValue(static_cast<int>(n) + 1);
      time->InsertNextValue(this->TimeOf(place.Frame));
      feature->InsertNextValue(static_cast<int>(place.Feature) + 1);
      for (std::size_t k = 0; k < 3; ++k)
      {
        numbers[k]->InsertNextValue(this->Frames[place.Frame][place.Feature].Place[k]);
        numbers[k + 3]->InsertNextValue(this->Values[place.Frame][place.Feature][k]);
      }
    }
  }
}

void vtkFeatureTracks::Collected::FillChart(
  const Tracks& places, const std::vector<std::size_t>& order, int charted, vtkTable* chart) const
{
  const auto add = [&](const std::string& name, const std::vector<double>& values)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name.c_str());
    for (const double value : values)
    {
      column->InsertNextValue(value);
    }
    chart->AddColumn(column);
  };
  std::vector<double> times;
  for (std::size_t t = 0; t < this->Frames.size(); ++t)
  {
    times.push_back(this->TimeOf(t));
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

void vtkFeatureTracks::Collected::FillPaths(
  const Tracks& places, const std::vector<std::size_t>& order, vtkPolyData* paths) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> track;
  vtkNew<vtkDoubleArray> time;
  vtkNew<vtkDoubleArray> radius;
  track->SetName("Track");
  time->SetName("Time");
  radius->SetName("Radius");
  for (const std::size_t n : order)
  {
    lines->InsertNextCell(static_cast<int>(places[n].size()));
    for (const Place& place : places[n])
    {
      lines->InsertCellPoint(
        points->InsertNextPoint(this->Frames[place.Frame][place.Feature].Place.data()));
      track->InsertNextValue(static_cast<int>(n) + 1);
      time->InsertNextValue(this->TimeOf(place.Frame));
      radius->InsertNextValue(this->Values[place.Frame][place.Feature][0]);
    }
  }
  paths->SetPoints(points);
  paths->SetLines(lines);
  paths->GetPointData()->SetScalars(track);
  paths->GetPointData()->AddArray(time);
  paths->GetPointData()->AddArray(radius);
}

void vtkFeatureTracks::Collected::FillEvents(
  const std::vector<isthmus::TrackEvent>& events, vtkTable* table) const
{
  auto* kind = AddColumn<vtkStringArray>(table, "Event");
  auto* time = AddColumn<vtkDoubleArray>(table, "Time");
  auto* track = AddColumn<vtkIntArray>(table, "Track");
  auto* other = AddColumn<vtkIntArray>(table, "Other");
  for (const isthmus::TrackEvent& event : events)
  {
    kind->InsertNextValue(event.Kind == isthmus::TrackEventKind::Merge ? "merge" : "split");
    time->InsertNextValue(this->TimeOf(event.Frame));
    track->InsertNextValue(event.Track + 1);
    other->InsertNextValue(event.Other + 1);
  }
}

void vtkFeatureTracks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "MaximumGap: " << this->MaximumGap << "\n";
  os << indent << "Charted: " << this->Charted << "\n";
  os << indent << "MinimumLength: " << this->MinimumLength << "\n";
}
