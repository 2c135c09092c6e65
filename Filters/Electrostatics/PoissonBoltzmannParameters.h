/**
 * @file PoissonBoltzmannParameters.h
 * @brief Parameters and results of the Poisson-Boltzmann solver.
 */
#ifndef isthmus_PoissonBoltzmannParameters_h
#define isthmus_PoissonBoltzmannParameters_h

#include "Core/Geometry.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace isthmus
{

/// Position and radius in angstrom, charge in e.
struct ChargedAtom
{
  Point3 Position;
  double Charge;
  double Radius;
};

/// One kind of ion of the salt: valence (with sign), concentration in mol/l, and its closest
/// distance to the surface in angstrom; if that is below 0, PoissonBoltzmannParameters::IonRadius
/// is used.
struct IonSpecies
{
  double Valence;
  double Concentration;
  double Radius = -1.0;
};

enum class BoundaryCondition
{
  Zero = 0,                 ///< u = 0
  SingleDebyeHueckel = 1,   ///< the net charge at the center of charge, in a sphere of the solute
  MultipleDebyeHueckel = 2, ///< each charge alone
  SelfConsistent = 3, ///< the former, corrected by the continuation of a solution on a coarser grid
  Given = 4           ///< by PoissonBoltzmannParameters::Boundary
};

/// Treatment of the jump of the dielectric constant at the surface.
enum class DielectricModel
{
  SharpInterface = 0, ///< jump conditions, fitted: InterfaceJumpConditions.h
  SmoothDielectric =
    1 ///< a permittivity for each edge, of its parts in series: InterfaceExtrapolation.h
};

/// A grid around a molecule, in angstrom.
struct GridRequest
{
  double Spacing = 0.5;
  double Padding = 10.0; ///< of solvent around the surface, at least
};

/// @throws std::invalid_argument with property, value and range; so does the other function of this
/// name.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT void Check(const GridRequest& request);

/// Spacing is that of a grid which is made for the solver; given ones have their own.
struct PoissonBoltzmannParameters : GridRequest
{
  isthmus::DielectricModel DielectricModel = isthmus::DielectricModel::SharpInterface;
  double SoluteDielectric = 2.0;
  double SolventDielectric = 80.0;
  double IonicStrength = 0.0;   ///< mol/l of a 1:1 salt, where there are no Ions
  std::vector<IonSpecies> Ions; ///< instead of the salt; their charges must cancel
  double IonRadius = 2.0;       ///< angstrom: ions without a radius keep that far from the surface
  double Temperature = 298.15;  ///< K
  bool Nonlinear = false;
  isthmus::BoundaryCondition BoundaryCondition = isthmus::BoundaryCondition::SelfConsistent;
  double Tolerance = 1e-6;     ///< of the residual, relative to the initial one
  int MaximumIterations = 100; ///< of BiCGSTAB in each linear system
  int MaximumNewtonSteps = 30;
  /// Weight of the equations inside relative to those outside in the fits at the surface, as a
  /// power of SoluteDielectric / SolventDielectric.
  double FitExponent = 1.5;
  /// Potential (kT/e) on the border of the box, for Given; in the frame of the level set's grid.
  std::function<double(const Point3&)> Boundary;
  /// Potential to start from, if any, on the whole box.
  std::function<double(const Point3&)> Start;

  /// Ions, or those of the 1:1 salt.
  std::vector<IonSpecies> AllIons() const
  {
    const double c = this->IonicStrength;
    return this->Ions.empty() && c > 0.0 ? std::vector<IonSpecies>{ { 1.0, c }, { -1.0, c } }
                                         : this->Ions;
  }
};

VTKISTHMUSFILTERSELECTROSTATICS_EXPORT void Check(const PoissonBoltzmannParameters& parameters);

/// Numbers about a solution. Energies in kT.
struct PoissonBoltzmannReport
{
  double SolvationEnergy = 0.0;       ///< 1/2 sum q u, and the ions' term where nonlinear
  double SolvationEnergyError = 0.0;  ///< estimated (EstimateEnergyError), if that was done
  double IonEnergy = 0.0;             ///< that term alone
  std::vector<double> AtomEnergies;   ///< 1/2 q u of each atom
  std::vector<double> AtomPotentials; ///< reaction potential u at each atom, kT/e
  std::vector<Point3> AtomForces;     ///< -q grad u, kT/angstrom, along the grid's axes
  int Iterations = 0;                 ///< of BiCGSTAB on this grid, in all solutions on it
  int BorderIterations = 0;           ///< of BiCGSTAB on a coarser grid, for the border
  int NewtonSteps = 0;                ///< of the last solution
  std::vector<double> Residuals;      ///< relative, after each iteration of the last solution
  double Reference = 0.0;             ///< what they are relative to, where linear: a norm
  std::int64_t Crossings = 0;         ///< of the surface with edges of the grid
  std::int64_t LinearFits = 0;        ///< of them, those for which a quadratic could not be fitted
  std::int64_t GhostFits = 0;         ///< and not even a linear function
};

}

#endif
