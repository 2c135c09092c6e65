// The .cmesh format: round trips through the writer, the thesis' sample, and bad files.

#include "vtkCombinatorialMeshReader.h"

#include "GridFixtures.h"
#include "Meshes/CombinatorialMeshFile.h"
#include "TemporaryFile.h"
#include "vtkCombinatorialMeshWriter.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedShortArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;

/// Table 3.3 of the thesis, with coordinates and an attribute.
const char* const Sample = R"(isthmus-combinatorial-mesh 1 text
types 2
type 4 4 tetrahedron
3 0 2 1
3 0 1 3
3 1 2 3
3 2 0 3
type 6 5 prism
3 0 2 1
4 0 1 4 3
4 1 2 5 4
4 2 0 3 5
3 3 4 5
vertices 8 float32
0 0 0
1 0 0
0 1 0
0 0 1
1 0 1
0 1 1
0.3 0.3 -1
0.3 0.3 2
blocks 2
block 0 2
1 0 2 6
3 4 5 7
block 1 1
0 1 2 3 4 5
attributes 1
attribute cells uint8 1 Material of the cell
1
2
3
end
)";

/// A reader whose errors are collected.
struct Reading
{
  Reading()
  {
    this->Reader->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Pipeline);
  }
  vtkUnstructuredGrid* Read(const char* path)
  {
    this->Reader->SetFileName(path);
    this->Reader->Update();
    return this->Reader->GetOutput();
  }
  vtkNew<vtkCombinatorialMeshReader> Reader;
  vtkNew<vtkTest::ErrorObserver> Observer, Pipeline;
};

std::string ReplaceInSample(const std::string& from, const std::string& to)
{
  std::string text = Sample;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void ExpectRefusal(const std::string& contents, const std::string& words)
{
  const TemporaryFile file(contents, "bad.cmesh");
  Reading reading;
  vtkUnstructuredGrid* grid = reading.Read(file.Path());
  EXPECT_NE(reading.Observer->GetErrorMessage().find(words), std::string::npos)
    << reading.Observer->GetErrorMessage() << "\nshould say: " << words;
  EXPECT_EQ(grid->GetNumberOfCells(), 0);
  EXPECT_EQ(grid->GetNumberOfPoints(), 0);
  EXPECT_EQ(
    reading.Reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileFormatError));
}

void ExpectSameArrays(vtkDataSetAttributes* a, vtkDataSetAttributes* b)
{
  ASSERT_EQ(a->GetNumberOfArrays(), b->GetNumberOfArrays());
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkDataArray *x = a->GetArray(i), *y = b->GetArray(i);
    ASSERT_STREQ(x->GetName(), y->GetName());
    ASSERT_EQ(x->GetNumberOfComponents(), y->GetNumberOfComponents());
    ASSERT_EQ(x->GetNumberOfTuples(), y->GetNumberOfTuples());
    ASSERT_EQ(x->GetDataTypeSize(), y->GetDataTypeSize());
    ASSERT_EQ(std::memcmp(x->GetVoidPointer(0), y->GetVoidPointer(0),
                static_cast<std::size_t>(x->GetDataSize()) *
                  static_cast<std::size_t>(x->GetDataTypeSize())),
      0)
      << x->GetName();
  }
}

void ExpectSameGrid(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  ASSERT_EQ(a->GetPoints()->GetDataType(), b->GetPoints()->GetDataType());
  for (vtkIdType p = 0; p < a->GetNumberOfPoints(); ++p)
  {
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_EQ(a->GetPoint(p)[i], b->GetPoint(p)[i]);
    }
  }
  vtkNew<vtkIdList> x, y;
  const auto expectSame = [&]()
  {
    ASSERT_EQ(x->GetNumberOfIds(), y->GetNumberOfIds());
    for (vtkIdType i = 0; i < x->GetNumberOfIds(); ++i)
    {
      ASSERT_EQ(x->GetId(i), y->GetId(i));
    }
  };
  for (vtkIdType c = 0; c < a->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(a->GetCellType(c), b->GetCellType(c));
    a->GetCellPoints(c, x);
    b->GetCellPoints(c, y);
    expectSame();
    if (a->GetCellType(c) == VTK_POLYHEDRON)
    {
      a->GetFaceStream(c, x);
      b->GetFaceStream(c, y);
      expectSame();
    }
  }
  ExpectSameArrays(a->GetPointData(), b->GetPointData());
  ExpectSameArrays(a->GetCellData(), b->GetCellData());
}

/// Arrays with values that are hard to keep.
void AddArrays(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> hard;
  hard->SetName("Hard values, two a point");
  hard->SetNumberOfComponents(2);
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    hard->InsertNextTuple2(std::sqrt(0.1 + static_cast<double>(p)) * 1e-300,
      p % 3 ? -0.0 : std::numeric_limits<double>::infinity());
  }
  grid->GetPointData()->AddArray(hard);
  vtkNew<vtkUnsignedShortArray> shorts;
  shorts->SetName("Shorts");
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    shorts->InsertNextValue(static_cast<unsigned short>(65535 - c));
  }
  grid->GetCellData()->AddArray(shorts);
}

}

TEST(CombinatorialMeshReader, ReadsTheSampleOfTheThesis)
{
  const TemporaryFile file(Sample, "sample.cmesh");
  Reading reading;
  vtkUnstructuredGrid* grid = reading.Read(file.Path());
  EXPECT_EQ(reading.Observer->GetErrorMessage(), "");
  ASSERT_EQ(grid->GetNumberOfCells(), 3);
  EXPECT_EQ(grid->GetCellType(0), VTK_TETRA);
  EXPECT_EQ(grid->GetCellType(2), VTK_WEDGE);
  EXPECT_EQ(grid->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_FLOAT_EQ(static_cast<float>(grid->GetPoint(6)[2]), -1.0f);
  EXPECT_EQ(grid->GetCellData()->GetArray("Material of the cell")->GetTuple1(2), 3.0);
  EXPECT_EQ(reading.Reader->CanReadFile(file.Path()), 1);
  const TemporaryFile other("isthmus", "other.cmesh");
  EXPECT_EQ(reading.Reader->CanReadFile(other.Path()), 0);
}

TEST(CombinatorialMeshReader, TextOfTheSampleSurvives)
{
  const CombinatorialMesh mesh = ParseCombinatorialMesh(Sample);
  std::ostringstream text;
  WriteCombinatorialMesh(mesh, false, text);
  EXPECT_EQ(text.str(), Sample);
}

TEST(CombinatorialMeshReader, RoundTripsAreExact)
{
  for (const bool binary : { true, false })
  {
    for (const GridFixture& fixture : AllGridFixtures())
    {
      AddArrays(fixture.Grid);
      const TemporaryFile file("", "round.cmesh");
      vtkNew<vtkCombinatorialMeshWriter> writer;
      writer->SetInputData(fixture.Grid);
      writer->SetFileName(file.Path());
      writer->SetBinary(binary);
      writer->Write();
      ASSERT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
      Reading reading;
      vtkUnstructuredGrid* grid = reading.Read(file.Path());
      EXPECT_EQ(reading.Observer->GetErrorMessage(), "") << fixture.Name;
      ExpectSameGrid(fixture.Grid, grid);
    }
  }
}

TEST(CombinatorialMeshReader, RefusesBadFilesWithTheLine)
{
  ExpectRefusal("", "ends where the file's name should be");
  ExpectRefusal("nonsense 1 text", "line 1: this is not a combinatorial mesh");
  ExpectRefusal(
    ReplaceInSample("mesh 1 text", "mesh 2 text"), "the version of the format should be");
  ExpectRefusal(ReplaceInSample(" text", " words"), "'text' or 'binary' should follow");
  ExpectRefusal(ReplaceInSample("types 2", "types 1000000"), "the number of cell types should be");
  ExpectRefusal(ReplaceInSample("3 0 2 1\n3 0 1 3", "3 0 1 2\n3 0 1 3"), "in the same direction");
  ExpectRefusal(ReplaceInSample("3 2 0 3\n", "3 2 0 9\n"), "line 7: a vertex of a face should be");
  ExpectRefusal(ReplaceInSample("vertices 8", "vertices 9"), "'blocks' among the coordinates");
  ExpectRefusal(
    ReplaceInSample("vertices 8", "vertices 99999999999"), "the number of vertices should be");
  ExpectRefusal(ReplaceInSample("float32", "int32"), "coordinates should be float32 or float64");
  ExpectRefusal(ReplaceInSample("block 1 1", "block 2 1"), "the number of a cell type should be");
  ExpectRefusal(ReplaceInSample("3 4 5 7", "3 4 5 8"), "block 0 has the vertex number 8");
  ExpectRefusal(ReplaceInSample("block 0 2", "block 0 3"), "'block' among the vertices of cells");
  ExpectRefusal(ReplaceInSample("uint8 1", "uint8 7"), "values of an attribute");
  ExpectRefusal(
    ReplaceInSample("\n3\nend", "\n300\nend"), "'300' among the values of an attribute");
  ExpectRefusal(ReplaceInSample("end\n", ""), "ends where 'end' should be. It is truncated.");
  std::ostringstream binary;
  WriteCombinatorialMesh(ParseCombinatorialMesh(Sample), true, binary);
  for (std::size_t size = 0; size + 1 < binary.str().size(); ++size)
  {
    EXPECT_THROW(ParseCombinatorialMesh(binary.str().substr(0, size)), std::runtime_error) << size;
  }
}

TEST(CombinatorialMeshReader, RefusesMissingFiles)
{
  Reading reading;
  EXPECT_EQ(reading.Read("/nowhere/at/all.cmesh")->GetNumberOfCells(), 0);
  EXPECT_NE(reading.Observer->GetErrorMessage().find("can't be opened"), std::string::npos);
  reading.Observer->Clear();
  EXPECT_EQ(reading.Read(nullptr)->GetNumberOfCells(), 0);
  EXPECT_NE(reading.Observer->GetErrorMessage().find("set FileName"), std::string::npos);
}

TEST(CombinatorialMeshReader, WriterReportsWhatItCannotDo)
{
  const auto grid = AllGridFixtures().front().Grid;
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkCombinatorialMeshWriter> writer;
  writer->AddObserver(vtkCommand::ErrorEvent, observer);
  writer->SetInputData(grid);
  writer->SetFileName("/nowhere/at/all.cmesh");
  writer->Write();
  EXPECT_NE(observer->GetErrorMessage().find("can't be written to its end"), std::string::npos);
  EXPECT_NE(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

TEST(CombinatorialMeshReader, ManyValuesComeBackInBinary)
{
  const auto grid = AllGridFixtures().front().Grid;
  while (grid->GetNumberOfPoints() < 5000)
  {
    const auto x = static_cast<double>(grid->GetNumberOfPoints());
    grid->GetPoints()->InsertNextPoint(x, 0.5 * x, -x);
  }
  const TemporaryFile file("", "many.cmesh");
  vtkNew<vtkCombinatorialMeshWriter> writer;
  writer->SetInputData(grid);
  writer->SetFileName(file.Path());
  writer->SetBinary(true);
  writer->Write();
  Reading reading;
  vtkUnstructuredGrid* back = reading.Read(file.Path());
  EXPECT_EQ(reading.Observer->GetErrorMessage(), "");
  ExpectSameGrid(grid, back);
}
