// OFF files: the shared ones against an independent parser, round trips bit for bit, damaged files,
// each with its line.

#include "MeshFileTrips.h"
#include "Meshes/OFFFile.h"
#include "SharedData.h"
#include "SurfaceFiles.h"
#include "TemporaryFile.h"
#include "vtkOFFSurfaceReader.h"
#include "vtkOFFSurfaceWriter.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

TEST(OFFFile, SharedSurfacesMatchAnIndependentParser)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/fertility.off");
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SharedDataFolder() / "surfaces"))
  {
    if (entry.path().extension() == ".off")
    {
      SCOPED_TRACE(entry.path().filename().string());
      EXPECT_EQ(vtkOFFSurfaceReader::CanReadFile(entry.path().c_str()), 1);
      const auto reader = OpenFile<vtkOFFSurfaceReader>(entry.path().string());
      ExpectSame(reader->GetOutput(), ReadOFF(entry.path()));
      ++files;
    }
  }
  EXPECT_GT(files, 20);
}

TEST(OFFFile, HeadersColoursNormalsCommentsAndAllSizesOfFaces)
{
  const TemporaryFile file("# a comment\r\nCNOFF 5 5 0 # counts\r\n\n"
                           "0 0 0  0 0 1  255 0 7 128\n1 0 0  0 0 1  0.5 1.0 0.0\n"
                           "1 1 0  0 0 1  1 2 3\n+0 1 0  0 0 1  0 0 0 0\n2 2 2  1 0 0  0 0 0\n"
                           "3 0 1 2 255 0 0\n4 0 1 2 3\n2 0 4\n1 4\n5 0 1 4 2 3 0.1 0.2 0.3\n",
    "x.off");
  const auto reader = OpenFile<vtkOFFSurfaceReader>(file.Path());
  vtkPolyData* surface = reader->GetOutput();
  EXPECT_EQ(surface->GetNumberOfVerts(), 1);
  EXPECT_EQ(surface->GetNumberOfLines(), 1);
  EXPECT_EQ(surface->GetNumberOfPolys(), 3);
  EXPECT_EQ(surface->GetCellType(2), VTK_TRIANGLE);
  EXPECT_EQ(surface->GetCellType(3), VTK_QUAD);
  EXPECT_EQ(surface->GetCellType(4), VTK_POLYGON);
  ASSERT_NE(surface->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(surface->GetPointData()->GetNormals()->GetComponent(4, 0), 1.0);
  vtkDataArray* colours = surface->GetPointData()->GetArray("Colors");
  ASSERT_NE(colours, nullptr);
  EXPECT_EQ(colours->GetComponent(0, 3), 128);
  EXPECT_EQ(colours->GetComponent(1, 0), 128); // a share of 255
  EXPECT_EQ(colours->GetComponent(1, 1), 255);
  EXPECT_EQ(colours->GetComponent(2, 3), 255); // none given: opaque
}

TEST(OFFFile, CountsMayFollowTheHeaderDirectly)
{
  // As in the files of ModelNet.
  const std::string rows = " 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const std::string begin : { "OFF3", "OFF 3", "OFF\n3", "\t OFF3" })
  {
    const TemporaryFile file(begin + rows, "x.off");
    EXPECT_EQ(vtkOFFSurfaceReader::CanReadFile(file.Path()), 1) << begin;
    const auto reader = OpenFile<vtkOFFSurfaceReader>(file.Path());
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 3) << begin;
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), 1) << begin;
  }
  for (const std::string begin : { "OFFx", "OFF3x", "OFF-3" })
  {
    const TemporaryFile file(begin + rows, "x.off");
    EXPECT_EQ(vtkOFFSurfaceReader::CanReadFile(file.Path()), 0) << begin;
  }
}

TEST(OFFFile, DamagedFilesReportTheLine)
{
  const auto why = [](const std::string& content)
  {
    return CatchMessage([](const char* path, const ProgressCallback& progress)
      { isthmus::ReadOFF(path, progress); },
      content, "x.off");
  };
  EXPECT_EQ(why("OFF\n0 0 0\n"), "");
  EXPECT_EQ(why("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "");
  EXPECT_SAYS(why("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "line 6: vertex 3 is named");
  EXPECT_SAYS(why("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), "line 6: vertex -1 is named");
  EXPECT_SAYS(why("OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"), "line 4: a coordinate is not");
  EXPECT_SAYS(why("OFF\n3 1 0\n0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n"), "line 4: a coordinate should be");
  EXPECT_SAYS(why("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1"), "ends at line 5");
  EXPECT_SAYS(why("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n0\n"), "line 6: a face has no vertices");
  EXPECT_SAYS(
    why("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n999999999 0\n"), "line 6: the number of a face");
  EXPECT_SAYS(why("OFF\n900000000000 1 0\n0 0 0\n"), "line 2: the file is too short");
  EXPECT_SAYS(why("OFF\n-3 1 0\n0 0 0\n"), "line 2: the file is too short");
  const std::string two = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n";
  EXPECT_SAYS(why("OFF\n3 1 0\n" + two), "line 7: the file should end after its 1 faces, but '3'");
  EXPECT_SAYS(why("OFF\n2 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n"), "line");
  EXPECT_EQ(why("OFF\n3 2 0\n" + two + "\n # a comment\n\t\n"), "");
  EXPECT_SAYS(why("OFF BINARY\n0123"), "binary OFF files are not read");
  EXPECT_SAYS(why("4OFF\n3 1 0\n"), "line 1: an OFF file begins with");
  EXPECT_SAYS(why("solid x\n"), "line 1: an OFF file begins with");
  const TemporaryFile foreign("solid x\n", "x.off");
  EXPECT_EQ(vtkOFFSurfaceReader::CanReadFile(foreign.Path()), 0);
  EXPECT_EQ(vtkOFFSurfaceReader::CanReadFile("no/such.off"), 0);
}

TEST(OFFFile, RoundTripIsBitwise)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->GenerateNormalsOff();
  sphere->SetCenter(1.0 / 3.0, 1e-200, -1e200);
  sphere->Update();
  for (const char* name : { "x.off", "x.off.gz" })
  {
    const TemporaryFile file("", name);
    Write<vtkOFFSurfaceWriter>(sphere->GetOutput(), file.Path());
    ExpectSame(OpenFile<vtkOFFSurfaceReader>(file.Path())->GetOutput(), sphere->GetOutput());
  }
}

TEST(OFFFile, WritersRefuseUnsupportedCells)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  const TemporaryFile file("", "x.off");
  vtkNew<vtkOFFSurfaceWriter> writer;
  writer->AddObserver(vtkCommand::ErrorEvent, observer);
  writer->SetInputData(vtkNew<vtkPolyData>());
  writer->Write();
  EXPECT_SAYS(observer->GetErrorMessage(), "set FileName");
  observer->Clear();
  writer->SetFileName(file.Path());
  writer->Write();
  EXPECT_SAYS(observer->GetErrorMessage(), "The input has no points");
  observer->Clear();
  vtkNew<vtkPolyData> point;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0, 0, 0);
  point->SetPoints(points);
  writer->SetInputData(point);
  writer->SetFileName("/no/such/folder/x.off");
  writer->Write();
  EXPECT_SAYS(observer->GetErrorMessage(), "can't be written to its end");
  EXPECT_NE(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  observer->Clear();
  points->SetPoint(0, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  points->Modified();
  writer->SetFileName(file.Path());
  writer->Write();
  EXPECT_SAYS(observer->GetErrorMessage(), "Point 0 has a coordinate");
}

TEST(OFFFile, PointsLinesAndPolygonsComeBack)
{
  CellMesh mesh;
  mesh.Coordinates = { 0, 0, 0, 1, 0, 0, 2, 1, 0, 1, 2, 0, 0, 1, 0.1 };
  for (const std::int64_t corners : { 1, 2, 3, 4, 5 })
  {
    for (std::int64_t c = 0; c < corners; ++c)
    {
      mesh.Vertices.push_back(c);
    }
    mesh.EndCell(std::array{ CellShape::Vertex, CellShape::Line, CellShape::Triangle,
      CellShape::Quadrilateral, CellShape::Polygon }[static_cast<std::size_t>(corners - 1)]);
  }
  const TemporaryFile file("", "x.off");
  WriteOFF(mesh, file.Path());
  const CellMesh back = isthmus::ReadOFF(file.Path());
  EXPECT_EQ(back.Coordinates, mesh.Coordinates);
  EXPECT_EQ(back.Vertices, mesh.Vertices);
  EXPECT_EQ(back.Shapes, mesh.Shapes);
}
