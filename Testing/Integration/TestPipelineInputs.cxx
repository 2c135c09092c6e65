// Inputs with hidden or missing parts: points with invalid coordinates, hidden points and cells.
#include "Core/PipelineInputs.h"
#include "vtkSurfaceMeasures.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{

vtkSmartPointer<vtkPolyData> Sphere(int precision)
{
  vtkNew<vtkSphereSource> source;
  source->SetOutputPointsPrecision(precision);
  source->Update();
  return source->GetOutput();
}

std::string CatchMessage(vtkPointSet* data)
{
  try
  {
    isthmus::RequireFinitePositions(data, "the surface");
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

TEST(PipelineInputs, UsedPointsNeedFinitePositions)
{
  for (const int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
  {
    const auto sphere = Sphere(precision);
    EXPECT_EQ(CatchMessage(sphere), "");
    const vtkIdType unused = sphere->GetPoints()->InsertNextPoint(0.0, 0.0, std::nan(""));
    EXPECT_EQ(CatchMessage(sphere), "");
    sphere->GetPoints()->SetPoint(7, 0.0, -std::numeric_limits<double>::infinity(), 1.5);
    EXPECT_EQ(CatchMessage(sphere).find("Point 7 of the surface is at (0, -inf, 1.5)"), 0u);
    // Where there are no cells, each point counts.
    vtkNew<vtkPolyData> atoms;
    atoms->SetPoints(sphere->GetPoints());
    sphere->GetPoints()->SetPoint(7, 0.0, 0.0, 0.0);
    EXPECT_EQ(
      CatchMessage(atoms).find("Point " + std::to_string(unused) + " of the surface is at"), 0u);
  }
  EXPECT_EQ(CatchMessage(nullptr), "");
  EXPECT_EQ(CatchMessage(vtkNew<vtkPolyData>()), "");
}

TEST(PipelineInputs, HiddenPointsAndCellsAreRefused)
{
  const auto run = [](bool ofCells, unsigned char type)
  {
    const auto sphere = Sphere(vtkAlgorithm::DOUBLE_PRECISION);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(ofCells ? sphere->GetNumberOfCells() : sphere->GetNumberOfPoints());
    ghosts->Fill(0);
    ghosts->SetValue(3, type);
    ghosts->SetValue(5, type);
    (ofCells ? static_cast<vtkFieldData*>(sphere->GetCellData()) : sphere->GetPointData())
      ->AddArray(ghosts);
    vtkNew<vtkSurfaceMeasures> filter;
    vtkNew<vtkTest::ErrorObserver> observer;
    filter->AddObserver(vtkCommand::ErrorEvent, observer);
    filter->AddObserver(vtkCommand::WarningEvent, observer);
    filter->SetInputData(sphere);
    filter->Update();
    EXPECT_EQ(observer->GetError(),
      vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints() == 0);
    return observer->GetErrorMessage();
  };
  EXPECT_NE(run(true, vtkDataSetAttributes::HIDDENCELL).find("2 cells of input 0 are hidden"),
    std::string::npos);
  EXPECT_NE(run(false, vtkDataSetAttributes::HIDDENPOINT).find("2 points of input 0 are hidden"),
    std::string::npos);
  EXPECT_EQ(run(true, 0), "");
  EXPECT_EQ(run(false, 0), "");
}

}
