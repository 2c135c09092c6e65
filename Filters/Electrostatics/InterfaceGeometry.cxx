#include "Electrostatics/InterfaceGeometry.h"

#include "Core/ParallelFor.h"
#include "Electrostatics/LocalPolynomial.h"

#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

// Fourth order, above the second that the solver needs: with linear crossings and normals (thesis
// 5.21 to 5.23) errors of the potential are 20 times as large.
constexpr double Central1[5] = { 1.0 / 12, -8.0 / 12, 0.0, 8.0 / 12, -1.0 / 12 };
constexpr double Central2[5] = { -1.0 / 12, 16.0 / 12, -30.0 / 12, 16.0 / 12, -1.0 / 12 };

/// The 6 x 5 x 5 samples around an edge: along it first.
struct Samples
{
  double At[Reach][5][5];
};

struct Line
{
  std::array<std::int64_t, 3> Node;
  int Axis;
};

void Gather(const LevelFunction& level, const SolverBox& box, const Line& line, Samples& samples)
{
  const auto a = static_cast<std::size_t>(line.Axis);
  const std::size_t b = (a + 1) % 3;
  const std::size_t c = (a + 2) % 3;
  for (int i = 0; i < Reach; ++i)
  {
    for (int j = 0; j < 5; ++j)
    {
      for (int k = 0; k < 5; ++k)
      {
        auto p = line.Node;
        p[a] += i - Before;
        p[b] += j - 2;
        p[c] += k - 2;
        samples.At[i][j][k] = Sample(level, box, p);
      }
    }
  }
}

/// Root of the sixth-order polynomial between the ends, which lie on two sides; linear where the
/// samples are not smooth.
double RootOnEdge(const LevelFunction& level, const SolverBox& box, const Line& line)
{
  double values[Reach];
  const auto a = static_cast<std::size_t>(line.Axis);
  for (int i = 0; i < Reach; ++i)
  {
    auto p = line.Node;
    p[a] += i - Before;
    values[i] = Sample(level, box, p);
  }
  const double first = values[Before];
  const double last = values[Before + 1];
  double low = 0.0, high = 1.0;
  double t = first / (first - last);
  for (int step = 0; step < 60 && high - low > 1e-14; ++step)
  {
    const LineWeights w = WeightsAt(t);
    double f = 0.0, d = 0.0;
    for (int i = 0; i < Reach; ++i)
    {
      f += w.Value[i] * values[i];
      d += w.First[i] * values[i];
    }
    // Newton's method, held in the bracket by bisection.
    ((f < 0.0) == (first < 0.0) ? low : high) = t;
    const double newton = t - f / d;
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - t) < 1e-13)
    {
      t = next;
      break;
    }
    t = next;
  }
  return std::isfinite(t) ? std::min(std::max(t, 0.0), 1.0) : 0.5;
}

/// Gradient and second derivatives from samples and weights along the line; with weights along
/// the line only, the point has to lie on the line.
void Derivatives(const Samples& s, const LineWeights& w, int axis, const Point3& h,
  Point3& gradient, double (&hessian)[3][3])
{
  const auto a = static_cast<std::size_t>(axis);
  const std::size_t b = (a + 1) % 3;
  const std::size_t c = (a + 2) % 3;
  gradient = { 0.0, 0.0, 0.0 };
  for (auto& row : hessian)
  {
    row[0] = row[1] = row[2] = 0.0;
  }
  for (int i = 0; i < Reach; ++i)
  {
    double fb = 0.0, fc = 0.0, fbb = 0.0, fcc = 0.0, fbc = 0.0;
    for (int j = 0; j < 5; ++j)
    {
      fb += Central1[j] * s.At[i][j][2];
      fc += Central1[j] * s.At[i][2][j];
      fbb += Central2[j] * s.At[i][j][2];
      fcc += Central2[j] * s.At[i][2][j];
      for (int k = 0; k < 5; ++k)
      {
        if (j != 2 && k != 2)
        {
          fbc += Central1[j] * Central1[k] * s.At[i][j][k];
        }
      }
    }
    gradient[a] += w.First[i] * s.At[i][2][2] / h[a];
    gradient[b] += w.Value[i] * fb / h[b];
    gradient[c] += w.Value[i] * fc / h[c];
    hessian[a][a] += w.Second[i] * s.At[i][2][2] / (h[a] * h[a]);
    hessian[b][b] += w.Value[i] * fbb / (h[b] * h[b]);
    hessian[c][c] += w.Value[i] * fcc / (h[c] * h[c]);
    hessian[a][b] += w.First[i] * fb / (h[a] * h[b]);
    hessian[a][c] += w.First[i] * fc / (h[a] * h[c]);
    hessian[b][c] += w.Value[i] * fbc / (h[b] * h[c]);
  }
  hessian[b][a] = hessian[a][b];
  hessian[c][a] = hessian[a][c];
  hessian[c][b] = hessian[b][c];
}

/// P H P / |g|, limited to one over the spacing: the grid does not resolve sharper bends.
SurfaceFrame ComputeFrame(
  const Point3& g, const double (&hessian)[3][3], double spacing, int axis, double towards)
{
  SurfaceFrame frame;
  const double length = std::hypot(g[0], g[1], g[2]);
  // A level function without a gradient still has two sides along the edge.
  if (!(length > 0.0) || !std::isfinite(length))
  {
    frame.Normal = { 0.0, 0.0, 0.0 };
    frame.Normal[static_cast<std::size_t>(axis)] = towards;
    return frame;
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    frame.Normal[a] = g[a] / length;
  }
  double p[3][3], hp[3][3], w[3][3];
  double largest = 0.0;
  const auto product = [](const double(&x)[3][3], const double(&y)[3][3], double(&z)[3][3])
  {
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        z[i][j] = x[i][0] * y[0][j] + x[i][1] * y[1][j] + x[i][2] * y[2][j];
      }
    }
  };
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      p[i][j] = (i == j ? 1.0 : 0.0) - frame.Normal[i] * frame.Normal[j];
    }
  }
  product(hessian, p, hp);
  product(p, hp, w);
  for (auto& row : w)
  {
    for (double& entry : row)
    {
      entry /= length;
      largest += entry * entry;
    }
  }
  largest = std::sqrt(largest);
  if (!std::isfinite(largest))
  {
    return frame;
  }
  const double scale = largest * spacing > 1.0 ? 1.0 / (largest * spacing) : 1.0;
  frame.Curvature = { scale * w[0][0], scale * w[1][1], scale * w[2][2], scale * w[0][1],
    scale * w[0][2], scale * w[1][2] };
  return frame;
}

double Largest(const Point3& h)
{
  return std::max({ h[0], h[1], h[2] });
}

}

std::vector<unsigned char> ClassifyNodes(const LevelFunction& level, const SolverBox& box)
{
  std::vector<unsigned char> inside(static_cast<std::size_t>(box.Size()), 0);
  const auto& n = box.Dimensions;
  ParallelFor(0, n[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        for (std::int64_t j = 0; j < n[1]; ++j)
        {
          for (std::int64_t i = 0; i < n[0]; ++i)
          {
            const std::int64_t at[3] = { box.First[0] + i * box.Stride,
              box.First[1] + j * box.Stride, box.First[2] + k * box.Stride };
            const auto& m = level.Dimensions();
            const bool within = at[0] >= 0 && at[0] < m[0] && at[1] >= 0 && at[1] < m[1] &&
              at[2] >= 0 && at[2] < m[2];
            inside[static_cast<std::size_t>(i + n[0] * (j + n[1] * k))] =
              within && level.Inside(at[0], at[1], at[2]) ? 1 : 0;
          }
        }
      }
    });
  return inside;
}

std::vector<InterfaceCrossing> FindCrossings(const LevelFunction& level, const SolverBox& box,
  const std::vector<unsigned char>& inside, const ProgressCallback& progress)
{
  const auto& n = box.Dimensions;
  const auto step = box.Steps();
  // One list per layer preserves the order of the nodes, whichever thread found them.
  std::vector<std::vector<InterfaceCrossing>> layers(static_cast<std::size_t>(n[2]));
  ParallelFor(
    0, n[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first * step[2]; node < last * step[2]; ++node)
      {
        const std::array<std::int64_t, 3> at{ node % n[0], node / n[0] % n[1], node / step[2] };
        for (int axis = 0; axis < 3; ++axis)
        {
          const auto a = static_cast<std::size_t>(axis);
          if (at[a] + 1 >= n[a] ||
            inside[static_cast<std::size_t>(node)] ==
              inside[static_cast<std::size_t>(node + step[a])])
          {
            continue;
          }
          for (std::size_t b = 0; b < 3; ++b)
          {
            if (at[b] < 3 || at[b] + 4 > n[b] - 1)
            {
              throw std::invalid_argument("The surface is less than three nodes away from the "
                                          "border of the box: add more solvent around it.");
            }
          }
          Samples samples;
          const Line line{ at, axis };
          InterfaceCrossing crossing{ node, axis, RootOnEdge(level, box, line), {} };
          Gather(level, box, line, samples);
          Point3 g;
          double hessian[3][3];
          Derivatives(samples, WeightsAt(crossing.Fraction), axis, box.Spacing, g, hessian);
          crossing.Frame = ComputeFrame(g, hessian, Largest(box.Spacing), axis,
            inside[static_cast<std::size_t>(node)] ? 1.0 : -1.0);
          layers[static_cast<std::size_t>(at[2])].push_back(crossing);
        }
      }
    },
    progress);
  std::vector<InterfaceCrossing> all;
  for (const auto& layer : layers)
  {
    all.insert(all.end(), layer.begin(), layer.end());
  }
  return all;
}

Point3 OnLevel(const LevelFunction& level, const SolverBox& box, Point3 x)
{
  const double furthest = Largest(box.Spacing);
  for (int step = 0; step < 3; ++step)
  {
    const LocalPolynomial f(level, box, x);
    const auto& g = f.Gradient;
    const double g2 = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    const double move = f.Value / g2;
    if (!(std::abs(move) * std::sqrt(g2) < furthest))
    {
      break;
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      x[a] -= move * g[a];
    }
  }
  return x;
}

SurfaceFrame FrameAt(const LevelFunction& level, const SolverBox& box, const Point3& x)
{
  const LocalPolynomial f(level, box, x);
  return ComputeFrame(f.Gradient, f.Hessian, Largest(box.Spacing), 2, 1.0);
}

}
