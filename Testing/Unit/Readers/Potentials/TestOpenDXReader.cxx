// Reading of OpenDX files: dialects, axis order, grids, and the values of the text.

#include "OpenDXTestFiles.h"
#include "SharedData.h"
#include "vtkOpenDXReader.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

using namespace isthmus::testing;

namespace
{

std::string SharedFile(const char* name)
{
  return (isthmus::testing::SharedDataFolder() / name).string();
}

/// Values after the line with "follows", read by strtod, in the file's order.
std::vector<double> ValuesByStrtod(const std::string& path)
{
  const std::string text = Content(path);
  const char* at = text.c_str() + text.find("follows") + 7;
  std::vector<double> values;
  for (char* end = nullptr;; at = end)
  {
    const double value = std::strtod(at, &end);
    if (end == at)
    {
      return values;
    }
    values.push_back(value);
  }
}

}

TEST(OpenDXReader, ZRunsFastestInTheFile)
{
  const File file("# POTENTIAL (kT/e)\n#\n" + head + twelve +
    "attribute \"dep\" string \"positions\"\nobject \"regular positions\" class field\n"
    "component \"positions\" value 1\ncomponent \"data\" value 3\n");
  const Reading reading(file.Path);
  EXPECT_FALSE(reading.Observer->GetError());
  EXPECT_FALSE(reading.Observer->GetWarning());
  ASSERT_EQ(reading.Image->GetNumberOfPoints(), 12);
  EXPECT_STREQ(reading.Image->GetPointData()->GetScalars()->GetName(), "Potential");
  EXPECT_EQ(reading.Image->GetScalarType(), VTK_DOUBLE);
  ExpectFileOrder(reading, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 });
  EXPECT_EQ(reading.At(0, 0, 1), 1.0);
  EXPECT_EQ(reading.At(0, 1, 0), 2.0);
  EXPECT_EQ(reading.At(1, 0, 0), 6.0);
  EXPECT_EQ(reading.Image->GetOrigin()[1], 2.0);
  EXPECT_EQ(reading.Image->GetSpacing()[2], 2.0);
  EXPECT_TRUE(reading.Image->GetDirectionMatrix()->IsIdentity());
  EXPECT_EQ(reading.Text("Comments"), "POTENTIAL (kT/e)");
  EXPECT_EQ(reading.Text("Comments", 1), "(none)");
  EXPECT_EQ(reading.Text("FieldName"), "regular positions");
}

TEST(OpenDXReader, OriginAndDeltasMayHaveNoKeys)
{
  const File plain(head + twelve, "plain.dx");
  const File bare(
    "object 1 class gridpositions counts 2 3 2\n 1 2 3\n0.5 0 0\n0 0.25 0\n0 0 2\n" + twelve);
  const Reading keys(plain.Path), none(bare.Path);
  EXPECT_FALSE(none.Observer->GetError()) << none.Observer->GetErrorMessage();
  ASSERT_EQ(none.Image->GetNumberOfPoints(), 12);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(none.Image->GetOrigin()[i], keys.Image->GetOrigin()[i]);
    EXPECT_EQ(none.Image->GetSpacing()[i], keys.Image->GetSpacing()[i]);
  }
  EXPECT_EQ(none.At(1, 2, 0), keys.At(1, 2, 0));
  const File few(
    "object 1 class gridpositions counts 2 3 2\n0.5 0 0\n0 0.25 0\n0 0 2\n" + twelve, "few.dx");
  const Reading three(few.Path);
  EXPECT_NE(three.Observer->GetErrorMessage().find("three rows of delta"), std::string::npos);
}

TEST(OpenDXReader, TakesEveryDialectOfTheSharedFiles)
{
  ISTHMUS_NEEDS_SHARED_DATA("maps/dx/test.dx");
  for (const char* name :
    { "maps/dx/esp.dx", "maps/dx/mapaligned.dx", "maps/dx/test.dx", "maps/dx/test.dx.gz" })
  {
    const Reading reading(SharedFile(name));
    EXPECT_FALSE(reading.Observer->GetError()) << reading.Observer->GetErrorMessage();
    ExpectFileOrder(reading, ValuesByStrtod(SharedFile(name)));
    EXPECT_EQ(vtkOpenDXReader::CanReadFile(SharedFile(name).c_str()), 1);
  }
  const Reading esp(SharedFile("maps/dx/esp.dx"));
  EXPECT_EQ(esp.Image->GetDimensions()[1], 52);
  EXPECT_EQ(esp.Image->GetSpacing()[2], 0.264782);
  EXPECT_EQ(esp.Image->GetOrigin()[0], -4.24704);
  const Reading packed(SharedFile("maps/dx/test.dx.gz"));
  EXPECT_EQ(packed.Text("FieldName"), "density");
  EXPECT_EQ(packed.Text("Comments", 1),
    "File format: http://opendx.sdsc.edu/docs/html/pages/usrgu068.htm#HDREDF");
}

TEST(OpenDXReader, ThePotentialOf1HEWIsTheFilesAtEveryNode)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/1hew/1hew_potential.dx.gz");
  const std::string path = SharedFile("molecules/1hew/1hew_potential.dx.gz");
  const Reading reading(path);
  EXPECT_FALSE(reading.Observer->GetError()) << reading.Observer->GetErrorMessage();
  const std::vector<double> values = ValuesByStrtod(path);
  ExpectFileOrder(reading, values);
  // The position of the largest value of the text, by the file's own numbers.
  const auto largest =
    static_cast<long>(std::max_element(values.begin(), values.end()) - values.begin());
  const long i = largest / (129 * 129), j = largest / 129 % 129, k = largest % 129;
  double position[3];
  reading.Image->TransformIndexToPhysicalPoint(
    static_cast<int>(i), static_cast<int>(j), static_cast<int>(k), position);
  EXPECT_DOUBLE_EQ(position[0], -31.315 + 0.5 * static_cast<double>(i));
  EXPECT_DOUBLE_EQ(position[1], -9.8925 + 0.5 * static_cast<double>(j));
  EXPECT_DOUBLE_EQ(position[2], -11.4135 + 0.5 * static_cast<double>(k));
  double range[2];
  reading.Image->GetPointData()->GetScalars()->GetRange(range);
  EXPECT_EQ(reading.At(static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)), range[1]);
}

TEST(OpenDXReader, BinaryValuesOfEitherByteOrder)
{
  const float values[12] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9.5f, -10, 1e-30f };
  for (const bool big : { false, true })
  {
    std::string bytes(reinterpret_cast<const char*>(values), sizeof(values));
    for (std::size_t i = 0; big && i < bytes.size(); i += 4)
    {
      std::swap(bytes[i], bytes[i + 3]);
      std::swap(bytes[i + 1], bytes[i + 2]);
    }
    const File file(head + "object 3 class array type float rank 0 items 12 " +
      (big ? "msb ieee" : "lsb ieee") + " data follows\n" + bytes +
      "\nattribute \"x\" string \"y\"\n");
    const Reading reading(file.Path);
    EXPECT_FALSE(reading.Observer->GetError()) << reading.Observer->GetErrorMessage();
    EXPECT_EQ(reading.Image->GetScalarType(), VTK_FLOAT);
    ExpectFileOrder(reading, std::vector<double>(values, values + 12));
  }
}

TEST(OpenDXReader, SeveralArraysVectorsWholeNumbersAndOddWords)
{
  const File file(head + twelve +
    "object \"E\" class array type int category real rank 1 shape 2 items 12 data follows\n"
    "0,+10 1 11 2 12 3 13 # within\n 4 14 5 15 6 16 7 17\t8 18 9 19 10 20 11 21");
  const Reading first(file.Path);
  EXPECT_FALSE(first.Observer->GetError()) << first.Observer->GetErrorMessage();
  EXPECT_EQ(first.At(1, 2, 1), 11.0);
  const Reading second(file.Path, 1);
  EXPECT_FALSE(second.Observer->GetError()) << second.Observer->GetErrorMessage();
  EXPECT_EQ(second.Image->GetNumberOfScalarComponents(), 2);
  EXPECT_EQ(second.At(0, 1, 0), 2.0);
  EXPECT_EQ(second.At(0, 1, 0, 1), 12.0);
  const Reading third(file.Path, 2);
  EXPECT_NE(third.Observer->GetErrorMessage().find("Choose another FieldIndex"), std::string::npos);
}

TEST(OpenDXReader, TurnedGridsGetADirectionMatrix)
{
  // x of the file runs along -y of the world, y along +x.
  const File file("object 1 class gridpositions counts 2 3 2\norigin 1 2 3\ndelta 0 -0.5 0\n"
                  "delta 0.25 0 0\ndelta 0 0 2\n" +
    twelve);
  const Reading reading(file.Path);
  EXPECT_FALSE(reading.Observer->GetWarning());
  double position[3];
  reading.Image->TransformIndexToPhysicalPoint(1, 2, 1, position);
  EXPECT_DOUBLE_EQ(position[0], 1.5);
  EXPECT_DOUBLE_EQ(position[1], 1.5);
  EXPECT_DOUBLE_EQ(position[2], 5.0);
}

TEST(OpenDXReader, SkewedGridsAreResampledWithANote)
{
  ISTHMUS_NEEDS_SHARED_DATA("maps/dx/mapskewed.dx");
  const Reading reading(SharedFile("maps/dx/mapskewed.dx"));
  EXPECT_FALSE(reading.Observer->GetError()) << reading.Observer->GetErrorMessage();
  EXPECT_NE(reading.Observer->GetWarningMessage().find("skewed"), std::string::npos);
  vtkDataArray* inside = reading.Image->GetPointData()->GetArray("InsideMap");
  ASSERT_NE(inside, nullptr);
  // Nodes 0 and 1 of the file's first row along x are nodes of the grid as well.
  int found = 0;
  for (vtkIdType node = 0; node < reading.Image->GetNumberOfPoints(); ++node)
  {
    const double value = reading.Image->GetPointData()->GetScalars()->GetTuple1(node);
    EXPECT_EQ(inside->GetTuple1(node) == 0.0, std::isnan(value));
    const double* at = reading.Image->GetPoint(node);
    if (at[1] == 2.0 && at[2] == 3.0 && (at[0] == 1.0 || at[0] == 5.0))
    {
      EXPECT_EQ(value, 1.0);
      ++found;
    }
  }
  EXPECT_EQ(found, 2);
}

TEST(OpenDXReader, ALinearFunctionSurvivesASkewedGrid)
{
  std::ostringstream text;
  text.precision(17);
  text << "object 1 class gridpositions counts 6 7 8\norigin 1 2 3\ndelta 1 0 0\ndelta 0.3 1.2 0\n"
          "delta 0.1 -0.4 0.9\nobject 2 class array type double rank 0 items 336 data follows\n";
  const auto f = [](double x, double y, double z) { return 3.0 + 2.0 * x - y + 0.5 * z; };
  for (int i = 0; i < 6; ++i)
  {
    for (int j = 0; j < 7; ++j)
    {
      for (int k = 0; k < 8; ++k)
      {
        text << f(1 + i + 0.3 * j + 0.1 * k, 2 + 1.2 * j - 0.4 * k, 3 + 0.9 * k) << "\n";
      }
    }
  }
  const File file(text.str());
  const Reading reading(file.Path);
  vtkDataArray* values = reading.Image->GetPointData()->GetScalars();
  int inside = 0;
  for (vtkIdType node = 0; node < values->GetNumberOfTuples(); ++node)
  {
    const double* at = reading.Image->GetPoint(node);
    if (!std::isnan(values->GetTuple1(node)))
    {
      EXPECT_NEAR(values->GetTuple1(node), f(at[0], at[1], at[2]), 1e-12);
      ++inside;
    }
  }
  // Approximately the volume of the lattice in cells of the grid.
  EXPECT_GT(inside, 150);
  EXPECT_LT(inside, 336);
}

TEST(OpenDXReader, APieceOfTheGridHasTheSameValues)
{
  const File file(head + twelve);
  vtkNew<vtkOpenDXReader> reader;
  reader->SetFileName(file.Path.c_str());
  reader->UpdateInformation();
  const int extent[6] = { 1, 1, 0, 2, 1, 1 };
  reader->UpdateExtent(extent);
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetNumberOfPoints(), 3);
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 2, 1, 0), 11.0);
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 0, 1, 0), 7.0);
}

TEST(OpenDXReader, ALaterArrayIsFoundAfterArbitraryBytes)
{
  std::string bytes = " object 9 class path of bytes that are numbers ";
  bytes.resize(48, ' ');
  const File file(head + "object 3 class array type float rank 0 items 12 lsb ieee data follows\n" +
    bytes + "\n" + twelve);
  const Reading reading(file.Path, 1);
  EXPECT_FALSE(reading.Observer->GetError()) << reading.Observer->GetErrorMessage();
  ExpectFileOrder(reading, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 });
}
