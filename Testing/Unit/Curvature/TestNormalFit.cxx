// The least-squares fit of normals: large radii, noise, borders, and what cannot be fitted.

#include "Core/Geometry.h"
#include "Curvature/SurfaceCurvature.h"
#include "SurfaceModels.h"
#include "TensorOptions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

// The edge tensor becomes smaller as the ball leaves the tangent plane; the fit does not.
TEST(NormalFit, SphereHasItsCurvatureAtAnyRadius)
{
  const Model sphere = Icosphere(14, 2.0);
  for (const double radius : { 0.5, 1.0, 2.0 })
  {
    const auto fit = ComputeSurfaceCurvature(sphere.View(), Fit(radius));
    const auto tensor =
      ComputeSurfaceCurvature(sphere.View(), Tensor(CurvatureNeighbourhood::Ball, radius));
    double worst = 0.0, worstTensor = 0.0;
    for (std::size_t i = 0; i < sphere.Points.size(); ++i)
    {
      for (const double sign : { 1.0, -1.0 })
      {
        worst = std::max(worst, std::abs(fit.Mean[i] + sign * fit.HalfDifference[i] - 0.5));
        worstTensor =
          std::max(worstTensor, std::abs(tensor.Mean[i] + sign * tensor.HalfDifference[i] - 0.5));
      }
    }
    std::printf("radius %.1f: largest error of the fit %.5f, of the tensor %.5f\n", radius, worst,
      worstTensor);
    EXPECT_LT(worst, 0.01);
    EXPECT_LT(worst, 0.4 * worstTensor);
  }
}

// Directions and signs, at the borders as well: a saddle, whose axes are turned by 30 degrees.
TEST(NormalFit, DirectionsOfASaddle)
{
  const double c = std::cos(Pi / 6.0), s = std::sin(Pi / 6.0);
  const Model saddle = Sheet(40,
    [&](double u, double v)
    {
      const double x = u - 0.5, y = v - 0.5;
      const double along = c * x + s * y, across = c * y - s * x;
      return Vector{ x, y, 0.5 * across * across - along * along };
    });
  const auto result = ComputeSurfaceCurvature(saddle.View(), Fit(0.1));
  EXPECT_EQ(std::count(result.Valid.begin(), result.Valid.end(), 1), 41 * 41);
  const std::size_t middle = 20 * 41 + 20;
  EXPECT_NEAR(result.Mean[middle] + result.HalfDifference[middle], 2.0, 0.03) << "bends down";
  EXPECT_NEAR(result.Mean[middle] - result.HalfDifference[middle], -1.0, 0.03);
  const auto direction = [&](const std::vector<double>& vectors)
  { return vectors.data() + 3 * middle; };
  EXPECT_NEAR(
    std::abs(direction(result.Direction1)[0] * c + direction(result.Direction1)[1] * s), 1.0, 1e-3);
  EXPECT_NEAR(
    std::abs(direction(result.Direction2)[1] * c - direction(result.Direction2)[0] * s), 1.0, 1e-3);
  double border = 0.0;
  for (std::size_t i = 0; i < saddle.Points.size(); ++i)
  {
    const Vector& p = saddle.Points[i];
    if (std::abs(p[0]) > 0.49 && std::abs(p[1]) < 0.01)
    {
      const double steep =
        1.0 + std::pow(2.0 * c * c * p[0] - s * s * p[0], 2) + std::pow(3.0 * c * s * p[0], 2);
      border = std::max(border, std::abs(result.Gaussian[i] * steep * steep / -2.0 - 1.0));
    }
  }
  std::printf("largest relative error of K at two borders: %.3f\n", border);
  EXPECT_GT(border, 0.0);
  EXPECT_LT(border, 0.05);
}

// A wider ball averages noise of the points out.
TEST(NormalFit, NoiseAveragesOut)
{
  Model sphere = Icosphere(20, 1.0);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.005);
  for (Vector& p : sphere.Points)
  {
    const double scale = 1.0 + noise(random);
    p = { scale * p[0], scale * p[1], scale * p[2] };
  }
  double last = 1e9;
  for (const double radius : { 0.2, 0.4, 0.8 })
  {
    const auto result = ComputeSurfaceCurvature(sphere.View(), Fit(radius));
    double squares = 0.0;
    for (const double mean : result.Mean)
    {
      squares += std::pow(mean - 1.0, 2);
    }
    const double error = std::sqrt(squares / static_cast<double>(result.Mean.size()));
    std::printf("radius %.1f: rms error of H %.4f\n", radius, error);
    EXPECT_LT(error, 0.5 * last);
    last = error;
  }
  EXPECT_LT(last, 0.02);
}

// Two sheets closer than the radius: only the sheet of the point counts.
TEST(NormalFit, OtherSheetsDoNotCount)
{
  Model two = Icosphere(8, 1.0);
  Append(two, Icosphere(8, 1.05), { 0.0, 0.0, 0.0 });
  SurfaceCurvatureOptions options = Fit(0.3);
  options.Orientation = SurfaceOrientation::AsWound;
  const auto both = ComputeSurfaceCurvature(two.View(), options);
  const auto inner = ComputeSurfaceCurvature(Icosphere(8, 1.0).View(), options);
  for (std::size_t i = 0; i < inner.Mean.size(); ++i)
  {
    EXPECT_EQ(both.Mean[i], inner.Mean[i]);
  }
}

// Triangles without area are passed over; points on a line, and a star whose normals cancel, have
// no fit.
TEST(NormalFit, DegenerateStars)
{
  Model sphere = Icosphere(6, 1.0);
  const Triangle split = sphere.Triangles[0];
  const Vector a = sphere.Points[static_cast<std::size_t>(split[0])];
  const Vector b = sphere.Points[static_cast<std::size_t>(split[1])];
  // A point in the middle of an edge of one triangle only: the other side gets a sliver.
  const vtkIdType middle =
    sphere.AddPoint(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]));
  sphere.Triangles[0] = { split[0], middle, split[2] };
  sphere.Triangles.push_back({ middle, split[1], split[2] });
  sphere.Triangles.push_back({ split[0], split[1], middle });
  const auto result = ComputeSurfaceCurvature(sphere.View(), Fit(0.5));
  EXPECT_EQ(result.DegeneratePoints, 0);
  for (std::size_t i = 0; i < result.Mean.size(); ++i)
  {
    EXPECT_NEAR(result.Mean[i], 1.0, 0.05);
  }
  Model folded; // two triangles back to back
  folded.AddPoint(0, 0, 0);
  folded.AddPoint(1, 0, 0);
  folded.AddPoint(0, 1, 0);
  folded.Triangles = { { 0, 1, 2 }, { 0, 2, 1 } };
  EXPECT_EQ(ComputeSurfaceCurvature(folded.View(), Fit()).DegeneratePoints, 3);
}
