/**
 * @file AtomElements.h
 * @brief Elements of atoms, from a column of the file or inferred without one.
 *
 * An element given by the file (PDB: columns 77-78) is used unless it is impossible (oganesson in a
 * serine, caused by OG in the wrong column). Files of CHARMM, VMD, NAMD, older GROMACS and AMBER
 * have no elements. There, in this order:
 *
 * - residue and atom name: amino acids, nucleotides, lipids, waters, ions and cofactors by their
 *   names in the PDB, CHARMM, AMBER, GROMACS and OPLS;
 * - the columns of the name: wwPDB's format has symbols right-justified in columns 13-14, so " CA "
 *   is carbon and "CA  " calcium. This is used where names of known residues follow it;
 * - the letters of the name (ChemicalElement.h).
 *
 * An apparent metal with a neighbour at the distance of a covalent bond is not a metal (CA of a
 * ligand at 1.5 angstrom from another atom is carbon).
 *
 * Beads of coarse-grained models (Martini), ghost and dummy atoms and virtual sites get element 0.
 */
#ifndef isthmus_AtomElements_h
#define isthmus_AtomElements_h

#include "Molecules/ReadingReport.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace isthmus
{

enum class ResidueFamily
{
  Unknown,
  AminoAcid,
  Nucleotide,
  Water,
  Lipid,
  Cofactor
};

/// The family of a residue, determined only by its name.
ResidueFamily FindResidueFamily(std::string_view name);

/// Whether this is a name of four letters that simulation programs use for residues (TIP3, POPC,
/// LYSH).
bool IsLongResidueName(std::string_view name);

/// Ghost atoms, dummies, lone pairs and virtual sites, by name or symbol: Bq, X1, EPW, Gh(C), `@H`.
bool IsDummyName(std::string_view name);

/// Columns of an atom's line, blanks included.
struct AtomColumns
{
  std::array<char, 4> Name{ ' ', ' ', ' ', ' ' }; ///< 13-16
  std::array<char, 2> Symbol{ ' ', ' ' };         ///< 77-78
};

/// The source of the elements of atoms in a format.
enum class ElementColumn
{
  PDB,   ///< columns 77-78
  Table, ///< a column of mmCIF's table
  None   ///< none has them: inferring them causes only a note
};

/**
 * Sets the elements of `atoms`. Residue r consists of the atoms [starts[r], starts[r + 1]), and the
 * last one extends to the end. `report` gets the number of atoms decided in each way. O(atoms).
 */
void SetElements(std::vector<Atom>& atoms, const std::vector<AtomColumns>& columns,
  const std::vector<std::size_t>& starts, ReadingReport& report,
  ElementColumn column = ElementColumn::PDB);

/**
 * The same for formats without PDB's columns: the given element of an atom is that of the file, or
 * 0 if there is none. Names are not right-justified; residues are consecutive. `isDummy`: of each
 * atom, whether its symbol in the file denotes no element; empty: of none.
 */
void SetElements(std::vector<Atom>& atoms, ReadingReport& report, ElementColumn column,
  const std::vector<bool>& isDummy = {});

/// Warns about atoms without an element, in formats in which types or symbols denote elements.
void ReportMissingElements(const std::vector<Atom>& atoms, ReadingReport& report);

}

#endif
