/**
 * @file OpenDXTestFiles.h
 * @brief OpenDX files of a test, and the result of reading them.
 */
#ifndef isthmus_OpenDXTestFiles_h
#define isthmus_OpenDXTestFiles_h

#include "Core/ChildProcess.h"
#include "vtkOpenDXReader.h"
#include "vtkOpenDXWriter.h"

#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <string>
#include <vector>

namespace isthmus::testing
{

/// A file in a folder of its own, deleted at the end; not made if `content` is empty.
struct File
{
  explicit File(const std::string& content, const std::string& name = "isthmus.dx")
    : Path((this->Folder.Path() / name).string())
  {
    if (!content.empty())
    {
      std::ofstream(this->Path, std::ios::binary) << content;
    }
  }

  const TemporaryFolder Folder;
  const std::string Path;
};

struct Reading
{
  explicit Reading(const std::string& path, int index = 0)
  {
    this->Reader->SetFileName(path.c_str());
    this->Reader->SetFieldIndex(index);
    this->Reader->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Reader->AddObserver(vtkCommand::WarningEvent, this->Observer);
    this->Reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->PipelineObserver);
    this->Reader->Update();
    this->Image = this->Reader->GetOutput();
  }
  double At(int i, int j, int k, int c = 0) const
  {
    return this->Image->GetScalarComponentAsDouble(i, j, k, c);
  }
  std::string Text(const char* name, int index = 0) const
  {
    auto* array = vtkStringArray::SafeDownCast(this->Image->GetFieldData()->GetAbstractArray(name));
    return array && index < array->GetNumberOfValues() ? array->GetValue(index) : "(none)";
  }

  vtkNew<vtkOpenDXReader> Reader;
  vtkNew<vtkTest::ErrorObserver> Observer;
  vtkNew<vtkTest::ErrorObserver> PipelineObserver;
  vtkImageData* Image = nullptr;
};

inline const std::string head = "object 1 class gridpositions counts 2 3 2\norigin 1 2 3\n"
                                "delta 0.5 0 0\ndelta 0 0.25 0\ndelta 0 0 2\n";

inline const std::string twelve = "object 3 class array type double rank 0 items 12 data follows\n"
                                  "0 1 2\n3 4 5\n6 7 8\n9 10 11\n";

/// Text content of a file, gunzipped where need be.
inline std::string Content(const std::string& path)
{
  std::string text;
  gzFile file = gzopen(path.c_str(), "rb");
  char buffer[65536];
  for (int got = gzread(file, buffer, sizeof(buffer)); got > 0;
       got = gzread(file, buffer, sizeof(buffer)))
  {
    text.append(buffer, static_cast<std::size_t>(got));
  }
  gzclose(file);
  return text;
}

inline void ExpectFileOrder(const Reading& reading, const std::vector<double>& values)
{
  const int* n = reading.Image->GetDimensions();
  ASSERT_EQ(static_cast<std::size_t>(reading.Image->GetNumberOfPoints()), values.size());
  std::size_t next = 0;
  int wrong = 0;
  for (int i = 0; i < n[0]; ++i)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int k = 0; k < n[2]; ++k)
      {
        wrong += reading.At(i, j, k) == values[next++] ? 0 : 1;
      }
    }
  }
  EXPECT_EQ(wrong, 0);
}

inline vtkSmartPointer<vtkImageData> WriteAndRead(vtkImageData* image, const std::string& path)
{
  vtkNew<vtkOpenDXWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  const Reading reading(path);
  EXPECT_FALSE(reading.Observer->GetError()) << reading.Observer->GetErrorMessage();
  return reading.Image;
}

}

#endif
