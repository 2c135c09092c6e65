// OFF, TetGen's and MEDIT's files: the shared ones against independent parsers, round trips bit for
// bit, and damaged files, each with its line.

#include "MEDITFile.h"
#include "OFFFile.h"
#include "SharedData.h"
#include "SurfaceFiles.h"
#include "TemporaryFile.h"
#include "TetGenMeshFile.h"
#include "VolumeMeshFiles.h"
#include "vtkMEDITReader.h"
#include "vtkMEDITWriter.h"
#include "vtkOFFSurfaceReader.h"
#include "vtkOFFSurfaceWriter.h"
#include "vtkTetGenMeshReader.h"
#include "vtkTetGenMeshWriter.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkQuadraticTetra.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

template <typename Reader>
auto Opened(const std::string& path)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError)) << path;
  return reader;
}

/// Points and cells are the same, in the same order; coordinates bit for bit.
void ExpectSame(vtkPointSet* a, vtkPointSet* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    ASSERT_TRUE(p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) << "point " << i;
  }
  vtkNew<vtkIdList> ids, others;
  for (vtkIdType c = 0; c < a->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(a->GetCellType(c), b->GetCellType(c)) << "cell " << c;
    a->GetCellPoints(c, ids);
    b->GetCellPoints(c, others);
    ASSERT_EQ(ids->GetNumberOfIds(), others->GetNumberOfIds()) << "cell " << c;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      ASSERT_EQ(ids->GetId(i), others->GetId(i)) << "cell " << c;
    }
  }
}

template <typename Writer>
void Write(vtkPointSet* data, const std::string& path)
{
  vtkNew<Writer> writer;
  writer->SetInputData(data);
  writer->SetFileName(path.c_str());
  EXPECT_EQ(writer->Write(), 1) << path;
}

/// The sentence that a file's reading ends in; empty: it was read.
template <typename Read>
std::string WhyRefused(Read&& read, const std::string& content, const std::string& name,
  const std::string& partner = {}, const std::string& partnerName = "x.node")
{
  const TemporaryFile file(content, name);
  if (!partner.empty())
  {
    std::ofstream(std::filesystem::path(file.Path()).parent_path() / partnerName) << partner;
  }
  try
  {
    read(file.Path(), ProgressCallback());
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

#define EXPECT_SAYS(sentence, part)                                                                \
  EXPECT_NE((sentence).find(part), std::string::npos) << (sentence)

/// Random tetrahedra with coordinates of every size, which text must keep.
vtkSmartPointer<vtkUnstructuredGrid> RandomMesh(int type, int corners, int cells)
{
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-300, 300);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < corners * cells; ++i)
  {
    points->InsertNextPoint(std::ldexp(mantissa(random), exponent(random)),
      std::ldexp(mantissa(random), exponent(random)), i == 0 ? -0.0 : mantissa(random));
  }
  grid->SetPoints(points);
  std::vector<vtkIdType> ids(static_cast<std::size_t>(corners));
  for (int c = 0; c < cells; ++c)
  {
    for (int i = 0; i < corners; ++i)
    {
      ids[static_cast<std::size_t>(i)] = corners * c + (i * 3 + c) % corners;
    }
    grid->InsertNextCell(type, corners, ids.data());
  }
  return grid;
}

const std::string fourNodes = "4 3 0 1\n0 0 0 0 7\n1 1 0 0 8\n2 0 1 0 9\n3 0 0 1 10\n";

}

TEST(OFFFile, SharedSurfacesAreThoseOfAnIndependentParser)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/fertility.off");
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SharedDataFolder() / "surfaces"))
  {
    if (entry.path().extension() == ".off")
    {
      SCOPED_TRACE(entry.path().filename().string());
      EXPECT_EQ(vtkOFFSurfaceReader::CanReadFile(entry.path().c_str()), 1);
      const auto reader = Opened<vtkOFFSurfaceReader>(entry.path().string());
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
  const auto reader = Opened<vtkOFFSurfaceReader>(file.Path());
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

TEST(OFFFile, DamagedFilesEndInASentenceWithTheLine)
{
  const auto why = [](const std::string& content)
  {
    return WhyRefused([](const char* path, const ProgressCallback& progress)
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
  EXPECT_SAYS(why("OFF BINARY\n0123"), "binary OFF files are not read");
  EXPECT_SAYS(why("4OFF\n3 1 0\n"), "line 1: an OFF file begins with");
  EXPECT_SAYS(why("solid x\n"), "line 1: an OFF file begins with");
  const TemporaryFile foreign("solid x\n", "x.off");
  EXPECT_EQ(vtkOFFSurfaceReader::CanReadFile(foreign.Path()), 0);
  EXPECT_EQ(vtkOFFSurfaceReader::CanReadFile("no/such.off"), 0);
}

TEST(OFFFile, WhatIsWrittenComesBackBitForBit)
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
    ExpectSame(Opened<vtkOFFSurfaceReader>(file.Path())->GetOutput(), sphere->GetOutput());
  }
}

TEST(OFFFile, WritersRefuseWhatTheyDoNotHold)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  const TemporaryFile file("", "x.off");
  vtkNew<vtkOFFSurfaceWriter> writer;
  writer->AddObserver(vtkCommand::ErrorEvent, observer);
  writer->SetInputData(vtkNew<vtkPolyData>());
  writer->Write();
  EXPECT_SAYS(observer->GetErrorMessage(), "set FileName");
  observer->Clear();
  writer->SetFileName("/no/such/folder/x.off");
  writer->Write();
  EXPECT_SAYS(observer->GetErrorMessage(), "can't be written to its end");
  EXPECT_NE(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  observer->Clear();
  vtkNew<vtkPolyData> broken;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  broken->SetPoints(points);
  writer->SetInputData(broken);
  writer->SetFileName(file.Path());
  writer->Write();
  EXPECT_SAYS(observer->GetErrorMessage(), "Point 0 has a coordinate");
}

TEST(TetGenMeshFile, TenNodesComeInVTKsOrder)
{
  ISTHMUS_NEEDS_SHARED_DATA("volumes/tetgen_one_tet10.ele");
  const auto path = SharedDataFolder() / "volumes/tetgen_one_tet10.ele";
  EXPECT_EQ(vtkTetGenMeshReader::CanReadFile(path.c_str()), 1);
  const auto reader = Opened<vtkTetGenMeshReader>(path.string());
  ASSERT_EQ(reader->GetOutput()->GetNumberOfCells(), 1);
  ASSERT_EQ(reader->GetOutput()->GetCellType(0), VTK_QUADRATIC_TETRA);
  // Each further node lies in the middle of the edge that VTK says.
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

TEST(TetGenMeshFile, WhatIsWrittenComesBackBitForBit)
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
    const auto reader = Opened<vtkTetGenMeshReader>(file.Path());
    ExpectSame(reader->GetOutput(), grid);
    vtkDataArray* read = reader->GetOutput()->GetCellData()->GetArray("Attribute");
    vtkDataArray* readMarkers = reader->GetOutput()->GetPointData()->GetArray("BoundaryMarker");
    ASSERT_TRUE(read && readMarkers);
    EXPECT_EQ(read->GetComponent(6, 0), values->GetComponent(6, 0));
    EXPECT_EQ(read->GetComponent(6, 1), -1e-300);
    EXPECT_EQ(readMarkers->GetComponent(0, 0), -5);
  }
}

TEST(TetGenMeshFile, TrianglesGoWithTheTetrahedra)
{
  const auto grid = RandomMesh(VTK_TETRA, 4, 2);
  const vtkIdType triangle[3] = { 1, 5, 2 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  const TemporaryFile file("", "x.node");
  Write<vtkTetGenMeshWriter>(grid, file.Path());
  const auto folder = std::filesystem::path(file.Path()).parent_path();
  const auto faces = Opened<vtkTetGenMeshReader>((folder / "x.face").string());
  ASSERT_EQ(faces->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_EQ(faces->GetOutput()->GetCell(0)->GetPointId(1), 5);
  EXPECT_EQ(
    Opened<vtkTetGenMeshReader>((folder / "x.ele").string())->GetOutput()->GetNumberOfCells(), 2);
  EXPECT_EQ(Opened<vtkTetGenMeshReader>(file.Path())->GetOutput()->GetNumberOfPoints(), 8);
}

TEST(TetGenMeshFile, DamagedFilesEndInASentenceWithTheLine)
{
  const auto why = [](const std::string& elements, const std::string& nodes = fourNodes)
  {
    return WhyRefused([](const char* path, const ProgressCallback& progress)
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

  const auto whyFace = [](const std::string& faces)
  {
    return WhyRefused([](const char* path, const ProgressCallback& progress)
      { ReadTetGenFiles(path, progress); },
      faces, "x.face", fourNodes);
  };
  EXPECT_EQ(whyFace("1 1\n0 0 1 2 -1\n"), "");
  EXPECT_SAYS(whyFace("1 0\n0 0 1 4\n"), "x.face, line 2: vertex 4 is named");
  EXPECT_SAYS(whyFace("2 0\n0 0 1 2\n5 0 1 3\n"), "x.face, line 3: row 2 has the number 5");
  EXPECT_SAYS(whyFace("2 0\n0 0 1 2\n"), "x.face, line 1: the number of triangles is given as 2");
}

TEST(MEDITFile, SharedMeshesAreThoseOfAnIndependentParser)
{
  ISTHMUS_NEEDS_SHARED_DATA("volumes/bunny.mesh");
  for (const char* name : { "bunny.mesh", "octopus-low.mesh", "rockerarm_hex.mesh" })
  {
    SCOPED_TRACE(name);
    const auto path = SharedDataFolder() / "volumes" / name;
    EXPECT_EQ(vtkMEDITReader::CanReadFile(path.c_str()), 1);
    const auto reader = Opened<vtkMEDITReader>(path.string());
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

TEST(MEDITFile, WhatIsWrittenComesBackBitForBit)
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
    const auto reader = Opened<vtkMEDITReader>(file.Path());
    ExpectSame(reader->GetOutput(), grid);
    vtkDataArray* read = reader->GetOutput()->GetCellData()->GetArray("Reference");
    ASSERT_NE(read, nullptr);
    EXPECT_EQ(read->GetComponent(4, 0), -18);
  }
}

TEST(MEDITFile, OtherSectionsAreLeftOutAndPointsMayComeLast)
{
  const TemporaryFile file("MeshVersionFormatted 2\nDimension\n3\n# cells first\nTetrahedra\n1\n"
                           "1 2 3 4 5\nCorners 2\n1\n2\nNormals 1\n0 0 1e0\nVertices 4\n0 0 0 1\n"
                           "1 0 0 1\n0 1 0 1\n0 0 1 2\nEnd\nVertices 9\n",
    "x.mesh");
  const auto reader = Opened<vtkMEDITReader>(file.Path());
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 4);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_EQ(reader->GetOutput()->GetCell(0)->GetPointId(3), 3);
  EXPECT_EQ(reader->GetOutput()->GetPointData()->GetArray("Reference")->GetComponent(3, 0), 2);
}

TEST(MEDITFile, DamagedFilesEndInASentenceWithTheLine)
{
  const std::string head = "MeshVersionFormatted 1\nDimension 3\n";
  const auto why = [&head](const std::string& content, bool withHead = true)
  {
    return WhyRefused([](const char* path, const ProgressCallback& progress)
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
  EXPECT_SAYS(why(points + points), "for the second time");
  EXPECT_SAYS(why("Vertices 1\n0 0 oops 0\n"), "line 4: a coordinate should be a number");
  EXPECT_SAYS(why("MFEM mesh v1.0\n", false), "line 1: a MEDIT mesh begins with");
  EXPECT_SAYS(why("MeshVersionFormatted 1\nDimension 2\n", false), "line 2: only meshes in space");
}

TEST(MeshFiles, WritersSayWhatTheyLeaveOut)
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
  EXPECT_SAYS(observer->GetWarningMessage(), "left out: 'Potential'");
  EXPECT_FALSE(observer->GetError());
  writer->SetInputData(RandomMesh(VTK_QUADRATIC_TETRA, 10, 1));
  writer->Write();
  EXPECT_SAYS(observer->GetErrorMessage(), "triangulate other cells first");
  EXPECT_FALSE(
    std::filesystem::exists(file.Path()) && std::filesystem::file_size(file.Path()) == 0);
}
