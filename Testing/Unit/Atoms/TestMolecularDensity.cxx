// Balls whose volume, values and enclosure are known; sums by brute force; invariances; bad input.

#include "vtkMolecularDensity.h"

#include "Atoms/MolecularDensity.h"
#include "BallPoints.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace isthmus;
using isthmus::testing::MakeAtoms;

namespace
{

constexpr double Pi = 3.14159265358979323846;

struct Volume
{
  DensityGrid Grid;
  std::vector<float> Values;

  std::array<double, 3> Place(std::size_t node) const
  {
    const auto& n = this->Grid.Dimensions;
    const auto at = static_cast<std::int64_t>(node);
    return { this->Grid.Origin[0] + this->Grid.Spacing * static_cast<double>(at % n[0]),
      this->Grid.Origin[1] + this->Grid.Spacing * static_cast<double>(at / n[0] % n[1]),
      this->Grid.Origin[2] + this->Grid.Spacing * static_cast<double>(at / (n[0] * n[1])) };
  }
  double Integral() const
  {
    double sum = 0.0;
    for (const float value : this->Values)
    {
      sum += static_cast<double>(value);
    }
    return sum * std::pow(this->Grid.Spacing, 3);
  }
};

enum class Form
{
  Union,
  Gaussians
};

Volume Make(const std::vector<Ball>& balls, Form form, double spacing,
  const std::array<double, 3>& padding = { 3.0, 3.0, 3.0 }, double decay = 2.3)
{
  Volume volume;
  volume.Grid = GridAroundBalls(balls, spacing, padding);
  const auto& n = volume.Grid.Dimensions;
  volume.Values.assign(static_cast<std::size_t>(n[0] * n[1] * n[2]), -1.0F);
  const GridView<float> view{ volume.Values.data(), n, { spacing, spacing, spacing } };
  if (form == Form::Union)
  {
    UnionOfBalls(balls, volume.Grid.Origin, view);
  }
  else
  {
    GaussianSum(balls, decay, volume.Grid.Origin, view);
  }
  return volume;
}

std::vector<Ball> RandomBalls(int count, double box)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0.0, box);
  std::uniform_real_distribution<double> radius(1.0, 2.0);
  std::vector<Ball> balls;
  for (int i = 0; i < count; ++i)
  {
    const double x = place(random);
    const double y = place(random);
    const double z = place(random);
    balls.push_back({ { x, y, z }, radius(random) });
  }
  return balls;
}

double SquaredDistance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
    (a[2] - b[2]) * (a[2] - b[2]);
}

}

TEST(MolecularDensity, VolumeOfOneBallConverges)
{
  // Balls at positions without symmetry on the grid: the error of counting nodes falls as h^1.5 or
  // faster.
  const std::vector<Ball> ball{ { { 0.123, 0.456, 0.789 }, 2.0 } };
  const double exact = 4.0 / 3.0 * Pi * 8.0;
  double worst = 1.0;
  for (const double h : { 0.4, 0.2, 0.1, 0.05 })
  {
    const double error =
      std::abs(Make(ball, Form::Union, h, { 0.31, 0.17, 0.23 }).Integral() / exact - 1.0);
    EXPECT_LT(error, 0.08 * std::pow(h / 0.4, 1.5)) << h;
    worst = error;
  }
  EXPECT_LT(worst, 1e-3);
}

TEST(MolecularDensity, VolumeOfTwoBallsLessTheirLens)
{
  const double r = 2.0;
  const double d = 2.5;
  const std::vector<Ball> balls{ { { 0.1, 0.2, 0.3 }, r }, { { 0.1 + d, 0.2, 0.3 }, r } };
  const double lens = Pi * (4.0 * r + d) * (2.0 * r - d) * (2.0 * r - d) / 12.0;
  const double exact = 2.0 * 4.0 / 3.0 * Pi * r * r * r - lens;
  // Paddings that place the centers between nodes; with centers on nodes, symmetric nodes would
  // change sides together.
  const double found = Make(balls, Form::Union, 0.05, { 0.31, 0.17, 0.23 }).Integral();
  EXPECT_NEAR(found / exact, 1.0, 1e-3);
}

TEST(MolecularDensity, IntegralOfGaussians)
{
  // The sum over a grid of a Gaussian equals its integral with an error far below the neglected
  // terms.
  for (const double decay : { 1.0, 2.3, 5.0 })
  {
    const std::vector<Ball> balls{ { { 0.1, 0.2, 0.3 }, 1.7 }, { { 2.0, 0.4, 0.1 }, 1.2 } };
    const double cubes = std::pow(1.7, 3) + std::pow(1.2, 3);
    const double exact = std::exp(decay) * std::pow(Pi / decay, 1.5) * cubes;
    const double found = Make(balls, Form::Gaussians, 0.25, { 8.0, 8.0, 8.0 }, decay).Integral();
    EXPECT_NEAR(found / exact, 1.0, 2e-5) << decay;
  }
}

TEST(MolecularDensity, EveryNodeIsTheSumOverAllBalls)
{
  const std::vector<Ball> balls = RandomBalls(300, 25.0);
  const Volume sum = Make(balls, Form::Gaussians, 0.7);
  const Volume inside = Make(balls, Form::Union, 0.7);
  ASSERT_GT(sum.Grid.Dimensions[1], 40); // several bricks
  std::size_t ones = 0;
  for (std::size_t node = 0; node < sum.Values.size(); node += 3)
  {
    const auto place = sum.Place(node);
    double expected = 0.0;
    bool in = false;
    bool near = false;
    for (const Ball& ball : balls)
    {
      const double q = SquaredDistance(place, ball.Center) / (ball.Radius * ball.Radius);
      expected += std::exp(-2.3 * (q - 1.0));
      in = in || q <= 1.0;
      near = near || std::abs(q - 1.0) < 1e-12;
    }
    // The bound: at most 300 neglected terms of 1e-6; actually about a dozen.
    ASSERT_NEAR(sum.Values[node], expected, 2e-5 + 1e-6 * expected) << node;
    ASSERT_TRUE(near || inside.Values[node] == (in ? 1.0F : 0.0F)) << node;
    ones += in ? 1 : 0;
    // The level 1 encloses every ball.
    ASSERT_TRUE(!in || sum.Values[node] > 1.0F - 1e-6F) << node;
  }
  EXPECT_GT(ones, 1000u);
}

TEST(MolecularDensity, LevelOneOfALoneAtomIsItsSphere)
{
  const std::vector<Ball> ball{ { { 0.0, 0.0, 0.0 }, 1.7 } };
  const Volume volume = Make(ball, Form::Gaussians, 0.1);
  for (std::size_t node = 0; node < volume.Values.size(); ++node)
  {
    const double r = std::sqrt(SquaredDistance(volume.Place(node), ball[0].Center));
    if (std::abs(r - 1.7) > 1e-5)
    {
      ASSERT_EQ(volume.Values[node] > 1.0F, r < 1.7) << r;
    }
  }
}

TEST(MolecularDensity, DoesNotDependOnOrderOrThreads)
{
  std::vector<Ball> balls = RandomBalls(2000, 40.0);
  for (const Form form : { Form::Union, Form::Gaussians })
  {
    const Volume first = Make(balls, form, 0.6);
    std::shuffle(balls.begin(), balls.end(), std::mt19937(3));
    EXPECT_EQ(Make(balls, form, 0.6).Values, first.Values);
    for (const int threads : { 1, 3 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
        [&] { EXPECT_EQ(Make(balls, form, 0.6).Values, first.Values); });
    }
  }
}

TEST(MolecularDensity, GridHoldsBallsAndPadding)
{
  const std::vector<Ball> balls{ { { 0.0, 0.0, 0.0 }, 1.0 }, { { 10.0, 0.0, -3.0 }, 2.0 } };
  const DensityGrid grid = GridAroundBalls(balls, 0.5, { 1.0, 2.0, 0.0 });
  EXPECT_EQ(grid.Origin, (std::array<double, 3>{ -2.0, -4.0, -5.0 }));
  EXPECT_EQ(grid.Dimensions, (std::array<std::int64_t, 3>{ 31, 17, 13 }));
  // Not a multiple of the spacing: rounded up.
  EXPECT_EQ(GridAroundBalls(balls, 0.7, { 0.0, 0.0, 0.0 }).Dimensions[0], 20);
  // At least two nodes along an axis, and no more if two suffice.
  for (const double radius : { 0.0, 0.1, 0.5 })
  {
    EXPECT_EQ(GridAroundBalls({ { { 1.0, 2.0, 3.0 }, radius } }, 1.0, { 0.0, 0.0, 0.0 }).Dimensions,
      (std::array<std::int64_t, 3>{ 2, 2, 2 }));
  }
}

TEST(MolecularDensity, AnyRadiusIsSafe)
{
  std::vector<Ball> balls{ { { 0.0, 0.0, 0.0 }, 1.5 }, { { 0.5, 0.0, 0.0 }, 0.0 } };
  const Volume volume = Make(balls, Form::Gaussians, 0.5);
  balls.pop_back();
  EXPECT_EQ(
    Make(balls, Form::Gaussians, 0.5).Values, volume.Values); // an atom of radius 0 has no effect
  for (const double tiny : { 1e-300, 1e-200, 1e-10 })
  {
    const Volume spike = Make({ { { 0.0, 0.0, 0.0 }, tiny } }, Form::Gaussians, 0.5);
    EXPECT_FALSE(std::any_of(
      spike.Values.begin(), spike.Values.end(), [](float value) { return std::isnan(value); }));
  }
  const double nan = std::nan("");
  EXPECT_THROW(Make({ { { 0.0, 0.0, 0.0 }, -1.0 } }, Form::Union, 0.5), std::invalid_argument);
  EXPECT_THROW(Make({ { { 0.0, nan, 0.0 }, 1.0 } }, Form::Union, 0.5), std::invalid_argument);
  EXPECT_THROW(Make({ { { 0.0, 0.0, 0.0 }, INFINITY } }, Form::Union, 0.5), std::invalid_argument);
}

TEST(MolecularDensity, FloatAndDoubleInputThroughVTK)
{
  const std::vector<Ball> balls{ { { 0.25, 0.5, 0.75 }, 1.5 }, { { 2.0, 0.5, 0.75 }, 1.25 } };
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    vtkNew<vtkMolecularDensity> filter;
    filter->SetInputData(MakeAtoms(balls, type));
    filter->SetPadding(1.0, 2.0, 3.0);
    filter->SetRadiusScale(1.2);
    filter->Update();
    std::vector<Ball> scaled = balls;
    for (Ball& ball : scaled)
    {
      ball.Radius *= 1.2;
    }
    const Volume expected = Make(scaled, Form::Gaussians, 0.5, { 1.0, 2.0, 3.0 });
    vtkImageData* image = filter->GetOutput();
    auto* density = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
    ASSERT_NE(density, nullptr);
    EXPECT_STREQ(density->GetName(), "Density");
    EXPECT_EQ(image->GetOrigin()[1], expected.Grid.Origin[1]);
    EXPECT_EQ(std::vector<float>(density->Begin(), density->End()), expected.Values);
    filter->SetForm(vtkMolecularDensity::UnionOfBalls);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetScalars()->GetRange()[1], 1.0);
  }
}

TEST(MolecularDensity, ReportsBadInput)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> pipeline;
  vtkNew<vtkMolecularDensity> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
  const auto saidOf = [&](vtkPolyData* atoms)
  {
    observer->Clear();
    filter->SetInputData(atoms);
    filter->Update();
    return observer->GetErrorMessage() + observer->GetWarningMessage();
  };
  const std::vector<Ball> sound{ { { 0.0, 0.0, 0.0 }, 1.5 }, { { 2.0, 0.0, 0.0 }, 1.5 } };
  EXPECT_EQ(saidOf(vtkNew<vtkPolyData>()), "");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  const auto noRadii = MakeAtoms(sound);
  noRadii->GetPointData()->RemoveArray("Radius");
  EXPECT_NE(
    saidOf(noRadii).find("no point array Radius of radii; they have: none"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  std::vector<Ball> bad = sound;
  bad[1].Center[2] = std::nan("");
  EXPECT_NE(saidOf(MakeAtoms(bad)).find("Atom 1 has a coordinate"), std::string::npos);
  bad = sound;
  bad[0].Radius = -1.0;
  EXPECT_NE(saidOf(MakeAtoms(bad)).find("The radius of atom 0 is -1"), std::string::npos);
  bad[0].Radius = 0.25; // arbitrarily small
  EXPECT_EQ(saidOf(MakeAtoms(bad)), "");
  bad[0].Radius = std::nan("");
  EXPECT_NE(saidOf(MakeAtoms(bad)).find("1 of 2 atoms have no radius"), std::string::npos);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  bad[1].Radius = std::nan("");
  EXPECT_NE(saidOf(MakeAtoms(bad)).find("2 of 2 atoms have no radius"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  const auto atoms = MakeAtoms(sound);
  EXPECT_EQ(saidOf(atoms), "");
  filter->SetSpacing(0.0);
  EXPECT_NE(saidOf(atoms).find("Spacing is 0"), std::string::npos);
  filter->SetSpacing(1e-12);
  EXPECT_NE(saidOf(atoms).find("more than 2^31 nodes"), std::string::npos);
  filter->SetSpacing(2e-5);
  EXPECT_NE(saidOf(atoms).find("choose a Spacing larger than 2e-05"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetSpacing(0.5);
  filter->SetDecay(0.0);
  EXPECT_NE(saidOf(atoms).find("Decay is 0"), std::string::npos);
  filter->SetDecay(1000.0);
  EXPECT_NE(saidOf(atoms).find("Decay is 1000"), std::string::npos);
  filter->SetDecay(2.3);
  filter->SetRadiusScale(-1.0);
  EXPECT_NE(saidOf(atoms).find("RadiusScale is -1"), std::string::npos);
  filter->SetRadiusScale(1.0);
  filter->SetPadding(0.0, -1.0, 0.0);
  EXPECT_NE(saidOf(atoms).find("Padding is -1"), std::string::npos);
  filter->SetPadding(3.0, 3.0, 3.0);
  EXPECT_EQ(saidOf(atoms), "");
}

TEST(MolecularDensity, ReportsProgressAndStops)
{
  vtkNew<vtkMolecularDensity> filter;
  filter->SetInputData(MakeAtoms(RandomBalls(20000, 60.0)));
  filter->SetSpacing(0.4);
  struct State
  {
    std::vector<double> Reported;
    bool Stop = false;
  } state;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&state);
  watch->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
      auto* seen = static_cast<State*>(data);
      seen->Reported.push_back(algorithm->GetProgress());
      algorithm->SetAbortExecute(seen->Stop ? 1 : 0);
    });
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 1000000);
  EXPECT_TRUE(std::is_sorted(state.Reported.begin(), state.Reported.end()));
  EXPECT_GT(state.Reported.size(), 3u);
  state.Stop = true;
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}
