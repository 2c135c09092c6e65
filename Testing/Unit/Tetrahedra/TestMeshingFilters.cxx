// The vtk classes of the module: an error is one message and an empty output; abort, repair, data
// kept from the input, empty input.

#include "vtkDelaunayIsosurface.h"
#include "vtkMSMSReader.h"
#include "vtkMeshQualityReport.h"
#include "vtkSurfaceRemesh.h"
#include "vtkTetrahedralMesher.h"

#include <vtkCallbackCommand.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFeatureEdges.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{

using Observer = vtkSmartPointer<vtkTest::ErrorObserver>;

Observer Watch(vtkAlgorithm* filter)
{
  auto observer = Observer::New();
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  // The executive only repeats that the filter failed.
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, Observer::New());
  return observer;
}

vtkSmartPointer<vtkPolyData> Sphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(16);
  source->SetPhiResolution(16);
  source->Update();
  vtkNew<vtkDoubleArray> made;
  made->SetName("MadeBy");
  made->InsertNextValue(7.0);
  source->GetOutput()->GetFieldData()->AddArray(made);
  return source->GetOutput();
}

/// The sphere without its last triangle.
vtkSmartPointer<vtkPolyData> OpenSphere()
{
  auto sphere = Sphere();
  vtkNew<vtkCellArray> fewer;
  for (vtkIdType i = 0; i + 1 < sphere->GetNumberOfCells(); ++i)
  {
    fewer->InsertNextCell(sphere->GetCell(i));
  }
  sphere->SetPolys(fewer);
  return sphere;
}

/// Each triangle with points of its own, as in an STL file.
vtkSmartPointer<vtkPolyData> Soup(vtkPolyData* surface)
{
  auto soup = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType t = 0; t < surface->GetNumberOfCells(); ++t)
  {
    triangles->InsertNextCell(3);
    for (int corner = 0; corner < 3; ++corner)
    {
      triangles->InsertCellPoint(
        points->InsertNextPoint(surface->GetPoint(surface->GetCell(t)->GetPointId(corner))));
    }
  }
  soup->SetPoints(points);
  soup->SetPolys(triangles);
  return soup;
}

void AbortAtOnce(vtkAlgorithm* filter)
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  filter->AddObserver(vtkCommand::ProgressEvent, abort);
}

}

TEST(MeshingFilters, AnOpenSurfaceIsRefusedWithItsTriangles)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  const Observer observer = Watch(mesher);
  mesher->SetInputData(OpenSphere());
  mesher->SetLibrary(vtkTetrahedralMesher::TetGen);
  mesher->Update();
  EXPECT_TRUE(observer->GetError());
  EXPECT_NE(observer->GetErrorMessage().find("triangles at a hole ("), std::string::npos)
    << observer->GetErrorMessage();
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0);
}

TEST(MeshingFilters, RepairFillsItAndReportsIt)
{
  for (const int library : { vtkTetrahedralMesher::TetGen, vtkTetrahedralMesher::Automatic })
  {
    vtkNew<vtkTetrahedralMesher> mesher;
    const Observer observer = Watch(mesher);
    mesher->SetInputData(OpenSphere());
    mesher->SetLibrary(library);
    mesher->RepairOn();
    mesher->Update();
    EXPECT_FALSE(observer->GetError()) << observer->GetErrorMessage();
    EXPECT_TRUE(observer->GetWarning());
    EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 100);
    auto* fields = mesher->GetOutput()->GetFieldData();
    auto* repair = vtkStringArray::SafeDownCast(fields->GetAbstractArray("Repair"));
    ASSERT_NE(repair, nullptr);
    EXPECT_NE(repair->GetValue(0).find("filled 1 hole"), std::string::npos);
    EXPECT_NE(fields->GetArray("MadeBy"), nullptr);
  }
}

TEST(MeshingFilters, ASoupGivesItsOriginalSurface)
{
  const auto mesh = [](vtkPolyData* surface, int library)
  {
    vtkNew<vtkTetrahedralMesher> mesher;
    const Observer observer = Watch(mesher);
    mesher->SetInputData(surface);
    mesher->SetLibrary(library);
    mesher->Update();
    EXPECT_FALSE(observer->GetError()) << observer->GetErrorMessage();
    return vtkSmartPointer<vtkUnstructuredGrid>(mesher->GetOutput());
  };
  const auto soup = Soup(Sphere());
  for (const int library : { vtkTetrahedralMesher::TetGen, vtkTetrahedralMesher::Automatic })
  {
    const auto found = mesh(soup, library);
    EXPECT_GT(found->GetNumberOfCells(), 100);
    const vtkIdType expected = mesh(Sphere(), library)->GetNumberOfCells();
    EXPECT_LT(std::abs(found->GetNumberOfCells() - expected), 100); // other ids
    vtkDataArray* original = found->GetPointData()->GetArray("OriginalPointId");
    for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
    {
      const auto id = static_cast<vtkIdType>(original->GetTuple1(i));
      for (int a = 0; a < 3 && id >= 0; ++a)
      {
        ASSERT_EQ(found->GetPoint(i)[a], soup->GetPoint(id)[a]) << i;
      }
    }
  }
}

// TetGen makes vertices of points that no triangle uses, or drops them, and numbers the rest anew:
// a point that it had added was given the id of an unused point.
TEST(MeshingFilters, UnusedPointsAreNotMeshed)
{
  const auto sphere = Sphere();
  const vtkIdType expected = sphere->GetNumberOfPoints();
  for (const double place : { 0.0, 1e5 }) // within and far away
  {
    const auto surface = Sphere();
    surface->GetPoints()->InsertNextPoint(place, 0.01, 0.02);
    surface->GetPointData()->Initialize();
    vtkNew<vtkTetrahedralMesher> mesher;
    const Observer observer = Watch(mesher);
    mesher->SetInputData(surface);
    mesher->SetLibrary(vtkTetrahedralMesher::TetGen);
    mesher->Update();
    EXPECT_FALSE(observer->GetError()) << observer->GetErrorMessage();
    vtkUnstructuredGrid* mesh = mesher->GetOutput();
    vtkDataArray* original = mesh->GetPointData()->GetArray("OriginalPointId");
    vtkIdType kept = 0;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const auto id = static_cast<vtkIdType>(original->GetTuple1(i));
      kept += id >= 0;
      ASSERT_LT(id, expected);
    }
    EXPECT_EQ(kept, expected);
  }
}

TEST(MeshingFilters, ASoupIsRemeshedWithItsPointData)
{
  const auto soup = Soup(Sphere());
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType i = 0; i < soup->GetNumberOfPoints(); ++i)
  {
    height->InsertNextValue(soup->GetPoint(i)[2]);
  }
  soup->GetPointData()->AddArray(height);
  vtkNew<vtkSurfaceRemesh> remesh;
  const Observer observer = Watch(remesh);
  remesh->SetInputData(soup);
  remesh->Update();
  EXPECT_FALSE(observer->GetError()) << observer->GetErrorMessage();
  vtkPolyData* surface = remesh->GetOutput();
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0) << "it is closed, as the sphere is";
  ASSERT_GT(surface->GetNumberOfPoints(), 50);
  vtkDataArray* carried = surface->GetPointData()->GetArray("Height");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(carried->GetTuple1(i), surface->GetPoint(i)[2], 1e-6);
  }
}

TEST(MeshingFilters, AMissingTetGenIsNamed)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  const Observer observer = Watch(mesher);
  mesher->SetInputData(Sphere());
  mesher->SetLibrary(vtkTetrahedralMesher::TetGen);
  mesher->SetTetGenCommand("no-such-tetgen");
  mesher->Update();
  EXPECT_NE(observer->GetErrorMessage().find("'no-such-tetgen' was not found"), std::string::npos);
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0);
}

TEST(MeshingFilters, AbortLeavesAnEmptyOutputAndNoError)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  const Observer observer = Watch(mesher);
  mesher->SetInputData(Sphere());
  AbortAtOnce(mesher);
  mesher->Update();
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_FALSE(observer->GetError());
}

TEST(MeshingFilters, EmptyInputGivesEmptyOutputWithoutAMessage)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  vtkNew<vtkSurfaceRemesh> remesh;
  vtkNew<vtkMeshQualityReport> report;
  vtkNew<vtkDelaunayIsosurface> isosurface;
  for (vtkAlgorithm* filter : { static_cast<vtkAlgorithm*>(mesher),
         static_cast<vtkAlgorithm*>(remesh), static_cast<vtkAlgorithm*>(report) })
  {
    const Observer observer = Watch(filter);
    filter->SetInputDataObject(vtkNew<vtkPolyData>());
    filter->Update();
    EXPECT_FALSE(observer->GetError()) << filter->GetClassName();
    EXPECT_EQ(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfCells(), 0);
  }
  const Observer observer = Watch(isosurface);
  isosurface->SetInputData(vtkNew<vtkImageData>());
  isosurface->Update();
  EXPECT_FALSE(observer->GetError());
}

TEST(MeshingFilters, WrongInputIsReported)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  vtkNew<vtkDelaunayIsosurface> isosurface;
  Observer observer = Watch(isosurface);
  isosurface->SetInputData(image);
  isosurface->Update();
  EXPECT_NE(observer->GetErrorMessage().find("no active scalars"), std::string::npos);

  vtkNew<vtkUnstructuredGrid> cubes;
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(8);
  cubes->SetPoints(points);
  const vtkIdType ids[] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  cubes->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  vtkNew<vtkMeshQualityReport> report;
  observer = Watch(report);
  report->SetInputData(cubes);
  report->Update();
  EXPECT_NE(observer->GetErrorMessage().find("vtkHexahedron"), std::string::npos);

  vtkNew<vtkMSMSReader> reader;
  observer = Watch(reader);
  reader->SetFileName("no/such/file.vert");
  reader->Update();
  EXPECT_NE(observer->GetErrorMessage().find("There is no file"), std::string::npos);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_NE(reader->GetErrorCode(), 0u);
}
