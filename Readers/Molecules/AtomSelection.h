/**
 * @file AtomSelection.h
 * @brief Leaves out the atoms of a molecule that are not wanted.
 */
#ifndef isthmus_AtomSelection_h
#define isthmus_AtomSelection_h

#include "Molecules/Macromolecule.h"

namespace isthmus
{

/**
 * Keeps the atoms of the chains, alternate locations, hetero groups and water that `options` wants,
 * and the bonds between them. A blank alternate location is always wanted. With AltLoc empty, each
 * residue (chain, number, insertion code) has the location whose occupancies have the highest sum,
 * the first letter among equals; an atom that is missing there keeps its own best location, unless
 * the locations are different residues. O(n log n).
 * @throws std::runtime_error for a chain or location that is not there.
 */
void SelectAtoms(Macromolecule& molecule, const MoleculeOptions& options);

}

#endif
