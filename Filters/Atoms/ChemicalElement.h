/**
 * @file ChemicalElement.h
 * @brief Symbols of the elements, their radii, and which element an atom's name means.
 */
#ifndef isthmus_ChemicalElement_h
#define isthmus_ChemicalElement_h

#include "vtkIsthmusFiltersAtomsModule.h"

#include <string_view>

namespace isthmus
{

/// Elements are numbered 0 (unknown) to 118.
constexpr int NumberOfElements = 119;

/// "C" for 6; "X" for 0.
VTKISTHMUSFILTERSATOMS_EXPORT const char* ElementSymbol(int element);

/// 6 for "C", "c"; 1 for "D"; 0 for anything that is no symbol.
VTKISTHMUSFILTERSATOMS_EXPORT int ElementOfSymbol(std::string_view symbol);

/**
 * The element meant by an atom's name in files without an element column (PQR).
 *
 * An atom named as its residue is an ion ("ZN" of "ZN", "NA+" of "NA"): its name is the symbol.
 * Else leading digits are left out, CL, BR, ZN, FE, MG, MN, SE and SI outside of the twenty amino
 * acids and the nucleotides are those elements, and otherwise the first letter decides ("CA" is a
 * carbon). 0 where that is no symbol.
 */
VTKISTHMUSFILTERSATOMS_EXPORT int ElementOfAtomName(
  std::string_view name, std::string_view residueName);

/// Tables of van der Waals radii.
enum class RadiusTable
{
  /// A. Bondi, J. Phys. Chem. 68 (1964) 441, with the main-group elements that M. Mantina et al.,
  /// J. Phys. Chem. A 113 (2009) 5806, Table 12 add. H 1.20 (Bondi's), C 1.70, N 1.55, O 1.52, S
  /// 1.80. Most transition metals have no radius there.
  Bondi,
  /// S. Alvarez, Dalton Trans. 42 (2013) 8617, Table 1: nearly all elements, metals as well.
  Alvarez,
  /// Atoms with the hydrogens that they carry, one radius for each element of a biopolymer: C 1.85,
  /// N 1.75, O 1.65, P 2.10, S 2.00. From S. J. Weiner et al., J. Am. Chem. Soc. 106 (1984) 765, as
  /// O. S. Smart et al. (HOLE, J. Mol. Graph. 14 (1996) 354) sum them up.
  UnitedAtom
};

/// Van der Waals radius in angstrom; NaN where the table has none.
VTKISTHMUSFILTERSATOMS_EXPORT double VanDerWaalsRadius(int element, RadiusTable table);

/**
 * Covalent radius in angstrom, B. Cordero et al., Dalton Trans. (2008) 2832 (carbon: sp3); NaN for
 * metals and noble gases, whose neighbours are not found by distance.
 */
VTKISTHMUSFILTERSATOMS_EXPORT double CovalentRadius(int element);

/// Is a residue of this name water (HOH, DOD, WAT, ... and the names that simulations use)?
VTKISTHMUSFILTERSATOMS_EXPORT bool IsWater(std::string_view residueName);

}

#endif
