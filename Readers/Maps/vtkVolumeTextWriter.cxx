#include "vtkVolumeTextWriter.h"

#include "Core/AlgorithmGuard.h"
#include "Files/TextFileWriter.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>

#include <stdexcept>

vtkStandardNewMacro(vtkVolumeTextWriter);

namespace
{

vtkDataArray* FindArray(vtkImageData* image, const std::string& name)
{
  vtkPointData* const data = image->GetPointData();
  vtkDataArray* array = name.empty() ? (data->GetScalars() ? data->GetScalars() : data->GetArray(0))
                                     : data->GetArray(name.c_str());
  if (image->GetNumberOfPoints() == 0 || !array || array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("The image has no point array" +
      (name.empty() ? std::string() : " '" + name + "'") +
      " with one number for each node: choose another array, or another input.");
  }
  if (array->GetNumberOfTuples() < image->GetNumberOfPoints())
  {
    throw std::invalid_argument("The array '" +
      std::string(array->GetName() ? array->GetName() : "") + "' has " +
      std::to_string(array->GetNumberOfTuples()) + " values for " +
      std::to_string(image->GetNumberOfPoints()) + " nodes: choose another array.");
  }
  return array;
}

bool HasUnitGrid(vtkImageData* image)
{
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  bool plain = true;
  for (int a = 0; a < 3; ++a)
  {
    plain = plain && origin[a] == 0.0 && spacing[a] == 1.0 && image->GetExtent()[2 * a] == 0;
  }
  return plain;
}

/// floats are written with their own precision, and 64-bit integers exactly.
void WriteNumber(isthmus::TextFileWriter& file, vtkDataArray* array, vtkIdType i)
{
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
      file << static_cast<float>(array->GetComponent(i, 0));
      break;
    case VTK_DOUBLE:
      file << array->GetComponent(i, 0);
      break;
    case VTK_UNSIGNED_LONG:
    case VTK_UNSIGNED_LONG_LONG:
      file << array->GetVariantValue(i).ToTypeUInt64();
      break;
    default:
      file << array->GetVariantValue(i).ToTypeInt64();
  }
}

void WriteRows(vtkImageData* image, vtkDataArray* array, const std::string& path,
  const isthmus::ProgressCallback& progress)
{
  const int* n = image->GetDimensions();
  isthmus::TextFileWriter file(path);
  file << n[0] << " " << n[1] << " " << n[2] << "\n";
  for (vtkIdType i = 0, row = 0; i < image->GetNumberOfPoints(); ++row)
  {
    for (int x = 0; x < n[0]; ++x, ++i)
    {
      file << (x == 0 ? "" : " ");
      WriteNumber(file, array, i);
    }
    file << "\n";
    if (row % n[1] == 0)
    {
      isthmus::Report(
        progress, static_cast<double>(i) / static_cast<double>(image->GetNumberOfPoints()));
    }
  }
  file.Close();
}

}

void vtkVolumeTextWriter::WriteFile()
{
  vtkImageData* const image = this->GetImage();
  WriteRows(image, FindArray(image, this->ArrayName), this->FileName, isthmus::MakeProgress(this));
  if (!HasUnitGrid(image))
  {
    vtkWarningMacro("A .dat file holds no origin and no spacing: note them elsewhere, or write "
                    "OpenDX (.dx), which holds both.");
  }
}
