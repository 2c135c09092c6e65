/**
 * @file CIFAtoms.h
 * @brief Atoms of a CIF block, whichever table it has.
 *
 * - PDBx/mmCIF (`_atom_site`): coordinates and the name of the atom are enough. Chain, residue and
 *   atom names are the authors' (auth_), or where these are missing or unknown, the others
 *   (label_); elements that the file does not give are inferred from names.
 * - core CIF of small molecules (`_atom_site_label`, `_atom_site_fract_x`; COD, CSD, ICSD):
 *   fractional coordinates are converted with the cell. Symmetry is not applied. U_iso is converted
 *   to B, and disorder groups become alternate locations.
 * - chemical components (`_chem_comp_atom`; CCD of the PDB, monomer libraries): ideal coordinates
 *   where they are complete, else those of the example.
 *
 * Rows without coordinates (`?`, `.`, NaN, infinite) are dropped, with a warning and their number.
 */
#ifndef isthmus_CIFAtoms_h
#define isthmus_CIFAtoms_h

#include "Molecules/ReadingReport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gemmi/cifdoc.hpp>

namespace isthmus
{

/// The text of a value: without quotes, empty where it is unknown.
std::string_view CIFText(const std::string& value);

/// The number that a value is, without its standard deviation in parentheses; NaN: none.
double CIFNumber(const std::string& value);

struct CIFAtoms
{
  enum class Source
  {
    None, ///< the block has no atoms
    MMCIF,
    CoreCIF,
    ChemicalComponent
  };

  Source From = Source::None;
  std::vector<Atom> Atoms;   ///< of all models, in the order of the file
  std::vector<int> Model;    ///< of each atom, from 0; empty: there is one
  std::vector<bool> IsDummy; ///< atoms whose symbols denote no element; empty: none
  int NumberOfModels = 0;
  /// label_asym_id and label_seq_id of each atom; views of the block. Empty if they are not read.
  std::vector<std::array<std::string_view, 2>> Labels;
  /// Bonds of chemical components: component (empty: not given) and names of both atoms.
  std::vector<std::array<std::string, 3>> Bonded;
  ReadingReport Report;
};

/**
 * Reads the table of atoms. `withLabels`: Labels are needed. O(values).
 * @throws std::invalid_argument if no row has coordinates, a cell is missing for fractional
 * coordinates, there is no column of names, or a whole number has more than nine digits.
 */
CIFAtoms ReadCIFAtoms(gemmi::cif::Block& block, bool withLabels);

/// The vectors of the cell; empty: there is none.
std::vector<std::array<double, 3>> ReadCIFCell(gemmi::cif::Block& block);

/// The Hermann-Mauguin symbol of the space group; empty: there is none.
std::string ReadCIFSpaceGroup(gemmi::cif::Block& block);

}

#endif
