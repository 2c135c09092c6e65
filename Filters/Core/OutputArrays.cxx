#include "Core/OutputArrays.h"

#include "Core/NumberText.h"

#include <vtkCommand.h>
#include <vtkFieldData.h>
#include <vtkObject.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace isthmus
{

OutputArraySelection::OutputArraySelection(vtkObject* owner, const std::vector<OutputArray>& table)
  : Table(&table)
{
  for (const OutputArray& array : table)
  {
    if (array.Choice != ArrayChoice::None)
    {
      this->Selection->AddArray(array.Name, array.Choice == ArrayChoice::On);
    }
  }
  this->Selection->AddObserver(vtkCommand::ModifiedEvent, owner, &vtkObject::Modified);
}

vtkDataArraySelection* OutputArraySelection::Get()
{
  for (const OutputArray& array : *this->Table)
  {
    if (array.Choice != ArrayChoice::None && !this->Selection->ArrayExists(array.Name))
    {
      this->Selection->AddArray(
        array.Name, false); // ParaView removes all names before it sets the selected ones
    }
  }
  return this->Selection;
}

bool OutputArraySelection::Has(const char* name) const
{
  return this->Selection->ArrayIsEnabled(name) != 0;
}

bool OutputArraySelection::HasAny(std::initializer_list<const char*> names) const
{
  return std::any_of(
    names.begin(), names.end(), [this](const char* name) { return this->Has(name); });
}

void OutputArraySelection::RemoveOthers(
  std::initializer_list<const char*> names, vtkFieldData* data) const
{
  for (const char* name : names)
  {
    if (!this->Has(name))
    {
      data->RemoveArray(name);
    }
  }
}

void OutputArraySelection::Check() const
{
  for (int i = 0; i < this->Selection->GetNumberOfArrays(); ++i)
  {
    const std::string name = this->Selection->GetArrayName(i);
    std::string known;
    bool isKnown = false;
    for (const OutputArray& array : *this->Table)
    {
      if (array.Choice != ArrayChoice::None)
      {
        known += (known.empty() ? "" : ", ") + std::string(array.Name);
        isKnown = isKnown || name == array.Name;
      }
    }
    if (!isKnown)
    {
      throw std::invalid_argument(
        JoinText("OutputArraySelection has ", name, ", but it must be of: ", known, "."));
    }
  }
}

void OutputArraySelection::Print(std::ostream& os, vtkIndent indent) const
{
  os << indent << "OutputArrays:";
  for (int i = 0; i < this->Selection->GetNumberOfArrays(); ++i)
  {
    if (this->Selection->GetArraySetting(i))
    {
      os << " " << this->Selection->GetArrayName(i);
    }
  }
  os << "\n";
}

}
