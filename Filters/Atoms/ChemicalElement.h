/**
 * @file ChemicalElement.h
 * @brief Symbols of the elements, and the element denoted by the name of an atom.
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

/// 6 for "C", "c"; 1 for "D"; 0 for anything that is not a symbol.
VTKISTHMUSFILTERSATOMS_EXPORT int ElementFromSymbol(std::string_view symbol);

/**
 * The element of an ion that is a separate residue, or 0 if it is not an ion: "NA+" of "NA", "Ca"
 * of "CA2", the names of CHARMM (SOD, POT, CAL, CES, CLA, LIT, RUB, BAR, CAD) and AMBER (IP, IM),
 * and the names of atoms in residue ION.
 */
VTKISTHMUSFILTERSATOMS_EXPORT int ElementFromIon(
  std::string_view name, std::string_view residueName);

/**
 * The element denoted by the name of an atom in files without an element column (PQR).
 *
 * An atom with the name of its residue is an ion ("ZN" of "ZN", "NA+" of "NA"; ElementFromIon).
 * Otherwise leading digits are ignored. CL, BR, ZN, FE, MG, MN, SE and SI outside the twenty amino
 * acids and the nucleotides are those elements; for other names, the first letter decides ("CA" is
 * a carbon). 0 if that is not a symbol.
 */
VTKISTHMUSFILTERSATOMS_EXPORT int ElementFromAtomName(
  std::string_view name, std::string_view residueName);

/// Whether a residue of this name is water (HOH, DOD, WAT, ... and the names used in simulations).
VTKISTHMUSFILTERSATOMS_EXPORT bool IsWater(std::string_view residueName);

}

#endif
