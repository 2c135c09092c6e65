// The extremes of TestExtremes in the filters that mesh, and invalid commands of TetGen.

#include "Core/ChildProcess.h"
#include "ExtremeInputs.h"
#include "SurfaceModels.h"
#include "TopologyFilterRun.h"
#include "vtkChokingLoops.h"
#include "vtkDelaunayIsosurface.h"
#include "vtkOffsetSurface.h"
#include "vtkSurfaceRemesh.h"
#include "vtkTetrahedralMesher.h"

#include <vtkCallbackCommand.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

using namespace isthmus::testing;

TEST(Extremes, CGALMesherAtAnyScale)
{
  for (const double factor : { 1e-38, 1e-20, 1e50, 1e99 })
  {
    TopologyFilterRun<vtkTetrahedralMesher> run(Scale(Torus(12, 8, 1.0, 0.4), factor),
      [factor](vtkTetrahedralMesher* filter)
      {
        filter->SetLibrary(vtkTetrahedralMesher::CGAL);
        filter->SetFacetSize(0.3 * factor);
        filter->SetCellSize(0.4 * factor);
      });
    EXPECT_EQ(run.Messages(), "") << factor;
    EXPECT_GT(run.Grid(0)->GetNumberOfCells(), 100) << factor;
    EXPECT_EQ(Outcome(run, run.Grid(0)), "result") << factor;
  }
}

TEST(Extremes, RepairOfAPointFarAway)
{
  for (const double place : { 1e40, 1e100, 1e150, 1e300 })
  {
    TopologyFilterRun<vtkTetrahedralMesher> run(OnePointAt(place),
      [](vtkTetrahedralMesher* filter)
      {
        filter->SetLibrary(vtkTetrahedralMesher::CGAL);
        filter->SetRepair(true);
      });
    EXPECT_NE(Outcome(run, run.Grid(0)), "not finite") << place;
    EXPECT_EQ(run.Messages().find("Switch on Repair"), std::string::npos) << run.Messages();
  }
}

// Found by the soak test: relative to a point that far away all others coincide, and CGAL's
// smoothing of them gave points that are not finite, on which its next step crashed.
TEST(Extremes, AnOutlierIsReportedByAllMeshers)
{
  for (const double place : { 1e18, 1e38 }) // CGAL's relaxation, by SIGSEGV
  {
    TopologyFilterRun<vtkSurfaceRemesh> remesh(OnePointAt(place));
    EXPECT_NE(remesh.Messages().find("far away"), std::string::npos) << remesh.Messages();
    EXPECT_EQ(remesh.Surface(0)->GetNumberOfPoints(), 0);
  }
  for (const double place : { 1e60, 1e99 })
  {
    const auto surface = OnePointAt(place);
    for (const int target :
      { vtkSurfaceRemesh::ByRelativeEdgeLength, vtkSurfaceRemesh::ByNumberOfTriangles })
    {
      TopologyFilterRun<vtkSurfaceRemesh> remesh(
        surface, [target](vtkSurfaceRemesh* filter) { filter->SetTarget(target); });
      EXPECT_NE(remesh.Messages().find("far away"), std::string::npos) << remesh.Messages();
      EXPECT_EQ(remesh.Surface(0)->GetNumberOfPoints(), 0);
    }
    for (const bool repair : { false, true })
    {
      TopologyFilterRun<vtkTetrahedralMesher> mesher(
        surface, [repair](vtkTetrahedralMesher* filter) { filter->SetRepair(repair); });
      EXPECT_NE(mesher.Messages(), "") << "at " << place;
      EXPECT_EQ(mesher.Grid(0)->GetNumberOfPoints(), 0);
    }
  }
}

TEST(Extremes, DelaunayIsosurfaceOfExtremeSpacings)
{
  for (const double spacing : { 1e-30, 1e50, 1e90 })
  {
    TopologyFilterRun<vtkDelaunayIsosurface> run(Ball(spacing, spacing, spacing),
      [](vtkDelaunayIsosurface* filter) { filter->SetLevel(0.5); });
    EXPECT_GT(run.Surface(0)->GetNumberOfCells(), 20) << spacing << run.Messages();
    EXPECT_EQ(Outcome(run, run.Surface(0)), "result") << spacing;
  }
}

TEST(Extremes, DelaunayIsosurfaceRefusesInfiniteValues)
{
  const auto messages = [](vtkImageData* image, double radius, double distance)
  {
    TopologyFilterRun<vtkDelaunayIsosurface> run(image,
      [radius, distance](vtkDelaunayIsosurface* filter)
      {
        filter->SetLevel(0.5);
        filter->SetRadius(radius);
        filter->SetDistance(distance);
      });
    return run.Messages();
  };
  EXPECT_NE(messages(Ball(1, 1, 1, NaN), 0, 0).find("origin"), std::string::npos);
  EXPECT_NE(messages(Ball(1e-6, 1, 1e6), 0, 0).find("Radius"), std::string::npos);
  EXPECT_NE(messages(Ball(1, 1, 1), 1e-300, 0).find("Radius"), std::string::npos);
  EXPECT_NE(messages(Ball(1, 1, 1), 0, 1e-300).find("Distance"), std::string::npos);
  EXPECT_NE(messages(Ball(1, 1, 1), NaN, 0).find("not a number"), std::string::npos);
}

TEST(Extremes, OffsetSurfaceIsFinite)
{
  for (const double factor : { 1e-90, 1e-30, 1.0, 1e30, 1e90 })
  {
    for (const double distance : { 1e-12, 0.1, 1e3, 1e12, 1e300 })
    {
      TopologyFilterRun<vtkOffsetSurface> run(Scale(Icosphere(3, 1.0), factor),
        [&](vtkOffsetSurface* filter)
        {
          filter->SetDistance(distance * factor);
          filter->SetResolution(24);
        });
      EXPECT_NE(Outcome(run, run.Surface(0)), "not finite") << factor << " " << distance;
    }
  }
}

TEST(Extremes, SurfaceRemeshInterpolatesFiniteNumbers)
{
  Model model = Icosphere(3, 1.0);
  model.Points[5] = { model.Points[5][0], model.Points[5][1], model.Points[5][2] + 1e-9 };
  for (const double flat : { 1.0, 1e-9, 1e-150 })
  {
    Model needle = model;
    for (Vector& p : needle.Points)
    {
      p[2] *= flat;
    }
    auto surface = ToPolyData(needle);
    vtkNew<vtkDoubleArray> height;
    height->SetName("Height");
    for (const Vector& p : model.Points)
    {
      height->InsertNextValue(p[2]);
    }
    surface->GetPointData()->AddArray(height);
    TopologyFilterRun<vtkSurfaceRemesh> run(surface);
    EXPECT_NE(Outcome(run, run.Surface(0)), "not finite") << flat;
    EXPECT_TRUE(AllFinite(run.Surface(0)->GetPointData()->GetArray("Height"))) << flat;
  }
}

// Found by FuzzSurfaceFilters: the mean edge was taken before corners were checked.
TEST(Extremes, CornersThatAreNoPointsAreReportedByAllMeshers)
{
  for (const vtkIdType corner : { vtkIdType(-1), vtkIdType(1) << 40 })
  {
    Model model = Icosphere(3, 1.0);
    model.Triangles[7][1] = corner;
    const auto surface = ToPolyData(model);
    TopologyFilterRun<vtkSurfaceRemesh> remesh(surface);
    EXPECT_NE(remesh.Messages().find("missing point"), std::string::npos) << remesh.Messages();
    TopologyFilterRun<vtkTetrahedralMesher> mesher(surface);
    EXPECT_NE(mesher.Messages().find("missing point"), std::string::npos) << mesher.Messages();
    TopologyFilterRun<vtkChokingLoops> loops(surface);
    EXPECT_NE(loops.Messages(), "");
    // With a quadrangle beside it, the surface goes through vtkTriangleFilter first.
    const vtkIdType four[4] = { 0, 1, 2, 3 };
    surface->GetPolys()->InsertNextCell(4, four);
    TopologyFilterRun<vtkSurfaceRemesh> polygons(surface);
    EXPECT_NE(polygons.Messages().find("damaged"), std::string::npos) << polygons.Messages();
  }
}

TEST(Extremes, SurfaceRemeshOfLongNeedlesIsRefused)
{
  Model model = Icosphere(3, 1e-5); // and therefore almost no area
  model.Points[5] = { 1e9, 0.0, 0.0 };
  TopologyFilterRun<vtkSurfaceRemesh> run(ToPolyData(model),
    [](vtkSurfaceRemesh* filter)
    {
      filter->SetTarget(vtkSurfaceRemesh::ByEdgeLength);
      filter->SetEdgeLength(0.2);
    });
  EXPECT_NE(run.Messages().find("50 million"), std::string::npos) << run.Messages();
}

TEST(Extremes, TheCGALMesherAbortsWithinASecond)
{
  using Clock = std::chrono::steady_clock;
  struct State
  {
    int Reports = 0;
    Clock::time_point Last = Clock::now();
    double LongestSilence = 0.0;
  } state;
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(ToPolyData(Icosphere(8, 1.0)));
  mesher->SetLibrary(vtkTetrahedralMesher::CGAL);
  mesher->SetCellSize(0.1);
  mesher->SetFacetSize(0.1);
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&state);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*)
    {
      auto& at = *static_cast<State*>(data);
      const auto now = Clock::now();
      at.LongestSilence =
        std::max(at.LongestSilence, std::chrono::duration<double>(now - at.Last).count());
      at.Last = now;
      ++at.Reports;
    });
  mesher->AddObserver(vtkCommand::ProgressEvent, observer);
  mesher->Update();
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 1000);
  EXPECT_GT(state.Reports, 50); // if progress is reported, an abort takes effect
  RecordProperty("LongestSilence", std::to_string(state.LongestSilence));
}

TEST(Extremes, InvalidTetGenCommandsAreReported)
{
  const isthmus::TemporaryFolder own;
  const std::filesystem::path& folder = own.Path();
  const std::string text = folder / "text";
  std::ofstream(text) << "no program\n";
  const std::string killed = folder / "killed";
  std::ofstream(killed) << "#!/bin/sh\nkill -TERM $$\n";
  std::filesystem::permissions(killed, std::filesystem::perms::owner_all);
  const auto messages = [](const std::string& command)
  {
    TopologyFilterRun<vtkTetrahedralMesher> run(ToPolyData(Icosphere(2, 1.0)),
      [&command](vtkTetrahedralMesher* filter)
      {
        filter->SetLibrary(vtkTetrahedralMesher::TetGen);
        filter->SetTetGenCommand(command.c_str());
      });
    return run.Messages();
  };
  EXPECT_NE(messages(folder.string()).find("can't be run"), std::string::npos)
    << messages(folder.string());
  EXPECT_NE(messages(text).find("can't be run"), std::string::npos) << messages(text);
  EXPECT_NE(messages(killed).find("killed by the signal"), std::string::npos) << messages(killed);
  EXPECT_NE(messages(folder / "missing").find("not found"), std::string::npos);
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  setenv("TMPDIR", (folder / "nowhere").c_str(), 1);
  const std::string missing = messages("tetgen");
  before ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
  EXPECT_NE(missing.find("set TMPDIR"), std::string::npos) << missing;
}
