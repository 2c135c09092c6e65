#include "Imaging/DiffusionHighPass.h"

#include "DiffusionFilterTest.h"
#include "DiffusionTestTools.h"
#include "vtkDiffusionHighPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace isthmus;
using namespace isthmus::testing;
using Filter = Listened<vtkDiffusionHighPass>;

namespace
{

/// u and v at the end, from noise.
std::array<std::vector<double>, 2> Evolved(const HighPassParameters& parameters)
{
  const auto grid = Grid<double>(12, 11, 10);
  std::array<std::vector<double>, 2> fields{ Noise(grid), Noise(grid) };
  EvolveHighPass<double>(grid, parameters, fields[0].data(), fields[1].data());
  return fields;
}

}

TEST(DiffusionHighPass, WithoutCouplingBothAreDiffusionsOfTheirOwn)
{
  HighPassParameters parameters;
  parameters.DiffusivityU = 0.2;
  parameters.DiffusivityV = 1.5;
  parameters.CouplingU = parameters.CouplingV = 0.0;
  parameters.Time = 1.0;
  parameters.Sigma = 0.8;
  const auto fields = Evolved(parameters);
  const auto grid = Grid<double>(12, 11, 10);
  DiffusionParameters diffusion;
  diffusion.Order = 0;
  diffusion.Sigma = 0.8;
  diffusion.Time = 1.0;
  for (std::size_t field = 0; field < 2; ++field)
  {
    diffusion.Diffusivity[0] = field == 0 ? parameters.DiffusivityU : parameters.DiffusivityV;
    EXPECT_EQ(fields[field], Diffused(grid, diffusion, Noise(grid)));
  }
}

// Without diffusion u' = a (v - u) and v' = b (u - v): the difference decays by exp(-(a + b) t),
// and b u + a v is constant, so that each field moves to the other by its own coupling's share.
TEST(DiffusionHighPass, CouplingPullsEachFieldByItsOwnRate)
{
  const auto grid = Grid<double>(5, 4, 3);
  HighPassParameters parameters;
  parameters.DiffusivityU = 0.0;
  parameters.DiffusivityV = 0.0;
  parameters.CouplingU = 0.5;
  parameters.CouplingV = 0.1;
  parameters.Time = 1.5;
  const std::vector<double> u = Noise(grid);
  std::vector<double> v(u.rbegin(), u.rend());
  std::vector<double> nowU = u, nowV = v;
  EvolveHighPass<double>(grid, parameters, nowU.data(), nowV.data());
  const double gone = 1.0 - std::exp(-0.6 * 1.5);
  for (std::size_t i = 0; i < u.size(); ++i)
  {
    EXPECT_NEAR(nowU[i], u[i] + 0.5 / 0.6 * gone * (v[i] - u[i]), 1e-12);
    EXPECT_NEAR(nowV[i], v[i] + 0.1 / 0.6 * gone * (u[i] - v[i]), 1e-12);
  }
}

TEST(DiffusionHighPass, CouplingKeepsEqualFieldsEqual)
{
  HighPassParameters parameters;
  parameters.CouplingU = 0.5;
  parameters.CouplingV = 0.3;
  parameters.DiffusivityU = 0.4;
  parameters.DiffusivityV = 0.4;
  parameters.Time = 2.0;
  parameters.Steps = 8;
  const auto fields = Evolved(parameters);
  EXPECT_EQ(fields[0], fields[1]);
  parameters.CouplingU = 0.0;
  parameters.CouplingV = 0.0;
  EXPECT_EQ(Evolved(parameters)[0], fields[0]);
}

TEST(DiffusionHighPass, TheSplittingIsOfSecondOrder)
{
  HighPassParameters parameters;
  parameters.CouplingU = 0.5;
  parameters.CouplingV = 0.3;
  parameters.DiffusivityU = 0.1;
  parameters.DiffusivityV = 1.0;
  parameters.Time = 2.0;
  auto difference = [&](int few, int many)
  {
    parameters.Steps = few;
    const auto coarse = Evolved(parameters);
    parameters.Steps = many;
    return Distance(coarse[1], Evolved(parameters)[1]);
  };
  // The super steps within a step depend on the number of steps as well, but are much finer.
  EXPECT_GT(difference(4, 64) / difference(16, 64), 8.0);
}

TEST(DiffusionHighPass, TheFieldsSynchronise)
{
  HighPassParameters parameters;
  parameters.DiffusivityU = 0.0;
  parameters.CouplingU = 0.2;
  parameters.CouplingV = 0.2;
  double last = 1e9;
  for (const double time : { 10.0, 30.0, 90.0 })
  {
    parameters.Time = time;
    const auto fields = Evolved(parameters);
    const double apart = Distance(fields[0], fields[1]);
    EXPECT_LT(apart, 0.5 * last);
    last = apart;
  }
  EXPECT_LT(last, 1e-3);
}

TEST(DiffusionHighPass, AConstantHasNoEdgesAndAStepHasOne)
{
  const auto image = BumpImage(VTK_DOUBLE, 40, 6, 6);
  for (const bool constant : { true, false })
  {
    vtkDataArray* const scalars = image->GetPointData()->GetScalars();
    for (vtkIdType n = 0; n < scalars->GetNumberOfTuples(); ++n)
    {
      scalars->SetTuple1(n, constant || n % 40 < 20 ? 1.0 / 3.0 : 2.0);
    }
    Filter filter(image);
    const std::vector<double> edges = Values(filter.Result());
    const auto row = edges.begin();
    if (constant)
    {
      EXPECT_TRUE(std::all_of(row, edges.end(), [](double value) { return value == 0.0; }));
    }
    else
    {
      const auto highest = std::max_element(row, row + 40) - row;
      const auto lowest = std::min_element(row, row + 40) - row;
      EXPECT_TRUE(highest >= 20 && highest <= 22) << "not on the denser side: " << highest;
      EXPECT_TRUE(lowest <= 19 && lowest >= 17) << "not on the thinner side: " << lowest;
      EXPECT_NEAR(edges[0], 0.0, 1e-3);
    }
  }
}

TEST(DiffusionHighPass, HasTheFieldsOnRequestAndRefusesWithAMessage)
{
  Filter filter(BumpImage());
  filter->GetOutputArraySelection()->EnableAllArrays();
  vtkPointData* const arrays = filter.Update()->GetPointData();
  ASSERT_TRUE(arrays->GetArray("SlowField") && arrays->GetArray("FastField"));
  const std::vector<double> u = Values(arrays->GetArray("SlowField")),
                            v = Values(arrays->GetArray("FastField")),
                            w = Values(arrays->GetArray("HighPass"));
  for (std::size_t n = 0; n < w.size(); ++n)
  {
    EXPECT_NEAR(w[n], u[n] - v[n], 1e-5);
  }
  filter->SetCouplingU(-1.0);
  EXPECT_NE(
    filter.Complaint().find("CouplingU is -1, but it must be a finite number of at least 0"),
    std::string::npos);
  filter->SetCouplingU(0.1);
  filter->SetTime(-1.0);
  EXPECT_NE(filter.Complaint().find("Time"), std::string::npos);
  vtkNew<vtkImageData> nothing;
  EXPECT_EQ(Filter(nothing).Complaint(), "");
}

TEST(DiffusionHighPass, TakesASliceAndNamesInvalidValues)
{
  ExpectTakesASliceAndNamesInvalidValues<Filter>();
}
