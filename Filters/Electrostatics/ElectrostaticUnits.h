/**
 * @file ElectrostaticUnits.h
 * @brief The constants for the conversion of charges, lengths and temperatures to kT/e and
 * kcal/mol.
 *
 * CODATA 2018: e, k and N_A are exact. Lengths in angstrom, charges in e, potentials in kT/e.
 */
#ifndef isthmus_ElectrostaticUnits_h
#define isthmus_ElectrostaticUnits_h

#include "Core/Geometry.h"

namespace isthmus::units
{

constexpr double ElementaryCharge = 1.602176634e-19;    ///< C
constexpr double BoltzmannConstant = 1.380649e-23;      ///< J/K
constexpr double AvogadroConstant = 6.02214076e23;      ///< 1/mol
constexpr double VacuumPermittivity = 8.8541878128e-12; ///< F/m
constexpr double JoulePerCalorie = 4.184;               ///< thermochemical
/// C = e^2 / (4 pi eps0 k T) in angstrom: the potential, in kT/e, at 1 angstrom from a charge of 1
/// e in vacuum. 560.45 at 298.15 K.
constexpr double CoulombLength(double kelvin)
{
  return 1e10 * ElementaryCharge * ElementaryCharge /
    (4.0 * Pi * VacuumPermittivity * BoltzmannConstant * kelvin);
}

/// kT in kJ/mol and in kcal/mol.
constexpr double ThermalKilojoule(double kelvin)
{
  return 1e-3 * BoltzmannConstant * AvogadroConstant * kelvin;
}
constexpr double ThermalKilocalorie(double kelvin)
{
  return ThermalKilojoule(kelvin) / JoulePerCalorie;
}

/// Limits of what is accepted, so that degrees Celsius and mmol/l are refused.
constexpr double LowestTemperature = 100.0;   ///< K
constexpr double HighestTemperature = 1000.0; ///< K
constexpr double LargestConcentration = 10.0; ///< mol/l

/// Number of ions in a cubic angstrom at 1 mol/l.
constexpr double IonsPerCubicAngstrom = AvogadroConstant * 1e-27;

}

#endif
