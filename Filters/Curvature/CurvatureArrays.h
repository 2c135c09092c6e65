/**
 * @file CurvatureArrays.h
 * @brief Arrays and properties that the curvature filters share.
 */
#ifndef isthmus_CurvatureArrays_h
#define isthmus_CurvatureArrays_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"

#include <ostream> // VTK's wrappers need only its declaration

/**
 * Properties of a filter (FilterProperties.h), which holds its CurvatureDescriptorOptions as
 * `Parameters`: the tolerances are bounds for `SurfaceType`. A point is flat if curvedness x a
 * length that depends on the filter is at most FlatTolerance. Otherwise K counts as zero if |K| is
 * at most GaussianTolerance x curvedness^2, and H if |H| is at most MeanTolerance x curvedness.
 * `NormalCurvature` is the bending of the surface along NormalCurvatureDirection, a vector of any
 * length in world axes, projected to the tangent plane; 0 where that direction is normal to the
 * surface.
 */
#define ISTHMUS_CURVATURE_PROPERTIES()                                                             \
public:                                                                                            \
  vtkSetVector3Macro(NormalCurvatureDirection, double);                                            \
  vtkGetVector3Macro(NormalCurvatureDirection, double);                                            \
                                                                                                   \
protected:                                                                                         \
  double NormalCurvatureDirection[3] = { 1.0, 0.0, 0.0 };                                          \
                                                                                                   \
public:                                                                                            \
  ISTHMUS_PARAMETER(FlatTolerance, double);                                                        \
  ISTHMUS_PARAMETER(GaussianTolerance, double);                                                    \
  ISTHMUS_PARAMETER(MeanTolerance, double);                                                        \
                                                                                                   \
protected:                                                                                         \
  void PrintCurvatureProperties(ostream& os, vtkIndent indent)                                     \
  {                                                                                                \
    os << indent << "NormalCurvatureDirection: " << this->NormalCurvatureDirection[0] << " "       \
       << this->NormalCurvatureDirection[1] << " " << this->NormalCurvatureDirection[2] << "\n"    \
       << indent << "FlatTolerance: " << this->Parameters.FlatTolerance << "\n"                    \
       << indent << "GaussianTolerance: " << this->Parameters.GaussianTolerance << "\n"            \
       << indent << "MeanTolerance: " << this->Parameters.MeanTolerance << "\n";                   \
  }                                                                                                \
  static_assert(true, "takes a semicolon")

/// Rows of the table of output arrays that both filters have. The formulas of the forms are in
/// DifferentialForms.h.
#define ISTHMUS_CURVATURE_ARRAY_ROWS                                                               \
  { 0, ArrayPlace::Points, "GaussianCurvature", 1, "1/length^2", ArrayChoice::On,                  \
    "K = kappa_1 kappa_2" },                                                                       \
    { 0, ArrayPlace::Points, "MeanCurvature", 1, "1/length", ArrayChoice::On,                      \
      "H = (kappa_1 + kappa_2) / 2, positive for a sphere" },                                      \
    { 0, ArrayPlace::Points, "MaximumCurvature", 1, "1/length", ArrayChoice::On,                   \
      "the larger principal curvature, kappa_1" },                                                 \
    { 0, ArrayPlace::Points, "MinimumCurvature", 1, "1/length", ArrayChoice::On,                   \
      "the smaller principal curvature, kappa_2" },                                                \
    { 0, ArrayPlace::Points, "ShapeIndex", 1, "", ArrayChoice::On,                                 \
      "-1 peak, 0 saddle, 1 pit, or the other way round: ShapeIndexConvention" },                  \
    { 0, ArrayPlace::Points, "Curvedness", 1, "1/length", ArrayChoice::On,                         \
      "sqrt((kappa_1^2 + kappa_2^2) / 2)" },                                                       \
    { 0, ArrayPlace::Points, "PrincipalDirection1", 3, "", ArrayChoice::Off,                       \
      "unit vector along which the curvature is kappa_1; its sign is arbitrary" },                 \
    { 0, ArrayPlace::Points, "PrincipalDirection2", 3, "", ArrayChoice::Off,                       \
      "unit vector along which the curvature is kappa_2; its sign is arbitrary" },                 \
    { 0, ArrayPlace::Points, "SurfaceType", 1, "", ArrayChoice::Off,                               \
      "by the signs of K and H: 0 none, 1 pit, 2 valley, 3 saddle ridge, 4 flat, 5 minimal "       \
      "surface, 6 saddle valley, 7 ridge, 8 peak" },                                               \
    { 0, ArrayPlace::Points, "GaussMap", 3, "", ArrayChoice::Off,                                  \
      "unit normal that points outwards, a point of the unit sphere" },                            \
    { 0, ArrayPlace::Points, "ShapeOperator", 6, "1/length", ArrayChoice::Off,                     \
      "symmetric tensor: xx, yy, zz, xy, yz, xz" },                                                \
    { 0, ArrayPlace::Points, "FirstFundamentalForm", 3, "", ArrayChoice::Off,                      \
      "E, F, G of the surface as a graph over the coordinate plane to which it is most "           \
      "nearly parallel" },                                                                         \
    { 0, ArrayPlace::Points, "SecondFundamentalForm", 3, "1/length", ArrayChoice::Off,             \
      "L, M, N of that graph" },                                                                   \
    { 0, ArrayPlace::Points, "AreaElement", 1, "", ArrayChoice::Off, "sqrt(E G - F^2)" },          \
    { 0, ArrayPlace::Points, "NormalCurvature", 1, "1/length", ArrayChoice::Off,                   \
      "curvature along NormalCurvatureDirection" },                                                \
    { 0, ArrayPlace::Points, "CurvatureValid", 1, "", ArrayChoice::None,                           \
      "1 where the values are meaningful; elsewhere 0, and so are the values" },                   \
    { 0, ArrayPlace::Field, "SurfaceTypeNames", 1, "", ArrayChoice::None,                          \
      "names of the types, with SurfaceType" },                                                    \
    { 0, ArrayPlace::Field, "GaussianCurvatureIntegral", 1, "", ArrayChoice::None,                 \
      "integral of GaussianCurvature over a surface on one rank" },                                \
  {                                                                                                \
    0, ArrayPlace::Field, "GaussBonnetEulerNumber", 1, "", ArrayChoice::None,                      \
      "that integral divided by 2 pi, close to the Euler number of a closed surface"               \
  }

#endif
