/**
 * @file DispersionIntegral.h
 * @brief The attraction between atoms and all solvent outside of a surface.
 *
 *   rho_0 int_solvent u_a dr = rho_0 (int u_a - int_inside u_a),
 *
 * u_a the pair of atom and solvent (Dispersion.h), whose integral over all space is known: so no
 * border cuts it off.
 */
#ifndef isthmus_DispersionIntegral_h
#define isthmus_DispersionIntegral_h

#include "Atoms/MolecularDensity.h"
#include "Core/Progress.h"
#include "MolecularSurfaces/Dispersion.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h"

#include <vector>

namespace isthmus
{

/// The part of a node's cell that is inside a surface at a signed distance from it.
double InsidePart(float distance, double spacing);

/**
 * That energy of each atom, kcal/mol, for the surface on which `distance` (angstrom, negative
 * inside, one value a node of `grid`) is 0. Inside nodes farther than 12 angstrom from an atom act
 * on it by blocks of 8^3. Second order in the spacing. O(inside nodes + atoms x inside nodes within
 * 12 angstrom), half a nanosecond or so for each pair of the latter; 32 bytes an inside node.
 * Parallel, the same bits on any number of threads.
 * @throws Cancelled.
 */
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT std::vector<double> DispersionEnergies(
  const std::vector<DispersionAtom>& atoms, const DensityGrid& grid, const float* distance,
  const SolventParameters& solvent, const ProgressCallback& progress = {});

/// How much the sum of these energies changes from one surface to another on the same grid: by the
/// nodes whose part inside has changed, of which none counts by its block. O(nodes + atoms x
/// these); parallel, the same bits on any number of threads.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT double DispersionChange(
  const std::vector<DispersionAtom>& atoms, const DensityGrid& grid, const float* before,
  const float* now, const SolventParameters& solvent);

}

#endif
