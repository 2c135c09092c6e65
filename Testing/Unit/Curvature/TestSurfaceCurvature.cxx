#include "SurfaceCurvature.h"

#include "EdgeBends.h"
#include "SharedData.h"
#include "SurfaceModels.h"
#include "SurfacePatch.h"
#include "TriangleStars.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

using namespace isthmus::testing;
using namespace isthmus;

namespace
{

const double pi = 4.0 * std::atan(1.0);

/// Weighted with the points' areas, as the thesis' tables are.
struct Statistics
{
  double Mean = 0.0;
  double Deviation = 0.0;
};

Statistics StatisticsOf(const std::vector<double>& values, const std::vector<double>& areas)
{
  double area = 0.0, sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    area += areas[i];
    sum += areas[i] * values[i];
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    squares += (values[i] - sum / area) * (values[i] - sum / area);
  }
  return { sum / area, std::sqrt(squares / static_cast<double>(values.size())) };
}

/// A surface z(x, y) on [-1/2, 1/2]^2, seen from above.
struct Graph
{
  const char* Name;
  std::function<double(double, double)> Z, X, Y, XX, XY, YY; // height and its derivatives

  double Mean(double x, double y) const
  {
    const double a = X(x, y), b = Y(x, y), g = 1.0 + a * a + b * b;
    return -((1.0 + b * b) * XX(x, y) - 2.0 * a * b * XY(x, y) + (1.0 + a * a) * YY(x, y)) /
      (2.0 * g * std::sqrt(g));
  }
  double Gaussian(double x, double y) const
  {
    const double a = X(x, y), b = Y(x, y), g = 1.0 + a * a + b * b;
    return (XX(x, y) * YY(x, y) - XY(x, y) * XY(x, y)) / (g * g);
  }
};

Graph Paraboloid(const char* name, double p, double q)
{
  return { name, [=](double x, double y) { return p * x * x + q * y * y; },
    [=](double x, double) { return 2.0 * p * x; }, [=](double, double y) { return 2.0 * q * y; },
    [=](double, double) { return 2.0 * p; }, [](double, double) { return 0.0; },
    [=](double, double) { return 2.0 * q; } };
}

/// The surface types of Table 2.1, and a patch of the unit sphere.
std::vector<Graph> SurfaceTypes()
{
  const auto cap = [](double x, double y) { return std::sqrt(1.0 - x * x - y * y); };
  const Graph sphere{ "sphere patch", cap, [=](double x, double y) { return -x / cap(x, y); },
    [=](double x, double y) { return -y / cap(x, y); },
    [=](double x, double y) { return -(1.0 - y * y) / std::pow(cap(x, y), 3); },
    [=](double x, double y) { return -x * y / std::pow(cap(x, y), 3); },
    [=](double x, double y) { return -(1.0 - x * x) / std::pow(cap(x, y), 3); } };
  const Graph scherk{ "minimal surface",
    [](double x, double y) { return std::log(std::cos(y) / std::cos(x)); },
    [](double x, double) { return std::tan(x); }, [](double, double y) { return -std::tan(y); },
    [](double x, double) { return 1.0 / std::pow(std::cos(x), 2); },
    [](double, double) { return 0.0; },
    [](double, double y) { return -1.0 / std::pow(std::cos(y), 2); } };
  return { sphere, Paraboloid("peak", -1.0, -0.6), Paraboloid("pit", 1.0, 0.6),
    Paraboloid("ridge", -1.0, 0.0), Paraboloid("valley", 1.0, 0.0),
    Paraboloid("saddle ridge", -1.0, 0.4), Paraboloid("saddle valley", 1.0, -0.4), scherk,
    { "flat", [](double x, double y) { return 0.3 * x - 0.2 * y; },
      [](double, double) { return 0.3; }, [](double, double) { return -0.2; },
      [](double, double) { return 0.0; }, [](double, double) { return 0.0; },
      [](double, double) { return 0.0; } } };
}

/// Mesh of a graph with n x n squares; points move by up to `shake` of a square's side.
Model MeshOf(const Graph& graph, int n, double shake = 0.0)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> move(-shake / n, shake / n);
  return Sheet(n,
    [&](double u, double v)
    {
      const double x = u - 0.5 + (shake > 0.0 ? move(random) : 0.0);
      const double y = v - 0.5 + (shake > 0.0 ? move(random) : 0.0);
      return Vector{ x, y, graph.Z(x, y) };
    });
}

struct Errors
{
  double Gaussian = 0.0;
  double Mean = 0.0;
};

/// Root mean squares of the errors at valid points at least `margin` from the border.
Errors ErrorsOf(const Graph& graph, const Model& mesh, const SurfaceCurvatureOptions& options,
  double margin = 0.0)
{
  const SurfaceCurvatureResult result = CurvatureOfSurface(mesh.View(), options);
  Errors sums;
  double count = 0.0;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const double x = mesh.Points[i][0], y = mesh.Points[i][1];
    if (result.Valid[i] && std::max(std::abs(x), std::abs(y)) < 0.5 - margin)
    {
      sums.Gaussian += std::pow(result.Gaussian[i] - graph.Gaussian(x, y), 2);
      sums.Mean += std::pow(result.Mean[i] - graph.Mean(x, y), 2);
      ++count;
    }
  }
  EXPECT_GT(count, 0.0);
  return { std::sqrt(sums.Gaussian / count), std::sqrt(sums.Mean / count) };
}

SurfaceCurvatureOptions Tensor(CurvatureNeighbourhood neighbourhood, double radius = 0.0)
{
  SurfaceCurvatureOptions options;
  options.Estimate = CurvatureEstimate::EdgeTensor;
  options.Neighbourhood = neighbourhood;
  options.Radius = radius;
  return options;
}

/// Open cylinder about z of radius `r` and height 2, `around` x `along` squares.
Model Cylinder(double r, int around, int along)
{
  Model model;
  for (int j = 0; j <= along; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      const double u = 2.0 * pi * (i + 0.5 * (j % 2)) / around;
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

TEST(SurfaceCurvature, SphereStatisticsOfTables42And43)
{
  const struct
  {
    int Frequency;
    double RadiusSquared;
    double MeanK;
    double MeanH;
  } rows[] = { { 10, 1.0, 1.003239, 1.000031 }, { 14, 2.0, 0.500804, 0.707106 },
    { 17, 3.0, 0.333685, 0.577343 } };
  for (const auto& row : rows)
  {
    const Model sphere = Icosphere(row.Frequency, std::sqrt(row.RadiusSquared));
    double deviationK[2] = { 0.0, 0.0 };
    for (const DualArea rule : { DualArea::Voronoi, DualArea::Barycentric })
    {
      SurfaceCurvatureOptions options;
      options.Area = rule;
      const SurfaceCurvatureResult result = CurvatureOfSurface(sphere.View(), options);
      const Statistics k = StatisticsOf(result.Gaussian, result.Area);
      const Statistics h = StatisticsOf(result.Mean, result.Area);
      std::printf("r^2 = %g %-11s mean K %.6f (printed %.6f) sd %.6f, mean H %.6f (%.6f) sd %.6f\n",
        row.RadiusSquared, rule == DualArea::Voronoi ? "Voronoi" : "barycentric", k.Mean, row.MeanK,
        k.Deviation, h.Mean, row.MeanH, h.Deviation);
      EXPECT_NEAR(k.Mean, row.MeanK, 1e-3);
      EXPECT_NEAR(h.Mean, row.MeanH, 1e-3);
      deviationK[rule == DualArea::Voronoi ? 0 : 1] = k.Deviation;
    }
    EXPECT_LT(deviationK[0], deviationK[1]);
  }
  const SurfaceCurvatureResult unit = CurvatureOfSurface(Icosphere(10, 1.0).View(), {});
  EXPECT_NEAR(StatisticsOf(unit.Gaussian, unit.Area).Mean, 1.003081, 1e-6);
  EXPECT_NEAR(StatisticsOf(unit.Gaussian, unit.Area).Deviation, 0.000375, 1e-5);
}

// As Tables 4.4 and 4.5, on every surface type of Table 2.1.
TEST(SurfaceCurvature, SecondOrderOnRegularMeshes)
{
  for (const Graph& graph : SurfaceTypes())
  {
    Errors last;
    for (const int n : { 16, 32, 64, 128 })
    {
      const Errors now = ErrorsOf(graph, MeshOf(graph, n), {});
      const double orderK = std::log2(last.Gaussian / now.Gaussian);
      const double orderH = std::log2(last.Mean / now.Mean);
      std::printf("%-15s n = %-3d K %.3e (order %.2f) H %.3e (order %.2f)\n", graph.Name, n,
        now.Gaussian, orderK, now.Mean, orderH);
      const bool developable = graph.Gaussian(0.1, 0.2) == 0.0;
      const bool flat = developable && graph.Mean(0.1, 0.2) == 0.0;
      if (n > 32)
      {
        EXPECT_TRUE(developable || orderK > 1.9) << graph.Name;
        EXPECT_TRUE(flat || orderH > 1.9) << graph.Name;
      }
      // A defect of a few roundings, over the area of a point.
      EXPECT_TRUE(!developable || now.Gaussian < 2e-15 * n * n) << graph.Name;
      EXPECT_TRUE(!flat || now.Mean < 1e-12) << graph.Name;
      last = now;
    }
  }
}

// The angle defect does not converge on irregular meshes; the tensor over a ball does.
TEST(SurfaceCurvature, PlateauOnIrregularMeshes)
{
  for (const Graph& graph : { SurfaceTypes()[1], SurfaceTypes()[5] })
  {
    Errors defect, ball, firstDefect, firstBall;
    for (const int n : { 32, 64, 128 })
    {
      const Model mesh = MeshOf(graph, n, 0.2);
      const double radius = 0.6 / std::sqrt(static_cast<double>(n));
      defect = ErrorsOf(graph, mesh, {}, 0.2);
      ball = ErrorsOf(graph, mesh, Tensor(CurvatureNeighbourhood::Ball, radius), 0.2);
      std::printf("%-13s n = %-3d angle defect K %.3e H %.3e; ball of %.2f h K %.3e H %.3e\n",
        graph.Name, n, defect.Gaussian, defect.Mean, radius * n, ball.Gaussian, ball.Mean);
      firstDefect = n == 32 ? defect : firstDefect;
      firstBall = n == 32 ? ball : firstBall;
    }
    EXPECT_GT(defect.Gaussian, 0.9 * firstDefect.Gaussian) << "is the mesh regular?";
    EXPECT_LT(ball.Gaussian, 0.75 * firstBall.Gaussian);
    EXPECT_LT(ball.Mean, 0.75 * firstBall.Mean);
  }
}

TEST(SurfaceCurvature, TensorOnCylinder)
{
  const Model cylinder = Cylinder(1.0, 96, 40);
  for (const auto neighbourhood : { CurvatureNeighbourhood::OneRing, CurvatureNeighbourhood::Ball,
         CurvatureNeighbourhood::GeodesicDisc })
  {
    const auto result = CurvatureOfSurface(cylinder.View(), Tensor(neighbourhood, 0.3));
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
    const EdgeBends bends(mesh.View(), stars);
    SurfacePatch patch(mesh.View(), stars, bends, radius);
    const double ball = patch.OverBall(point).Area;
    return std::array<double, 2>{ ball, patch.OverDisc(point).Area };
  };
  for (const double radius : { 0.11, 0.21, 0.35 })
  {
    const auto flat = areasOf(plane, radius, 20 * 41 + 20);
    EXPECT_NEAR(flat[0] / (pi * radius * radius), 1.0, 1e-12) << radius;
    EXPECT_NEAR(flat[1] / (pi * radius * radius), 1.0, 0.02) << radius;
    for (const vtkIdType point : { 0, 12, 500 })
    {
      const auto curved = areasOf(sphere, radius, point);
      EXPECT_NEAR(curved[0] / (pi * radius * radius), 1.0, 0.02) << radius << " at " << point;
    }
  }
  // The disc's border is a chord in each triangle: its error falls as the square of the edges.
  const double cap = 2.0 * pi * (1.0 - std::cos(0.35));
  const double coarse = std::abs(areasOf(sphere, 0.35, 0)[1] / cap - 1.0);
  const double fine = std::abs(areasOf(Icosphere(28, 1.0), 0.35, 0)[1] / cap - 1.0);
  std::printf(
    "disc of 0.35 on the sphere: area off by %.4f, with half the edges %.4f\n", coarse, fine);
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(fine, coarse / 2.5);
  for (const auto neighbourhood :
    { CurvatureNeighbourhood::Ball, CurvatureNeighbourhood::GeodesicDisc })
  {
    const auto onPlane = CurvatureOfSurface(plane.View(), Tensor(neighbourhood, 0.21));
    EXPECT_NEAR(onPlane.Mean[20 * 41 + 20], 0.0, 1e-14);
    const auto result = CurvatureOfSurface(sphere.View(), Tensor(neighbourhood, 0.35));
    for (std::size_t i = 0; i < sphere.Points.size(); ++i)
    {
      EXPECT_NEAR(result.Mean[i], 1.0, 0.05);
      EXPECT_NEAR(result.Gaussian[i], 1.0, 0.1);
    }
  }
}

TEST(SurfaceCurvature, AreasArePartitionsAndDefectsSumToTheEulerNumber)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/fertility.off");
  const Model mesh = ReadOFF((SharedDataFolder() / "surfaces/fertility.off").string());
  double areas[3] = { 0, 0, 0 };
  for (const DualArea rule : { DualArea::Voronoi, DualArea::Barycentric, DualArea::Mixed })
  {
    SurfaceCurvatureOptions options;
    options.Area = rule;
    const auto result = CurvatureOfSurface(mesh.View(), options);
    double total = 0.0;
    for (std::size_t i = 0; i < result.Area.size(); ++i)
    {
      total += result.Gaussian[i] * result.Area[i];
      areas[static_cast<int>(rule)] += result.Area[i];
    }
    if (rule != DualArea::Voronoi)
    {
      EXPECT_EQ(result.AreaNotPositive, 0);
      EXPECT_NEAR(total, 2.0 * pi * -6.0, 1e-9) << "Gauss and Bonnet, genus 4";
    }
  }
  EXPECT_NEAR(areas[1] / areas[0], 1.0, 1e-12);
  EXPECT_NEAR(areas[2] / areas[0], 1.0, 1e-12);
}

TEST(SurfaceCurvature, OrientationDecidesTheSign)
{
  Model sphere = Icosphere(6, 2.0);
  Model cap = Sheet(6,
    [](double u, double v) {
      return Vector{ u, v, std::sqrt(4.0 - u * u - v * v) };
    });
  for (const auto estimate : { CurvatureEstimate::AngleDefect, CurvatureEstimate::EdgeTensor })
  {
    SurfaceCurvatureOptions options;
    options.Estimate = estimate;
    const auto outward = CurvatureOfSurface(sphere.View(), options);
    EXPECT_NEAR(outward.Mean[0], 0.5, 0.05);
    TurnInsideOut(sphere);
    const auto inward = CurvatureOfSurface(sphere.View(), options);
    EXPECT_NEAR(inward.Mean[0], outward.Mean[0], 1e-12);
    options.Orientation = SurfaceOrientation::AsWound;
    EXPECT_NEAR(CurvatureOfSurface(sphere.View(), options).Mean[0], -outward.Mean[0], 1e-12);
    options.Orientation = SurfaceOrientation::Reversed;
    EXPECT_NEAR(CurvatureOfSurface(sphere.View(), options).Mean[0], outward.Mean[0], 1e-12);
    TurnInsideOut(sphere);

    options.Orientation = SurfaceOrientation::Automatic; // open: as wound
    EXPECT_GT(CurvatureOfSurface(cap.View(), options).Mean[24], 0.4);
    TurnInsideOut(cap);
    EXPECT_LT(CurvatureOfSurface(cap.View(), options).Mean[24], -0.4);
    TurnInsideOut(cap);
  }
}

TEST(SurfaceCurvature, InvariantUnderMotionScaleAndOrder)
{
  const Model torus = Torus(48, 24, 2.0, 0.7);
  const double c = std::cos(0.7), s = std::sin(0.7), scale = 3.0;
  Model moved = torus;
  for (Vector& p : moved.Points)
  {
    p = { 100.0 + scale * (c * p[0] - s * p[2]), scale * p[1] - 50.0,
      scale * (s * p[0] + c * p[2]) };
  }
  std::reverse(moved.Triangles.begin(), moved.Triangles.end());
  for (const auto& options : { SurfaceCurvatureOptions{}, Tensor(CurvatureNeighbourhood::Ball) })
  {
    const auto a = CurvatureOfSurface(torus.View(), options);
    const auto b = CurvatureOfSurface(moved.View(), options);
    for (std::size_t i = 0; i < torus.Points.size(); ++i)
    {
      EXPECT_NEAR(a.Mean[i], scale * b.Mean[i], 1e-10);
      EXPECT_NEAR(a.Gaussian[i], scale * scale * b.Gaussian[i], 1e-9);
    }
  }
}

TEST(SurfaceCurvature, WhatHasNoCurvatureIsMarked)
{
  Model model = Icosphere(4, 1.0);
  model.AddPoint(9, 9, 9);
  const vtkIdType extra = model.AddPoint(3, 0, 0);
  model.Triangles.push_back({ model.Triangles[0][0], model.Triangles[0][1], extra });
  const vtkIdType thin = model.AddPoint(5, 0, 0);
  model.AddPoint(6, 0, 0);
  model.AddPoint(7, 0, 0);
  model.Triangles.push_back({ thin, thin + 1, thin + 2 });
  for (const auto& options : { SurfaceCurvatureOptions{}, Tensor(CurvatureNeighbourhood::Ball, 0.4),
         Tensor(CurvatureNeighbourhood::GeodesicDisc, 0.4) })
  {
    const auto result = CurvatureOfSurface(model.View(), options);
    EXPECT_EQ(result.IrregularPoints, 2);
    EXPECT_GE(
      result.DegeneratePoints, 3 - (options.Estimate == CurvatureEstimate::AngleDefect) * 3);
    for (const vtkIdType point : { extra - 1, thin, model.Triangles[0][0] })
    {
      EXPECT_EQ(result.Valid[static_cast<std::size_t>(point)], 0);
      EXPECT_EQ(result.Mean[static_cast<std::size_t>(point)], 0.0);
    }
    for (std::size_t i = 0; i < result.Mean.size(); ++i)
    {
      EXPECT_TRUE(std::isfinite(result.Mean[i]) && std::isfinite(result.Gaussian[i]));
    }
  }
  EXPECT_THROW(CurvatureOfSurface(model.View(), Tensor(CurvatureNeighbourhood::Ball, -1.0)),
    std::invalid_argument);
  EXPECT_TRUE(CurvatureOfSurface(Model{}.View(), {}).Mean.empty());
  EXPECT_THROW(CurvatureOfSurface(model.View(), {}, [](double) { return false; }), Cancelled);
}
