// Writing of OpenDX files: round trips are bitwise, and data that cannot be written cause an error
// message.

#include "OpenDXTestFiles.h"
#include "vtkOpenDXWriter.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <type_traits>

using namespace isthmus::testing;

namespace
{

/// Values that test printing: every exponent, neighbours of round numbers, denormals, zeros.
template <typename Array>
vtkSmartPointer<vtkImageData> HardImage()
{
  using T = typename Array::ValueType;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(2, 8, -3, 1, 5, 15);
  image->SetSpacing(0.1, 1.0 / 3.0, 0.7e-3);
  image->SetOrigin(-31.315, 1e-7, 12345.678);
  vtkNew<Array> values;
  values->SetName("Potential");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  std::uint64_t state = 88172645463325252ull;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    T value;
    do
    {
      state ^= state << 13;
      state ^= state >> 7;
      state ^= state << 17;
      std::memcpy(&value, &state, sizeof(T));
    } while (!std::isfinite(value));
    values->SetValue(i, value);
  }
  const T special[] = { T(0), T(-0.0), std::numeric_limits<T>::denorm_min(),
    std::numeric_limits<T>::max(), std::nextafter(T(1), T(2)), T(1e-5), T(0.1), T(1e23) };
  for (vtkIdType i = 0; i < 8; ++i)
  {
    values->SetValue(i, special[i]);
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

template <typename Array>
void ExpectSameBack(const char* name)
{
  const File file("", name);
  const auto image = HardImage<Array>();
  const auto back = WriteAndRead(image, file.Path);
  auto* before = Array::SafeDownCast(image->GetPointData()->GetScalars());
  // Every array is read back as double, the only type that is written.
  auto* after = vtkDoubleArray::SafeDownCast(back->GetPointData()->GetArray("Potential"));
  ASSERT_NE(after, nullptr);
  ASSERT_EQ(after->GetNumberOfTuples(), before->GetNumberOfTuples());
  using T = std::decay_t<decltype(before->GetValue(0))>;
  for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
  {
    const T expected = before->GetValue(i);
    const T found = static_cast<T>(after->GetValue(i));
    ASSERT_EQ(std::memcmp(&found, &expected, sizeof(T)), 0) << i << ": " << expected;
  }
  double first[3];
  image->TransformIndexToPhysicalPoint(2, -3, 5, first);
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_EQ(back->GetOrigin()[a], first[a]);
    EXPECT_EQ(back->GetSpacing()[a], image->GetSpacing()[a]);
  }
}

}

TEST(OpenDXWriter, RoundTripIsBitwise)
{
  ExpectSameBack<vtkDoubleArray>("double.dx");
  ExpectSameBack<vtkFloatArray>("float.dx");
  ExpectSameBack<vtkDoubleArray>("double.dx.gz");
  const File packed("", "double.dx.gz");
  WriteAndRead(HardImage<vtkFloatArray>(), packed.Path);
  EXPECT_EQ(Content(packed.Path).find("object 1 class gridpositions counts 7 5 11"), 0u);
}

TEST(OpenDXWriter, ValuesThatAreNotFiniteAreWarnedAbout)
{
  const File file("", "odd.dx");
  for (const double odd : { 1.0, std::nan(""), HUGE_VAL, -HUGE_VAL })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(3, 3, 3);
    image->AllocateScalars(VTK_DOUBLE, 1);
    image->GetPointData()->GetScalars()->Fill(1.0);
    image->SetScalarComponentFromDouble(1, 1, 1, 0, odd);
    vtkNew<vtkTest::ErrorObserver> said;
    vtkNew<vtkOpenDXWriter> writer;
    writer->AddObserver(vtkCommand::WarningEvent, said);
    writer->SetInputData(image);
    writer->SetFileName(file.Path.c_str());
    writer->Write();
    EXPECT_EQ(said->GetWarningMessage().find("1 values are not finite") != std::string::npos,
      !std::isfinite(odd))
      << odd << said->GetWarningMessage();
  }
}

// PyMOL and others refuse "type float".
TEST(OpenDXWriter, TheTypeIsDouble)
{
  const File file("", "float.dx");
  WriteAndRead(HardImage<vtkFloatArray>(), file.Path);
  const std::string text = Content(file.Path);
  EXPECT_NE(text.find("class array type double rank 0"), std::string::npos);
  EXPECT_EQ(text.find("float"), std::string::npos);
  for (const int type : { VTK_DOUBLE, VTK_INT, VTK_SHORT, VTK_UNSIGNED_CHAR })
  {
    for (const int components : { 1, 3 })
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(2, 3, 4);
      image->AllocateScalars(type, components);
      image->GetPointData()->GetScalars()->Fill(7.0);
      const auto back = WriteAndRead(image, file.Path);
      EXPECT_EQ(back->GetPointData()->GetScalars()->GetRange()[1], 7.0);
      const std::string other = Content(file.Path);
      EXPECT_NE(other.find("class array type double rank"), std::string::npos) << type;
      EXPECT_EQ(other.find("type int"), std::string::npos) << type;
    }
  }
}

// APBS and VMD read lines of three values; z runs fastest, and numbers of a node stay together.
TEST(OpenDXWriter, TextMatchesAPBS)
{
  for (const int components : { 1, 2 })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(2, 1, 2);
    image->SetOrigin(1.0, 2.0, 3.0);
    image->SetSpacing(0.5, 0.5, 0.5);
    vtkNew<vtkDoubleArray> values;
    values->SetName("Values");
    values->SetNumberOfComponents(components);
    values->SetNumberOfTuples(4);
    for (vtkIdType i = 0; i < 4 * components; ++i)
    {
      values->SetValue(i, 0.5 + static_cast<double>(i));
    }
    image->GetPointData()->SetScalars(values);
    const File file("", "text.dx");
    vtkNew<vtkOpenDXWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(file.Path.c_str());
    ASSERT_EQ(writer->Write(), 1);
    const std::string text = Content(file.Path);
    const std::string data = components == 1
      ? "rank 0 items 4 data follows\n0.5 2.5 1.5\n3.5 \nattribute"
      : "rank 1 shape 2 items 4 data follows\n0.5 1.5 4.5\n5.5 2.5 3.5\n6.5 7.5 \nattribute";
    EXPECT_NE(text.find("object 3 class array type double " + data), std::string::npos) << text;
  }
}

TEST(OpenDXWriter, RotatedGridsAndLabelsComeBack)
{
  const File file("# the unit is kT/e\nobject 1 class gridpositions counts 2 3 2\norigin 1 2 3\n"
                  "delta 0 -0.5 0\ndelta 0.25 0 0\ndelta 0 0 2\n" +
    twelve + "object \"my field\" class field\n");
  const Reading reading(file.Path);
  const File copy("", "copy.dx");
  WriteAndRead(reading.Image, copy.Path);
  const Reading again(copy.Path);
  EXPECT_EQ(again.Text("Comments"), "the unit is kT/e");
  EXPECT_EQ(again.Text("FieldName"), "my field");
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      EXPECT_EQ(again.Image->GetDirectionMatrix()->GetElement(i, j),
        reading.Image->GetDirectionMatrix()->GetElement(i, j));
    }
  }
  ExpectFileOrder(again, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 });
}

TEST(OpenDXWriter, WhatCannotBeWrittenIsReported)
{
  const auto expect = [](
                        vtkImageData* image, const char* path, const char* array, const char* words)
  {
    vtkNew<vtkOpenDXWriter> writer;
    vtkNew<vtkTest::ErrorObserver> observer;
    writer->AddObserver(vtkCommand::ErrorEvent, observer);
    writer->SetInputData(image);
    writer->SetFileName(path);
    writer->SetArrayName(array);
    writer->Write();
    EXPECT_NE(observer->GetErrorMessage().find(words), std::string::npos)
      << observer->GetErrorMessage();
    EXPECT_NE(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  };
  const File file("");
  vtkNew<vtkImageData> empty;
  expect(empty, file.Path.c_str(), "", "no nodes");
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(2, 2, 2);
  expect(bare, file.Path.c_str(), "", "no point array");
  expect(HardImage<vtkFloatArray>(), file.Path.c_str(), "Charge", "'Charge'");
  const auto cut = HardImage<vtkFloatArray>();
  vtkDataArray* const values = cut->GetPointData()->GetArray(0);
  values->SetNumberOfTuples(cut->GetNumberOfPoints() - 1);
  expect(cut, file.Path.c_str(), values->GetName(), "nodes: choose another array");
  expect(HardImage<vtkFloatArray>(), "no/such/folder.dx", "", "can't be written");
  EXPECT_FALSE(std::ifstream(file.Path).good());
}

TEST(OpenDXWriter, ThreeValuesOnALineAndTheRankOfThem)
{
  for (const int components : { 1, 2 })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(2, 2, 1);
    vtkNew<vtkFloatArray> values;
    values->SetName("Potential");
    values->SetNumberOfComponents(components);
    values->SetNumberOfTuples(4);
    for (vtkIdType i = 0; i < 4 * components; ++i)
    {
      values->SetValue(i, static_cast<float>(i));
    }
    image->GetPointData()->SetScalars(values);
    const File file("", "lines.dx");
    WriteAndRead(image, file.Path);
    // z runs fastest, then y.
    const char* const expected = components == 1
      ? " rank 0 items 4 data follows\n0 2 1\n3 \nattribute"
      : " rank 1 shape 2 items 4 data follows\n0 1 4\n5 2 3\n6 7 \nattribute";
    EXPECT_NE(Content(file.Path).find(expected), std::string::npos) << Content(file.Path);
  }
}
