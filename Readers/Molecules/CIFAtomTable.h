/**
 * @file CIFAtomTable.h
 * @brief The atom table of a CIF block, completed for gemmi's mmCIF reader.
 *
 * gemmi reads `_atom_site` of PDBx/mmCIF only with all columns that files of the PDB have.
 * Predictors, refinement programs and exporters write fewer, and other kinds of CIF have other
 * tables:
 *
 * - PDBx/mmCIF: coordinates and the name of the atom are enough. Columns that are missing are
 *   added, with values of the matching auth_ or label_ column if there is one, otherwise as
 *   unknown; elements are inferred from the names (ChemicalElement.h).
 * - core CIF of small molecules (`_atom_site_label`, `_atom_site_fract_x`; COD, CSD, ICSD):
 *   fractional coordinates are converted with the cell. Symmetry is not applied. U_iso is converted
 *   to B, and disorder groups become alternate locations.
 * - chemical components (`_chem_comp_atom`; CCD of the PDB, monomer libraries): ideal coordinates
 *   where they are complete, else those of the example.
 *
 * Rows without coordinates (`?`, `.`, NaN, infinite) are dropped, with a warning and their number.
 */
#ifndef isthmus_CIFAtomTable_h
#define isthmus_CIFAtomTable_h

#include "Molecules/ReadingReport.h"
#include "Molecules/StructureRecords.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gemmi/cifdoc.hpp>

namespace isthmus
{

/// The changes of CompleteAtomTable to a block.
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
  std::size_t Rows = 0; ///< with coordinates
  /// Bonds of chemical components: component (empty: not given) and names of both atoms.
  std::vector<std::array<std::string, 3>> Bonded;
  /// pLDDT of ModelCIF, 0 to 100, by model (from 0), label_asym_id and label_seq_id.
  std::map<std::tuple<std::int64_t, std::string, std::string>, double> Confidence;
  /// Ids of atoms whose symbols in the file do not denote an element.
  std::set<int> Dummies;
  std::vector<StructureRange> Structure; ///< helices and strands
  ReadingReport Report;
};

/**
 * Converts the atom table of `block` to the form that gemmi reads. O(values).
 * @throws std::invalid_argument if no row has coordinates, a cell is missing for fractional
 * coordinates, or there is no column of names.
 */
CIFAtoms CompleteAtomTable(gemmi::cif::Block& block);

}

#endif
