// Finite numbers that once caused crashes, endless loops or huge allocations: spacings, scales and
// coordinates of 1e-300 to 1e300 in every filter that passes them to other libraries. Each case
// gives a finite result, or an error message and an empty output. Those that mesh:
// TestExtremeMeshing.

#include "ExtremeInputs.h"
#include "SurfaceModels.h"
#include "TopologyFilterRun.h"
#include "vtkChokingLoops.h"
#include "vtkDiffusionHighPass.h"
#include "vtkHessianCurvature.h"
#include "vtkMeshQualityReport.h"

#include <vtkCellData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace isthmus::testing;

TEST(Extremes, HessianCurvatureRefusesInvalidScalesAndSpacings)
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

TEST(Extremes, ChokingLoopsReportsASurfaceWithoutTriangles)
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
      Scale(model, factor), [](vtkChokingLoops* filter) { filter->SetCapHoles(true); });
    EXPECT_NE(run.Messages().find("unit of length"), std::string::npos) << run.Messages();
  }
}

TEST(Extremes, ChokingLoopsSampleSpacingIsBounded)
{
  // 1e-4: few points along the edges, but 10^9 on the triangles
  for (const double spacing : { 1e-300, 1e-12, 1e-4, -1.0, NaN })
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

TEST(Extremes, MeshQualityAtAnyScale)
{
  double usual = 0.0;
  for (const double factor : { 1.0, 1e-99, 1e-50, 1e50, 1e99 })
  {
    TopologyFilterRun<vtkMeshQualityReport> run(Scale(Icosphere(3, 1.0), factor));
    vtkDataArray* ratio = run.Surface(0)->GetCellData()->GetArray("RadiusEdgeRatio");
    ASSERT_NE(ratio, nullptr) << factor << run.Messages();
    EXPECT_TRUE(AllFinite(ratio)) << factor;
    usual = factor == 1.0 ? ratio->GetComponent(7, 0) : usual;
    EXPECT_NEAR(ratio->GetComponent(7, 0), usual, 1e-9) << factor;
  }
  TopologyFilterRun<vtkMeshQualityReport> run(OnePointAt(1e300));
  EXPECT_NE(run.Messages().find("1e+300"), std::string::npos) << run.Messages();
}

TEST(Extremes, DiffusionHighPassReportsItsIterations)
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
