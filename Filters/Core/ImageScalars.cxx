#include "Core/ImageScalars.h"

#include "Core/ArrayMemory.h"
#include "Core/ImageExtent.h"
#include "Core/NamedColumns.h"
#include "Core/RangeChecks.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

std::string JoinArrayNames(vtkPointData* data)
{
  std::string names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* name = data->GetArrayName(i);
    names += (i > 0 ? ", '" : "'") + std::string(name ? name : "(unnamed)") + "'";
  }
  return names.empty() ? "none" : names;
}

[[noreturn]] void RejectMissing(const char* name, vtkImageData* image)
{
  throw std::invalid_argument((name ? "The image has no array '" + std::string(name) + "'"
                                    : std::string("The image has no active scalars")) +
    " to work on; its point arrays are: " + JoinArrayNames(image->GetPointData()) +
    ". Choose one of them as Scalars (in C++ by SetInputArrayToProcess).");
}

void RequireOnePerNode(vtkImageData* image, vtkDataArray* scalars, bool onCells)
{
  const std::string name = scalars->GetName() ? scalars->GetName() : "(unnamed)";
  if (onCells)
  {
    throw std::invalid_argument("Array '" + name +
      "' is not on points: convert it first, with vtkCellDataToPointData for instance.");
  }
  if (scalars->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("Array '" + name + "' has " +
      std::to_string(scalars->GetNumberOfComponents()) +
      " components, but one number for each node is needed: extract a component or use the "
      "magnitude.");
  }
  if (scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw std::invalid_argument("Array '" + name + "' has " +
      std::to_string(scalars->GetNumberOfTuples()) + " values for the " +
      std::to_string(image->GetNumberOfPoints()) + " nodes of the image: it is damaged.");
  }
}

/// Whether it is a part of the filter's first input, as those of several ranks.
bool IsPiece(vtkAlgorithm* filter, vtkImageData* image)
{
  constexpr auto whole = &vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT;
  vtkInformation* const input =
    filter->GetNumberOfInputPorts() > 0 && filter->GetNumberOfInputConnections(0) > 0
    ? filter->GetInputInformation(0, 0)
    : nullptr;
  return input && input->Has(whole()) &&
    image->GetNumberOfPoints() < NodeCount(ReadExtent(input, whole()));
}

}

vtkDataArray* ChosenScalars(vtkAlgorithm* filter, vtkImageData* image)
{
  vtkInformation* chosen = filter->GetInputArrayInformation(0);
  const char* name = chosen->Get(vtkDataObject::FIELD_NAME());
  const bool named = name && *name;
  const bool onCells =
    chosen->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkDataSetAttributes* data =
    onCells ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData();
  vtkDataArray* scalars = named ? data->GetArray(name) : data->GetScalars();
  if (!scalars)
  {
    RejectMissing(named ? name : nullptr, image);
  }
  RequireOnePerNode(image, scalars, onCells);
  // A part may contain only values of the background of a map.
  if (!IsPiece(filter, image) || LargestMagnitude(scalars) >= SmallestPeak)
  {
    RequireUsualValues(scalars);
  }
  return scalars;
}

bool FitsFloat(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT ||
    (array->GetDataType() != VTK_DOUBLE && array->GetDataTypeSize() <= 2);
}

vtkSmartPointer<vtkDataArray> WideIntegersAsDouble(vtkDataArray* array)
{
  if (array->GetDataType() == VTK_DOUBLE || FitsFloat(array))
  {
    return array;
  }
  auto doubles = ArrayOfType(
    VTK_DOUBLE, array->GetName(), array->GetNumberOfTuples(), array->GetNumberOfComponents());
  doubles->DeepCopy(array);
  return doubles;
}

}
