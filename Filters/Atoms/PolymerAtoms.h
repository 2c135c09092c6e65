/**
 * @file PolymerAtoms.h
 * @brief Which atoms of a file are the protein (or nucleic acid), and which only sit in it.
 */
#ifndef isthmus_PolymerAtoms_h
#define isthmus_PolymerAtoms_h

#include "Core/Geometry.h"
#include "vtkIsthmusFiltersAtomsModule.h"

#include <set>
#include <string>
#include <vector>

namespace isthmus
{

/// An atom with the names that a file gives it; what it does not give stays empty.
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
};

struct PolymerOptions
{
  bool Hydrogens = false;
  bool Waters = false;
  bool Ions = false;              ///< residues of one heavy atom
  bool Ligands = false;           ///< all else that is no part of a chain
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
 * their variants in force fields, and whatever a peptide (C-N) or phosphodiester (O3'-P) bond links
 * to one: modified residues, D-amino acids, caps. What the file calls HETATM is none by its name
 * alone, since a free amino acid can be the ligand. Where no residue is recognised (no names, or
 * unknown ones), all but water is kept. Of alternate locations, each residue keeps the one with the
 * greatest sum of occupancies. O(n log n).
 */
VTKISTHMUSFILTERSATOMS_EXPORT PolymerChoice ChoosePolymer(
  const std::vector<NamedAtom>& atoms, const PolymerOptions& options);

}

#endif
