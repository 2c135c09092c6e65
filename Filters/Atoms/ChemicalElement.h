/**
 * @file ChemicalElement.h
 * @brief Symbols of the elements, and the element that the name of an atom means.
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
 * The element of an ion that is a residue of its own, 0 if it is none: "NA+" of "NA", "Ca" of
 * "CA2", the names of CHARMM (SOD, POT, CAL, CES, CLA, LIT, RUB, BAR, CAD) and AMBER (IP, IM), and
 * what atoms of residue ION are named.
 */
VTKISTHMUSFILTERSATOMS_EXPORT int ElementOfIon(std::string_view name, std::string_view residueName);

/**
 * The element meant by an atom's name in files without an element column (PQR).
 *
 * An atom named as its residue is an ion ("ZN" of "ZN", "NA+" of "NA"; ElementOfIon).
 * Else leading digits are left out, CL, BR, ZN, FE, MG, MN, SE and SI outside of the twenty amino
 * acids and the nucleotides are those elements, and otherwise the first letter decides ("CA" is a
 * carbon). 0 where that is no symbol.
 */
VTKISTHMUSFILTERSATOMS_EXPORT int ElementOfAtomName(
  std::string_view name, std::string_view residueName);

/// Is a residue of this name water (HOH, DOD, WAT, ... and the names that simulations use)?
VTKISTHMUSFILTERSATOMS_EXPORT bool IsWater(std::string_view residueName);

}

#endif
