/**
 * @file FuzzImageFile.h
 * @brief Common to targets of readers with a writer: data that were read are written, and read
 * again unchanged.
 */
#ifndef isthmus_FuzzImageFile_h
#define isthmus_FuzzImageFile_h

#include "FuzzInput.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace isthmus::testing
{

/// Aborts unless both arrays exist and have the same values and type.
inline void ExpectSame(vtkDataArray* first, vtkDataArray* second)
{
  if (!first || !second || first->GetNumberOfValues() != second->GetNumberOfValues() ||
    first->GetDataType() != second->GetDataType())
  {
    std::abort();
  }
  for (vtkIdType i = 0; i < first->GetNumberOfValues(); ++i)
  {
    const double was = first->GetVariantValue(i).ToDouble();
    const double is = second->GetVariantValue(i).ToDouble();
    if (!(was == is || (std::isnan(was) && std::isnan(is))))
    {
      std::abort();
    }
  }
}

/// The output of `reader` for a file: an image without points if it refuses the file.
template <class Reader>
vtkSmartPointer<vtkImageData> ReadImage(Reader* reader, const std::string& path)
{
  Reader::CanReadFile(path.c_str());
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// Writes `image`, which has points, as the file `name` and reads it again: its array is the same.
template <class Reader, class Writer>
void ExpectToComeBack(vtkImageData* image, const char* array, const std::string& name)
{
  const std::string path = Folder().Write(name, nullptr, nullptr);
  vtkNew<Writer> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->Write();
  vtkNew<Reader> reader;
  ExpectSame(image->GetPointData()->GetArray(array),
    ReadImage(reader.Get(), path)->GetPointData()->GetArray(array));
}

}

#endif
