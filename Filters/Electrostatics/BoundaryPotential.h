/**
 * @file BoundaryPotential.h
 * @brief The potential on the border of the box: Debye-Hueckel sums.
 */
#ifndef isthmus_BoundaryPotential_h
#define isthmus_BoundaryPotential_h

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

}

#endif
