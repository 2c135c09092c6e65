/**
 * @file ProteinCharges.h
 * @brief Hydrogens, charges and radii of a force field for a protein or nucleic acid, by pdb2pqr.
 *
 * T. J. Dolinsky et al., Nucleic Acids Res. 32 (2004) W665; E. Jurrus et al., Protein Sci. 27
 * (2018) 112. The program runs as a child process; its input is a file in PDB columns, its output a
 * file of words separated by blanks. Protonation states are those of the force field at pH 7, and
 * hydrogens are placed by geometry.
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

/// An atom for which the force field has parameters.
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
  std::string Warning; ///< what was dropped or built; empty if only water and hydrogens
};

/**
 * Runs pdb2pqr (or pdb2pqr30), which is searched for on PATH. Water is dropped; so is each residue
 * that the force field does not know (ligands, ions, modified residues), which the warning names.
 * @throws std::invalid_argument for molecules that a PDB file cannot contain (more than 62 chains,
 * more than 9,999 residues in one chain, coordinates beyond +-9,999), and if no atom has a residue
 * name.
 * @throws std::runtime_error if the program is not installed, fails or exceeds `limits`.
 */
ChargedProtein ChargeProtein(const std::vector<NamedAtom>& atoms, ChargeTable table,
  const ChildLimits& limits, const ProgressCallback& progress = {});

}

#endif
