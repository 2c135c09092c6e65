/**
 * @file InterfaceSolver.h
 * @brief BiCGSTAB for InterfaceOperator, preconditioned by a multigrid cycle.
 *
 * H. A. van der Vorst, SIAM J. Sci. Stat. Comput. 13 (1992) 631, with right preconditioning: one
 * V(1,1) cycle of the symmetric operator with the permittivities of edges in series at the surface,
 * then one Gauss-Seidel pass over the fitted rows of the true matrix. Sums are computed in fixed
 * blocks, so the result is bitwise the same on any number of threads.
 */
#ifndef isthmus_InterfaceSolver_h
#define isthmus_InterfaceSolver_h

#include "Core/Progress.h"
#include "Electrostatics/InterfaceOperator.h"
#include "Electrostatics/MultigridPoisson.h"

namespace isthmus
{

struct SolverControl
{
  double Tolerance = 1e-6; ///< of the residual, relative to `Reference`
  double Reference = 0.0;  ///< 0: the initial residual
  int MaximumIterations = 100;
};

struct SolverReport
{
  int Iterations = 0;
  bool Converged = false;
  std::vector<double> Residuals; ///< relative to Reference, after each iteration
};

/// Work arrays, kept between Newton steps: 40 bytes per node.
struct SolverWorkspace
{
  std::vector<double> Residual, Direction, Image, Second;
  std::vector<float> Shadow, Preconditioned;
};

/**
 * Iterates u, whose residual b - A u is in `work.Residual`, until the residual is small enough.
 * Throws std::runtime_error if the residual is not finite.
 */
SolverReport SolveInterface(const InterfaceOperator& matrix, MultigridPoisson& multigrid,
  const SolverControl& control, SolverWorkspace& work, std::vector<double>& u,
  const ProgressCallback& progress = {});

/// Throws std::runtime_error, with the residual that was reached, if the iteration did not
/// converge.
void RequireConvergence(const SolverReport& report, const SolverControl& control);

/// sqrt(sum a_i^2), bitwise the same on any number of threads.
double ComputeNorm(const std::vector<double>& a);

}

#endif
