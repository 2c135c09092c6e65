#include "ArrayTables.h"

#include <vtkAbstractArray.h>
#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>

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
  { ArrayPlace::Cells, vtkDataObject::CELL, "cells" },
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
      use(place, array->GetName() ? array->GetName() : "", array->GetNumberOfComponents());
    }
  }
}

std::set<std::string> NamesInInputs(vtkAlgorithm* algorithm)
{
  std::set<std::string> names;
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      ForArrays(algorithm->GetInputDataObject(port, i),
        [&](const Place&, const std::string& name, int) { names.insert(name); });
    }
  }
  return names;
}

std::string MakeKey(
  const std::string& className, int port, ArrayPlace value, const std::string& name)
{
  for (const Place& place : Places)
  {
    if (place.Value == value)
    {
      return className + ", output " + std::to_string(port) + ", " + place.Name + ": " + name;
    }
  }
  return {};
}

}

void ArrayTables::Compare(
  const std::string& className, const ArrayTable& table, vtkAlgorithm* algorithm)
{
  std::map<std::string, int> components;
  for (const OutputArray& row : table)
  {
    const std::string key = MakeKey(className, row.Port, row.Place, row.Name);
    components[key] = row.Components;
    this->RowIsFound.insert({ key, false });
  }
  const std::set<std::string> passed = NamesInInputs(algorithm);
  for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    ForArrays(algorithm->GetOutputDataObject(port),
      [&](const Place& place, const std::string& name, int found)
      {
        std::string key = MakeKey(className, port, place.Value, name);
        if (components.count(key) == 0) // Current_NAME stands for Current_K, ...
        {
          key = MakeKey(className, port, place.Value, name.substr(0, name.rfind('_')) + "_NAME");
        }
        const auto row = components.find(key);
        if (row == components.end())
        {
          if (passed.count(name) == 0)
          {
            this->Wrong.insert(
              MakeKey(className, port, place.Value, name) + " is not in OutputArrayTable()");
          }
          return;
        }
        this->RowIsFound[key] = true;
        if (row->second != 0 && row->second != found)
        {
          this->Wrong.insert(key + " has " + std::to_string(found) +
            " components, in OutputArrayTable() " + std::to_string(row->second));
        }
      });
  }
}

std::vector<std::string> ArrayTables::Complaints(bool all) const
{
  std::vector<std::string> complaints(this->Wrong.begin(), this->Wrong.end());
  for (const auto& [key, isFound] : this->RowIsFound)
  {
    if (all && !isFound)
    {
      complaints.push_back(key + " is in OutputArrayTable(), but in no output");
    }
  }
  return complaints;
}

}
