// OpenDX files in and out: dialects, axis order, grids, errors, and values that come back exactly.

#include "OpenDXReader.h"
#include "SharedData.h"
#include "vtkOpenDXReader.h"
#include "vtkOpenDXWriter.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

namespace
{

/// A file in the test's own folder, deleted at the end.
struct File
{
  explicit File(const std::string& content, const std::string& name = "isthmus.dx")
    : Path(::testing::TempDir() + "/" +
        ::testing::UnitTest::GetInstance()->current_test_info()->name() + name)
  {
    if (!content.empty())
    {
      std::ofstream(this->Path, std::ios::binary) << content;
    }
  }
  ~File() { std::remove(this->Path.c_str()); }
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

std::string Shared(const char* name)
{
  return (isthmus::testing::SharedDataFolder() / name).string();
}

const std::string head = "object 1 class gridpositions counts 2 3 2\norigin 1 2 3\n"
                         "delta 0.5 0 0\ndelta 0 0.25 0\ndelta 0 0 2\n";
const std::string twelve = "object 3 class array type double rank 0 items 12 data follows\n"
                           "0 1 2\n3 4 5\n6 7 8\n9 10 11\n";

/// Text content of a file, gunzipped where need be.
std::string Content(const std::string& path)
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

void ExpectFileOrder(const Reading& reading, const std::vector<double>& values)
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

vtkSmartPointer<vtkImageData> WriteAndRead(vtkImageData* image, const std::string& path)
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
  auto* after = Array::SafeDownCast(back->GetPointData()->GetArray("Potential"));
  ASSERT_NE(after, nullptr);
  ASSERT_EQ(after->GetNumberOfTuples(), before->GetNumberOfTuples());
  EXPECT_EQ(std::memcmp(after->GetPointer(0), before->GetPointer(0),
              static_cast<std::size_t>(before->GetDataSize()) * sizeof(*before->GetPointer(0))),
    0);
  double first[3];
  image->TransformIndexToPhysicalPoint(2, -3, 5, first);
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_EQ(back->GetOrigin()[a], first[a]);
    EXPECT_EQ(back->GetSpacing()[a], image->GetSpacing()[a]);
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

TEST(OpenDXReader, TakesEveryDialectOfTheSharedFiles)
{
  ISTHMUS_NEEDS_SHARED_DATA("maps/dx/test.dx");
  for (const char* name :
    { "maps/dx/esp.dx", "maps/dx/mapaligned.dx", "maps/dx/test.dx", "maps/dx/test.dx.gz" })
  {
    const Reading reading(Shared(name));
    EXPECT_FALSE(reading.Observer->GetError()) << reading.Observer->GetErrorMessage();
    ExpectFileOrder(reading, ValuesByStrtod(Shared(name)));
    EXPECT_EQ(vtkOpenDXReader::CanReadFile(Shared(name).c_str()), 1);
  }
  const Reading esp(Shared("maps/dx/esp.dx"));
  EXPECT_EQ(esp.Image->GetDimensions()[1], 52);
  EXPECT_EQ(esp.Image->GetSpacing()[2], 0.264782);
  EXPECT_EQ(esp.Image->GetOrigin()[0], -4.24704);
  const Reading packed(Shared("maps/dx/test.dx.gz"));
  EXPECT_EQ(packed.Text("FieldName"), "density");
  EXPECT_EQ(packed.Text("Comments", 1),
    "File format: http://opendx.sdsc.edu/docs/html/pages/usrgu068.htm#HDREDF");
}

TEST(OpenDXReader, ThePotentialOf1HEWIsTheFilesAtEveryNode)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/1hew/1hew_potential.dx.gz");
  const std::string path = Shared("molecules/1hew/1hew_potential.dx.gz");
  const Reading reading(path);
  EXPECT_FALSE(reading.Observer->GetError()) << reading.Observer->GetErrorMessage();
  const std::vector<double> values = ValuesByStrtod(path);
  ExpectFileOrder(reading, values);
  // Where the largest value of the text stands, by the file's own numbers.
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

TEST(OpenDXReader, SkewedGridsAreResampledAndSayWhere)
{
  ISTHMUS_NEEDS_SHARED_DATA("maps/dx/mapskewed.dx");
  const Reading reading(Shared("maps/dx/mapskewed.dx"));
  EXPECT_FALSE(reading.Observer->GetError()) << reading.Observer->GetErrorMessage();
  EXPECT_NE(reading.Observer->GetWarningMessage().find("skewed"), std::string::npos);
  vtkDataArray* inside = reading.Image->GetPointData()->GetArray("InsideMap");
  ASSERT_NE(inside, nullptr);
  // Nodes 0 and 1 of the file's first row along x are nodes of the grid, too.
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
  // About the volume of the lattice in cells of the grid.
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

TEST(OpenDXReader, BadFilesEndInASentence)
{
  using Code = vtkErrorCode::ErrorIds;
  const std::string values = "object 3 class array type double rank 0 items 12 data follows\n";
  ExpectFailure("hello world\n", "no OpenDX file", Code::UnrecognizedFileTypeError);
  ExpectFailure(head + values + "0 1 2 3 4 5\n6 7 8 9 10", "line 8", Code::PrematureEndOfFileError);
  ExpectFailure("object 1 class gridpositions counts 1000 1000 1000\ndelta 1 0 0\ndelta 0 1 0\n"
                "delta 0 0 1\nobject 3 class array type float items 1000000000 data follows\n0\n",
    "counts lie", Code::PrematureEndOfFileError);
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
  ExpectFailure(
    "object 1 class gridpositions counts 2 nan 2\n", "whole number", Code::FileFormatError);
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

TEST(OpenDXReader, NoFileIsASentence)
{
  const Reading reading("no/such.dx");
  EXPECT_NE(reading.Observer->GetErrorMessage().find("no such file"), std::string::npos);
  EXPECT_EQ(
    reading.Reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileNotFoundError));
  EXPECT_EQ(vtkOpenDXReader::CanReadFile("no/such.dx"), 0);
  const File text("objection, my lord\n");
  EXPECT_EQ(vtkOpenDXReader::CanReadFile(text.Path.c_str()), 0);
}

TEST(OpenDXReader, ProgressRisesAndAStopLeavesNothing)
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
    struct Seen
    {
      std::vector<double> Fractions;
      bool Stop;
    } seen{ {}, stop };
    vtkNew<vtkCallbackCommand> watch;
    watch->SetClientData(&seen);
    watch->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void* fraction)
      {
        auto* all = static_cast<Seen*>(data);
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

TEST(OpenDXReader, ValuesThatAreNotFiniteAreKeptAndTold)
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

TEST(OpenDXWriter, EveryBitComesBack)
{
  ExpectSameBack<vtkDoubleArray>("double.dx");
  ExpectSameBack<vtkFloatArray>("float.dx");
  ExpectSameBack<vtkDoubleArray>("double.dx.gz");
  const File packed("", "double.dx.gz");
  WriteAndRead(HardImage<vtkFloatArray>(), packed.Path);
  EXPECT_EQ(Content(packed.Path).find("object 1 class gridpositions counts 7 5 11"), 0u);
}

TEST(OpenDXWriter, TurnedGridsAndLabelsComeBack)
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

TEST(OpenDXWriter, WhatCannotBeWrittenIsASentence)
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
  expect(HardImage<vtkFloatArray>(), "no/such/folder.dx", "", "can't be written");
  EXPECT_FALSE(std::ifstream(file.Path).good());
}
