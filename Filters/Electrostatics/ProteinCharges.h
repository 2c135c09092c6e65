/**
 * @file ProteinCharges.h
 * @brief Hydrogens, charges and radii of a force field for a protein or nucleic acid, by pdb2pqr.
 *
 * T. J. Dolinsky et al., Nucleic Acids Res. 32 (2004) W665; E. Jurrus et al., Protein Sci. 27
 * (2018) 112. The program runs as a child process; its input is a file in PDB columns, its output a
 * file of words separated by blanks. Protonation states are those of the force field at pH 7, or by
 * PROPKA (C. R. Sondergaard et al., J. Chem. Theory Comput. 7 (2011) 2284), and hydrogens are
 * placed by geometry.
 */
#ifndef isthmus_ProteinCharges_h
#define isthmus_ProteinCharges_h

#include "Atoms/PolymerAtoms.h"
#include "Core/ChildProcess.h"

namespace isthmus
{

enum class ChargeTable
{
  AMBER = 0, ///< W. D. Cornell et al., J. Am. Chem. Soc. 117 (1995) 5179
  PARSE = 1  ///< D. Sitkoff, K. Sharp, B. Honig, J. Phys. Chem. 98 (1994) 1978
};

struct ChargeOptions
{
  ChargeOptions(ChargeTable table = ChargeTable::AMBER) // NOLINT(google-explicit-constructor)
    : Table(table)
  {
  }

  ChargeTable Table;
  /// Protonation states by PROPKA at PH, instead of those of the force field at pH 7.
  bool UsePropka = false;
  double PH = 7.0; ///< 0 to 14
};

/// @throws std::invalid_argument with property, value and range.
void Check(const ChargeOptions& options);

/// An atom with the charge of the force field, or of a ligand.
struct ForceFieldAtom
{
  Point3 Place{ 0.0, 0.0, 0.0 }; ///< angstrom
  double Charge = 0.0;           ///< e
  double Radius = 0.0;           ///< angstrom
  std::string Name;              ///< the force field's, and its residue's
  std::string Residue;
  std::size_t SourceAtom =
    0; ///< the corresponding atom of the input or, if there is none, another of the same residue
  bool IsNew = false; ///< not in the input: hydrogens, heavy atoms that were missing
};

struct ChargedProtein
{
  std::vector<ForceFieldAtom> Atoms;
  /// Residues that the force field does not know, as indices of their atoms.
  std::vector<std::vector<std::size_t>> Uncharged;
  std::string Warning; ///< atoms that were lost or built; empty: none but water and hydrogens
  std::vector<std::string> Notes; ///< hydrogens that were dropped
};

/**
 * Runs pdb2pqr (or pdb2pqr30), which is searched for on PATH. Water is dropped. Copies of a chain
 * under one name (an atom that comes twice in a residue) are separate chains. Of alternate
 * locations, each residue has the most occupied one. Atoms at which the program stops because its
 * force field does not know them are left out, one after the other: hydrogens with a note, others
 * with the warning.
 *
 * What comes back is compared atom by atom with what went in: the warning lists all atoms other
 * than hydrogens that are missing in residues that have charges, and counts those that were built.
 * A phosphate at the 5' end, which the program removes, is restored with one proton (-1 e) where
 * another residue has one, with a note.
 * @throws std::invalid_argument for options out of range, for molecules that a PDB file cannot
 * contain (more than 62 chains, more than 9,999 residues in one chain, coordinates beyond +-9,999),
 * and if no atom has a residue name.
 * @throws std::runtime_error if the program is not installed, fails or exceeds `limits`.
 */
ChargedProtein ChargeProtein(const std::vector<NamedAtom>& atoms, const ChargeOptions& options,
  const ChildLimits& limits, const ProgressCallback& progress = {});

/// An atom of a molecule with charges, e.g. of a MOL2 or PQR file.
struct LigandAtom
{
  NamedAtom Named;
  double Charge; ///< e; NaN: none
  double Radius; ///< angstrom
};

/**
 * Adds residues without charges whose heavy atoms are all among `ligands`, and removes them from
 * Uncharged. Atoms are the same where element and place (0.5 angstrom) are; then hydrogens of the
 * ligand are added, too. Otherwise they are the same by residue and atom name; then the charges of
 * hydrogens that the residue lacks are added to the atoms nearest to them in the ligand. Notes say
 * which residues these are.
 */
void AddLigandCharges(const std::vector<NamedAtom>& atoms, const std::vector<LigandAtom>& ligands,
  ChargedProtein& protein);

/// "The force field has no charges for ..." with the formal charges of the file (NaN: none), one
/// for each atom; empty where all residues have charges.
std::string DescribeUncharged(const std::vector<NamedAtom>& atoms,
  const std::vector<double>& formalCharges, const ChargedProtein& protein);

}

#endif
