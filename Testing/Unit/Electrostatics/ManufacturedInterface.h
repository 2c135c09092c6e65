/**
 * @file ManufacturedInterface.h
 * @brief The solver with a manufactured solution, on any surface.
 *
 * u = A inside and u = B outside, both harmonic. The scheme takes jumps from the charges' potential
 * G alone, by its value and two derivatives at each crossing. So G is made such that the total
 * inside, p = A + G, joins B as potentials do, phi and eps d_n phi continuous: with rho = eps_m /
 * eps_s and W the surface's curvature,
 *
 *     p_n = B_n / rho,  p_t = B_t,  Htt = H(B)tt + (1 - rho) p_n W,
 *     Hnt = (H(B)nt + (1 - rho) W B_t) / rho,  Hnn = -tr Htt.
 *
 * Normal and W are those of the exact surface where they are known; an error of the curvature that
 * the scheme finds for itself shows in the order.
 */
#ifndef isthmus_ManufacturedInterface_h
#define isthmus_ManufacturedInterface_h

#include "Electrostatics/InterfaceSolver.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace isthmus::testing
{

/// strength / |x - Source|: harmonic away from the source.
struct PointSource
{
  Point3 Source;
  double Strength;

  SecondOrderTaylor operator()(const Point3& x) const
  {
    const Point3 y{ x[0] - this->Source[0], x[1] - this->Source[1], x[2] - this->Source[2] };
    const double i2 = 1.0 / (y[0] * y[0] + y[1] * y[1] + y[2] * y[2]);
    const double v = this->Strength * std::sqrt(i2);
    const double s = v * i2, b = 3.0 * s * i2;
    return { v, { -s * y[0], -s * y[1], -s * y[2] },
      { b * y[0] * y[0] - s, b * y[1] * y[1] - s, b * y[2] * y[2] - s, b * y[0] * y[1],
        b * y[0] * y[2], b * y[1] * y[2] } };
  }
};

using FrameFunction = std::function<SurfaceFrame(const InterfaceCrossing&, const Point3&)>;

struct Manufactured
{
  PointSource A; ///< its source is outside, or beyond the box
  PointSource B; ///< its source is inside
  double Solute = 2.0, Solvent = 80.0;
};

inline Eigen::Matrix3d Symmetric(const std::array<double, 6>& h)
{
  Eigen::Matrix3d m;
  m << h[0], h[3], h[4], h[3], h[1], h[5], h[4], h[5], h[2];
  return m;
}

/// The jet of G at a crossing.
inline SecondOrderTaylor JumpAt(const Manufactured& m, const SurfaceFrame& frame, const Point3& x)
{
  const SecondOrderTaylor a = m.A(x);
  const SecondOrderTaylor b = m.B(x);
  const double rho = m.Solute / m.Solvent;
  const Eigen::Map<const Eigen::Vector3d> n(frame.Normal.data());
  const Eigen::Vector3d grad = Eigen::Map<const Eigen::Vector3d>(b.Gradient.data());
  const Eigen::Matrix3d hess = Symmetric(b.Hessian);
  const Eigen::Matrix3d w = Symmetric(frame.Curvature);
  const Eigen::Matrix3d p = Eigen::Matrix3d::Identity() - n * n.transpose();
  const double slope = grad.dot(n) / rho;
  const Eigen::Vector3d along = p * grad;
  const Eigen::Matrix3d tangent = p * hess * p + (1.0 - rho) * slope * w;
  const Eigen::Vector3d mixed = (p * hess * n + (1.0 - rho) * w * along) / rho;
  const Eigen::Matrix3d total =
    tangent + mixed * n.transpose() + n * mixed.transpose() - tangent.trace() * n * n.transpose();
  const Eigen::Vector3d gradient = along + slope * n;
  SecondOrderTaylor g;
  g.Value = b.Value - a.Value;
  for (Eigen::Index i = 0; i < 3; ++i)
  {
    g.Gradient[static_cast<std::size_t>(i)] = gradient(i) - a.Gradient[static_cast<std::size_t>(i)];
  }
  const double h[6] = { total(0, 0), total(1, 1), total(2, 2), total(0, 1), total(0, 2),
    total(1, 2) };
  for (std::size_t i = 0; i < 6; ++i)
  {
    g.Hessian[i] = h[i] - a.Hessian[i];
  }
  return g;
}

/// The whole grid of a level.
inline SolverBox WholeBox(const LevelFunction& level)
{
  SolverBox box;
  box.Dimensions = level.Dimensions();
  box.Spacing = level.Spacing();
  return box;
}

inline EdgePermittivity TwoPermittivities(const Manufactured& m,
  const std::vector<unsigned char>& inside, const std::vector<InterfaceCrossing>& crossings)
{
  EdgePermittivity edges;
  for (std::size_t c = 0; c < 256; ++c)
  {
    edges.Table[c] =
      static_cast<float>(SeriesPermittivity(m.Solute, m.Solvent, static_cast<double>(c) / 255.0));
  }
  for (auto& code : edges.Code)
  {
    code.resize(inside.size());
    std::transform(inside.begin(), inside.end(), code.begin(),
      [](unsigned char in) { return static_cast<unsigned char>(in ? 255 : 0); });
  }
  for (const InterfaceCrossing& c : crossings)
  {
    const bool in = inside[static_cast<std::size_t>(c.Node)] != 0;
    edges.Code[static_cast<std::size_t>(c.Axis)][static_cast<std::size_t>(c.Node)] =
      static_cast<unsigned char>(std::lround(255.0 * (in ? c.Fraction : 1.0 - c.Fraction)));
  }
  return edges;
}

struct ManufacturedErrors
{
  double Outside = 0.0, Inside = 0.0; ///< the largest
  double RootMeanSquare = 0.0;        ///< over all nodes
  int Iterations = 0;
  std::int64_t Fallbacks = 0;
};

/// Solves on the level's grid with the exact values on its border; largest errors at nodes.
inline ManufacturedErrors SolveManufactured(
  const Manufactured& m, const LevelFunction& level, const FrameFunction& frame)
{
  const SolverBox box = WholeBox(level);
  const std::vector<unsigned char> inside = ClassifyNodes(level, box);
  const std::vector<InterfaceCrossing> crossings = FindCrossings(level, box, inside);
  std::vector<SecondOrderTaylor> jumps;
  for (const InterfaceCrossing& c : crossings)
  {
    Point3 x = box.Position(c.Node);
    x[static_cast<std::size_t>(c.Axis)] += c.Fraction * box.Spacing[0];
    jumps.push_back(JumpAt(m, frame(c, x), x));
  }
  InterfaceProblem problem{ &box, &inside, &crossings, &jumps,
    { m.Solute, m.Solvent, std::pow(m.Solute / m.Solvent, PoissonBoltzmannParameters().FitExponent),
      0.0, box.Spacing[0] },
    {} };
  InterfaceMatrixRows rows = AssembleIrregularRows(problem);
  ManufacturedErrors errors;
  errors.Fallbacks = rows.LinearFits + rows.GhostFits;
  InterfaceOperator matrix(box, inside, m.Solute, m.Solvent);
  matrix.SetRows(std::move(rows));
  MultigridPoisson multigrid(
    box.Dimensions, { 1.0, 1.0, 1.0 }, TwoPermittivities(m, inside, crossings));
  std::vector<double> u(inside.size(), 0.0);
  const auto& n = box.Dimensions;
  for (std::int64_t node = 0; node < box.Size(); ++node)
  {
    const std::int64_t at[3] = { node % n[0], node / n[0] % n[1], node / (n[0] * n[1]) };
    for (std::size_t a = 0; a < 3; ++a)
    {
      if (at[a] == 0 || at[a] == n[a] - 1)
      {
        u[static_cast<std::size_t>(node)] = m.B(box.Position(node)).Value;
      }
    }
  }
  SolverWorkspace work;
  work.Residual.resize(u.size());
  matrix.Residual(u, work.Residual);
  SolverControl control;
  control.Tolerance = 1e-8;
  errors.Iterations = SolveInterface(matrix, multigrid, control, work, u).Iterations;
  for (std::int64_t node = 0; node < box.Size(); ++node)
  {
    const auto i = static_cast<std::size_t>(node);
    const double exact = (inside[i] ? m.A : m.B)(box.Position(node)).Value;
    double& error = inside[i] ? errors.Inside : errors.Outside;
    error = std::max(error, std::abs(u[i] - exact));
    errors.RootMeanSquare += (u[i] - exact) * (u[i] - exact) / static_cast<double>(u.size());
  }
  errors.RootMeanSquare = std::sqrt(errors.RootMeanSquare);
  return errors;
}

}

#endif
