#include "vtkOpenDXWriter.h"

#include "Core/AlgorithmGuard.h"
#include "Potentials/OpenDXWriter.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkOpenDXWriter);

namespace
{

isthmus::VoxelLattice MakeLattice(vtkImageData* image)
{
  isthmus::VoxelLattice lattice;
  const int* extent = image->GetExtent();
  const int* dimensions = image->GetDimensions();
  for (std::size_t a = 0; a < 3; ++a)
  {
    lattice.Dimensions[a] = dimensions[a];
    for (std::size_t i = 0; i < 3; ++i)
    {
      lattice.Steps[i][a] =
        image->GetDirectionMatrix()->GetElement(static_cast<int>(i), static_cast<int>(a)) *
        image->GetSpacing()[a];
    }
  }
  image->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], lattice.Origin.data());
  return lattice;
}

vtkDataArray* FindArray(vtkImageData* image, const std::string& name)
{
  vtkPointData* const data = image->GetPointData();
  vtkDataArray* array = data->GetArray(name.empty() ? "Potential" : name.c_str());
  if (!array && name.empty())
  {
    array = data->GetScalars() ? data->GetScalars() : data->GetArray(0);
  }
  if (!array)
  {
    throw std::invalid_argument(name.empty()
        ? std::string("The image has no point array of numbers to write.")
        : "The image has no point array of numbers named '" + name + "': choose another.");
  }
  if (array->GetNumberOfTuples() < image->GetNumberOfPoints())
  {
    throw std::invalid_argument("The array '" +
      std::string(array->GetName() ? array->GetName() : "") + "' has " +
      std::to_string(array->GetNumberOfTuples()) + " tuples for " +
      std::to_string(image->GetNumberOfPoints()) + " nodes: choose another array.");
  }
  return array;
}

std::vector<std::string> Texts(vtkFieldData* fields, const char* name)
{
  std::vector<std::string> texts;
  if (auto* array = vtkStringArray::SafeDownCast(fields->GetAbstractArray(name)))
  {
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      texts.push_back(array->GetValue(i));
    }
  }
  return texts;
}

/// Writes a copy of `array` in the plain layout of `Array`.
template <typename Array>
void WriteAs(vtkDataArray* array, const std::string& path, const isthmus::VoxelLattice& lattice,
  const isthmus::OpenDXLabels& labels, const isthmus::ProgressCallback& progress)
{
  vtkNew<Array> plain;
  plain->ShallowCopy(array); // copies only where type or layout differ
  isthmus::WriteOpenDX(
    path, lattice, plain->GetPointer(0), plain->GetNumberOfComponents(), labels, progress);
}

}

void vtkOpenDXWriter::WriteFile()
{
  vtkImageData* const image = this->GetImage();
  if (image->GetNumberOfPoints() == 0)
  {
    throw std::invalid_argument("The image has no nodes: there is nothing to write.");
  }
  vtkDataArray* const array = FindArray(image, this->ArrayName);
  const std::vector<std::string> names = Texts(image->GetFieldData(), "FieldName");
  isthmus::OpenDXLabels labels{ names.empty() ? (array->GetName() ? array->GetName() : "data")
                                              : names.front(),
    Texts(image->GetFieldData(), "Comments") };
  vtkIdType odd = 0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      odd += std::isfinite(array->GetComponent(i, c)) ? 0 : 1;
    }
  }
  if (odd > 0)
  {
    vtkWarningMacro(<< odd
                    << " values are not finite numbers, and few programs read them from an OpenDX "
                       "file: replace them first.");
  }
  const auto write =
    array->GetDataType() == VTK_FLOAT ? &WriteAs<vtkFloatArray> : &WriteAs<vtkDoubleArray>;
  write(array, this->FileName, MakeLattice(image), labels, isthmus::MakeProgress(this));
}
