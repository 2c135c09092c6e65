/**
 * @file BoundaryPotential.h
 * @brief The potential on the border of the box: Debye-Hueckel sums, and what a solution radiates.
 */
#ifndef isthmus_BoundaryPotential_h
#define isthmus_BoundaryPotential_h

#include "ChargeSums.h"
#include "LevelFunction.h"
#include "vtkIsthmusModule.h"

namespace isthmus
{

using PotentialFunction = std::function<double(const Vector3&)>;

/**
 * sum C q_i exp(-kappa (|x - r_i| - a_i)) / (eps_s |x - r_i| (1 + kappa a_i)), each charge by
 * itself in the solvent. It decays and solves the linear equation outside, but knows nothing of the
 * cavity that the solute is.
 */
VTKISTHMUS_EXPORT PotentialFunction MultipleDebyeHueckel(const std::vector<ChargedAtom>& atoms,
  double coulombLength, double solventDielectric, double kappa);

/// The same with all charge in the middle, in a sphere around all atoms.
VTKISTHMUS_EXPORT PotentialFunction SingleDebyeHueckel(const std::vector<ChargedAtom>& atoms,
  double coulombLength, double solventDielectric, double kappa);

/// Nodes first and last along each axis.
struct BoxNodes
{
  std::array<std::int64_t, 3> First, Last;
};

/**
 * `base` + the function outside the range of nodes that decays, solves the linear equation there
 * and continues the rest u - base, by Green's third identity on the range's surface:
 *
 *     w(x) = int [ w d_n g - g d_n w ] dS,   g = exp(-kappa r) / (4 pi r).
 *
 * What a wrong border value adds to u and is smooth inside the range drops out. The range has to
 * keep two nodes from the border and lie where the equation is linear, in the solvent.
 */
VTKISTHMUS_EXPORT PotentialFunction RadiatedPotential(const SolverBox& box,
  const std::vector<double>& u, const BoxNodes& range, double kappa, PotentialFunction base);

/// Sets the border nodes of u to f. With `sampled`, f is called at every 3 angstrom or so only,
/// also a little beyond the border, and interpolated by cubics: f must be smooth there.
VTKISTHMUS_EXPORT void FillBorder(
  const SolverBox& box, const PotentialFunction& f, bool sampled, std::vector<double>& u);

}

#endif
