// The .dat export: counts and order of the values, numbers that come back bit for bit, and what it
// refuses.

#include "vtkVolumeTextWriter.h"

#include "TemporaryFile.h"

#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

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

TEST(VolumeTextWriter, TellsWhatTheFormatLosesAndRefusesWhatItDoesNotHold)
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
  writer->SetInputData(vtkNew<vtkImageData>());
  writer->Write();
  EXPECT_TRUE(observer->GetError());
}
