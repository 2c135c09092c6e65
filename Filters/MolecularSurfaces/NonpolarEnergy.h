/**
 * @file NonpolarEnergy.h
 * @brief The nonpolar solvation energy of atoms within a surface, in total and for each atom.
 *
 *   G = gamma Area + p Vol + rho_0 int_solvent U dr
 *
 * (thesis 4.3 to 4.6; J. A. Wagoner, N. A. Baker, Proc. Natl. Acad. Sci. 103 (2006) 8331), and U is
 * the sum of the attraction of the atoms, see Dispersion.h.
 */
#ifndef isthmus_NonpolarEnergy_h
#define isthmus_NonpolarEnergy_h

#include "Atoms/MolecularDensity.h"
#include "Core/Progress.h"
#include "MolecularSurfaces/Dispersion.h"

#include <vector>

namespace isthmus
{

/// Lengths in angstrom, energies in kcal/mol.
struct NonpolarTerms
{
  double Area = 0.0;
  double Volume = 0.0;
  double SurfaceEnergy = 0.0;    ///< gamma Area
  double VolumeEnergy = 0.0;     ///< p Vol
  double DispersionEnergy = 0.0; ///< rho_0 int U

  double Total() const { return this->SurfaceEnergy + this->VolumeEnergy + this->DispersionEnergy; }
};

struct NonpolarEnergies
{
  NonpolarTerms Whole;
  /// Area and volume are assigned to the atom whose ball is nearest, dispersion to the atom that
  /// causes it. The contributions add up to the total.
  std::vector<NonpolarTerms> Atoms;
  /// Of area and volume, estimated from every other node, times tension and pressure, kcal/mol.
  double Error = 0.0;
};

/// @throws std::invalid_argument if values at the border are not above 0, so that the surface is
/// not closed, or if the gradient at the surface is not about 1, so that they are no distances.
/// O(nodes).
void RequireDistances(const DensityGrid& grid, const std::vector<float>& distance);

/**
 * Energies of the surface on which `distance` (angstrom, negative inside, one value for each node
 * of `grid`) is 0. `balls` and `atoms` are the same atoms in the same order. Second order in the
 * spacing. Time and memory are those of DispersionEnergies() and 17 bytes for each node. The result
 * is bitwise the same on any number of threads. Throws std::invalid_argument for lists of different
 * lengths, and Cancelled.
 */
NonpolarEnergies NonpolarEnergy(const std::vector<Ball>& balls,
  const std::vector<DispersionAtom>& atoms, const DensityGrid& grid, const float* distance,
  const SolventParameters& solvent, const ProgressCallback& progress = {});

}

#endif
