/**
 * @file RadiatedPotential.h
 * @brief What a solution on a box says about the potential beyond it.
 */
#ifndef isthmus_RadiatedPotential_h
#define isthmus_RadiatedPotential_h

#include "Electrostatics/BoundaryPotential.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

namespace isthmus
{

/// Nodes first and last along each axis.
struct BoxNodes
{
  std::array<std::int64_t, 3> First, Last;
};

/// Least distance of the nodes `inside` from the border, angstrom.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT double GapAround(
  const BoxNodes& inside, const SolverBox& box);

/// Every Stride-th node of the surface of a box of nodes.
struct RadiatingBox : BoxNodes
{
  std::array<std::int64_t, 3> Stride;
};

/// About half-way between the nodes `inside` and the border, two nodes off the border at least;
/// strides are about a quarter of the gap.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT RadiatingBox HalfWayOut(
  const BoxNodes& inside, const SolverBox& box);

/**
 * The function outside of the range of nodes that decays, solves the linear equation there and
 * continues u, by Green's third identity on the range's surface:
 *
 *     v(x) = int [ u d_n g - g d_n u ] dS,   g = exp(-kappa r) / (4 pi r).
 *
 * What a wrong border value adds to u and is smooth inside the range drops out. The range has to
 * keep two nodes from the border and lie where the equation is linear, in the solvent.
 *
 * The integrals are sums over every Stride-th node with the end corrections of Gregory's rule
 * (fourth order at the edges; inside a face the error falls as exp(-2 pi d / stride), d the
 * distance of range and border), each a pair of charges for source and dipole. Above some thousand
 * of them, by a tree.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT PotentialFunction RadiatedPotential(
  const SolverBox& box, const std::vector<double>& u, const RadiatingBox& range, double kappa);

}

#endif
