// The edge tensor over one ring, balls and geodesic discs.

#include "Core/Geometry.h"
#include "Curvature/EdgeTensor.h"
#include "Curvature/SurfaceCurvature.h"
#include "SurfaceModels.h"
#include "Surfaces/TriangleStars.h"
#include "TensorOptions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Open cylinder about z of radius `r` and height 2, `around` x `along` squares.
Model Cylinder(double r, int around, int along)
{
  Model model;
  for (int j = 0; j <= along; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      const double u = 2.0 * Pi * (i + 0.5 * (j % 2)) / around;
      model.AddPoint(r * std::cos(u), r * std::sin(u), 2.0 * j / along);
    }
  }
  for (int j = 0; j < along; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      const vtkIdType a = j * around + i, b = j * around + (i + 1) % around;
      const vtkIdType c = a + around, d = b + around;
      if (j % 2 == 0)
      {
        model.Triangles.insert(model.Triangles.end(), { { a, b, c }, { b, d, c } });
      }
      else
      {
        model.Triangles.insert(model.Triangles.end(), { { a, b, d }, { a, d, c } });
      }
    }
  }
  return model;
}

}

TEST(SurfaceCurvature, TensorOnCylinder)
{
  const Model cylinder = Cylinder(1.0, 96, 40);
  for (const auto neighbourhood : { CurvatureNeighbourhood::OneRing, CurvatureNeighbourhood::Ball,
         CurvatureNeighbourhood::GeodesicDisc })
  {
    const auto result = ComputeSurfaceCurvature(cylinder.View(), Tensor(neighbourhood, 0.3));
    const bool oneRing = neighbourhood == CurvatureNeighbourhood::OneRing;
    EXPECT_EQ(result.BoundaryPoints, 2 * 96);
    double worst[2] = { 0.0, 0.0 }; // inside, near the boundary
    for (std::size_t i = 0; i < cylinder.Points.size(); ++i)
    {
      const Vector& p = cylinder.Points[i];
      const bool border = p[2] < 1e-9 || p[2] > 2.0 - 1e-9;
      ASSERT_EQ(result.Valid[i], !(border && oneRing));
      if (result.Valid[i])
      {
        const bool near = std::abs(p[2] - 1.0) > 0.7;
        worst[near] =
          std::max({ worst[near], std::abs(result.Mean[i] - 0.5), std::abs(result.Gaussian[i]) });
        const double* direction = result.Direction1.data() + 3 * i;
        EXPECT_NEAR(std::abs(direction[1] * p[0] - direction[0] * p[1]), 1.0, 0.03) << "around";
        EXPECT_NEAR(std::abs(result.Direction2[3 * i + 2]), 1.0, 0.03) << "along";
      }
    }
    std::printf("neighbourhood %d: largest error inside %.4f, near the boundary %.4f\n",
      static_cast<int>(neighbourhood), worst[0], worst[1]);
    EXPECT_LT(worst[0], oneRing ? 2e-3 : 0.08);
    EXPECT_LT(worst[1], 0.1);
  }
}

TEST(SurfaceCurvature, BallAndDiscHaveTheirAreas)
{
  // On a plane both are circles. On a sphere of radius 1, the ball cuts out a cap of area pi r^2
  // (Archimedes), the geodesic disc one of 2 pi (1 - cos r).
  const Model plane = Sheet(40, [](double u, double v) { return Vector{ u, v, 0.0 }; });
  const Model sphere = Icosphere(14, 1.0);
  const auto areasOf = [](const Model& mesh, double radius, vtkIdType point)
  {
    const TriangleStars stars(mesh.View());
    const DihedralAngles dihedrals(mesh.View(), stars);
    EdgeTensorIntegrator patch(mesh.View(), stars, dihedrals, radius);
    const double ball = patch.IntegrateOverBall(point).Area;
    return std::array<double, 2>{ ball, patch.IntegrateOverDisc(point).Area };
  };
  for (const double radius : { 0.11, 0.21, 0.35 })
  {
    const auto flat = areasOf(plane, radius, 20 * 41 + 20);
    EXPECT_NEAR(flat[0] / (Pi * radius * radius), 1.0, 1e-12) << radius;
    EXPECT_NEAR(flat[1] / (Pi * radius * radius), 1.0, 0.02) << radius;
    for (const vtkIdType point : { 0, 12, 500 })
    {
      const auto curved = areasOf(sphere, radius, point);
      EXPECT_NEAR(curved[0] / (Pi * radius * radius), 1.0, 0.02) << radius << " at " << point;
    }
  }
  // The disc's border is a chord in each triangle: its error falls as the square of the edges.
  const double cap = 2.0 * Pi * (1.0 - std::cos(0.35));
  const double coarse = std::abs(areasOf(sphere, 0.35, 0)[1] / cap - 1.0);
  const double fine = std::abs(areasOf(Icosphere(28, 1.0), 0.35, 0)[1] / cap - 1.0);
  std::printf(
    "disc of 0.35 on the sphere: area off by %.4f, with half the edges %.4f\n", coarse, fine);
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(fine, coarse / 2.5);
  for (const auto neighbourhood :
    { CurvatureNeighbourhood::Ball, CurvatureNeighbourhood::GeodesicDisc })
  {
    const auto onPlane = ComputeSurfaceCurvature(plane.View(), Tensor(neighbourhood, 0.21));
    EXPECT_NEAR(onPlane.Mean[20 * 41 + 20], 0.0, 1e-14);
    const auto result = ComputeSurfaceCurvature(sphere.View(), Tensor(neighbourhood, 0.35));
    for (std::size_t i = 0; i < sphere.Points.size(); ++i)
    {
      EXPECT_NEAR(result.Mean[i], 1.0, 0.05);
      EXPECT_NEAR(result.Gaussian[i], 1.0, 0.1);
    }
  }
}
