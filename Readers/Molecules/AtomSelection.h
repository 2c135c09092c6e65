/**
 * @file AtomSelection.h
 * @brief Selects atoms of a molecule by the options of the reader.
 */
#ifndef isthmus_AtomSelection_h
#define isthmus_AtomSelection_h

#include "Molecules/Macromolecule.h"

namespace isthmus
{

/**
 * Keeps the atoms of the chains, alternate locations, hetero groups and water selected by
 * `options`, and the bonds between them. A blank alternate location is always kept. With AltLoc
 * empty, each residue (chain, number, insertion code) has the location whose occupancies have the
 * highest sum, or for equal sums the one with the first letter. An atom that is missing in this
 * location keeps its own best location, unless the locations are different residues. O(n log n).
 * @throws std::runtime_error for a chain or location that does not exist.
 */
void SelectAtoms(Macromolecule& molecule, const MoleculeOptions& options);

}

#endif
