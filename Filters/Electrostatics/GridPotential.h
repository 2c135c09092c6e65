/**
 * @file GridPotential.h
 * @brief The Poisson-Boltzmann problem of a surface and charges on one box of nodes.
 *
 *     inside:   phi = G + u,  G = sum C q_i / (eps_m |x - r_i|),  Laplace u = 0
 *     outside:  phi = u,      -eps_s Laplace u + f(u) = 0  (f: IonAtmosphere)
 *     surface:  phi and eps d_n phi go through
 *
 * so u inside is the reaction potential, without any self-energy to subtract, and no second
 * solution is needed for an energy.
 */
#ifndef isthmus_GridPotential_h
#define isthmus_GridPotential_h

#include "Electrostatics/BoundaryPotential.h"
#include "Electrostatics/InterfaceSolver.h"
#include "Electrostatics/IonAccess.h"
#include "Electrostatics/IonAtmosphere.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

#include <memory>

namespace isthmus
{

/// Memory: see PoissonBoltzmann.h.
class VTKISTHMUSFILTERSELECTROSTATICS_EXPORT GridPotential
{
public:
  /// Finds the surface and fits the rows at it. The arguments are referred to, not copied, except
  /// the level. `last` is a solution for another surface with otherwise equal arguments; the
  /// potential, the border values and the reference of the residuals start from those of `last`.
  GridPotential(const LevelFunction& level, const SolverBox& box,
    const std::vector<ChargedAtom>& atoms, const PoissonBoltzmannParameters& parameters,
    const IonAtmosphere& ions, const ProgressCallback& progress = {},
    const GridPotential* last = nullptr);

  /// Sets border values. With `sampled`, `border` must be smooth and defined slightly beyond the
  /// border.
  void SetBorder(const PotentialFunction& border, bool sampled);
  /// The function of the last SetBorder().
  const PotentialFunction& GetBorder() const { return this->Border; }
  /// Sets the interior, which is 0 at first.
  void SetStart(const PotentialFunction& start);

  /**
   * Solves the linear equation from the current potential, and with Parameters.Nonlinear then the
   * full one by Newton's method, until the residual is `tolerance` times that of the first start.
   * May be called again, with other border values.
   */
  void Solve(double tolerance, const ProgressCallback& progress = {});

  /// Computes energies, u and forces at the atoms.
  void Evaluate();

  /// Frees what only solving needs. The rest can still be evaluated and passed as `last` to another
  /// problem.
  void Release();

  const SolverBox& GetBox() const { return this->Box; }
  const std::vector<double>& GetPotential() const { return this->U; }
  std::vector<double>& GetPotential() { return this->U; }
  const std::vector<unsigned char>& GetInside() const { return this->Inside; }
  const std::vector<InterfaceCrossing>& GetCrossings() const { return this->Crossings; }
  /// G at each crossing.
  const std::vector<SecondOrderTaylor>& GetChargesAtCrossings() const { return this->AtCrossing; }
  const FitMedium& GetMedium() const { return this->Medium; }
  const ChargeList& GetCharges() const { return this->Charges; }
  const PoissonBoltzmannReport& GetReport() const { return this->Report; }
  const IonAtmosphere& GetIons() const { return this->Ions; }
  const std::vector<ChargedAtom>& GetAtoms() const { return this->Atoms; }
  const PoissonBoltzmannParameters& GetParameters() const { return this->Parameters; }
  /// The fraction of the cell of each node that the ions of a layer reach; empty after Release().
  const std::vector<std::vector<float>>& GetAccess() const { return this->Access; }
  /// Smallest distance of the ions of a layer from the surface, in angstrom.
  double LayerRadius(std::size_t layer) const;
  /// The permittivity of each edge, with its two parts in series.
  EdgePermittivity Permittivities() const;
  void SetEnergyError(double error) { this->Report.SolvationEnergyError = error; }
  void SetBorderIterations(int iterations) { this->Report.BorderIterations = iterations; }
  double Kappa() const;
  /// First and last nodes inside the surface; Last < First if there are none.
  BoxNodes RangeInside() const;

private:
  void EvaluateCharges(const GridPotential* last, const ProgressCallback& progress);
  void Assemble(std::vector<SurfaceIons> ions, const ProgressCallback& progress);
  /// Whether the ions of any layer reach a node.
  bool IonsReach(std::size_t node) const;
  /// f'(u) at a node, h^2 times; linear: f'(0).
  double ScaledDerivative(std::size_t node, bool nonlinear) const;
  /// f(u), and its derivative, of the ions that reach the surface itself.
  double ChargeAtSurface(double phi) const;
  double DerivativeAtSurface(double phi) const;
  /// The potential on the surface at a crossing.
  double SurfaceValue(
    std::size_t crossing, const FitNodes& nodes, const FitFunctional& functional) const;
  /// The ions at the surface, linearised about phi, with a slope of at most 1 / spacing^2, since a
  /// quadratic cannot represent a layer thinner than the spacing.
  SurfaceIons IonsAt(double phi) const;
  std::vector<SurfaceIons> IonsAtCrossings() const;
  /// Correction of the energy of the ions that reach the surface, relative to the sum over whole
  /// cells, in kT.
  double IonEnergyOfCutCells() const;
  double NonlinearResidual(const std::vector<double>& u, std::vector<double>& out) const;
  void FillDiagonal(bool nonlinear);
  void SolveLinear(double tolerance, const ProgressCallback& progress);
  void SolveNonlinear(double tolerance, const ProgressCallback& progress);
  void ClipStart();
  double NewtonStep(double tolerance, double norm);
  double TakeStep(const std::vector<double>& step, double before);

  const SolverBox Box;
  const std::vector<ChargedAtom>& Atoms;
  const PoissonBoltzmannParameters& Parameters;
  const IonAtmosphere& Ions;
  double Spacing; ///< the shortest
  std::vector<unsigned char> Inside;
  std::vector<InterfaceCrossing> Crossings;
  ChargeList Charges;                        ///< C q / eps_m
  std::vector<SecondOrderTaylor> AtCrossing; ///< G
  FitMedium Medium;
  std::unique_ptr<InterfaceOperator> Matrix;
  std::unique_ptr<MultigridPoisson> Multigrid;
  std::vector<std::vector<float>> Access;          ///< of ions, by layer and node
  std::shared_ptr<std::vector<float>> IonDiagonal; ///< h^2 access f'(u)
  std::vector<double> U;
  PotentialFunction Border;
  SolverWorkspace Work;
  PoissonBoltzmannReport Report;
};

}

#endif
