/**
 * @file CurvatureArrays.h
 * @brief The properties that select the curvature arrays computed by a filter.
 */
#ifndef isthmus_CurvatureArrays_h
#define isthmus_CurvatureArrays_h

#include "Core/FilterProperties.h"

#include <ostream> // the wrappers see only its declaration

/**
 * Properties of a filter (FilterProperties.h).
 *
 * GenerateX: whether to compute the array X. The tolerances are bounds for `SurfaceType`: a point
 * is flat if curvedness x a length that depends on the filter is at most FlatTolerance. Otherwise K
 * counts as zero if |K| is at most GaussianTolerance x curvedness^2, and H if |H| is at most
 * MeanTolerance x curvedness. Types: 0 none, 1 pit, 2 valley, 3 saddle ridge, 4 flat, 5 minimal
 * surface, 6 saddle valley, 7 ridge, 8 peak.
 *
 * GenerateDifferentialForms (off): `GaussMap` (the unit normal that points outwards, as a point of
 * the unit sphere), `ShapeOperator` (symmetric tensor xx, yy, zz, xy, yz, xz, in 1/length),
 * `FirstFundamentalForm` (E, F, G; no unit), `SecondFundamentalForm` (L, M, N; 1/length) and
 * `AreaElement` (sqrt(E G - F^2)), of the surface as a graph over the coordinate plane to which it
 * is most nearly parallel. GenerateNormalCurvature (off): `NormalCurvature` (1/length), the bending
 * of the surface along NormalCurvatureDirection, a vector of any length in world axes, (1, 0, 0) by
 * default, projected to the tangent plane; 0 where that direction is normal to the surface. The
 * formulas are in DifferentialForms.h.
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
  ISTHMUS_SWITCH(GenerateDifferentialForms, false);                                                \
  ISTHMUS_SWITCH(GenerateNormalCurvature, false);                                                  \
                                                                                                   \
public:                                                                                            \
  vtkSetVector3Macro(NormalCurvatureDirection, double);                                            \
  vtkGetVector3Macro(NormalCurvatureDirection, double);                                            \
                                                                                                   \
protected:                                                                                         \
  double NormalCurvatureDirection[3] = { 1.0, 0.0, 0.0 };                                          \
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
       << indent << "GenerateDifferentialForms: " << this->GenerateDifferentialForms << "\n"       \
       << indent << "GenerateNormalCurvature: " << this->GenerateNormalCurvature << "\n"           \
       << indent << "NormalCurvatureDirection: " << this->NormalCurvatureDirection[0] << " "       \
       << this->NormalCurvatureDirection[1] << " " << this->NormalCurvatureDirection[2] << "\n"    \
       << indent << "FlatTolerance: " << this->FlatTolerance << "\n"                               \
       << indent << "GaussianTolerance: " << this->GaussianTolerance << "\n"                       \
       << indent << "MeanTolerance: " << this->MeanTolerance << "\n";                              \
  }                                                                                                \
  static_assert(true, "takes a semicolon")

#endif
