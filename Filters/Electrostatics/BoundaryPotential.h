/**
 * @file BoundaryPotential.h
 * @brief The potential on the border of the box: Debye-Hueckel sums, and the continuation of a
 * solution on a smaller box.
 */
#ifndef isthmus_BoundaryPotential_h
#define isthmus_BoundaryPotential_h

#include "Electrostatics/BoundaryPotential.h"
#include "Electrostatics/ChargeSums.h"
#include "Electrostatics/LevelFunction.h"

namespace isthmus
{

using PotentialFunction = std::function<double(const Point3&)>;

/**
 * sum C q_i exp(-kappa (|x - r_i| - a_i)) / (eps_s |x - r_i| (1 + kappa a_i)), each charge alone in
 * the solvent. It decays and solves the linear equation outside, but does not account for the
 * dielectric cavity of the solute.
 */
PotentialFunction MultipleDebyeHueckel(const std::vector<ChargedAtom>& atoms, double coulombLength,
  double solventDielectric, double kappa);

/// The same with the total charge at the center of a sphere around all atoms.
PotentialFunction SingleDebyeHueckel(const std::vector<ChargedAtom>& atoms, double coulombLength,
  double solventDielectric, double kappa);

/**
 * Sets u to f at the border nodes. With a `sampleLength` (angstrom) above 0, f is called only at
 * nodes at this distance from each other, some of them slightly beyond the border, and interpolated
 * by cubics; f must be smooth there. Parallel.
 */
void FillBorder(
  const SolverBox& box, const PotentialFunction& f, double sampleLength, std::vector<double>& u);

/// The first and last node along each axis.
struct BoxNodes
{
  std::array<std::int64_t, 3> First, Last;
};

/// Smallest distance of the nodes `inside` from the border, in angstrom.
double GapAround(const BoxNodes& inside, const SolverBox& box);

/// Every Stride-th node of the surface of a box of nodes.
struct RadiatingBox : BoxNodes
{
  std::array<std::int64_t, 3> Stride;
};

/// A box about half-way between the nodes `inside` and the border, at least two nodes away from the
/// border and, in a gap of six nodes or more, three from those inside; strides are at most about a
/// quarter of the gap.
RadiatingBox MakeIntermediateBox(const BoxNodes& inside, const SolverBox& box);

/**
 * The function outside of the range of nodes that decays, solves the linear equation there and
 * continues u, by Green's third identity on the range's surface:
 *
 *     v(x) = int [ u d_n g - g d_n u ] dS,   g = exp(-kappa r) / (4 pi r).
 *
 * Errors of u that come from wrong border values and are smooth inside the range cancel. The
 * surface of the range has to be at least two nodes away from the border and in the solvent, where
 * the equation is linear.
 *
 * The integrals are sums over every Stride-th node, of fourth order; more than a few thousand terms
 * are summed by a tree.
 */
PotentialFunction RadiatedPotential(
  const SolverBox& box, const std::vector<double>& u, const RadiatingBox& range, double kappa);

}

#endif
