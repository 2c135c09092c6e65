// The .dat files: counts and order of the values, numbers that are restored bitwise, data that they
// cannot hold, and damaged files, reported with the line.

#include "vtkVolumeTextReader.h"
#include "vtkVolumeTextWriter.h"

#include "TemporaryFile.h"

#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkLongLongArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedLongLongArray.h>

#include <gtest/gtest.h>
#include <iterator>
#include <limits>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

using isthmus::testing::TemporaryFile;

namespace
{

/// 2 x 3 x 4 nodes; values of all sizes that differ in every node.
vtkSmartPointer<vtkImageData> Volume(int components = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2, 3, 4);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(24);
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(
      i, std::ldexp(1.0 / 3.0 + static_cast<double>(i), static_cast<int>(50 * i - 600)));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

}

TEST(VolumeTextWriter, CountsThenValuesWithXFastest)
{
  const auto image = Volume();
  const TemporaryFile file("", "x.dat");
  vtkNew<vtkVolumeTextWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.Path());
  writer->Write();
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  std::ifstream text(file.Path());
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, "2 3 4");
  for (vtkIdType row = 0; row < 12; ++row)
  {
    ASSERT_TRUE(std::getline(text, line));
    char* rest = nullptr;
    const double first = std::strtod(line.c_str(), &rest);
    const double second = std::strtod(rest, nullptr);
    EXPECT_EQ(first, image->GetPointData()->GetScalars()->GetComponent(2 * row, 0)) << row;
    EXPECT_EQ(second, image->GetPointData()->GetScalars()->GetComponent(2 * row + 1, 0)) << row;
  }
  EXPECT_FALSE(std::getline(text, line));
}

TEST(VolumeTextWriter, ReportsWhatTheFormatLosesAndRefusesTheRest)
{
  const TemporaryFile file("", "x.dat");
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkVolumeTextWriter> writer;
  writer->AddObserver(vtkCommand::ErrorEvent, observer);
  writer->AddObserver(vtkCommand::WarningEvent, observer);
  const auto image = Volume();
  image->SetSpacing(1.0, 1.0, 2.0);
  writer->SetInputData(image);
  writer->Write();
  EXPECT_NE(observer->GetErrorMessage().find("set FileName"), std::string::npos);
  observer->Clear();
  writer->SetFileName(file.Path());
  writer->Write();
  EXPECT_FALSE(observer->GetError());
  EXPECT_NE(observer->GetWarningMessage().find("no origin and no spacing"), std::string::npos);
  observer->Clear();
  writer->SetArrayName("Potential");
  writer->Write();
  EXPECT_NE(observer->GetErrorMessage().find("no point array 'Potential'"), std::string::npos);
  EXPECT_NE(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  observer->Clear();
  writer->SetArrayName("");
  writer->SetInputData(Volume(3));
  writer->Write();
  EXPECT_NE(observer->GetErrorMessage().find("one number for each node"), std::string::npos);
  observer->Clear();
  const auto cut = Volume();
  cut->GetPointData()->GetScalars()->SetNumberOfTuples(cut->GetNumberOfPoints() - 1);
  writer->SetInputData(cut);
  writer->Write();
  EXPECT_NE(observer->GetErrorMessage().find("choose another array"), std::string::npos);
  observer->Clear();
  writer->SetInputData(vtkNew<vtkImageData>());
  writer->Write();
  EXPECT_TRUE(observer->GetError());
}

TEST(VolumeTextWriter, IntegersOf64BitsKeepAllTheirDigits)
{
  const TemporaryFile file("", "x.dat");
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  const auto written = [&](vtkDataArray* values)
  {
    values->SetName("Label");
    image->GetPointData()->SetScalars(values);
    vtkNew<vtkVolumeTextWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(file.Path());
    EXPECT_EQ(writer->Write(), 1);
    std::ifstream text(file.Path());
    return std::string(std::istreambuf_iterator<char>(text), std::istreambuf_iterator<char>());
  };
  vtkNew<vtkUnsignedLongLongArray> large;
  large->InsertNextValue(std::numeric_limits<unsigned long long>::max());
  large->InsertNextValue(1);
  EXPECT_EQ(written(large), "2 1 1\n18446744073709551615 1\n");
  vtkNew<vtkLongLongArray> least;
  least->InsertNextValue(std::numeric_limits<long long>::min());
  least->InsertNextValue(-1);
  EXPECT_EQ(written(least), "2 1 1\n-9223372036854775808 -1\n");
}

TEST(VolumeTextReader, RoundTripIsBitwise)
{
  const auto image = Volume();
  for (const char* name : { "x.dat", "x.dat.gz" })
  {
    const TemporaryFile file("", name);
    vtkNew<vtkVolumeTextWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(file.Path());
    writer->Write();
    EXPECT_EQ(vtkVolumeTextReader::CanReadFile(file.Path()), 1);
    vtkNew<vtkVolumeTextReader> reader;
    reader->SetFileName(file.Path());
    reader->Update();
    vtkDataArray* const values = reader->GetOutput()->GetPointData()->GetScalars();
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_EQ(reader->GetOutput()->GetDimensions()[a], image->GetDimensions()[a]);
    }
    ASSERT_TRUE(values);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(
        values->GetComponent(i, 0), image->GetPointData()->GetScalars()->GetComponent(i, 0));
    }
  }
}

TEST(VolumeTextReader, BrokenFilesReportTheLine)
{
  const auto why = [](const std::string& text)
  {
    const TemporaryFile file(text, "x.dat");
    vtkNew<vtkTest::ErrorObserver> observer;
    vtkNew<vtkVolumeTextReader> reader;
    reader->AddObserver(vtkCommand::ErrorEvent, observer);
    reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
    reader->SetFileName(file.Path());
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_NE(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    return observer->GetErrorMessage();
  };
  const auto says = [&why](const std::string& text, const std::string& sentence)
  { EXPECT_NE(why(text).find(sentence), std::string::npos) << why(text); };
  says("2 1 2\n1 2\n3 x\n", "line 3");
  says("2 1 2\n1 2\n3\n", "line 4");
  says("2 1 1\n1 2\n3\n", "line 3: there are more values");
  says("2 1\n1 2\n", "line 3: the line above holds more");
  says("2 1 0\n", "line 1: the number of nodes");
  says("2 -1 1\n1 2\n", "line 1: the number of nodes");
  says("90000 90000 90000\n1 2\n", "line 1: the number of nodes");
  says("2 1 1 7\n1 2\n", "line 2: the line above holds more");
  says("TITLE = \"a\"\n", "line 1");
  const TemporaryFile other("VARIABLES = x y\n", "x.dat");
  EXPECT_EQ(vtkVolumeTextReader::CanReadFile(other.Path()), 0);
}
