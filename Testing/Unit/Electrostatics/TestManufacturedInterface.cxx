// Manufactured solutions on a torus, a sum of fourteen Gaussians and a surface by
// curvature flow: the errors fall by the square of the spacing.

#include "ManufacturedInterface.h"
#include "MolecularSurfaces/SurfaceFlow.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr double Half = 8.0;

/// Moved along all three axes.
Point3 Along(const Point3& x, double by)
{
  return { x[0] + by, x[1] + by, x[2] + by };
}

Manufactured Translate(Manufactured m, double by)
{
  m.A.Source = Along(m.A.Source, by);
  m.B.Source = Along(m.B.Source, by);
  return m;
}

struct SampledLevel
{
  std::vector<double> Values;
  LevelFunction Level;

  /// f, moved by `shift` spacings along each axis, on nodes of [0, 2 Half]^3; below 0 inside.
  template <typename F>
  SampledLevel(double h, double shift, F&& f)
  {
    const auto n = static_cast<std::int64_t>(std::llround(2.0 * Half / h)) + 1;
    for (std::int64_t node = 0; node < n * n * n; ++node)
    {
      this->Values.push_back(
        f(Along({ h * static_cast<double>(node % n), h * static_cast<double>(node / n % n),
                  h * static_cast<double>(node / (n * n)) },
          -shift * h)));
    }
    this->Level.Doubles = { this->Values.data(), { n, n, n }, { h, h, h } };
    this->Level.InsideIsHigher = false;
  }
};

/// Of y over x.
template <std::size_t N>
double Slope(const std::array<double, N>& x, const std::array<double, N>& y)
{
  double mx = 0.0, my = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < N; ++i)
  {
    mx += x[i] / N;
    my += y[i] / N;
  }
  for (std::size_t i = 0; i < N; ++i)
  {
    xx += (x[i] - mx) * (x[i] - mx);
    xy += (x[i] - mx) * (y[i] - my);
  }
  return xy / xx;
}

/// Errors at five spacings, on average over three places of the surface between the nodes (`shift`,
/// in spacings). Requires orders, slopes of their logarithms, of 1.8 for the mean square, and of
/// 1.7 for the largest, which depend on the worst of some thousand crossings. The number of
/// iterations, 8 to 13, does not grow with that of nodes.
void ExpectSecondOrder(
  const char* name, const std::function<ManufacturedErrors(double h, double shift)>& solve)
{
  constexpr std::size_t count = 5;
  std::array<double, count> x, outside, inside, mean;
  double h = 0.5;
  for (std::size_t i = 0; i < count; ++i, h *= 0.75)
  {
    x[i] = std::log(h);
    outside[i] = inside[i] = mean[i] = 0.0;
    for (const double shift : { 0.0, 0.29, 0.61 })
    {
      const ManufacturedErrors e = solve(h, shift);
      outside[i] += e.Outside / 3.0;
      inside[i] += e.Inside / 3.0;
      mean[i] += e.RootMeanSquare / 3.0;
      EXPECT_LE(e.Iterations, 15); // rounding decides on one or two
      EXPECT_EQ(e.Fallbacks, 0);
    }
    std::printf(
      "%s h=%.4f: outside %.2e inside %.2e mean %.2e\n", name, h, outside[i], inside[i], mean[i]);
    outside[i] = std::log(outside[i]);
    inside[i] = std::log(inside[i]);
    mean[i] = std::log(mean[i]);
  }
  std::printf("%s: orders %.2f outside, %.2f inside, %.2f mean\n", name, Slope(x, outside),
    Slope(x, inside), Slope(x, mean));
  EXPECT_GE(Slope(x, mean), 1.8);
  EXPECT_GE(Slope(x, outside), 1.7);
  EXPECT_GE(Slope(x, inside), 1.7);
}

const Point3 Middle{ Half + 0.11, Half - 0.07, Half + 0.05 };

/// A torus about the z axis through the middle.
struct Torus
{
  double Ring = 4.0, Tube = 1.7;

  double operator()(const Point3& x) const
  {
    const double r = std::hypot(x[0] - Middle[0], x[1] - Middle[1]);
    return std::hypot(r - this->Ring, x[2] - Middle[2]) - this->Tube;
  }
  SurfaceFrame Frame(const Point3& x) const
  {
    const Eigen::Vector3d y(x[0] - Middle[0], x[1] - Middle[1], x[2] - Middle[2]);
    const double r = std::hypot(y[0], y[1]);
    const double d = std::hypot(r - this->Ring, y[2]);
    const Eigen::Vector3d out(y[0] / r, y[1] / r, 0.0), up(0.0, 0.0, 1.0);
    const Eigen::Vector3d n = ((r - this->Ring) * out + y[2] * up) / d;
    const Eigen::Vector3d round(-y[1] / r, y[0] / r, 0.0);
    const Eigen::Vector3d tube = n.cross(round);
    const Eigen::Matrix3d w =
      tube * tube.transpose() / d + round * round.transpose() * (r - this->Ring) / (d * r);
    return { { n[0], n[1], n[2] }, { w(0, 0), w(1, 1), w(2, 2), w(0, 1), w(0, 2), w(1, 2) } };
  }
};

/// -log of a sum of Gaussians, with its derivatives.
struct Gaussians
{
  std::vector<Ball> Balls;
  double Decay = 1.2;

  double operator()(const Point3& x) const
  {
    double sum = 0.0;
    for (const Ball& b : this->Balls)
    {
      sum += this->Term(b, x);
    }
    return -std::log(sum);
  }
  double Term(const Ball& b, const Point3& x) const
  {
    const double r2 = std::pow(x[0] - b.Center[0], 2) + std::pow(x[1] - b.Center[1], 2) +
      std::pow(x[2] - b.Center[2], 2);
    return std::exp(-this->Decay * (r2 / (b.Radius * b.Radius) - 1.0));
  }
  SurfaceFrame Frame(const Point3& x) const
  {
    double sum = 0.0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (const Ball& b : this->Balls)
    {
      const double t = this->Term(b, x);
      const double k = 2.0 * this->Decay / (b.Radius * b.Radius);
      const Eigen::Vector3d y(x[0] - b.Center[0], x[1] - b.Center[1], x[2] - b.Center[2]);
      sum += t;
      first -= t * k * y;
      second += t * (k * k * y * y.transpose() - k * Eigen::Matrix3d::Identity());
    }
    // Of -log(sum).
    const Eigen::Vector3d g = -first / sum;
    const Eigen::Matrix3d h = g * g.transpose() - second / sum;
    const Eigen::Vector3d n = g.normalized();
    const Eigen::Matrix3d p = Eigen::Matrix3d::Identity() - n * n.transpose();
    const Eigen::Matrix3d w = p * h * p / g.norm();
    return { { n[0], n[1], n[2] }, { w(0, 0), w(1, 1), w(2, 2), w(0, 1), w(0, 2), w(1, 2) } };
  }
};

/// A chain of fourteen atoms about the middle.
std::vector<Ball> FourteenAtoms()
{
  std::mt19937 random(14);
  std::uniform_real_distribution<double> step(-1.0, 1.0), radius(1.2, 1.9);
  std::vector<Ball> balls;
  Point3 x{ Half - 1.0, Half, Half };
  while (balls.size() < 14)
  {
    balls.push_back({ { x[0], x[1], x[2] }, radius(random) });
    Point3 next;
    do
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        next[a] = x[a] + 1.5 * step(random);
      }
    } while (std::hypot(next[0] - Half, next[1] - Half, next[2] - Half) > 3.0);
    x = next;
  }
  return balls;
}

TEST(ManufacturedInterface, Torus)
{
  const Torus torus;
  // A harmonic outside has its source in the tube; inside, beyond the box.
  const Manufactured m{ { { -6.0, 3.0, 20.0 }, 30.0 },
    { { Middle[0] + 4.0, Middle[1], Middle[2] }, 6.0 } };
  ExpectSecondOrder("torus",
    [&](double h, double shift)
    {
      const SampledLevel sampled(h, shift, torus);
      return SolveManufactured(Translate(m, shift * h), sampled.Level,
        [&](const InterfaceCrossing&, const Point3& x)
        { return torus.Frame(Along(x, -shift * h)); });
    });
}

TEST(ManufacturedInterface, FourteenGaussians)
{
  const Gaussians gaussians{ FourteenAtoms() };
  const auto& c = gaussians.Balls[6].Center;
  const Manufactured m{ { { -6.0, 3.0, 20.0 }, 30.0 }, { { c[0], c[1], c[2] }, 6.0 } };
  ExpectSecondOrder("fourteen Gaussians",
    [&](double h, double shift)
    {
      const SampledLevel sampled(h, shift, gaussians);
      return SolveManufactured(Translate(m, shift * h), sampled.Level,
        [&](const InterfaceCrossing&, const Point3& x)
        { return gaussians.Frame(Along(x, -shift * h)); });
    });
}

TEST(ManufacturedInterface, FlowSurface)
{
  const std::vector<Ball> balls = FourteenAtoms();
  ExpectSecondOrder("flow surface",
    [&](double h, double shift)
    {
      SurfaceFlowParameters parameters;
      parameters.Spacing = h;
      parameters.Padding = 4.0 + shift * h;
      // At a time before it touches the atoms, where its curvature would jump.
      parameters.Enlargement = 2.0;
      parameters.EvolutionTime = 1.0;
      const SurfaceFlowResult flow = SurfaceFlow(balls, parameters);
      LevelFunction level;
      level.Floats = { flow.Distance.data(), flow.Grid.Dimensions, { h, h, h } };
      level.InsideIsHigher = false;
      const auto& o = flow.Grid.Origin;
      const auto& c = balls[6].Center;
      const Manufactured m{ { { -6.0 - o[0], 3.0 - o[1], 20.0 - o[2] }, 30.0 },
        { { c[0] - o[0], c[1] - o[1], c[2] - o[2] }, 6.0 } };
      return SolveManufactured(
        m, level, [](const InterfaceCrossing& c2, const Point3&) { return c2.Frame; });
    });
}

}
