#include "vtkMSMSReader.h"

#include "Core/ChildProcess.h"
#include "Core/PolyDataTriangles.h"
#include "Meshes/MSMSReader.h"
#include "SharedData.h"
#include "Surfaces/ShellNesting.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <fstream>

using namespace isthmus;

namespace
{

/// A pair of files in a folder of its own.
struct Pair
{
  Pair(const std::string& vertices, const std::string& faces)
    : File(this->Folder.Path() / "isthmus_msms.vert")
  {
    std::ofstream(this->File) << vertices;
    std::ofstream(this->Folder.Path() / "isthmus_msms.face") << faces;
  }

  TemporaryFolder Folder;
  std::filesystem::path File; ///< the .vert
};

std::string CatchMessage(const std::filesystem::path& file)
{
  try
  {
    MSMSSurface surface;
    ReadMSMS(file, 0, surface);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return {};
}

const char* const Three = "0 0 0 0 0 1 0 7 2\n1 0 0 0 0 1 3 8 1\n0 1 0 0 0 1 0 9 3\n";

}

TEST(MSMSReader, ReadsHeadersCommentsAndAtomNames)
{
  const Pair pair("# MSMS solvent excluded surface vertices\n#vertex #sphere density probe_r\n"
                  "3 40 1.00 1.50\n0 0 0 0 0 1 0 7 2 N_ALA_1\n"
                  "1 0 0 0 0 1 3 8 1 CA_ALA_1\n0 1 0 0 0 1 0 9 3 C_ALA_1\n",
    "#faces\n1 40 1.00 1.50\n1 2 3 1 12\n");
  MSMSSurface surface;
  ReadMSMS(pair.File, 4, surface);
  ASSERT_EQ(surface.Points.size(), 3u);
  EXPECT_EQ(surface.Points[1][0], 1.0);
  EXPECT_EQ(surface.SphereOfPoint, (std::vector<int>{ 6, 7, 8 }));
  EXPECT_EQ(surface.TypeOfPoint, (std::vector<int>{ 2, 1, 3 }));
  ASSERT_EQ(surface.Triangles.size(), 1u);
  EXPECT_EQ(surface.Triangles[0], (isthmus::Triangle{ 0, 1, 2 }));
  EXPECT_EQ(surface.ComponentOfTriangle, (std::vector<int>{ 4 }));
  EXPECT_EQ(surface.AnalyticFaceOfTriangle, (std::vector<int>{ 12 }));
  EXPECT_EQ(vtkMSMSReader::CanReadFile(pair.File.c_str()), 1);
}

TEST(MSMSReader, DamagedFilesReportTheLine)
{
  EXPECT_NE(
    CatchMessage(Pair(Three, "1 2 4 1 12\n").File).find("names vertex 4"), std::string::npos);
  EXPECT_NE(CatchMessage(Pair(Three, "1 2 1.5 1 12\n").File).find("integer"), std::string::npos);
  EXPECT_NE(CatchMessage(Pair(Three, "1 2 3 1 12\n1 2\n").File).find("Line 2"), std::string::npos);
  EXPECT_NE(
    CatchMessage(Pair("0 0 nan 0 0 1 0 7 2\n", "").File).find("not a finite"), std::string::npos);
  EXPECT_NE(
    CatchMessage(Pair("hello\n", "").File).find("0 numbers instead of 9"), std::string::npos);
  EXPECT_NE(CatchMessage("no/such.vert").find("There is no file"), std::string::npos);
  EXPECT_EQ(vtkMSMSReader::CanReadFile("no/such.vert"), 0);
  EXPECT_EQ(vtkMSMSReader::CanReadFile("picture.png"), 0);
}

TEST(MSMSReader, LysozymeHasAShellAndThreeCavities)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/lysozyme_msms/Lys1.vert");
  vtkNew<vtkMSMSReader> reader;
  reader->SetFileName(
    (isthmus::testing::SharedDataFolder() / "surfaces/lysozyme_msms/Lys1.face").c_str());
  reader->Update();
  vtkPolyData* surface = reader->GetOutput();
  EXPECT_EQ(surface->GetNumberOfPoints(), 7201 + 35 + 158 + 37);
  EXPECT_EQ(surface->GetNumberOfCells(), 14398 + 66 + 312 + 70);
  EXPECT_EQ(surface->GetCellData()->GetArray("Component")->GetRange()[1], 3.0);
  const TriangleMesh mesh = ToTriangleMesh(surface);
  EXPECT_EQ(FindDefects(mesh).Message(), "");
  // Four spheres: Euler number 8; normals point as the triangles do.
  EXPECT_EQ(EulerCharacteristic(mesh), 8);
  std::int64_t agree = 0;
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  for (const Triangle& t : mesh.Triangles)
  {
    const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
    Point3 n;
    normals->GetTuple(t[0], n.data());
    agree += Dot(Cross(at(1) - at(0), at(2) - at(0)), n) > 0.0 ? 1 : 0;
  }
  EXPECT_GT(agree, 99 * static_cast<std::int64_t>(mesh.Triangles.size()) / 100);
  const ShellNesting nesting = FindNesting(mesh);
  ASSERT_EQ(nesting.InnerRegions.size(), 4u);
  EXPECT_EQ(nesting.InnerRegions[0].Id, 1);
  EXPECT_EQ(nesting.InnerRegions[1].Id, -1);
  EXPECT_EQ(nesting.InnerRegions[3].Id, -3);
}
