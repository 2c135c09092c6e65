// Orders of convergence on the surface types of the thesis' Table 2.1.

#include "Curvature/SurfaceCurvature.h"
#include "SurfaceModels.h"
#include "TensorOptions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

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
Model MakeMesh(const Graph& graph, int n, double shake = 0.0)
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
Errors RecordErrors(const Graph& graph, const Model& mesh, const SurfaceCurvatureOptions& options,
  double margin = 0.0)
{
  const SurfaceCurvatureResult result = ComputeSurfaceCurvature(mesh.View(), options);
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

}

// As Tables 4.4 and 4.5, on every surface type of Table 2.1.
TEST(SurfaceCurvature, SecondOrderOnRegularMeshes)
{
  for (const Graph& graph : SurfaceTypes())
  {
    Errors last;
    for (const int n : { 16, 32, 64, 128 })
    {
      const Errors now = RecordErrors(graph, MakeMesh(graph, n), {});
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
      // A defect of a few rounding errors, divided by the area of a point.
      EXPECT_TRUE(!developable || now.Gaussian < 2e-15 * n * n) << graph.Name;
      EXPECT_TRUE(!flat || now.Mean < 1e-12) << graph.Name;
      last = now;
    }
  }
}

// The angle defect does not converge on irregular meshes; the tensor over a ball does, the fit of
// normals with second order in the radius.
TEST(SurfaceCurvature, PlateauOnIrregularMeshes)
{
  for (const Graph& graph : { SurfaceTypes()[1], SurfaceTypes()[5] })
  {
    Errors defect, ball, fit, firstDefect, firstBall, firstFit;
    for (const int n : { 32, 64, 128 })
    {
      const Model mesh = MakeMesh(graph, n, 0.2);
      const double radius = 0.6 / std::sqrt(static_cast<double>(n));
      defect = RecordErrors(graph, mesh, {}, 0.2);
      ball = RecordErrors(graph, mesh, Tensor(CurvatureNeighbourhood::Ball, radius), 0.2);
      fit = RecordErrors(graph, mesh, Fit(radius), 0.2);
      std::printf("%-13s n = %-3d angle defect K %.3e H %.3e; ball of %.2f h K %.3e H %.3e; fit K "
                  "%.3e H %.3e\n",
        graph.Name, n, defect.Gaussian, defect.Mean, radius * n, ball.Gaussian, ball.Mean,
        fit.Gaussian, fit.Mean);
      firstFit = n == 32 ? fit : firstFit;
      firstDefect = n == 32 ? defect : firstDefect;
      firstBall = n == 32 ? ball : firstBall;
    }
    EXPECT_GT(defect.Gaussian, 0.9 * firstDefect.Gaussian) << "is the mesh regular?";
    EXPECT_LT(ball.Gaussian, 0.75 * firstBall.Gaussian);
    EXPECT_LT(ball.Mean, 0.75 * firstBall.Mean);
    // The radius is halved.
    EXPECT_LT(fit.Gaussian, 0.35 * firstFit.Gaussian);
    EXPECT_LT(fit.Mean, 0.35 * firstFit.Mean);
  }
}
