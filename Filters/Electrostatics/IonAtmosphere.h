/**
 * @file IonAtmosphere.h
 * @brief The charge of a salt in the potential.
 */
#ifndef isthmus_IonAtmosphere_h
#define isthmus_IonAtmosphere_h

#include "Electrostatics/PoissonBoltzmannParameters.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

#include <cstddef>

namespace isthmus
{

/**
 * Boltzmann's ions: with C the Coulomb length and c_j the bulk density of species j,
 *
 *     -div(eps grad u) + f(u) = 0,   f(u) = -4 pi C sum_j z_j c_j exp(-z_j u),
 *
 * eps_s kappa^2 sinh u for a 1:1 salt. Beyond |u| = 50 the function is continued linearly, which
 * affects no solution but may affect an iteration. Ions of the same radius form a layer. A layer is
 * neutral only together with the others, so between the radii of two layers there is charge even
 * where u is 0. (The linear equation omits this charge, since it describes only the response to the
 * solute.)
 */
class VTKISTHMUSFILTERSELECTROSTATICS_EXPORT IonAtmosphere
{
public:
  /// Throws std::invalid_argument if concentrations are negative or charges do not cancel.
  IonAtmosphere(const std::vector<IonSpecies>& species, double kelvin);

  bool Empty() const { return this->Layers.empty(); }
  double Charge(double u) const;
  double Derivative(double u) const;
  /// eps_s kappa^2 = f'(0).
  double Linear() const { return this->Derivative(0.0); }
  /// Energy of the ions at a point, kT per cubic angstrom: -1/2 rho u - sum c (exp(-z u) - 1).
  double Energy(double u) const;

  ///@{
  /// The ions of one radius.
  std::size_t NumberOfLayers() const { return this->Layers.size(); }
  /// In angstrom; below 0 if the species have no radius of their own.
  double LayerRadius(std::size_t layer) const { return this->Layers[layer].Radius; }
  double Charge(std::size_t layer, double u) const;
  double Derivative(std::size_t layer, double u) const;
  double Energy(std::size_t layer, double u) const;
  /// Osmotic pressure above that of the bulk, kT per cubic angstrom: sum c (exp(-z u) - 1).
  double Pressure(std::size_t layer, double u) const;
  /// The same for the linear equation: sum c z^2 u^2 / 2.
  double LinearPressure(std::size_t layer, double u) const;
  ///@}

private:
  struct Layer
  {
    double Radius;
    std::vector<IonSpecies> Ions; ///< with concentrations in 1 / cubic angstrom
  };

  template <class Term>
  double Sum(const Term& term) const
  {
    double sum = 0.0;
    for (std::size_t l = 0; l < this->Layers.size(); ++l)
    {
      sum += term(l);
    }
    return sum;
  }

  std::vector<Layer> Layers;
  double Factor; ///< 4 pi C
};

}

#endif
