/**
 * @file PolymerResidues.h
 * @brief Atoms in residues, with those of the backbone by name, and which residues follow each
 * other along a chain.
 */
#ifndef isthmus_PolymerResidues_h
#define isthmus_PolymerResidues_h

#include "Atoms/PolymerAtoms.h"
#include "vtkIsthmusFiltersAtomsModule.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isthmus
{

enum class ResidueKind
{
  AminoAcid,  ///< has an atom CA
  Nucleotide, ///< has an atom C4' or P
  Other
};

/// A residue. Atoms are given by their indices; -1: the residue has none of that name.
struct PolymerResidue
{
  static constexpr std::int64_t None = -1;

  std::vector<std::size_t> Atoms; ///< ascending, never empty
  ResidueKind Kind = ResidueKind::Other;
  std::int64_t N = None;
  std::int64_t CA = None;
  std::int64_t C = None;
  std::int64_t O = None;
  std::int64_t P = None;
  std::int64_t C4 = None;      ///< C4' of a nucleotide
  std::int64_t O3 = None;      ///< O3'
  std::int64_t BaseEnd = None; ///< N1 of a purine, N3 of a pyrimidine: they face the other strand
  bool IsLinked = false;       ///< to the residue after it in the list

  /// The atom that the chain's curve follows: CA of an amino acid, else C4', else P.
  std::int64_t Trace() const
  {
    return this->Kind == ResidueKind::AminoAcid ? this->CA : this->C4 != None ? this->C4 : this->P;
  }
};

/**
 * The residues of the atoms `kept`, in the order of their first atoms. Consecutive atoms with the
 * same chain, number, insertion code and residue name are a residue, until the backbone's first
 * atom comes again. O(atoms).
 */
VTKISTHMUSFILTERSATOMS_EXPORT std::vector<PolymerResidue> FindResidues(
  const std::vector<NamedAtom>& atoms, const std::vector<std::size_t>& kept);

/**
 * Whether `b` follows `a` in a chain: both have the same chain name and kind, and C of `a` is
 * bonded to N of `b` (up to 2.0 angstrom), or O3' to P (up to 2.2). Without these atoms: CA up
 * to 4.5 angstrom apart, C4' or P up to 8.
 */
VTKISTHMUSFILTERSATOMS_EXPORT bool AreLinked(
  const std::vector<NamedAtom>& atoms, const PolymerResidue& a, const PolymerResidue& b);

}

#endif
