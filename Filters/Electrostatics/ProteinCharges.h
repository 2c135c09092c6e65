/**
 * @file ProteinCharges.h
 * @brief Hydrogens, charges and radii of a force field for a protein or nucleic acid, by pdb2pqr.
 *
 * T. J. Dolinsky et al., Nucleic Acids Res. 32 (2004) W665; E. Jurrus et al., Protein Sci. 27
 * (2018) 112. The program runs as a child with a file of the PDB's columns and answers with one of
 * words; protonation is the force field's at pH 7, hydrogens stand where geometry puts them.
 */
#ifndef isthmus_ProteinCharges_h
#define isthmus_ProteinCharges_h

#include "Atoms/PolymerAtoms.h"
#include "Core/ChildProcess.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

namespace isthmus
{

enum class ChargeTable
{
  AMBER = 0, ///< W. D. Cornell et al., J. Am. Chem. Soc. 117 (1995) 5179
  PARSE = 1  ///< D. Sitkoff, K. Sharp, B. Honig, J. Phys. Chem. 98 (1994) 1978
};

/// An atom that the force field knows.
struct ForceFieldAtom
{
  Point3 Place{ 0.0, 0.0, 0.0 }; ///< angstrom
  double Charge = 0.0;           ///< e
  double Radius = 0.0;           ///< angstrom
  std::string Name;              ///< the force field's, and its residue's
  std::string Residue;
  std::size_t Like =
    0;                ///< an atom of the input of the same residue: the same one, where it is there
  bool IsNew = false; ///< not in the input: hydrogens, heavy atoms that were missing
};

struct ChargedProtein
{
  std::vector<ForceFieldAtom> Atoms;
  std::string Warning; ///< what was left out or built; empty: nothing but water and hydrogens
};

/**
 * Runs pdb2pqr (or pdb2pqr30), as found on PATH. Water is left out; so is each residue that the
 * force field does not know (ligands, ions, modified residues), and the warning names it.
 * @throws std::invalid_argument for what a PDB file can't hold: more than 62 chains, or 9,999
 *   residues in one, coordinates beyond +-9,999; no atom with a residue's name.
 * @throws std::runtime_error where the program is not there, fails or takes longer than `limits`.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT ChargedProtein ChargeProtein(
  const std::vector<NamedAtom>& atoms, ChargeTable table, const ChildLimits& limits,
  const ProgressCallback& progress = {});

}

#endif
