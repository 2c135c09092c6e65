#include "TrackedData.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();
constexpr const char* ValueNames[] = { "Radius", "Volume", "Score" };

vtkDataArray* NumbersOf(vtkDataSetAttributes* data, const std::string& name)
{
  return vtkDataArray::SafeDownCast(data->GetAbstractArray(name.c_str()));
}

/// Where the features of a table or of points are.
std::vector<Point3> PlacesOf(vtkDataObject* input)
{
  std::vector<Point3> places;
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
void AddLining(vtkTable* lining, TrackFrame& frame)
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
  for (TrackedFeature& feature : frame)
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

void TrackedData::Add(vtkDataObject* features, vtkTable* lining)
{
  TrackFrame frame;
  auto& values = this->Values.emplace_back();
  const auto places = PlacesOf(features);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    auto& value = values.emplace_back();
    for (std::size_t k = 0; k < value.size(); ++k)
    {
      vtkDataArray* array = NumbersOf(AttributesOf(features), ValueNames[k]);
      value[k] = array ? array->GetComponent(static_cast<vtkIdType>(i), 0) : Unknown;
    }
    frame.push_back({ places[i], value[0], {} });
  }
  if (lining)
  {
    AddLining(lining, frame);
  }
  this->Frames.push_back(std::move(frame));
}

void TrackedData::FillTable(const Tracks& places, vtkTable* table) const
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

void TrackedData::FillChart(
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

void TrackedData::FillPaths(
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

void TrackedData::FillEvents(const std::vector<TrackEvent>& events, vtkTable* table) const
{
  auto* kind = AddColumn<vtkStringArray>(table, "Event");
  auto* time = AddColumn<vtkDoubleArray>(table, "Time");
  auto* track = AddColumn<vtkIntArray>(table, "Track");
  auto* other = AddColumn<vtkIntArray>(table, "Other");
  for (const TrackEvent& event : events)
  {
    kind->InsertNextValue(event.Kind == TrackEventKind::Merge ? "merge" : "split");
    time->InsertNextValue(this->TimeOf(event.Frame));
    track->InsertNextValue(event.Track + 1);
    other->InsertNextValue(event.Other + 1);
  }
}

}
