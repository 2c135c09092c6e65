/**
 * @file InterfaceExtrapolation.h
 * @brief The functions of both sides, continued across the surface to the ends of an edge that it
 * crosses.
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

/// The data from which the values are computed.
struct InterfaceProblem
{
  const SolverBox* Box = nullptr;
  const std::vector<unsigned char>* Inside = nullptr;
  const std::vector<InterfaceCrossing>* Crossings = nullptr;
  const std::vector<SecondOrderTaylor>* Charges = nullptr; ///< G at each crossing, kT/e
  FitMedium Medium;
  /// The ions at each crossing in Newton's method, if ions reach the surface; empty: those of the
  /// linear equation.
  std::vector<SurfaceIons> Ions;
  DielectricModel Model = DielectricModel::SharpInterface;
  /// The crossings of each closed cavity (ClosedCavities.h).
  std::vector<std::vector<std::int64_t>> Cavities = {};
};

/// The nodes around the edge of a crossing, with weights, for a fit at the crossing.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT FitNodes NodesAroundCrossing(const SolverBox& box,
  const std::vector<unsigned char>& inside, const InterfaceCrossing& crossing, double length);

/// Weights (h / h_a)^2 of the axes, h the shortest spacing.
Point3 AxisWeights(const SolverBox& box);

/// A ghost value as a weighted sum over nodes and a constant.
struct Continuation
{
  std::array<double, 36> Coefficient;
  double Constant;
};

/// For a crossing: the function on the side of the lower end, continued to the upper end, and the
/// reverse.
struct InterfaceExtrapolation
{
  std::array<std::int64_t, 36> Id;
  Continuation AtUpper, AtLower;
  FitQuality Quality;
};

/**
 * SmoothDielectric: the ghost-fluid values of X.-D. Liu, R. Fedkiw and M. Kang (J. Comput. Phys.
 * 160 (2000) 151), only from the continuity of the potential and of its flux along the edge. Rows
 * of them are those of -div(eps grad phi) in finite volumes with the permittivity
 *
 *     1 / eps_f = part inside / eps_m + part outside / eps_s
 *
 * on an edge's face: symmetric, an M-matrix, conservative: the flux out of a node enters the next.
 * Second order in the energy, first in the potential next to the surface. (Thesis 4.16 has eps(S)
 * at nodes, S smeared over cells, which is far less accurate.)
 *
 * SharpInterface: values by InterfaceJumpConditions. The ghost-fluid values are used where nothing
 * can be fitted, and where fewer surrounding nodes are outside than a harmonic quadratic has
 * coefficients (9), i.e. in a cavity or cleft of the molecule that is only one or two nodes wide.
 */
InterfaceExtrapolation ValuesAtCrossing(const InterfaceProblem& problem, std::size_t index);

}

#endif
