#include "Electrostatics/InterfaceSolver.h"

#include "Core/NumberText.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

constexpr std::int64_t ValuesPerTask = 1 << 15;

template <typename A, typename B>
double Dot(const std::vector<A>& a, const std::vector<B>& b)
{
  return ParallelReduce<double>(static_cast<std::int64_t>(a.size()), ValuesPerTask, 0.0,
    [&](double& partial, std::int64_t first, std::int64_t last)
    {
      // Four running sums: with a single one, each addition would wait for the one before.
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
  ParallelFor(0, static_cast<std::int64_t>(n), ValuesPerTask,
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
  const double norm = ComputeNorm(r);
  if (!std::isfinite(norm))
  {
    throw std::runtime_error(
      "A value that is not finite occurred in the iteration for the potential: check the surface, "
      "the charges and the initial potential.");
  }
  return norm;
}

/// The iteration, right-preconditioned (H. van der Vorst, SIAM J. Sci. Stat. Comput. 13 (1992)
/// 631).
class BiCGSTAB
{
public:
  BiCGSTAB(const InterfaceOperator& matrix, MultigridPoisson& multigrid, SolverWorkspace& work,
    std::vector<double>& u)
    : Matrix(matrix)
    , Multigrid(multigrid)
    , Work(work)
    , U(u)
  {
    const std::size_t n = u.size();
    work.Direction.assign(n, 0.0);
    work.Image.assign(n, 0.0);
    work.Second.resize(n);
    work.Shadow.resize(n);
    work.Preconditioned.resize(n);
  }

  /// A new search from the residual, whose length is `norm`.
  void Begin(double norm)
  {
    ForEach(this->U.size(),
      [&](std::size_t i)
      {
        this->Work.Shadow[i] = static_cast<float>(this->Work.Residual[i] / norm);
        this->Work.Direction[i] = this->Work.Image[i] = 0.0;
      });
    this->Rho = this->Alpha = this->Omega = 1.0;
  }

  void Step();

  /// A direction nearly orthogonal to its shadow makes no progress.
  bool IsStuck(double norm) const
  {
    return !(std::abs(this->Rho) > 1e-12 * norm) || this->Omega == 0.0;
  }

private:
  const InterfaceOperator& Matrix;
  MultigridPoisson& Multigrid;
  SolverWorkspace& Work;
  std::vector<double>& U;
  double Rho = 1.0, Alpha = 1.0, Omega = 1.0;
};

void BiCGSTAB::Step()
{
  auto& r = this->Work.Residual;
  auto& p = this->Work.Direction;
  auto& v = this->Work.Image;
  auto& t = this->Work.Second;
  auto& z = this->Work.Preconditioned;
  const std::size_t n = this->U.size();
  const double before = this->Rho;
  this->Rho = Dot(this->Work.Shadow, r);
  // U moves along the preconditioned directions z, so the residual stays that of the system itself.
  const double beta = this->Rho / before * (this->Alpha / this->Omega);
  ForEach(n, [&](std::size_t i) { p[i] = r[i] + beta * (p[i] - this->Omega * v[i]); });
  Precondition(this->Matrix, this->Multigrid, p, z);
  this->Matrix.Apply(z, v);
  this->Alpha = this->Rho / Dot(this->Work.Shadow, v);
  ForEach(n,
    [&](std::size_t i)
    {
      this->U[i] += this->Alpha * static_cast<double>(z[i]);
      r[i] -= this->Alpha * v[i];
    });
  Precondition(this->Matrix, this->Multigrid, r, z);
  this->Matrix.Apply(z, t);
  const double tt = Dot(t, t);
  this->Omega = tt > 0.0 ? Dot(t, r) / tt : 0.0;
  ForEach(n,
    [&](std::size_t i)
    {
      this->U[i] += this->Omega * static_cast<double>(z[i]);
      r[i] -= this->Omega * t[i];
    });
}

}

void RequireConvergence(const SolverReport& report, const SolverControl& control)
{
  if (!report.Converged)
  {
    const double reached = report.Residuals.empty() ? 1.0 : report.Residuals.back();
    throw std::runtime_error("The potential did not converge: after " +
      std::to_string(report.Iterations) + " iterations the residual is " + FormatNumber(reached) +
      " of the initial one, but " + FormatNumber(control.Tolerance) +
      " was requested. Allow more iterations, or use a smoother surface or a finer grid.");
  }
}

double ComputeNorm(const std::vector<double>& a)
{
  return std::sqrt(Dot(a, a));
}

SolverReport SolveInterface(const InterfaceOperator& matrix, MultigridPoisson& multigrid,
  const SolverControl& control, SolverWorkspace& work, std::vector<double>& u,
  const ProgressCallback& progress)
{
  SolverReport report;
  double norm = FiniteNorm(work.Residual);
  const double reference = control.Reference > 0.0 ? control.Reference : norm;
  const double goal = control.Tolerance * reference;
  if (norm <= goal || norm == 0.0)
  {
    report.Converged = true;
    return report;
  }
  const double start = std::log(norm / goal);
  BiCGSTAB search(matrix, multigrid, work, u);
  bool fresh = true; // the search starts again from the residual
  while (report.Iterations < control.MaximumIterations)
  {
    if (fresh)
    {
      search.Begin(norm);
    }
    search.Step();
    ++report.Iterations;
    norm = FiniteNorm(work.Residual);
    report.Residuals.push_back(norm / reference);
    if (norm <= goal)
    {
      report.Converged = true;
      break;
    }
    fresh = search.IsStuck(norm);
    Report(progress, std::clamp(1.0 - std::log(norm / goal) / start, 0.0, 1.0));
  }
  return report;
}

}
