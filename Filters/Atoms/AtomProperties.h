/**
 * @file AtomProperties.h
 * @brief The properties of a filter that determine which atoms of its input are used, and their
 * radii.
 */
#ifndef isthmus_AtomProperties_h
#define isthmus_AtomProperties_h

#include "Core/FilterProperties.h"

#include <ostream> // VTK's wrappers need only its declaration

/**
 * Properties of a filter (FilterProperties.h).
 *
 * IncludeWaters: treat water as part of the molecule. Default off.
 *
 * UnitedAtoms: if amino acids or nucleotides have no hydrogens at all and the radii are those of a
 * table by element, they are replaced by united-atom radii: C 1.85, N 1.75, O 1.65, P 2.10, S 2.00
 * (AtomRadii.h). Radii of a force field are not changed. Default on.
 */
#define ISTHMUS_ATOM_PROPERTIES()                                                                  \
  ISTHMUS_SWITCH(IncludeWaters, false);                                                            \
  ISTHMUS_SWITCH(UnitedAtoms, true);                                                               \
                                                                                                   \
  void PrintAtomProperties(ostream& os, vtkIndent indent)                                          \
  {                                                                                                \
    os << indent << "IncludeWaters: " << this->IncludeWaters << "\n"                               \
       << indent << "UnitedAtoms: " << this->UnitedAtoms << "\n";                                  \
  }                                                                                                \
  static_assert(true, "takes a semicolon")

#endif
