#include "InterfaceSolver.h"

#include "ParallelReduce.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

constexpr std::int64_t Block = 1 << 15;

template <typename A, typename B>
double Dot(const std::vector<A>& a, const std::vector<B>& b)
{
  return ParallelReduce<double>(static_cast<std::int64_t>(a.size()), Block, 0.0,
    [&](double& partial, std::int64_t first, std::int64_t last)
    {
      // Four running sums: one would wait for each addition to end.
      double s[4] = { 0.0, 0.0, 0.0, 0.0 };
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        s[i & 3] += static_cast<double>(a[i]) * static_cast<double>(b[i]);
      }
      partial += (s[0] + s[1]) + (s[2] + s[3]);
    });
}

/// Calls `each(i)` for all i below n, in parallel.
template <typename Each>
void ForEach(std::size_t n, Each&& each)
{
  ParallelFor(0, static_cast<std::int64_t>(n), Block,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        each(i);
      }
    });
}

/// z = M^-1 r.
void Precondition(const InterfaceOperator& matrix, MultigridPoisson& multigrid,
  const std::vector<double>& r, std::vector<float>& z)
{
  multigrid.Cycle(r, z);
  matrix.SmoothIrregular(r, z);
}

double FiniteNorm(const std::vector<double>& r)
{
  const double norm = NormOf(r);
  if (!std::isfinite(norm))
  {
    throw std::runtime_error("The iteration for the potential met a number that is not finite: "
                             "check the surface, the charges and the potential to start from.");
  }
  return norm;
}

}

void RequireConvergence(const SolverReport& report, const SolverControl& control)
{
  if (!report.Converged)
  {
    const double reached = report.Residuals.empty() ? 1.0 : report.Residuals.back();
    throw std::runtime_error("The potential did not converge: after " +
      std::to_string(report.Iterations) + " iterations the residual is " + std::to_string(reached) +
      " of that of the start, and " + std::to_string(control.Tolerance) +
      " was asked for. Allow more iterations, or give a smoother surface or a finer grid.");
  }
}

double NormOf(const std::vector<double>& a)
{
  return std::sqrt(Dot(a, a));
}

SolverReport SolveInterface(const InterfaceOperator& matrix, MultigridPoisson& multigrid,
  const SolverControl& control, SolverWorkspace& work, std::vector<double>& u,
  const ProgressCallback& progress)
{
  const std::size_t n = u.size();
  auto& r = work.Residual;
  auto& p = work.Direction;
  auto& v = work.Image;
  auto& t = work.Second;
  auto& shadow = work.Shadow;
  auto& z = work.Preconditioned;
  p.assign(n, 0.0);
  v.assign(n, 0.0);
  t.resize(n);
  shadow.resize(n);
  z.resize(n);
  SolverReport report;
  double norm = FiniteNorm(r);
  const double reference = control.Reference > 0.0 ? control.Reference : norm;
  const double goal = control.Tolerance * reference;
  if (norm <= goal || norm == 0.0)
  {
    report.Converged = true;
    return report;
  }
  const double start = std::log(norm / goal);
  double rho = 1.0, alpha = 1.0, omega = 1.0;
  bool fresh = true; // the search starts anew from r
  while (report.Iterations < control.MaximumIterations)
  {
    if (fresh)
    {
      ForEach(n,
        [&](std::size_t i)
        {
          shadow[i] = static_cast<float>(r[i] / norm);
          p[i] = v[i] = 0.0;
        });
      rho = alpha = omega = 1.0;
    }
    const double before = rho;
    rho = Dot(shadow, r);
    const double beta = rho / before * (alpha / omega);
    ForEach(n, [&](std::size_t i) { p[i] = r[i] + beta * (p[i] - omega * v[i]); });
    Precondition(matrix, multigrid, p, z);
    matrix.Apply(z, v);
    alpha = rho / Dot(shadow, v);
    ForEach(n,
      [&](std::size_t i)
      {
        u[i] += alpha * static_cast<double>(z[i]);
        r[i] -= alpha * v[i];
      });
    Precondition(matrix, multigrid, r, z);
    matrix.Apply(z, t);
    const double tt = Dot(t, t);
    omega = tt > 0.0 ? Dot(t, r) / tt : 0.0;
    ForEach(n,
      [&](std::size_t i)
      {
        u[i] += omega * static_cast<double>(z[i]);
        r[i] -= omega * t[i];
      });
    ++report.Iterations;
    norm = FiniteNorm(r);
    report.Residuals.push_back(norm / reference);
    if (norm <= goal)
    {
      report.Converged = true;
      break;
    }
    // A search direction that has all but lost its shadow goes nowhere: begin again from here.
    fresh = !(std::abs(rho) > 1e-12 * norm) || omega == 0.0;
    Report(progress, std::clamp(1.0 - std::log(norm / goal) / start, 0.0, 1.0));
  }
  return report;
}

}
