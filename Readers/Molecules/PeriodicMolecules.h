/**
 * @file PeriodicMolecules.h
 * @brief Makes molecules whole that a simulation program has broken at its periodic box.
 */
#ifndef isthmus_PeriodicMolecules_h
#define isthmus_PeriodicMolecules_h

#include "Molecules/Macromolecule.h"

#include <array>
#include <vector>

namespace isthmus
{

/// The vectors of a cell with these lengths (angstrom) and angles (degrees), a along x and b in the
/// plane of x and y; empty if they are no cell, or a dummy as CRYST1 of structures by NMR.
std::vector<std::array<double, 3>> CellVectors(
  const std::array<double, 3>& lengths, const std::array<double, 3>& angles);

/**
 * Makes molecules whole by the cell, if any are broken.
 *
 * Bonds by distance are found with the nearest images of atoms. A molecule is broken where atoms of
 * one residue, or of adjacent ones, are bonded to images of each other: bonds to symmetry mates in
 * crystals are not. The atoms of a broken molecule are moved by whole cells, so that its bonds are
 * short; most of them stay where they are. Molecules that are bonded to their own images (crystals
 * of minerals, tubes) stay as they are. Then chains are moved by whole cells to where they have
 * most contacts (5 angstrom) with larger ones, and so are other molecules with names that few have
 * (ligands). Notes say how many molecules and atoms were moved.
 *
 * Where there is no cell, or it does not help, one warning names the first residue that is torn: an
 * amino acid or nucleotide with atoms more than 20 angstrom apart, or neighbours in a chain that
 * are apart along one axis by more than 15 angstrom and along the others by less than a bond.
 *
 * `addBonds`: adds bonds that had crossed the box. O(n log n); O(n) where no atoms are a cell
 * apart.
 */
void MakeMoleculesWhole(Macromolecule& molecule, bool addBonds);

}

#endif
