/**
 * @file CoordinateUnits.h
 * @brief The unit of length of a file: rescaling, and whether the distances of atoms fit it.
 */
#ifndef isthmus_CoordinateUnits_h
#define isthmus_CoordinateUnits_h

#include "Molecules/Macromolecule.h"

namespace isthmus
{

/// Converts coordinates and cell from `unit` to angstrom, if it is another one than the format's.
void ConvertUnit(Macromolecule& molecule, CoordinateUnit unit);

/**
 * Whether atoms lie at distances that fit angstrom. The nearest neighbour of an atom is 0.7 to 7
 * angstrom away in molecules, also where only C-alphas or phosphates are there. Where the median
 * over at most 1,000 atoms is below 0.75 or above 8 angstrom, and nearly all distances are a tenth
 * or ten times of what they should be, a warning with these distances says which unit to choose.
 * Atoms without an element (beads) do not count. O(1) for sound files, else O(n log n).
 * @return false if the atoms are too close to each other to look for bonds.
 */
bool CheckDistances(Macromolecule& molecule, CoordinateUnit unit);

}

#endif
