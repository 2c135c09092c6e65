#include "Core/PipelineInputs.h"

#include "Core/GatherRanks.h"
#include "Core/InputOverlap.h"
#include "Core/NumberText.h"
#include "Core/Progress.h"
#include "Core/RangeChecks.h"

#include <vtkAbstractArray.h>
#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationStringVectorKey.h>
#include <vtkMatrix3x3.h>
#include <vtkMolecule.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace isthmus
{
namespace
{

/// Whether `data` is of one of the types of the port; if not, `wanted` names these types.
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

/// Checks that no array of `data` has fewer values than `data` has points or cells.
void RequireWholeArrays(vtkDataObject* data)
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
          " " + elements + " of the input: it is damaged. Create the array again, or remove it.");
      }
    }
  }
}

/// Filters compute with all points and cells, including those hidden from view.
void RejectHidden(vtkDataObject* data, int port)
{
  for (const auto& [kind, bit, elements] :
    { std::tuple<int, unsigned char, const char*>{
        vtkDataObject::POINT, vtkDataSetAttributes::HIDDENPOINT, "points" },
      { vtkDataObject::CELL, vtkDataSetAttributes::HIDDENCELL, "cells" } })
  {
    const bool has = vtkDataSet::SafeDownCast(data) != nullptr;
    vtkUnsignedCharArray* const ghosts = has ? data->GetGhostArray(kind) : nullptr;
    if (!ghosts)
    {
      continue;
    }
    const unsigned char* const first = ghosts->GetPointer(0);
    const auto hidden = std::count_if(first, first + ghosts->GetNumberOfValues(),
      [bit = bit](unsigned char type) { return (type & bit) != 0; });
    if (hidden > 0)
    {
      throw std::invalid_argument(std::to_string(hidden) + " " + elements + " of " + "input " +
        std::to_string(port) +
        " are hidden (array vtkGhostType), but this filter cannot leave them out. Extract the "
        "visible part first (Threshold by vtkGhostType), or remove the array.");
    }
  }
}

/// Filters compute along the axes of an image as if these were perpendicular; they may be turned
/// and mirrored.
void RequirePerpendicularAxes(vtkDataObject* data, int port)
{
  auto* const image = vtkImageData::SafeDownCast(data);
  if (!image || image->GetNumberOfPoints() == 0)
  {
    return;
  }
  constexpr double rounding = 1e-3;
  vtkNew<vtkMatrix3x3> transposed, product;
  vtkMatrix3x3::Transpose(image->GetDirectionMatrix(), transposed);
  vtkMatrix3x3::Multiply3x3(transposed, image->GetDirectionMatrix(), product);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (!(std::abs(product->GetElement(i, j) - (i == j ? 1.0 : 0.0)) <= rounding))
      {
        throw std::invalid_argument("The columns of the direction matrix of input " +
          std::to_string(port) +
          " are not perpendicular unit vectors, so lengths along the axes of the image are not its "
          "spacing: resample it to perpendicular axes (Resample To Image), or correct the matrix.");
      }
    }
  }
}

/// Warns where single precision is too coarse for the distances between points.
void WarnOfRounding(vtkAlgorithm* self, vtkDataObject* data, int port)
{
  auto* const set = vtkPointSet::SafeDownCast(data);
  auto* const molecule = vtkMolecule::SafeDownCast(data);
  vtkPoints* const points = set ? set->GetPoints() : molecule ? molecule->GetPoints() : nullptr;
  constexpr vtkIdType fewest = 2;
  if (!points || points->GetDataType() != VTK_FLOAT || points->GetNumberOfPoints() < fewest)
  {
    return;
  }
  double box[6];
  points->GetBounds(box);
  const double largest = std::abs(
    *std::max_element(box, box + 6, [](double a, double b) { return std::abs(a) < std::abs(b); }));
  const double rounding = 0.5 * std::numeric_limits<float>::epsilon() * largest;
  const double distance = std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]) /
    std::sqrt(static_cast<double>(points->GetNumberOfPoints()));
  constexpr double share = 0.02;
  if (rounding > share * distance && std::isfinite(rounding))
  {
    vtkWarningWithObjectMacro(self,
      << JoinText("The coordinates of input ", port, " are in single precision and as large as ",
           FormatNumber(largest), ", so they are rounded by up to ", FormatNumber(rounding, 2),
           ", while its points are about ", FormatNumber(distance, 2),
           " apart: the shape is distorted. Move the data to the origin before they are stored in "
           "single precision, or store them in double precision."));
  }
}

template <typename T>
vtkIdType FirstNotFinite(const T* values, vtkIdType begin, vtkIdType count)
{
  const T* const end = values + count;
  return std::find_if(values + begin, end, [](T x) { return !std::isfinite(x); }) - values;
}

/// The first value from `begin` on that is not finite, or their number.
vtkIdType FirstNotFinite(vtkDataArray* values, vtkIdType begin)
{
  const vtkIdType count = values->GetNumberOfValues();
  if (auto* const floats = vtkArrayDownCast<vtkFloatArray>(values))
  {
    return FirstNotFinite(floats->GetPointer(0), begin, count);
  }
  if (auto* const doubles = vtkArrayDownCast<vtkDoubleArray>(values))
  {
    return FirstNotFinite(doubles->GetPointer(0), begin, count);
  }
  const int components = values->GetNumberOfComponents();
  while (begin < count &&
    std::isfinite(values->GetComponent(begin / components, static_cast<int>(begin % components))))
  {
    ++begin;
  }
  return begin;
}

std::vector<bool> UsedPoints(vtkPointSet* data)
{
  std::vector<bool> used(static_cast<std::size_t>(data->GetNumberOfPoints()));
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const auto id = static_cast<std::size_t>(ids->GetId(i));
      if (id < used.size())
      {
        used[id] = true;
      }
    }
  }
  return used;
}

}

void RequireFinitePositions(vtkPointSet* data, const std::string& name)
{
  vtkDataArray* const values = data && data->GetPoints() ? data->GetPoints()->GetData() : nullptr;
  const vtkIdType count = values ? values->GetNumberOfValues() : 0;
  std::vector<bool> used; // for data with points that are not finite
  for (vtkIdType at = 0; values && (at = FirstNotFinite(values, at)) < count; ++at)
  {
    const vtkIdType point = at / 3;
    if (used.empty())
    {
      used = data->GetNumberOfCells() > 0
        ? UsedPoints(data)
        : std::vector<bool>(static_cast<std::size_t>(data->GetNumberOfPoints()), true);
    }
    if (used[static_cast<std::size_t>(point)])
    {
      double p[3];
      data->GetPoint(point, p);
      throw std::invalid_argument(
        JoinText("Point ", point, " of ", name, " is at (", p[0], ", ", p[1], ", ", p[2],
          "), which is not finite: correct its position, or remove the point and its cells."));
    }
  }
}

void CheckInputs(vtkAlgorithm* self)
{
  if (self->CheckAbort())
  {
    throw Cancelled(); // an input is empty because its algorithm was aborted
  }
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
          " there: remove data of other types (Extract Block), or convert them.");
      }
      if (data)
      {
        RequireWholeArrays(data);
        RejectHidden(data, port);
        RequireUsualCoordinates(data, "input " + std::to_string(port));
        RequirePerpendicularAxes(data, port);
        WarnOfRounding(self, data, port);
      }
    }
  }
  CheckOverlap(self);
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
  RejectSeveralRanks(found == this->RanksOf.end() ? 0 : found->second, what);
}

}
