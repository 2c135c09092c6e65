/**
 * @file CovalentBonds.h
 * @brief Bonds found by distance.
 */
#ifndef isthmus_CovalentBonds_h
#define isthmus_CovalentBonds_h

#include "Core/Progress.h"
#include "Molecules/Macromolecule.h"

namespace isthmus
{

/**
 * Adds a bond for each pair of atoms with
 *
 *   0.4 angstrom < distance < r_1 + r_2 + 0.45 angstrom
 *
 * (E. C. Meng, R. A. Lewis, J. Comput. Chem. 12 (1991) 891, with the tolerance of Open Babel, N. M.
 * O'Boyle et al., J. Cheminform. 3 (2011) 33), where r are the covalent radii of AtomRadii.h.
 * Metals and atoms of unknown element get no bonds, nor do pairs of hydrogens or pairs of atoms in
 * different alternate locations. Existing bonds are kept; the result is sorted and has each bond
 * once.
 *
 * Time: O(n log n) for realistic densities of atoms. If more than 1000 atoms lie in a box with the
 * side of a bond length, no bonds are added, with a warning. Parallel; the result is the same on
 * any number of threads.
 */
void AddCovalentBonds(Macromolecule& molecule, const ProgressCallback& progress);

/// What of an atom decides its bonds.
struct BondingAtom
{
  std::array<double, 3> Position;
  int Element;
  char AltLoc;
};

/// The same bonds of atoms without names, in any order. Empty, and `isCrowded` true, where there
/// are too many atoms in one place.
std::vector<Bond> FindCovalentBonds(
  const std::vector<BondingAtom>& atoms, bool& isCrowded, const ProgressCallback& progress = {});

/// Sorts the bonds and keeps one for each pair of atoms, preferably that of the file.
void SortBonds(Macromolecule& molecule);

}

#endif
