/**
 * @file AtomElements.h
 * @brief Elements of atoms, with and without a column that gives them.
 *
 * An element that the file gives (PDB: columns 77-78) is taken, unless it cannot be (oganesson in a
 * serine, where OG in the wrong column is meant). Files of CHARMM, VMD, NAMD, older GROMACS and
 * AMBER have none. There, in this order:
 *
 * - residue and atom name: amino acids, nucleotides, lipids, waters, ions and cofactors by their
 *   names in the PDB, CHARMM, AMBER, GROMACS and OPLS;
 * - the columns of the name: wwPDB's format has symbols right-justified in columns 13-14, so " CA "
 *   is carbon and "CA  " calcium. This is used where names of known residues follow it;
 * - the letters of the name (ChemicalElement.h).
 *
 * A metal that has a neighbour as near as in a covalent bond is none (CA of a ligand at 1.5
 * angstrom from another atom is carbon).
 *
 * Beads of coarse-grained models (Martini), ghost and dummy atoms and virtual sites get element 0.
 */
#ifndef isthmus_AtomElements_h
#define isthmus_AtomElements_h

#include "Molecules/ReadingReport.h"
#include "vtkIsthmusReadersMoleculesModule.h"

#include <array>
#include <cstddef>
#include <functional>
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

/// The family of a residue by its name alone.
VTKISTHMUSREADERSMOLECULES_EXPORT ResidueFamily FamilyOfResidue(std::string_view name);

/// Is this a name of four letters that simulation programs give residues (TIP3, POPC, LYSH)?
VTKISTHMUSREADERSMOLECULES_EXPORT bool IsLongResidueName(std::string_view name);

/// Ghost atoms, dummies, lone pairs and virtual sites, by name or symbol: Bq, X1, EPW, Gh(C), `@H`.
VTKISTHMUSREADERSMOLECULES_EXPORT bool IsDummyName(std::string_view name);

/// Columns of an atom's line, blanks included.
struct AtomColumns
{
  std::array<char, 4> Name{ ' ', ' ', ' ', ' ' }; ///< 13-16
  std::array<char, 2> Symbol{ ' ', ' ' };         ///< 77-78
};

/// Where a format has the elements of atoms.
enum class ElementColumn
{
  PDB,   ///< columns 77-78
  Table, ///< a column of mmCIF's table
  None   ///< none has them: deciding them is worth a note only
};

/**
 * Sets the elements of `atoms`. Residue r consists of atoms [starts[r], starts[r + 1]), the last
 * one of those to the end. `report` gets how many atoms were decided how. O(atoms).
 */
VTKISTHMUSREADERSMOLECULES_EXPORT void SetElements(std::vector<Atom>& atoms,
  const std::vector<AtomColumns>& columns, const std::vector<std::size_t>& starts,
  ReadingReport& report, ElementColumn column = ElementColumn::PDB);

/**
 * The same for formats without PDB's columns: the element that an atom has is that of the file, 0
 * if it has none. Names are not right-justified; residues follow each other. `isDummy`: the file's
 * symbol means no element.
 */
VTKISTHMUSREADERSMOLECULES_EXPORT void SetElements(std::vector<Atom>& atoms, ReadingReport& report,
  ElementColumn column, const std::function<bool(const Atom&)>& isDummy = {});

/// Warns of atoms without element, in formats where types or symbols mean elements.
void ReportMissingElements(const std::vector<Atom>& atoms, ReadingReport& report);

}

#endif
