/**
 * @file Dispersion.h
 * @brief The attraction between atoms and the solvent around them.
 *
 * The attractive part of a Lennard-Jones pair by Weeks, Chandler and Andersen (J. Chem. Phys. 54
 * (1971) 5237), with the well's depth eps at the distance m:
 *
 *   u(r) = -eps for r < m,   eps ((m / r)^12 - 2 (m / r)^6) beyond,
 *
 * m = R_i + R_s and eps = sqrt(eps_i eps_s) of half the minimum's distance and depth of atom and
 * solvent. Equation 4.6 of the thesis writes the pair potential with a factor of 4, as if that were
 * the depth; here eps is the depth. Of an atom a and all solvent outside of a surface,
 *
 *   rho_0 int_solvent u_a dr = rho_0 (int u_a - int_inside u_a),
 *
 * where the integral of u_a over all space is known, so that the grid's border does not matter.
 */
#ifndef isthmus_Dispersion_h
#define isthmus_Dispersion_h

#include "Atoms/MolecularDensity.h"
#include "Core/Progress.h"
#include "MolecularSurfaces/MolecularSurfaceParameters.h"
#include "MolecularSurfaces/SurfaceFlow.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h"

#include <array>
#include <vector>

namespace isthmus
{

/// Half the distance of the energy minimum of two particles of the same kind, in angstrom, and its
/// depth in kcal/mol.
struct DispersionAtom
{
  std::array<double, 3> Center;
  double Radius;
  double WellDepth;
};

/// Parameters for the pair of an atom and a solvent molecule.
struct DispersionPair
{
  DispersionPair(const DispersionAtom& atom, const SolventParameters& solvent);

  double At(double squaredDistance) const;
  /// The integral over all space.
  double Integral() const;

  double Minimum; ///< m, angstrom
  double Depth;   ///< eps, kcal/mol
};

/// Half the minimum's distance and the depth of an element by AMBER's parm99 (W. D. Cornell et al.,
/// J. Am. Chem. Soc. 117 (1995) 5179): H of alkyl groups, C sp3, N, O of carbonyl groups, F, P, S,
/// Cl, Br, I. Depth 0 for others.
std::array<double, 2> ElementDispersion(int element);

/// -V / gamma = (pressure - density U) / gamma of equation 4.9, U from atoms within 10 angstrom.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT PullField SolventPull(
  std::vector<DispersionAtom> atoms, const SolventParameters& solvent);

/// The fraction of the cell of a node that is inside a surface at the given signed distance.
double InsidePart(float distance, double spacing);

/**
 * The energy of each atom with the solvent, kcal/mol, for the surface on which `distance`
 * (angstrom, negative inside, one value for each node of `grid`) is 0. Nodes inside that are
 * farther than 12 angstrom from an atom are combined in blocks of 8^3. Second order in the spacing.
 * O(inside nodes + atoms x inside nodes within 12 angstrom); 32 bytes for each node inside.
 * Parallel, bitwise the same on any number of threads.
 * @throws Cancelled.
 */
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT std::vector<double> DispersionEnergies(
  const std::vector<DispersionAtom>& atoms, const DensityGrid& grid, const float* distance,
  const SolventParameters& solvent, const ProgressCallback& progress = {});

/// Change of the sum of these energies from one surface to another on the same grid, computed from
/// the nodes whose fraction inside has changed, without blocks. O(nodes + atoms x changed nodes);
/// parallel, bitwise the same on any number of threads.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT double DispersionChange(
  const std::vector<DispersionAtom>& atoms, const DensityGrid& grid, const float* before,
  const float* now, const SolventParameters& solvent);

}

#endif
