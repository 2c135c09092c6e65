/**
 * @file AtomProperties.h
 * @brief The properties of a filter that say which atoms of its input count, and how large they
 * are.
 */
#ifndef isthmus_AtomProperties_h
#define isthmus_AtomProperties_h

#include "Core/FilterProperties.h"

#include <ostream> // the wrappers see it declared only

/**
 * Properties of a filter (FilterProperties.h).
 *
 * KeepWaters: water counts as part of the molecule. Default off.
 *
 * UnitedAtoms: where amino acids or nucleotides come without any hydrogen and the radii are those
 * of a table by element, radii of united atoms take their place: C 1.85, N 1.75, O 1.65, P 2.10,
 * S 2.00 (AtomRadii.h). Radii of a force field stay as they are. Default on.
 */
#define ISTHMUS_ATOM_PROPERTIES()                                                                  \
  ISTHMUS_SWITCH(KeepWaters, false);                                                               \
  ISTHMUS_SWITCH(UnitedAtoms, true);                                                               \
                                                                                                   \
  void PrintAtomProperties(ostream& os, vtkIndent indent)                                          \
  {                                                                                                \
    os << indent << "KeepWaters: " << this->KeepWaters << "\n"                                     \
       << indent << "UnitedAtoms: " << this->UnitedAtoms << "\n";                                  \
  }                                                                                                \
  static_assert(true, "takes a semicolon")

#endif
