// Finite numbers that were once the end of the program, of its patience or of its memory: spacings,
// scales and coordinates of 1e-300 to 1e300 in every filter that hands them to others. Each case
// ends in a finite result or in a sentence and an empty output.

#include "vtkChokingLoops.h"
#include "vtkDelaunayIsosurface.h"
#include "vtkDiffusionHighPass.h"
#include "vtkHessianCurvature.h"
#include "vtkMeshQualityReport.h"
#include "vtkOffsetSurface.h"
#include "vtkSurfaceRemesh.h"
#include "vtkTetrahedralMesher.h"

#include "RangeGuard.h"
#include "SurfaceModels.h"
#include "TopologyFilterRun.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

using namespace isthmus::testing;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// A ball of density, 12 nodes each way.
vtkSmartPointer<vtkImageData> Ball(double hx, double hy, double hz, double origin = 0.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(12, 12, 12);
  image->SetSpacing(hx, hy, hz);
  image->SetOrigin(origin, 0.0, 0.0);
  vtkNew<vtkFloatArray> values;
  values->SetName("Density");
  for (int node = 0; node < 12 * 12 * 12; ++node)
  {
    const double x = node % 12 - 5.5, y = node / 12 % 12 - 5.5, z = node / 144 - 5.5;
    values->InsertNextValue(static_cast<float>(std::exp(-(x * x + y * y + z * z) / 12.0)));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

vtkSmartPointer<vtkPolyData> Scaled(Model model, double factor)
{
  for (Vector& p : model.Points)
  {
    for (double& x : p)
    {
      x *= factor;
    }
  }
  return ToPolyData(model);
}

vtkSmartPointer<vtkPolyData> OnePointAt(double place)
{
  Model model = Icosphere(3, 1.0);
  model.Points[5] = { place, 0.0, 0.0 };
  return ToPolyData(model);
}

bool AllFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(array->GetComponent(i, c)))
      {
        return false;
      }
    }
  }
  return true;
}

/// A sentence and nothing, or a result whose points are finite.
template <typename Filter>
std::string Outcome(TopologyFilterRun<Filter>& run, vtkPointSet* output)
{
  if (!run.Messages().empty() && output->GetNumberOfPoints() == 0)
  {
    return "refused";
  }
  return !output->GetPoints() || AllFinite(output->GetPoints()->GetData()) ? "result"
                                                                           : "not finite";
}

}

TEST(Extremes, HessianCurvatureRefusesScalesAndSpacingsThatAreNone)
{
  const auto messages = [](double scale, double spacing)
  {
    TopologyFilterRun<vtkHessianCurvature> run(Ball(spacing, spacing, spacing),
      [scale](vtkHessianCurvature* filter) { filter->SetScale(scale); });
    return run.Messages();
  };
  EXPECT_NE(messages(1.0, 0.0).find("spacing"), std::string::npos);
  EXPECT_NE(messages(1.0, NaN).find("not a number"), std::string::npos);
  EXPECT_NE(messages(1.0, 1e-30).find("Scale is 1"), std::string::npos);
  EXPECT_NE(messages(1e9, 1.0).find("Scale is 1e+09"), std::string::npos);
  EXPECT_NE(messages(NaN, 1.0).find("Scale"), std::string::npos);
  EXPECT_EQ(messages(2.0, 1.0), "");
  EXPECT_EQ(messages(12.0, 1.0), ""); // as long as the image
}

TEST(Extremes, HessianCurvatureOfTinyAndHugeSpacingsIsFiniteOrMarked)
{
  for (const double spacing : { 1e-30, 1e-15, 1e15, 1e30, 1e99 })
  {
    vtkNew<vtkHessianCurvature> filter;
    filter->SetInputData(Ball(spacing, spacing, spacing));
    filter->Update();
    for (int a = 0; a < filter->GetOutput()->GetPointData()->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray(a);
      EXPECT_TRUE(AllFinite(array)) << array->GetName() << " at spacing " << spacing;
    }
  }
}

TEST(Extremes, ChokingLoopsWithoutTrianglesIsASentence)
{
  Model model = Icosphere(3, 1.0);
  model.Triangles.clear();
  for (const int filtration : { 0, 1 })
  {
    for (const int morse : { 0, 1, 2 })
    {
      TopologyFilterRun<vtkChokingLoops> run(ToPolyData(model),
        [filtration, morse](vtkChokingLoops* filter)
        {
          filter->SetFiltration(filtration);
          filter->SetMorseFunction(morse);
        });
      EXPECT_NE(run.Messages().find("no triangles"), std::string::npos) << filtration << morse;
    }
  }
}

TEST(Extremes, ChokingLoopsCapHolesAtHugeCoordinates)
{
  Model model = Icosphere(3, 1.0);
  Append(model, Icosphere(3, 1.0), { 0.7, 0.1, 0.2 });
  for (const double factor : { 1e150, 1e300 })
  {
    TopologyFilterRun<vtkChokingLoops> run(
      Scaled(model, factor), [](vtkChokingLoops* filter) { filter->SetCapHoles(true); });
    EXPECT_NE(run.Messages().find("unit of length"), std::string::npos) << run.Messages();
  }
}

TEST(Extremes, ChokingLoopsSampleSpacingIsBounded)
{
  for (const double spacing : { 1e-300, 1e-12, -1.0, NaN })
  {
    TopologyFilterRun<vtkChokingLoops> run(ToPolyData(Icosphere(3, 1.0)),
      [spacing](vtkChokingLoops* filter) { filter->SetSampleSpacing(spacing); });
    EXPECT_NE(run.Messages().find("SampleSpacing"), std::string::npos) << run.Messages();
  }
}

// Needles have edges but next to no area: the spacing that the area suggests is next to nothing.
TEST(Extremes, ChokingLoopsOfNeedlesEnd)
{
  Model model = Icosphere(2, 1.0);
  for (Vector& p : model.Points)
  {
    p[1] *= 1e-9;
    p[2] *= 1e-9;
  }
  TopologyFilterRun<vtkChokingLoops> run(ToPolyData(model));
  SUCCEED();
}

TEST(Extremes, CGALMesherAtAnyScale)
{
  for (const double factor : { 1e-38, 1e-20, 1e50, 1e99 })
  {
    TopologyFilterRun<vtkTetrahedralMesher> run(Scaled(Torus(12, 8, 1.0, 0.4), factor),
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

TEST(Extremes, MeshQualityAtAnyScale)
{
  double usual = 0.0;
  for (const double factor : { 1.0, 1e-99, 1e-50, 1e50, 1e99 })
  {
    TopologyFilterRun<vtkMeshQualityReport> run(Scaled(Icosphere(3, 1.0), factor));
    vtkDataArray* ratio = run.Surface(0)->GetCellData()->GetArray("RadiusEdgeRatio");
    ASSERT_NE(ratio, nullptr) << factor << run.Messages();
    EXPECT_TRUE(AllFinite(ratio)) << factor;
    usual = factor == 1.0 ? ratio->GetComponent(7, 0) : usual;
    EXPECT_NEAR(ratio->GetComponent(7, 0), usual, 1e-9) << factor;
  }
  TopologyFilterRun<vtkMeshQualityReport> run(OnePointAt(1e300));
  EXPECT_NE(run.Messages().find("1e+300"), std::string::npos) << run.Messages();
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

TEST(Extremes, DelaunayIsosurfaceRefusesWhatHasNoEnd)
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
      TopologyFilterRun<vtkOffsetSurface> run(Scaled(Icosphere(3, 1.0), factor),
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
TEST(Extremes, CornersThatAreNoPointsAreToldByAllThatMesh)
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
  Model model = Icosphere(3, 1e-9); // and so next to no area
  model.Points[5] = { 1e9, 0.0, 0.0 };
  TopologyFilterRun<vtkSurfaceRemesh> run(ToPolyData(model),
    [](vtkSurfaceRemesh* filter)
    {
      filter->SetTarget(vtkSurfaceRemesh::EDGE_LENGTH);
      filter->SetEdgeLength(0.2);
    });
  EXPECT_NE(run.Messages().find("50 million"), std::string::npos) << run.Messages();
}

TEST(Extremes, DiffusionHighPassTellsWhatItWouldTake)
{
  const auto messages = [](double diffusivity, double time, int steps)
  {
    TopologyFilterRun<vtkDiffusionHighPass> run(Ball(1, 1, 1),
      [&](vtkDiffusionHighPass* filter)
      {
        filter->SetDiffusivityU(diffusivity);
        filter->SetTime(time);
        filter->SetSteps(steps);
      });
    return run.Messages();
  };
  EXPECT_NE(messages(1e10, 1.0, 0).find("evaluations"), std::string::npos);
  EXPECT_NE(messages(1e300, 1.0, 0).find("evaluations"), std::string::npos);
  EXPECT_NE(messages(1.0, 1e300, 0).find("evaluations"), std::string::npos);
  EXPECT_NE(messages(1.0, 1.0, 2147483647).find("evaluations"), std::string::npos);
  EXPECT_EQ(messages(10.0, 1.0, 0), "");
}

TEST(Extremes, AnAbortOfTheCGALMesherIsHeardWithinASecond)
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
  EXPECT_GT(state.Reports, 50); // where progress is told, a stop is heard
  RecordProperty("LongestSilence", std::to_string(state.LongestSilence));
}

TEST(Extremes, TetGenCommandsThatAreNoneAreTold)
{
  const auto folder = std::filesystem::path(::testing::TempDir()) / "isthmus_tetgen_command";
  std::filesystem::create_directories(folder);
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
        filter->SetLibrary(vtkTetrahedralMesher::TETGEN);
        filter->SetTetGenCommand(command.c_str());
      });
    return run.Messages();
  };
  EXPECT_NE(messages(folder.string()).find("can't be run"), std::string::npos)
    << messages(folder.string());
  EXPECT_NE(messages(text).find("can't be run"), std::string::npos) << messages(text);
  EXPECT_NE(messages(killed).find("from outside"), std::string::npos) << messages(killed);
  EXPECT_NE(messages(folder / "missing").find("not found"), std::string::npos);
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  setenv("TMPDIR", (folder / "nowhere").c_str(), 1);
  const std::string missing = messages("tetgen");
  before ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
  EXPECT_NE(missing.find("set TMPDIR"), std::string::npos) << missing;
}

TEST(RangeGuard, SaysNumbersInWords)
{
  EXPECT_EQ(isthmus::Shown(1e300), "1e+300");
  EXPECT_EQ(isthmus::Shown(NaN), "not a number");
  EXPECT_EQ(isthmus::Shown(0.25), "0.25");
}

TEST(RangeGuard, ScalesByPowersOfTwoOnlyWhatNeedsIt)
{
  const std::vector<isthmus::Point3> usual{ { 1.0, -300.0, 0.1 } };
  EXPECT_TRUE(isthmus::UnitScale(usual).IsOne());
  std::vector<isthmus::Point3> points{ { 1.1e-50, -3.3e-51, 0.0 }, { NaN, 0.0, 0.0 } };
  const auto before = points;
  const isthmus::UnitScale scale(points);
  scale.Apply(points);
  EXPECT_GT(points[0][0], 0.5);
  EXPECT_LT(points[0][0], 1.0);
  scale.Undo(points);
  EXPECT_EQ(points[0], before[0]);
  EXPECT_THROW(
    isthmus::UnitScale(std::vector<isthmus::Point3>{ { 0.0, 2e100, 0.0 } }), std::invalid_argument);
  EXPECT_THROW(isthmus::UnitScale(std::vector<isthmus::Point3>{ { 0.0, 1e-101, 0.0 } }),
    std::invalid_argument);
}

TEST(RangeGuard, RefusesNaNWithTheRange)
{
  try
  {
    isthmus::DemandRange("Angle", NaN, 0.0, 30.0, "It is in degrees.");
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(
      error.what(), "Angle is not a number, but it must be from 0 to 30. It is in degrees.");
  }
}
