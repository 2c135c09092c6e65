/**
 * @file StructureRecords.h
 * @brief Helices and strands as files describe them: HELIX and SHEET of PDB, struct_conf and
 * struct_sheet_range of mmCIF.
 */
#ifndef isthmus_StructureRecords_h
#define isthmus_StructureRecords_h

#include "Molecules/Macromolecule.h"

#include <string>
#include <string_view>
#include <vector>

#include <gemmi/cifdoc.hpp>

namespace isthmus
{

/// Residues of a chain, first to last, by the authors' names and numbers.
struct StructureRange
{
  std::string Chain;
  int First = 0;
  int Last = 0;
  char FirstCode = ' '; ///< insertion codes
  char LastCode = ' ';
  unsigned char Structure = 0; ///< as Atom::Structure
};

/// The structure given by the lines before the first atom. Records that cannot be read are ignored.
std::vector<StructureRange> ReadPDBStructure(std::string_view text);

/**
 * Sets PLDDT of a predicted model in a PDB file from the B factors, in which AlphaFold, ESMFold and
 * their relatives write it. False where the title does not say so, the file names an experiment
 * (EXPDTA), or the values are not confidences: from 0 to 100 (or to 1), the same for all atoms of a
 * residue.
 */
bool ReadPDBConfidence(std::string_view text, std::vector<Atom>& atoms);

/// Rows that lack a chain or a number are ignored. Helices of ModelCIF have a type, those of the
/// PDB a class.
std::vector<StructureRange> ReadCIFStructure(gemmi::cif::Block& block);

/// Sets Structure of all atoms, 0 outside of the ranges; changes nothing if no atom is in any.
/// O(atoms + ranges) for each chain.
void SetStructure(const std::vector<StructureRange>& ranges, std::vector<Atom>& atoms);

}

#endif
