#include "Core/PipelineInputs.h"

#include "Core/GatherRanks.h"

#include <vtkAbstractArray.h>
#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkInformation.h>
#include <vtkInformationStringVectorKey.h>
#include <vtkNew.h>
#include <vtkObject.h>

#include <stdexcept>
#include <utility>

namespace isthmus
{
namespace
{

/// Is `data` of one of the types of the port? If not, what these are is left in `wanted`.
bool Fits(vtkAlgorithm* self, int port, vtkDataObject* data, std::string& wanted)
{
  vtkInformation* demand = self->GetInputPortInformation(port);
  auto* key = vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE();
  wanted.clear();
  for (int i = 0; i < key->Length(demand); ++i)
  {
    const char* type = key->Get(demand, i);
    if (data->IsA(type))
    {
      return true;
    }
    wanted += (i > 0 ? " or a " : "") + std::string(type);
  }
  return wanted.empty();
}

/// No array of `data` ends before the last element of its kind.
void DemandWholeArrays(vtkDataObject* data)
{
  for (const auto& [kind, elements] :
    { std::pair<int, const char*>{ vtkDataObject::POINT, "points" },
      { vtkDataObject::CELL, "cells" }, { vtkDataObject::VERTEX, "vertices" },
      { vtkDataObject::EDGE, "edges" }, { vtkDataObject::ROW, "rows" } })
  {
    vtkDataSetAttributes* attributes = data->GetAttributes(kind);
    const vtkIdType count = attributes ? data->GetNumberOfElements(kind) : 0;
    for (int a = 0; count > 0 && a < attributes->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = attributes->GetAbstractArray(a);
      if (array && array->GetNumberOfTuples() < count)
      {
        throw std::invalid_argument("The array '" +
          std::string(array->GetName() ? array->GetName() : "(unnamed)") + "' has " +
          std::to_string(array->GetNumberOfTuples()) + " values for the " + std::to_string(count) +
          " " + elements + " of the input: it is damaged. Make it anew, or leave it out.");
      }
    }
  }
}

}

void CheckInputs(vtkAlgorithm* self)
{
  for (int port = 0; port < self->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < self->GetNumberOfInputConnections(port); ++i)
    {
      vtkDataObject* data = self->GetInputDataObject(port, i);
      std::string wanted;
      if (data && !Fits(self, port, data, wanted))
      {
        throw std::invalid_argument("Input " + std::to_string(port) + " got a " +
          data->GetClassName() + ", but this filter works on a " + wanted +
          " there: take out what is of another kind (Extract Block), or convert it.");
      }
      if (data)
      {
        DemandWholeArrays(data);
      }
    }
  }
}

InputInAdvance::InputInAdvance(vtkAlgorithm* self)
  : Self(self)
{
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&this->Executing);
  observer->SetCallback([](vtkObject*, unsigned long event, void* executing, void*)
    { *static_cast<int*>(executing) += event == vtkCommand::StartEvent ? 1 : -1; });
  self->AddObserver(vtkCommand::StartEvent, observer);
  self->AddObserver(vtkCommand::EndEvent, observer);
}

void InputInAdvance::Update(int port)
{
  if (this->Executing == 0)
  {
    this->Self->GetInputAlgorithm(port, 0)->Update(
      this->Self->GetInputConnection(port, 0)->GetIndex());
    vtkDataObject* data = this->Self->GetInputDataObject(port, 0);
    this->RanksOf[port] = vtkCompositeDataSet::SafeDownCast(data) ? 0 : RanksWithPoints(data);
  }
}

void InputInAdvance::RequireOneRank(int port, const std::string& what) const
{
  const auto found = this->RanksOf.find(port);
  RefuseSeveralRanks(found == this->RanksOf.end() ? 0 : found->second, what);
}

}
