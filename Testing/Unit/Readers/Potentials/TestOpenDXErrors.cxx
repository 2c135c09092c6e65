// OpenDX files that cause an error message, aborted reading, and values that are not numbers.

#include "OpenDXTestFiles.h"
#include "vtkOpenDXReader.h"
#include "vtkOpenDXWriter.h"

#include <vtkCallbackCommand.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace isthmus::testing;

namespace
{

void ExpectFailure(const std::string& content, const char* words, unsigned long code)
{
  const File file(content);
  const Reading reading(file.Path);
  EXPECT_TRUE(reading.Observer->GetError()) << words;
  EXPECT_NE(reading.Observer->GetErrorMessage().find(words), std::string::npos)
    << reading.Observer->GetErrorMessage();
  EXPECT_NE(reading.Observer->GetErrorMessage().find(file.Path), std::string::npos);
  EXPECT_EQ(reading.Reader->GetErrorCode(), code) << words;
  EXPECT_EQ(reading.Image->GetNumberOfPoints(), 0);
  EXPECT_EQ(reading.Image->GetPointData()->GetNumberOfArrays(), 0);
}

}

TEST(OpenDXReader, BadFilesAreReported)
{
  using Code = vtkErrorCode::ErrorIds;
  const std::string values = "object 3 class array type double rank 0 items 12 data follows\n";
  ExpectFailure("hello world\n", "not an OpenDX file", Code::UnrecognizedFileTypeError);
  ExpectFailure(head + values + "0 1 2 3 4 5\n6 7 8 9 10", "line 8", Code::PrematureEndOfFileError);
  ExpectFailure("object 1 class gridpositions counts 1000 1000 1000\ndelta 1 0 0\ndelta 0 1 0\n"
                "delta 0 0 1\nobject 3 class array type float items 1000000000 data follows\n0\n",
    "counts are wrong", Code::PrematureEndOfFileError);
  ExpectFailure(head + values + "0 1 2 3 4 5 6 7 8 9 ten 11\n", "'ten'", Code::FileFormatError);
  ExpectFailure(
    head + values + "0 1 2 3 4 5 6 7 8 9 1e999 11\n", "too large", Code::FileFormatError);
  ExpectFailure(head + twelve + "12 13\n", "more values", Code::FileFormatError);
  ExpectFailure(head + "object 3 class array type double rank 0 items 13 data follows\n0\n",
    "grid has 12 nodes", Code::FileFormatError);
  ExpectFailure(head, "no array of values", Code::FileFormatError);
  ExpectFailure(twelve, "before the grid", Code::FileFormatError);
  ExpectFailure(head + "object 3 class array type string rank 0 items 12 data follows\n",
    "type string", Code::FileFormatError);
  ExpectFailure(head + "object 3 class array type float rank 0 items 12 data file x,0\n", "'file'",
    Code::FileFormatError);
  ExpectFailure("object 1 class gridpositions counts 2 nan 2\n", "integer", Code::FileFormatError);
  ExpectFailure("object 1 class gridpositions counts 2 0 2\n", "between 1", Code::FileFormatError);
  ExpectFailure("object 1 class gridpositions counts 2 2 2\norigin 0 0 nan\ndelta 1 0 0\n"
                "delta 0 1 0\ndelta 0 0 1\n",
    "finite", Code::FileFormatError);
  ExpectFailure("object 1 class gridpositions counts 2 2 2\norigin 0 0 0\ndelta 1 0 0\n"
                "delta 0 0 0\ndelta 0 0 1\n",
    "length zero", Code::FileFormatError);
  ExpectFailure(
    "object 1 class gridpositions counts 2 2 2\norigin 0 0 0\ndelta 1 0 0\ndelta 1 0 0\n"
    "delta 0 0 1\nobject 3 class array type float items 8 data follows\n0 1 2 3 4 5 6 7",
    "one plane", Code::FileFormatError);
  ExpectFailure(
    "object 1 class gridpositions counts 2000000000 2000000000 2000000000\norigin 0 0 0\n"
    "delta 1 0 0\ndelta 0 1 0\ndelta 0 0 1\nobject 3 class array type float items 1 data "
    "follows\n0",
    "64 bits", Code::FileFormatError);
  ExpectFailure("object 1 class product\nterm 2\n", "class product", Code::FileFormatError);
}

TEST(OpenDXReader, AMissingFileIsReported)
{
  const Reading reading("no/such.dx");
  EXPECT_NE(reading.Observer->GetErrorMessage().find("no such file"), std::string::npos);
  EXPECT_EQ(
    reading.Reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileNotFoundError));
  EXPECT_EQ(vtkOpenDXReader::CanReadFile("no/such.dx"), 0);
  const File text("objection, my lord\n");
  EXPECT_EQ(vtkOpenDXReader::CanReadFile(text.Path.c_str()), 0);
}

TEST(OpenDXReader, ReportsProgressAndAbortsEmpty)
{
  const File file("", "large.dx");
  vtkNew<vtkImageData> image;
  image->SetDimensions(300, 100, 100); // several pieces of work
  vtkNew<vtkFloatArray> values;
  values->SetName("Potential");
  values->SetNumberOfValues(image->GetNumberOfPoints());
  values->Fill(1.5);
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkOpenDXWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.Path.c_str());
  writer->Write();
  for (const bool stop : { false, true })
  {
    vtkNew<vtkOpenDXReader> reader;
    reader->SetFileName(file.Path.c_str());
    struct WatchState
    {
      std::vector<double> Fractions;
      bool Stop;
    } seen{ {}, stop };
    vtkNew<vtkCallbackCommand> watch;
    watch->SetClientData(&seen);
    watch->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void* fraction)
      {
        auto* all = static_cast<WatchState*>(data);
        all->Fractions.push_back(*static_cast<double*>(fraction));
        if (all->Stop && all->Fractions.back() > 0.2)
        {
          static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
        }
      });
    reader->AddObserver(vtkCommand::ProgressEvent, watch);
    reader->Update();
    EXPECT_GT(seen.Fractions.size(), 2u);
    EXPECT_TRUE(std::is_sorted(seen.Fractions.begin(), seen.Fractions.end()) || stop);
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), stop ? 0 : 3000000);
  }
}

TEST(OpenDXReader, ValuesThatAreNotFiniteAreKeptAndReported)
{
  const File file(head +
    "object 3 class array type double rank 0 items 12 data follows\n"
    "0 nan 2 3 -inf 5 6 7 8 9 10 1e-999\n");
  const Reading reading(file.Path);
  EXPECT_FALSE(reading.Observer->GetError()) << reading.Observer->GetErrorMessage();
  EXPECT_NE(
    reading.Observer->GetWarningMessage().find("2 values are not finite"), std::string::npos);
  EXPECT_TRUE(std::isnan(reading.At(0, 0, 1)));
  EXPECT_EQ(reading.At(1, 2, 1), 0.0);
}

TEST(OpenDXReader, ShapesBeyondAThousandAreRefused)
{
  std::string numbers;
  for (int i = 0; i < 1001; ++i)
  {
    numbers += std::to_string(i) + "\n";
  }
  ExpectFailure("object 1 class gridpositions counts 1 1 1\norigin 0 0 0\ndelta 1 0 0\n"
                "delta 0 1 0\ndelta 0 0 1\nobject 3 class array type float rank 1 shape 1001 "
                "items 1 data follows\n" +
      numbers,
    "values", vtkErrorCode::FileFormatError);
}

TEST(OpenDXReader, ShapesBelowOneAreRefused)
{
  for (const char* shape : { "0", "-1" })
  {
    ExpectFailure("object 1 class gridpositions counts 1 1 1\norigin 0 0 0\ndelta 1 0 0\n"
                  "delta 0 1 0\ndelta 0 0 1\nobject 3 class array type float rank 1 shape " +
        std::string(shape) + " items 1 data follows\n7\n",
      "shape of the array", vtkErrorCode::FileFormatError);
  }
}

TEST(OpenDXReader, AFieldThatPutsTheArrayOnAnotherGridIsRefused)
{
  ExpectFailure(head + twelve +
      "object \"potential\" class field\ncomponent \"positions\" value 9\n"
      "component \"data\" value 3\n",
    "lies on the grid 9", vtkErrorCode::FileFormatError);
}
