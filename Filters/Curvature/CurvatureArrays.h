/**
 * @file CurvatureArrays.h
 * @brief The properties of a filter that say which arrays of curvature it makes.
 */
#ifndef isthmus_CurvatureArrays_h
#define isthmus_CurvatureArrays_h

#include "Core/FilterProperties.h"

#include <ostream> // the wrappers see it declared only

/**
 * Properties of a filter (FilterProperties.h).
 *
 * GenerateX: whether to make the array X. The tolerances are bounds for `SurfaceType`: a point is
 * flat where curvedness x a length that the filter names is at most FlatTolerance; elsewhere K is
 * zero where |K| is at most GaussianTolerance x curvedness^2, and H where |H| is at most
 * MeanTolerance x curvedness. Types: 0 none, 1 pit, 2 valley, 3 saddle ridge, 4 flat, 5 minimal
 * surface, 6 saddle valley, 7 ridge, 8 peak.
 */
#define ISTHMUS_CURVATURE_ARRAYS()                                                                 \
  ISTHMUS_SWITCH(GenerateGaussianCurvature, true);                                                 \
  ISTHMUS_SWITCH(GenerateMeanCurvature, true);                                                     \
  ISTHMUS_SWITCH(GenerateMaximumCurvature, true);                                                  \
  ISTHMUS_SWITCH(GenerateMinimumCurvature, true);                                                  \
  ISTHMUS_SWITCH(GenerateShapeIndex, true);                                                        \
  ISTHMUS_SWITCH(GenerateCurvedness, true);                                                        \
  ISTHMUS_SWITCH(GeneratePrincipalDirection1, false);                                              \
  ISTHMUS_SWITCH(GeneratePrincipalDirection2, false);                                              \
  ISTHMUS_SWITCH(GenerateSurfaceType, false);                                                      \
  ISTHMUS_PROPERTY(double, FlatTolerance, 1e-3);                                                   \
  ISTHMUS_PROPERTY(double, GaussianTolerance, 1e-3);                                               \
  ISTHMUS_PROPERTY(double, MeanTolerance, 1e-3);                                                   \
                                                                                                   \
  void PrintCurvatureArrays(ostream& os, vtkIndent indent)                                         \
  {                                                                                                \
    os << indent << "GenerateGaussianCurvature: " << this->GenerateGaussianCurvature << "\n"       \
       << indent << "GenerateMeanCurvature: " << this->GenerateMeanCurvature << "\n"               \
       << indent << "GenerateMaximumCurvature: " << this->GenerateMaximumCurvature << "\n"         \
       << indent << "GenerateMinimumCurvature: " << this->GenerateMinimumCurvature << "\n"         \
       << indent << "GenerateShapeIndex: " << this->GenerateShapeIndex << "\n"                     \
       << indent << "GenerateCurvedness: " << this->GenerateCurvedness << "\n"                     \
       << indent << "GeneratePrincipalDirection1: " << this->GeneratePrincipalDirection1 << "\n"   \
       << indent << "GeneratePrincipalDirection2: " << this->GeneratePrincipalDirection2 << "\n"   \
       << indent << "GenerateSurfaceType: " << this->GenerateSurfaceType << "\n"                   \
       << indent << "FlatTolerance: " << this->FlatTolerance << "\n"                               \
       << indent << "GaussianTolerance: " << this->GaussianTolerance << "\n"                       \
       << indent << "MeanTolerance: " << this->MeanTolerance << "\n";                              \
  }                                                                                                \
  static_assert(true, "takes a semicolon")

#endif
