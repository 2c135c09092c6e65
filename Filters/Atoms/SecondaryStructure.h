/**
 * @file SecondaryStructure.h
 * @brief Helices and strands of a protein by its hydrogen bonds (DSSP).
 *
 * W. Kabsch and C. Sander, Biopolymers 22 (1983) 2577. The energy of a hydrogen bond from N-H of a
 * residue to C=O of another is
 *
 *     E = 0.42 0.20 332 (1/r_ON + 1/r_CH - 1/r_OH - 1/r_CN) kcal/mol, lengths in angstrom;
 *
 * below -0.5 there is a bond. H is 1 angstrom from N, opposite to C=O of the residue before.
 * Each N-H keeps its two strongest bonds. Two consecutive turns of 4, 3 or 5 residues are an alpha,
 * 3-10 or pi helix; two or more consecutive bridges, also across a bulge, are strands. Alpha
 * helices take precedence over strands and 3-10 helices, pi helices over alpha ones, as from DSSP
 * 2.1 on (W. G. Touw et al., Nucleic Acids Res. 43 (2015) D364). DSSP's single bridges, turns and
 * bends count as coil.
 */
#ifndef isthmus_SecondaryStructure_h
#define isthmus_SecondaryStructure_h

#include "Atoms/PolymerResidues.h"
#include "vtkIsthmusFiltersAtomsModule.h"

#include <vector>

namespace isthmus
{

/// Values of the array `SecondaryStructure`.
enum class SecondaryStructure : unsigned char
{
  Coil = 0,
  AlphaHelix = 1,
  Strand = 2,
  Helix310 = 3,
  PiHelix = 4,
  NucleicAcid = 5
};

inline bool IsHelix(SecondaryStructure s)
{
  return s == SecondaryStructure::AlphaHelix || s == SecondaryStructure::Helix310 ||
    s == SecondaryStructure::PiHelix;
}

/**
 * The secondary structure of each residue; NucleicAcid of nucleotides. Residues without N, C and O
 * have no hydrogen bonds. O(n log n) in residues.
 */
VTKISTHMUSFILTERSATOMS_EXPORT std::vector<SecondaryStructure> FindSecondaryStructure(
  const std::vector<NamedAtom>& atoms, const std::vector<PolymerResidue>& residues);

}

#endif
