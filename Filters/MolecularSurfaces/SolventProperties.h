/**
 * @file SolventProperties.h
 * @brief The properties of a filter that describe the effect of the solvent on the surface of a
 * molecule.
 */
#ifndef isthmus_SolventProperties_h
#define isthmus_SolventProperties_h

#include "Core/FilterProperties.h"

#include <ostream> // the wrappers see it declared only

/**
 * Properties of a filter (FilterProperties.h).
 *
 * SurfaceTension: gamma, kcal/mol per square angstrom. Default 0.0700. Pressure: p, kcal/mol per
 * cubic angstrom. Default 0.0464. Where both are from: vtkNonpolarSolvation.
 */
#define ISTHMUS_SOLVENT_PROPERTIES()                                                               \
  ISTHMUS_PROPERTY(double, SurfaceTension, 0.0700);                                                \
  ISTHMUS_PROPERTY(double, Pressure, 0.0464);                                                      \
                                                                                                   \
  void PrintSolventProperties(ostream& os, vtkIndent indent)                                       \
  {                                                                                                \
    os << indent << "SurfaceTension: " << this->SurfaceTension << "\n"                             \
       << indent << "Pressure: " << this->Pressure << "\n";                                        \
  }                                                                                                \
  static_assert(true, "takes a semicolon")

#endif
