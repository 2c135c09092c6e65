// What the vtk classes of the room add: errors as one sentence and an empty output, abort, repair,
// what is kept of the input, empty input.

#include "vtkDelaunayIsosurface.h"
#include "vtkMSMSReader.h"
#include "vtkMeshQualityReport.h"
#include "vtkSurfaceRemesh.h"
#include "vtkTetrahedralMesher.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

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
  mesher->SetLibrary(vtkTetrahedralMesher::TETGEN);
  mesher->Update();
  EXPECT_TRUE(observer->GetError());
  EXPECT_NE(observer->GetErrorMessage().find("triangles at a hole ("), std::string::npos)
    << observer->GetErrorMessage();
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0);
}

TEST(MeshingFilters, RepairFillsItAndSaysSo)
{
  for (const int library : { vtkTetrahedralMesher::TETGEN, vtkTetrahedralMesher::AUTOMATIC })
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

TEST(MeshingFilters, AMissingTetGenIsNamed)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  const Observer observer = Watch(mesher);
  mesher->SetInputData(Sphere());
  mesher->SetLibrary(vtkTetrahedralMesher::TETGEN);
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

TEST(MeshingFilters, EmptyInputGivesEmptyOutputWithoutAWord)
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

TEST(MeshingFilters, WrongInputEndsInASentence)
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
