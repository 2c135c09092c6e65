/**
 * @file BoundaryPotential.h
 * @brief The potential on the border of the box: Debye-Hueckel sums, and what a solution on a
 * smaller box radiates to it.
 */
#ifndef isthmus_BoundaryPotential_h
#define isthmus_BoundaryPotential_h

#include "Electrostatics/BoundaryPotential.h"
#include "Electrostatics/ChargeSums.h"
#include "Electrostatics/LevelFunction.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

namespace isthmus
{

using PotentialFunction = std::function<double(const Point3&)>;

/**
 * sum C q_i exp(-kappa (|x - r_i| - a_i)) / (eps_s |x - r_i| (1 + kappa a_i)), each charge by
 * itself in the solvent. It decays and solves the linear equation outside, but knows nothing of the
 * cavity that the solute is.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT PotentialFunction MultipleDebyeHueckel(
  const std::vector<ChargedAtom>& atoms, double coulombLength, double solventDielectric,
  double kappa);

/// The same with all charge in the middle, in a sphere around all atoms.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT PotentialFunction SingleDebyeHueckel(
  const std::vector<ChargedAtom>& atoms, double coulombLength, double solventDielectric,
  double kappa);

/**
 * Sets the border nodes of u to f. With a `sampleLength` (angstrom) above 0, f is called at nodes
 * so far apart only, also a little beyond the border, and interpolated by cubics: f must be smooth
 * there. Parallel.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT void FillBorder(
  const SolverBox& box, const PotentialFunction& f, double sampleLength, std::vector<double>& u);

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
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT RadiatingBox MakeIntermediateBox(
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
