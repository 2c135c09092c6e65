#include "Pockets/FeatureInput.h"

#include "Core/NumberText.h"
#include "Core/PipelineInputs.h"
#include "Pockets/PocketScore.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

vtkDataArray* FindNumbers(vtkDataSetAttributes* data, const std::string& name)
{
  return vtkDataArray::SafeDownCast(data->GetAbstractArray(name.c_str()));
}

double ReadValue(vtkDataArray* array, vtkIdType i)
{
  return array ? array->GetComponent(i, 0) : Unknown;
}

/// A number of a list of words; -1 without one.
int ReadInteger(vtkDataArray* array, vtkIdType i)
{
  const double value = ReadValue(array, i);
  return std::isfinite(value) ? static_cast<int>(value) : -1;
}

/// The items of a list separated by semicolons, sorted.
std::vector<std::string> SplitNames(const std::string& list)
{
  std::vector<std::string> names;
  for (std::size_t at = 0; at < list.size();)
  {
    const std::size_t end = std::min(list.find("; ", at), list.size());
    names.push_back(list.substr(at, end - at));
    at = end + 2;
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<InputFeature> ReadRows(vtkTable* table)
{
  std::vector<InputFeature> features;
  vtkDataSetAttributes* data = table->GetRowData();
  vtkDataArray* number = FindNumbers(data, "PoreId");
  for (const char* prefix : { "Center", "Bottleneck" })
  {
    vtkDataArray* at[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      at[k] = FindNumbers(data, std::string(prefix) + static_cast<char>('X' + k));
    }
    if (!at[0] || !at[1] || !at[2])
    {
      continue;
    }
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      const double radius = ReadValue(FindNumbers(data, "Radius"), row);
      for (vtkDataArray* const coordinate : at)
      {
        if (!std::isfinite(coordinate->GetComponent(row, 0)))
        {
          throw std::invalid_argument(JoinText("Row ", row, " of the table has the ",
            coordinate->GetName(), " ", coordinate->GetComponent(row, 0),
            ", which is not finite: a feature without a position cannot be tracked. Remove it."));
        }
      }
      features.push_back(
        { { { ReadValue(at[0], row), ReadValue(at[1], row), ReadValue(at[2], row) }, radius, {}, -1,
            -1 },
          { radius, ReadValue(FindNumbers(data, "Volume"), row),
            ReadValue(FindNumbers(data, "Score"), row) },
          number ? static_cast<std::int64_t>(ReadValue(number, row)) : row + 1 });
    }
    return features;
  }
  if (table->GetNumberOfRows() > 0)
  {
    throw std::invalid_argument(
      "The table has no columns CenterX, CenterY, CenterZ (nor BottleneckX, ...): use the Ranking "
      "of Molecular Pockets, the Pores of Pore Profile, or points.");
  }
  return features;
}

/// The arrays that assign cells or points to features.
struct Owner
{
  vtkDataSetAttributes* Data = nullptr;
  vtkDataArray* Whole = nullptr;
  vtkDataArray* Part = nullptr;
  bool IsPore = false;
};

Owner OwnerIn(vtkPointSet* input)
{
  const std::pair<const char*, const char*> names[] = { { "PocketId", "MouthId" },
    { "PoreId", "Rank" }, { "FeatureId", "" } };
  for (const auto& [whole, part] : names)
  {
    for (auto* data :
      std::initializer_list<vtkDataSetAttributes*>{ input->GetPointData(), input->GetCellData() })
    {
      if (vtkDataArray* array = FindNumbers(data, whole))
      {
        return { data, array, FindNumbers(data, part), whole == names[1].first };
      }
    }
  }
  return {};
}

Point3 CellCenter(vtkPointSet* input, vtkIdType cell)
{
  vtkNew<vtkIdList> corners;
  input->GetCellPoints(cell, corners);
  Point3 sum{ 0.0, 0.0, 0.0 };
  for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
  {
    Point3 corner;
    input->GetPoint(corners->GetId(k), corner.data());
    sum = sum + corner;
  }
  return (1.0 / static_cast<double>(corners->GetNumberOfIds())) * sum;
}

/// A feature as its cells or points are added to it.
struct FeatureSum
{
  Point3 Sum{ 0.0, 0.0, 0.0 };
  double Weight = 0.0;
  Point3 PlainSum{ 0.0, 0.0, 0.0 };
  double Count = 0.0;
  double Radius = Unknown;
  double Volume = Unknown;
  double Score = Unknown;
  int Kind = -1;
  int Side = -1;

  void Add(const Point3& place, double weight, double radius)
  {
    this->Sum = this->Sum + weight * place;
    this->Weight += weight;
    this->PlainSum = this->PlainSum + place;
    this->Count += 1.0;
    this->Radius = std::fmax(this->Radius, radius);
  }

  void AddNarrow(const Point3& place, double radius)
  {
    if (this->Count == 0.0 || radius < this->Radius)
    {
      *this = { place, 1.0, place, 1.0, radius, Unknown, Unknown, -1, -1 };
    }
  }

  /// The unweighted mean if all weights are 0.
  Point3 Place() const
  {
    return this->Weight > 0.0 ? (1.0 / this->Weight) * this->Sum
                              : (1.0 / this->Count) * this->PlainSum;
  }

  /// Empty volume weighted by the number of atoms around it.
  void AddRoom(double volume, double atoms)
  {
    const double share = volume * BurialWeight(atoms);
    this->Volume = std::isnan(this->Volume) ? volume : this->Volume + volume;
    this->Score = std::isnan(this->Score) ? share : this->Score + share;
  }
};

std::vector<InputFeature> ReadGroups(vtkPointSet* input, const Owner& owner)
{
  const bool isOfCells = owner.Data == input->GetCellData();
  vtkDataArray* room = FindNumbers(owner.Data, "EmptyVolume");
  vtkDataArray* atoms = FindNumbers(owner.Data, "Burial");
  vtkDataArray* width = FindNumbers(owner.Data, "Radius");
  width = width ? width : FindNumbers(owner.Data, "Clearance");
  vtkDataArray* kind = FindNumbers(owner.Data, "Kind");
  vtkDataArray* side = FindNumbers(owner.Data, "Side");
  std::map<std::pair<double, double>, FeatureSum> groups;
  for (vtkIdType i = 0; i < owner.Whole->GetNumberOfTuples(); ++i)
  {
    const std::pair<double, double> key{ ReadValue(owner.Whole, i),
      owner.Part ? ReadValue(owner.Part, i) : 0.0 };
    if (!std::isfinite(key.first) || !std::isfinite(key.second) ||
      (isOfCells && input->GetCellSize(i) == 0))
    {
      continue; // belongs to no feature, or has no position
    }
    FeatureSum& group = groups[key];
    Point3 place;
    if (isOfCells)
    {
      place = CellCenter(input, i);
    }
    else
    {
      input->GetPoint(i, place.data());
    }
    if (owner.IsPore)
    {
      group.AddNarrow(place, ReadValue(width, i));
      continue;
    }
    const bool isRoom = room && atoms;
    const double n = ReadValue(atoms, i);
    group.Kind = ReadInteger(kind, i);
    group.Side = ReadInteger(side, i);
    group.Add(place, isRoom ? std::max(0.0, ReadValue(room, i)) * BurialWeight(n) : 1.0,
      ReadValue(width, i));
    if (isRoom)
    {
      group.AddRoom(ReadValue(room, i), n);
    }
  }
  std::vector<InputFeature> features;
  for (const auto& [key, group] : groups)
  {
    const auto row = static_cast<std::int64_t>(features.size()) + 1;
    features.push_back({ { group.Place(), group.Radius, {}, group.Kind, group.Side },
      { group.Radius, group.Volume, group.Score },
      owner.Part ? row : static_cast<std::int64_t>(key.first) });
  }
  return features;
}

std::vector<InputFeature> ReadPoints(vtkPointSet* input)
{
  std::vector<InputFeature> features(static_cast<std::size_t>(input->GetNumberOfPoints()));
  auto* names = vtkStringArray::SafeDownCast(input->GetPointData()->GetAbstractArray("Residues"));
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    InputFeature& feature = features[i];
    input->GetPoint(point, feature.Feature.Place.data());
    const char* values[] = { "Radius", "Volume", "Score" };
    for (std::size_t k = 0; k < feature.Values.size(); ++k)
    {
      feature.Values[k] = ReadValue(FindNumbers(input->GetPointData(), values[k]), point);
    }
    feature.Feature.Radius = feature.Values[0];
    feature.Number = point + 1;
    if (names)
    {
      feature.Feature.Lining = SplitNames(names->GetValue(point));
    }
  }
  return features;
}

/// Assigns to each feature the residues listed under its number in the lining table.
void AddLining(vtkTable* lining, std::vector<InputFeature>& features)
{
  vtkDataArray* owner = FindNumbers(lining->GetRowData(), "PocketId");
  owner = owner ? owner : FindNumbers(lining->GetRowData(), "PoreId");
  std::map<std::int64_t, TrackedFeature*> byNumber;
  for (InputFeature& feature : features)
  {
    byNumber[feature.Number] = &feature.Feature;
  }
  for (vtkIdType row = 0; owner && row < lining->GetNumberOfRows(); ++row)
  {
    const auto at = byNumber.find(static_cast<std::int64_t>(ReadValue(owner, row)));
    if (at != byNumber.end())
    {
      std::string& name = at->second->Lining.emplace_back();
      for (const char* column : { "Chain", "ResidueId", "InsertionCode", "ResidueName" })
      {
        name += lining->GetValueByName(row, column).ToString() + "|";
      }
    }
  }
  for (InputFeature& feature : features)
  {
    std::sort(feature.Feature.Lining.begin(), feature.Feature.Lining.end());
  }
}

}

std::vector<InputFeature> ReadFeatures(vtkDataObject* input, vtkTable* lining)
{
  auto* points = vtkPointSet::SafeDownCast(input);
  if (!points)
  {
    auto features = ReadRows(vtkTable::SafeDownCast(input));
    if (lining)
    {
      AddLining(lining, features);
    }
    return features;
  }
  const Owner owner = OwnerIn(points);
  const bool areBottlenecks = owner.IsPore && owner.Part;
  if (!owner.Whole || areBottlenecks)
  {
    vtkNew<vtkPolyData> all; // all points count, including those that no cell uses
    all->SetPoints(points->GetPoints());
    RequireFinitePositions(all, "the features");
    return ReadPoints(points);
  }
  RequireFinitePositions(points, "the features");
  auto features = ReadGroups(points, owner);
  if (lining && !owner.Part)
  {
    AddLining(lining, features);
  }
  return features;
}

}
