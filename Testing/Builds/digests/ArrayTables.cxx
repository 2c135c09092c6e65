#include "ArrayTables.h"

#include <vtkAbstractArray.h>
#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace isthmus::digests
{

namespace
{

struct Place
{
  ArrayPlace Value;
  int Attributes;
  const char* Name;
};

constexpr Place Places[] = {
  { ArrayPlace::Points, vtkDataObject::POINT, "points" },
  { ArrayPlace::Points, vtkDataObject::VERTEX, "points" },
  { ArrayPlace::Cells, vtkDataObject::CELL, "cells" },
  { ArrayPlace::Cells, vtkDataObject::EDGE, "cells" },
  { ArrayPlace::Field, vtkDataObject::FIELD, "field data" },
  { ArrayPlace::Rows, vtkDataObject::ROW, "rows" },
};

template <typename Use>
void ForArrays(vtkDataObject* data, const Use& use)
{
  for (const Place& place : Places)
  {
    vtkFieldData* const arrays = data ? data->GetAttributesAsFieldData(place.Attributes) : nullptr;
    for (int i = 0; arrays && i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = arrays->GetAbstractArray(i);
      use(place.Value, array->GetName() ? array->GetName() : "", array->GetNumberOfComponents());
    }
  }
}

using PlacedName = std::pair<ArrayPlace, std::string>;

std::set<PlacedName> ArraysOfInputs(vtkAlgorithm* algorithm)
{
  std::set<PlacedName> names;
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      ForArrays(algorithm->GetInputDataObject(port, i),
        [&](ArrayPlace place, const std::string& name, int) {
          names.insert({ place, name });
        });
    }
  }
  return names;
}

std::string MakeKey(
  const std::string& className, int port, ArrayPlace value, const std::string& name)
{
  const std::string output = port < 0 ? "all outputs" : "output " + std::to_string(port);
  const auto* const place = std::find_if(
    std::begin(Places), std::end(Places), [&](const Place& one) { return one.Value == value; });
  return className + ", " + output + ", " + place->Name + ": " + name;
}

/// `pattern` may have NAME for any text that is not empty.
bool Matches(const std::string& pattern, const std::string& name)
{
  const std::string any = "NAME";
  const std::size_t fixed = pattern.find(any);
  if (fixed == std::string::npos)
  {
    return pattern == name;
  }
  if (name.compare(0, fixed, pattern, 0, fixed) != 0)
  {
    return false;
  }
  for (std::size_t end = fixed + 1; end <= name.size(); ++end)
  {
    if (Matches(pattern.substr(fixed + any.size()), name.substr(end)))
    {
      return true;
    }
  }
  return false;
}

/// The row of an array: the one with its name, else one with NAME, else INPUT; null if there is
/// none.
const OutputArray* FindRow(
  const ArrayTable& table, int port, const PlacedName& array, bool isOfInput)
{
  const auto& [place, name] = array;
  const OutputArray* found = nullptr;
  for (const OutputArray& row : table)
  {
    if ((row.Port >= 0 && row.Port != port) || row.Place != place)
    {
      continue;
    }
    if (row.Name == name)
    {
      return &row;
    }
    const bool isInput = std::string(row.Name) == "INPUT";
    if (isInput ? isOfInput && !found : Matches(row.Name, name))
    {
      found = &row;
    }
  }
  return found;
}

}

void ArrayTables::Compare(
  const std::string& className, const ArrayTable& table, vtkAlgorithm* algorithm)
{
  for (const OutputArray& row : table)
  {
    this->RowIsFound.insert({ MakeKey(className, row.Port, row.Place, row.Name), false });
  }
  const std::set<PlacedName> passed = ArraysOfInputs(algorithm);
  for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    ForArrays(algorithm->GetOutputDataObject(port),
      [&](ArrayPlace place, const std::string& name, int components)
      {
        const bool isOfInput = passed.count({ place, name }) > 0;
        const OutputArray* const row = FindRow(table, port, { place, name }, isOfInput);
        if (!row)
        {
          if (!isOfInput)
          {
            this->Wrong.insert(
              MakeKey(className, port, place, name) + " is not in OutputArrayTable()");
          }
          return;
        }
        this->RowIsFound[MakeKey(className, row->Port, place, row->Name)] = true;
        if (row->Components != 0 && row->Components != components)
        {
          this->Wrong.insert(MakeKey(className, port, place, name) + " has " +
            std::to_string(components) + " components, in OutputArrayTable() " +
            std::to_string(row->Components));
        }
      });
  }
}

void ArrayTables::AddMissing(const std::string& className)
{
  this->Wrong.insert(className + " has outputs, but no OutputArrayTable()");
}

void ArrayTables::AddSkipped(const std::string& className)
{
  this->Skipped.insert(className);
}

std::vector<std::string> ArrayTables::Complaints(bool all) const
{
  std::vector<std::string> complaints(this->Wrong.begin(), this->Wrong.end());
  for (const auto& [key, isFound] : this->RowIsFound)
  {
    if (all && !isFound && this->Skipped.count(key.substr(0, key.find(','))) == 0)
    {
      complaints.push_back(key + " is in OutputArrayTable(), but in no output");
    }
  }
  return complaints;
}

}
