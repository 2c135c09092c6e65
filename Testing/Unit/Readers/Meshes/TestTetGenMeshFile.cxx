// TetGen's files: round trips bit for bit, damaged files, each with its line.

#include "Files/ReaderError.h"
#include "MeshFileTrips.h"
#include "Meshes/TetGenMeshFile.h"
#include "SharedData.h"
#include "TemporaryFile.h"
#include "vtkTetGenMeshReader.h"
#include "vtkTetGenMeshWriter.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

const std::string fourNodes = "4 3 0 1\n0 0 0 0 7\n1 1 0 0 8\n2 0 1 0 9\n3 0 0 1 10\n";

}

TEST(TetGenMeshFile, TenNodesComeInVTKsOrder)
{
  ISTHMUS_NEEDS_SHARED_DATA("volumes/tetgen_one_tet10.ele");
  const auto path = SharedDataFolder() / "volumes/tetgen_one_tet10.ele";
  EXPECT_EQ(vtkTetGenMeshReader::CanReadFile(path.c_str()), 1);
  const auto reader = OpenFile<vtkTetGenMeshReader>(path.string());
  ASSERT_EQ(reader->GetOutput()->GetNumberOfCells(), 1);
  ASSERT_EQ(reader->GetOutput()->GetCellType(0), VTK_QUADRATIC_TETRA);
  // Each further node lies in the middle of the edge given by VTK's order.
  vtkPoints* points = reader->GetOutput()->GetCell(0)->GetPoints();
  const int edges[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
  for (int e = 0; e < 6; ++e)
  {
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_EQ(points->GetPoint(4 + e)[a],
        0.5 *
          (points->GetData()->GetComponent(edges[e][0], a) +
            points->GetData()->GetComponent(edges[e][1], a)));
    }
  }
}

TEST(TetGenMeshFile, RoundTripIsBitwise)
{
  for (const auto& [type, corners] : { std::pair{ VTK_TETRA, 4 }, { VTK_QUADRATIC_TETRA, 10 } })
  {
    const auto grid = RandomMesh(type, corners, 7);
    vtkNew<vtkDoubleArray> values;
    values->SetName("Attribute");
    values->SetNumberOfComponents(2);
    vtkNew<vtkIntArray> markers;
    markers->SetName("BoundaryMarker");
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      markers->InsertNextValue(static_cast<int>(i) - 5);
    }
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      values->InsertNextTuple2(1.0 / (3.0 + static_cast<double>(i)), -1e-300);
    }
    grid->GetPointData()->AddArray(markers);
    grid->GetCellData()->AddArray(values);
    const TemporaryFile file("", "x.ele");
    Write<vtkTetGenMeshWriter>(grid, file.Path());
    const auto reader = OpenFile<vtkTetGenMeshReader>(file.Path());
    ExpectSame(reader->GetOutput(), grid);
    vtkDataArray* read = reader->GetOutput()->GetCellData()->GetArray("Attribute");
    vtkDataArray* readMarkers = reader->GetOutput()->GetPointData()->GetArray("BoundaryMarker");
    ASSERT_TRUE(read && readMarkers);
    EXPECT_EQ(read->GetComponent(6, 0), values->GetComponent(6, 0));
    EXPECT_EQ(read->GetComponent(6, 1), -1e-300);
    EXPECT_EQ(readMarkers->GetComponent(0, 0), -5);
  }
}

TEST(TetGenMeshFile, TrianglesAreReadWithTheTetrahedra)
{
  const auto grid = RandomMesh(VTK_TETRA, 4, 2);
  const vtkIdType triangle[3] = { 1, 5, 2 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  const TemporaryFile file("", "x.node");
  Write<vtkTetGenMeshWriter>(grid, file.Path());
  const auto folder = std::filesystem::path(file.Path()).parent_path();
  const auto faces = OpenFile<vtkTetGenMeshReader>((folder / "x.face").string());
  ASSERT_EQ(faces->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_EQ(faces->GetOutput()->GetCell(0)->GetPointId(1), 5);
  EXPECT_EQ(
    OpenFile<vtkTetGenMeshReader>((folder / "x.ele").string())->GetOutput()->GetNumberOfCells(), 2);
  EXPECT_EQ(OpenFile<vtkTetGenMeshReader>(file.Path())->GetOutput()->GetNumberOfPoints(), 8);
}

TEST(TetGenMeshFile, DamagedFilesReportTheLine)
{
  const auto why = [](const std::string& elements, const std::string& nodes = fourNodes)
  {
    return CatchMessage([](const char* path, const ProgressCallback& progress)
      { ReadTetGenFiles(path, progress); },
      elements, "x.ele", nodes);
  };
  EXPECT_EQ(why("1 4 1\n0 0 1 2 3 2.5\n"), "");
  EXPECT_EQ(why("# none\n0 4 0\n"), "");
  EXPECT_SAYS(why("1 4 0\n0 0 1 2 4\n"), "x.ele, line 2: vertex 4 is named");
  EXPECT_SAYS(why("2 4 0\n0 0 1 2 3\n7 0 1 2 3\n"), "x.ele, line 3: row 2 has the number 7");
  EXPECT_SAYS(why("1 5 0\n0 0 1 2 3 3\n"), "x.ele, line 1: tetrahedra have 4 or 10 corners");
  EXPECT_SAYS(why("2 4 0\n0 0 1 2 3\n"), "x.ele: the file ends at line 3");
  EXPECT_SAYS(why("2 4 0\n0 0 1 2 3 \n1 0 1 2"), "x.ele");
  EXPECT_SAYS(why("1 4 0\n0 0 1 2 3\n", "4 2 0 0\n0 0 0\n1 1 0\n2 0 1\n3 1 1\n"),
    "x.node, line 1: the points have 2");
  EXPECT_SAYS(why("1 4 0\n0 0 1 2 3\n", "4 3 0 0\n0 0 0 inf\n1 0 0 0\n2 0 0 0\n3 0 0 0\n"),
    "x.node, line 2: a coordinate is not a finite number");
  EXPECT_SAYS(why("1 4 0\n0 0 1 2 3\n", ""), "x.node");
  EXPECT_SAYS(why("1 4 0\n0 0 1 2 3\n1 0 1 2 3\n"),
    "x.ele, line 3: the file should end after its 1 tetrahedra, but '1'");
  EXPECT_SAYS(why("1 4 0\n0 0 1 2 3 4\n"), "x.ele, line 2: the file should end after");
  EXPECT_SAYS(why("1 4 0\n0 0 1 2 3\n", "3 3 0 1\n" + fourNodes.substr(8)), "x.node, line 5: the");
  EXPECT_EQ(why("1 4 0\n0 0 1 2 3 # one\n\n# Generated by tetgen\n"), "");

  const auto whyFace = [](const std::string& faces)
  {
    return CatchMessage([](const char* path, const ProgressCallback& progress)
      { ReadTetGenFiles(path, progress); },
      faces, "x.face", fourNodes);
  };
  EXPECT_EQ(whyFace("1 1\n0 0 1 2 -1\n"), "");
  EXPECT_SAYS(whyFace("1 0\n0 0 1 4\n"), "x.face, line 2: vertex 4 is named");
  EXPECT_SAYS(whyFace("2 0\n0 0 1 2\n5 0 1 3\n"), "x.face, line 3: row 2 has the number 5");
  EXPECT_SAYS(whyFace("1 0\n0 0 1 2\n1 0 1 3\n"), "x.face, line 3: the file should end after");
  EXPECT_EQ(whyFace("1 1\n0 0 1 2 -1 5 6\n"), "");
  EXPECT_SAYS(whyFace("1 1\n0 0 1 2 -1 5\n"), "has 2 numbers after its corners instead of 1");
  EXPECT_SAYS(whyFace("2 0\n0 0 1 2\n"), "x.face, line 1: the number of triangles is given as 2");

  // MSMS has .face files as well.
  const TemporaryFile faces("#faces\n1 1 1.00 1.50\n1 2 3 1 1\n", "y.face");
  std::ofstream(std::filesystem::path(faces.Path()).replace_extension(".vert")) << "#vertices\n";
  try
  {
    ReadTetGenFiles(faces.Path());
    FAIL();
  }
  catch (const ReaderError& error)
  {
    EXPECT_SAYS(std::string(error.what()), "Open it with the MSMS Surface Reader");
  }
}
