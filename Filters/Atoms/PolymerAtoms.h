/**
 * @file PolymerAtoms.h
 * @brief Determines which atoms of a file belong to the protein (or nucleic acid), and which are
 * only bound to it.
 */
#ifndef isthmus_PolymerAtoms_h
#define isthmus_PolymerAtoms_h

#include "Core/Geometry.h"
#include "vtkIsthmusFiltersAtomsModule.h"

#include <limits>
#include <set>
#include <string>
#include <vector>

namespace isthmus
{

/// An atom with its names in a file; names that the file lacks are empty.
struct NamedAtom
{
  Point3 Place{ 0.0, 0.0, 0.0 };
  int Element = 0; ///< 0: unknown
  std::string Name;
  std::string Residue;
  std::string Chain;
  int ResidueId = 0;
  std::string InsertionCode;
  std::string AltLoc;
  double Occupancy = 1.0;
  bool IsHetero = false;
  double Confidence = std::numeric_limits<double>::quiet_NaN(); ///< pLDDT, 0 to 100; NaN: none
};

struct PolymerOptions
{
  bool Hydrogens = false;
  bool Waters = false;
  bool Ions = false;              ///< residues of one heavy atom
  bool Ligands = false;           ///< everything else that is not part of a chain
  bool ProstheticGroups = false;  ///< hemes, flavins, iron-sulphur clusters, chlorophylls, ...
  std::set<std::string> Residues; ///< always kept
};

struct PolymerChoice
{
  std::vector<std::size_t> Kept;  ///< ascending
  std::vector<std::string> Notes; ///< one message for each kind of atom that was dropped
  bool AnyChain = false;          ///< whether a residue of a chain was recognised
};

/**
 * Keeps the residues of chains: those with a name of the twenty amino acids, the nucleotides and
 * their variants in force fields, and all residues linked to one by a peptide (C-N) or
 * phosphodiester (O3'-P) bond: modified residues, D-amino acids, caps. HETATM residues do not count
 * as part of a chain by their name alone, since a free amino acid can be the ligand. If no residue
 * is recognised (no names, or unknown ones), everything except water is kept. Of alternate
 * locations, each residue keeps the one with the greatest sum of occupancies. O(n log n).
 */
VTKISTHMUSFILTERSATOMS_EXPORT PolymerChoice ChoosePolymer(
  const std::vector<NamedAtom>& atoms, const PolymerOptions& options);

/**
 * Says where side chains or bases are missing, so that pockets, pores and surfaces are not those of
 * the molecule: chains of at least five residues, more than half of which have only C-alpha, only
 * the backbone (with C-beta), or nucleotides only the phosphorus or the backbone. Glycine and
 * alanine count where their backbone is not complete. Residues with atoms of other names (beads)
 * do not count. Empty: nothing is missing. O(n log n).
 */
VTKISTHMUSFILTERSATOMS_EXPORT std::string DescribeMissingSideChains(
  const std::vector<NamedAtom>& atoms);

}

#endif
