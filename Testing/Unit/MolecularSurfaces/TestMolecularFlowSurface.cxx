// vtkMolecularFlowSurface as users run it: surfaces, image, table, progress and stop.

#include "vtkMolecularFlowSurface.h"

#include "FlowCases.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkTable.h>
#include <vtkTriangle.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

double GetLast(vtkTable* table, const char* column)
{
  return table->GetValueByName(table->GetNumberOfRows() - 1, column).ToDouble();
}

/// Nodes on the image's border have to be outside, or the surface would be open.
double LowestOnBorder(vtkImageData* image)
{
  const int* n = image->GetDimensions();
  vtkDataArray* values = image->GetPointData()->GetArray("SignedDistance");
  double lowest = 1e9;
  for (vtkIdType node = 0; node < image->GetNumberOfPoints(); ++node)
  {
    const auto i = static_cast<int>(node % n[0]);
    const auto j = static_cast<int>(node / n[0] % n[1]);
    const auto k = static_cast<int>(node / n[0] / n[1]);
    if (i == 0 || j == 0 || k == 0 || i == n[0] - 1 || j == n[1] - 1 || k == n[2] - 1)
    {
      lowest = std::min(lowest, values->GetComponent(node, 0));
    }
  }
  return lowest;
}

}

TEST(MolecularFlowSurface, OutputsFitEachOther)
{
  const auto filter = MakeFilter(MakeAtoms(RandomBalls(60, 12.0)));
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  const SurfaceMeasure whole = MeasureFlowSurface(surface).Whole;
  EXPECT_TRUE(whole.IsClosed());
  EXPECT_EQ(whole.IrregularPoints, 0);
  EXPECT_GT(whole.Volume, 0.0); // triangles face outwards
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  double ids[3];
  vtkIdType along = 0;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkTriangle* triangle = vtkTriangle::SafeDownCast(surface->GetCell(cell));
    ASSERT_NE(triangle, nullptr);
    vtkTriangle::ComputeNormal(
      surface->GetPoints(), 3, triangle->GetPointIds()->GetPointer(0), ids);
    along += vtkMath::Dot(ids, normals->GetTuple(triangle->GetPointId(0))) > 0.0 ? 1 : 0;
  }
  EXPECT_GT(along, surface->GetNumberOfCells() * 99 / 100);

  vtkImageData* image = filter->GetImage();
  vtkDataArray* distance = image->GetPointData()->GetArray("SignedDistance");
  vtkDataArray* s = image->GetPointData()->GetArray("S");
  ASSERT_NE(distance, nullptr);
  ASSERT_NE(s, nullptr);
  for (vtkIdType node = 0; node < image->GetNumberOfPoints(); ++node)
  {
    const double expected =
      std::clamp(0.5 - distance->GetComponent(node, 0) / (2.4 * 0.5), 0.0, 1.0);
    ASSERT_NEAR(s->GetComponent(node, 0), expected, 1e-5);
  }
  EXPECT_GT(LowestOnBorder(image), 0.9);
  vtkTable* history = filter->GetHistory();
  EXPECT_EQ(history->GetValueByName(0, "Time").ToDouble(), 0.0);
  EXPECT_NEAR(GetLast(history, "Time"), 2.5, 1e-9);
  EXPECT_NEAR(GetLast(history, "Area") / whole.Area, 1.0, 5e-3);
  EXPECT_NEAR(GetLast(history, "Volume") / whole.Volume, 1.0, 5e-3);
  EXPECT_NEAR(GetLast(history, "Energy"), 0.0700 * GetLast(history, "Area"), 1e-9);
}

TEST(MolecularFlowSurface, AtomsStayInside)
{
  const std::vector<Ball> balls = RandomBalls(60, 12.0);
  for (const int preset : { vtkMolecularFlowSurface::Fine, vtkMolecularFlowSurface::Coarse,
         vtkMolecularFlowSurface::Hull, vtkMolecularFlowSurface::Channel })
  {
    const auto filter = MakeFilter(MakeAtoms(balls));
    filter->SetPreset(preset);
    filter->Update();
    vtkImageData* image = filter->GetImage();
    vtkDataArray* distance = image->GetPointData()->GetArray("SignedDistance");
    for (vtkIdType node = 0; node < image->GetNumberOfPoints(); ++node)
    {
      double at[3];
      image->GetPoint(node, at);
      double nearest = 2.25; // where SignedDistance is cut
      for (const Ball& ball : balls)
      {
        nearest = std::min(nearest,
          std::sqrt(vtkMath::Distance2BetweenPoints(at, ball.Center.data())) - ball.Radius);
      }
      ASSERT_LT(distance->GetComponent(node, 0), nearest + 2e-3) << preset;
    }
    EXPECT_GT(LowestOnBorder(image), 0.9);
  }
}

TEST(MolecularFlowSurface, LevelIsAnOffset)
{
  const auto filter = MakeFilter(MakeAtoms({ { { 0.1, 0.2, 0.3 }, 4.0 } }));
  filter->SetSteady(true);
  for (const double level : { 0.2, 0.5, 0.8 })
  {
    filter->SetLevel(level);
    filter->Update();
    const double radius =
      std::sqrt(MeasureFlowSurface(filter->GetOutput()).Whole.Area / (4.0 * vtkMath::Pi()));
    EXPECT_NEAR(radius, 4.0 + 0.6 * (1.0 - 2.0 * level), 0.02) << level;
  }
}

TEST(MolecularFlowSurface, BorderIsKeptFreeWithoutPadding)
{
  const auto filter = MakeFilter(MakeAtoms(RandomBalls(20, 8.0)));
  filter->SetPadding(0.0);
  for (const double spacing : { 0.3, 0.7, 1.0 })
  {
    filter->SetSpacing(spacing);
    filter->Update();
    EXPECT_TRUE(MeasureFlowSurface(filter->GetOutput()).Whole.IsClosed());
    EXPECT_GT(LowestOnBorder(filter->GetImage()), 1.5 * spacing);
  }
}

TEST(MolecularFlowSurface, DelaunayQualityIsTheSameSurface)
{
  const auto filter = MakeFilter(MakeAtoms(Catenoid().Balls()));
  filter->SetSteady(true);
  filter->SetSpacing(0.25);
  filter->Update();
  const SurfaceMeasure plain = MeasureFlowSurface(filter->GetOutput()).Whole;
  filter->SetDelaunayQuality(true);
  filter->Update();
  const SurfaceMeasure fair = MeasureFlowSurface(filter->GetOutput()).Whole;
  EXPECT_TRUE(fair.IsClosed());
  EXPECT_EQ(fair.Genus, 0);
  EXPECT_NEAR(fair.Area / plain.Area, 1.0, 0.02);
  EXPECT_GT(fair.Volume, 0.0);
}

TEST(MolecularFlowSurface, ReportsProgressAndStops)
{
  struct State
  {
    std::vector<double> Reported;
    double StopAt = 2.0;
  } state;
  const auto filter = MakeFilter(MakeAtoms(RandomBalls(1000, 22.0)));
  filter->SetSteady(true);
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&state);
  watch->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
      auto* seen = static_cast<State*>(data);
      seen->Reported.push_back(algorithm->GetProgress());
      algorithm->SetAbortExecute(algorithm->GetProgress() >= seen->StopAt ? 1 : 0);
    });
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  EXPECT_TRUE(std::is_sorted(state.Reported.begin(), state.Reported.end()));
  EXPECT_GT(state.Reported.size(), 50u);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  for (const double at : { 0.0, 0.3, 0.8 })
  {
    state.StopAt = at;
    filter->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << at;
    EXPECT_EQ(filter->GetImage()->GetNumberOfPoints(), 0) << at;
  }
}
