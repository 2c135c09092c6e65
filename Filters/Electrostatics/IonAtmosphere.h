/**
 * @file IonAtmosphere.h
 * @brief The charge of a salt in the potential, and where its ions get.
 */
#ifndef isthmus_IonAtmosphere_h
#define isthmus_IonAtmosphere_h

#include "InterfaceGeometry.h"
#include "vtkIsthmusModule.h"

namespace isthmus
{

/**
 * Boltzmann's ions: with C the Coulomb length and c_j the bulk density of species j,
 *
 *     -div(eps grad u) + f(u) = 0,   f(u) = -4 pi C sum_j z_j c_j exp(-z_j u),
 *
 * eps_s kappa^2 sinh u for a 1:1 salt. Beyond |u| = 50 the function goes on linearly, which no
 * solution feels but an iteration may.
 */
class VTKISTHMUS_EXPORT IonAtmosphere
{
public:
  /// Throws std::invalid_argument for concentrations that are negative and charges that don't
  /// cancel.
  IonAtmosphere(const std::vector<IonSpecies>& species, double kelvin);

  bool Empty() const { return this->Species.empty(); }
  double Charge(double u) const;
  double Derivative(double u) const;
  /// eps_s kappa^2 = f'(0).
  double Linear() const { return this->Derivative(0.0); }
  /// Energy of the ions at a point, kT per cubic angstrom: -1/2 rho u - sum c (exp(-z u) - 1).
  double Energy(double u) const;

private:
  std::vector<IonSpecies> Species; ///< with concentrations in 1 / cubic angstrom
  double Factor;                   ///< 4 pi C
};

/**
 * The part of each node's cell that ions reach: 0 inside and within `layer` (angstrom) of the
 * surface, 1 beyond, clamp(1/2 + D / h) where that border, at signed distance D, cuts the cell.
 * Distances are those to the osculating paraboloid of the nearest crossing. With layer 0: 0 inside,
 * 1 outside. O(nodes + crossings layer^3 / h^3), serial.
 */
VTKISTHMUS_EXPORT std::vector<float> IonAccess(const SolverBox& box,
  const std::vector<unsigned char>& inside, const std::vector<InterfaceCrossing>& crossings,
  double layer);

}

#endif
