/**
 * @file SolventProperties.h
 * @brief The properties of a filter that describe the effect of the solvent on the surface of a
 * molecule.
 */
#ifndef isthmus_SolventProperties_h
#define isthmus_SolventProperties_h

#include "Core/FilterProperties.h"
#include "MolecularSurfaces/MolecularSurfaceParameters.h"

#include <ostream> // VTK's wrappers need only its declaration

/**
 * Properties of a filter (FilterProperties.h) that holds SolventParameters as `parameters`.
 *
 * SurfaceTension: gamma, kcal/mol per square angstrom. Default 0.0700. Pressure: p, kcal/mol per
 * cubic angstrom. Default 0.0464. Where both are from: vtkNonpolarSolvation.
 */
#define ISTHMUS_SOLVENT_PROPERTIES(parameters)                                                     \
public:                                                                                            \
  ISTHMUS_PARAMETER_OF(parameters, SurfaceTension, double);                                        \
  ISTHMUS_PARAMETER_OF(parameters, Pressure, double);                                              \
                                                                                                   \
protected:                                                                                         \
  void PrintSolventProperties(ostream& os, vtkIndent indent)                                       \
  {                                                                                                \
    os << indent << "SurfaceTension: " << this->GetSurfaceTension() << "\n"                        \
       << indent << "Pressure: " << this->GetPressure() << "\n";                                   \
  }                                                                                                \
  static_assert(true, "takes a semicolon")

#endif
