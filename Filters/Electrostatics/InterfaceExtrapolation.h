/**
 * @file InterfaceExtrapolation.h
 * @brief What the two sides' functions are across the surface, at the ends of an edge it crosses.
 */
#ifndef isthmus_InterfaceExtrapolation_h
#define isthmus_InterfaceExtrapolation_h

#include "Electrostatics/ChargeSums.h"
#include "Electrostatics/InterfaceJumpConditions.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

namespace isthmus
{

/// The ions just outside the surface, linearised: the Laplacian of phi is Slope phi + Constant.
struct SurfaceIons
{
  double Slope = 0.0, Constant = 0.0;
};

/// What the values are made of.
struct InterfaceProblem
{
  const SolverBox* Box = nullptr;
  const std::vector<unsigned char>* Inside = nullptr;
  const std::vector<InterfaceCrossing>* Crossings = nullptr;
  const std::vector<SecondOrderTaylor>* Charges = nullptr; ///< G at each crossing, kT/e
  FitMedium Medium;
  /// Of Newton's method where ions reach the surface, at each crossing; empty: the linear ones.
  std::vector<SurfaceIons> Ions;
  DielectricModel Model = DielectricModel::SharpInterface;
  /// The crossings of each closed cavity (ClosedCavities.h).
  std::vector<std::vector<std::int64_t>> Cavities = {};
};

/// The nodes around the edge of a crossing, with weights, for a fit at the crossing.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT FitNodes NodesAroundCrossing(const SolverBox& box,
  const std::vector<unsigned char>& inside, const InterfaceCrossing& crossing, double length);

/// Weights (h / h_a)^2 of the axes, h the shortest spacing.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT Point3 AxisWeights(const SolverBox& box);

/// A fictitious value as a sum over nodes and a constant.
struct Continuation
{
  std::array<double, 36> Coefficient;
  double Constant;
};

/// Of a crossing: the function of the lower end's side at the upper end, and the reverse.
struct InterfaceExtrapolation
{
  std::array<std::int64_t, 36> Id;
  Continuation AtUpper, AtLower;
  FitQuality Quality;
};

/**
 * SmoothDielectric: the ghost-fluid values of X.-D. Liu, R. Fedkiw and M. Kang (J. Comput. Phys.
 * 160 (2000) 151), from the potential's continuity and its flux's along the edge alone. Rows of
 * them are those of -div(eps grad phi) in finite volumes with the permittivity
 *
 *     1 / eps_f = part inside / eps_m + part outside / eps_s
 *
 * on an edge's face: symmetric, an M-matrix, what leaves a node arrives at the next. Second order
 * in the energy, first in the potential next to the surface. (Thesis 4.16 has eps(S) at nodes, S
 * smeared over cells: the energy of an ion of 2 angstrom at a spacing of 0.25 is off by 14 % so, by
 * 0.11 % here.)
 *
 * SharpInterface: by InterfaceJumpConditions; by the ghost-fluid values where nothing can be
 * fitted, and where fewer of the nodes around are outside than a harmonic quadratic has
 * coefficients (9): in a cavity or cleft of the molecule a node or two wide. There the fit
 * continues the outside function from values inside, whose errors count solvent / solute dielectric
 * times outside and shift the potential of a whole cavity; the ghost-fluid fluxes add up to 0
 * around it.
 */
InterfaceExtrapolation ValuesAtCrossing(const InterfaceProblem& problem, std::size_t index);

}

#endif
