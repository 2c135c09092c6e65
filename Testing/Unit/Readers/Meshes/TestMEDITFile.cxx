// MEDIT's files: the shared ones against an independent parser, round trips bit for bit, damaged
// files, each with its line; what all writers leave out.

#include "MeshFileTrips.h"
#include "Meshes/MEDITFile.h"
#include "SharedData.h"
#include "TemporaryFile.h"
#include "VolumeMeshFiles.h"
#include "vtkMEDITReader.h"
#include "vtkMEDITWriter.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

TEST(MEDITFile, SharedMeshesMatchAnIndependentParser)
{
  ISTHMUS_NEEDS_SHARED_DATA("volumes/bunny.mesh");
  for (const char* name : { "bunny.mesh", "octopus-low.mesh", "rockerarm_hex.mesh" })
  {
    SCOPED_TRACE(name);
    const auto path = SharedDataFolder() / "volumes" / name;
    EXPECT_EQ(vtkMEDITReader::CanReadFile(path.c_str()), 1);
    const auto reader = OpenFile<vtkMEDITReader>(path.string());
    // The parser of the tests leaves surface cells out.
    vtkNew<vtkUnstructuredGrid> volume;
    volume->SetPoints(reader->GetOutput()->GetPoints());
    volume->AllocateEstimate(1, 8);
    vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; c < reader->GetOutput()->GetNumberOfCells(); ++c)
    {
      if (reader->GetOutput()->GetCell(c)->GetCellDimension() == 3)
      {
        reader->GetOutput()->GetCellPoints(c, ids);
        volume->InsertNextCell(reader->GetOutput()->GetCellType(c), ids);
      }
    }
    ASSERT_GT(volume->GetNumberOfCells(), 100);
    ExpectSame(volume, ReadVolumeMesh(path));
  }
  EXPECT_EQ(
    vtkMEDITReader::CanReadFile((SharedDataFolder() / "volumes/tinyzoo-3d.mesh").c_str()), 0);
}

TEST(MEDITFile, RoundTripIsBitwise)
{
  for (const auto& [type, corners] :
    { std::pair{ VTK_TETRA, 4 }, { VTK_HEXAHEDRON, 8 }, { VTK_WEDGE, 6 }, { VTK_PYRAMID, 5 },
      { VTK_TRIANGLE, 3 }, { VTK_QUAD, 4 }, { VTK_LINE, 2 } })
  {
    const auto grid = RandomMesh(type, corners, 5);
    vtkNew<vtkIntArray> references;
    references->SetName("Reference");
    for (int i = 0; i < 5; ++i)
    {
      references->InsertNextValue(10 - 7 * i);
    }
    grid->GetCellData()->AddArray(references);
    const TemporaryFile file("", "x.mesh");
    Write<vtkMEDITWriter>(grid, file.Path());
    const auto reader = OpenFile<vtkMEDITReader>(file.Path());
    ExpectSame(reader->GetOutput(), grid);
    vtkDataArray* read = reader->GetOutput()->GetCellData()->GetArray("Reference");
    ASSERT_NE(read, nullptr);
    EXPECT_EQ(read->GetComponent(4, 0), -18);
  }
}

TEST(MEDITFile, OtherSectionsAreSkippedAndPointsMayComeLast)
{
  const TemporaryFile file("MeshVersionFormatted 2\nDimension\n3\n# cells first\nTetrahedra\n1\n"
                           "1 2 3 4 5\nCorners 2\n1\n2\nNormals 1\n0 0 1e0\nVertices 4\n0 0 0 1\n"
                           "1 0 0 1\n0 1 0 1\n0 0 1 2\nEnd\nVertices 9\n",
    "x.mesh");
  const auto reader = OpenFile<vtkMEDITReader>(file.Path());
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 4);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_EQ(reader->GetOutput()->GetCell(0)->GetPointId(3), 3);
  EXPECT_EQ(reader->GetOutput()->GetPointData()->GetArray("Reference")->GetComponent(3, 0), 2);
}

TEST(MEDITFile, DamagedFilesReportTheLine)
{
  const std::string head = "MeshVersionFormatted 1\nDimension 3\n";
  const auto why = [&head](const std::string& content, bool withHead = true)
  {
    return CatchMessage([](const char* path, const ProgressCallback& progress)
      { ReadMEDIT(path, progress); },
      (withHead ? head : "") + content, "x.mesh");
  };
  const std::string points = "Vertices 3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n";
  EXPECT_EQ(why(points + "Triangles 1\n1 2 3 0\nEnd\n"), "");
  EXPECT_SAYS(why(points + "Triangles 1\n1 2 4 0\nEnd\n"), "line 8: vertex 4 is named");
  EXPECT_SAYS(why(points + "Triangles 1\n0 1 2 0\nEnd\n"), "line 8: vertex 0 is named");
  EXPECT_SAYS(
    why("Triangles 1\n1 2 9 0\n" + points + "End\n"), "vertex 9 is named, but there are 3");
  EXPECT_SAYS(
    why(points + "Triangles 1\n1 2 3 0\n1 2 3 0\nEnd\n"), "line 9: a section should begin");
  EXPECT_SAYS(
    why(points + "Triangles 2000000\n1 2 3 0\n"), "line 7: Triangles is given as 2000000");
  EXPECT_SAYS(why(points + "Triangles 1\n1 2"), "line 8");
  EXPECT_SAYS(why(points + points), "Vertices occurs twice");
  EXPECT_SAYS(why("Vertices 1\n0 0 oops 0\n"), "line 4: a coordinate should be a number");
  EXPECT_SAYS(why("MFEM mesh v1.0\n", false), "line 1: a MEDIT mesh begins with");
  EXPECT_SAYS(why("MeshVersionFormatted 1\nDimension 4\n", false), "line 2: the dimension is 4");
  EXPECT_SAYS(why(points + "Dimension 3\nEnd\n"), "the dimension comes after the vertices");
}

TEST(MEDITFile, PlaneMeshesHaveNoHeight)
{
  // Written as by mmg2d, Gmsh and FreeFem.
  for (const std::string dimension : { "Dimension 2", "Dimension\n2" })
  {
    const TemporaryFile file("MeshVersionFormatted 2\n\n" + dimension +
        "\n\nVertices\n4\n0 0.5 1\n1 0.5 2\n1 2 3\n0 2 4\nEdges\n1\n1 2 7\nTriangles\n2\n"
        "1 2 3 8\n1 3 4 9\nEnd\n",
      "x.mesh");
    const auto reader = OpenFile<vtkMEDITReader>(file.Path());
    vtkUnstructuredGrid* grid = reader->GetOutput();
    ASSERT_EQ(grid->GetNumberOfPoints(), 4);
    ASSERT_EQ(grid->GetNumberOfCells(), 3);
    EXPECT_EQ(grid->GetPoint(2)[1], 2.0);
    EXPECT_EQ(grid->GetPoint(2)[2], 0.0);
    EXPECT_EQ(grid->GetPointData()->GetArray("Reference")->GetComponent(3, 0), 4);
    EXPECT_EQ(grid->GetCellData()->GetArray("Reference")->GetComponent(2, 0), 9);
  }
}

TEST(MEDITFile, TheBinaryFormatIsNamed)
{
  // The first words of libMeshb's files: 1 and the version, in either byte order.
  for (const bool isLittle : { true, false })
  {
    for (const char version : { '\1', '\2', '\3', '\4' })
    {
      std::string begin(16, '\0');
      begin[isLittle ? 0 : 3] = 1;
      begin[isLittle ? 4 : 7] = version;
      const TemporaryFile file(begin, "x.meshb");
      EXPECT_EQ(vtkMEDITReader::CanReadFile(file.Path()), 1);
      EXPECT_SAYS(CatchMessage([](const char* path, const ProgressCallback& progress)
                    { ReadMEDIT(path, progress); },
                    begin, "x.meshb"),
        "MEDIT's binary format (.meshb), which is not read. Convert it");
    }
  }
}

TEST(MeshFiles, WritersReportWhatTheyOmit)
{
  const auto grid = RandomMesh(VTK_TETRA, 4, 1);
  vtkNew<vtkDoubleArray> extra;
  extra->SetName("Potential");
  extra->SetNumberOfTuples(grid->GetNumberOfPoints());
  extra->Fill(1.0);
  grid->GetPointData()->AddArray(extra);
  const TemporaryFile file("", "x.mesh");
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkMEDITWriter> writer;
  writer->AddObserver(vtkCommand::WarningEvent, observer);
  writer->AddObserver(vtkCommand::ErrorEvent, observer);
  writer->SetInputData(grid);
  writer->SetFileName(file.Path());
  writer->Write();
  EXPECT_SAYS(observer->GetWarningMessage(), "dropped: 'Potential'");
  EXPECT_FALSE(observer->GetError());
  writer->SetInputData(RandomMesh(VTK_QUADRATIC_TETRA, 10, 1));
  writer->Write();
  EXPECT_SAYS(observer->GetErrorMessage(), "triangulate other cells first");
  EXPECT_FALSE(
    std::filesystem::exists(file.Path()) && std::filesystem::file_size(file.Path()) == 0);
}
