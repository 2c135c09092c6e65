/**
 * @file HessianCurvatureParameters.h
 * @brief What HessianCurvature is asked for, and where its results go.
 */
#ifndef isthmus_HessianCurvatureParameters_h
#define isthmus_HessianCurvatureParameters_h

#include "Curvature/CurvatureDescriptors.h"

#include <array>

namespace isthmus
{

struct HessianCurvatureOptions
{
  int Accuracy = 2;           ///< Order of the differences: 2 or 4.
  bool InsideIsHigher = true; ///< Whether the scalar grows inwards.
  ShapeIndexConvention Convention = ShapeIndexConvention::Thesis;
  SurfaceTypeTolerance Tolerance;
  /// Row-major 3 x 3 matrix, columns the grid's axes in the world; only directions depend on it.
  std::array<double, 9> Axes{ 1, 0, 0, 0, 1, 0, 0, 0, 1 };
};

/// Where results go, one value (three for directions) for each place; null for what isn't wanted.
template <typename T>
struct CurvatureArrays
{
  T* Gaussian = nullptr;
  T* Mean = nullptr;
  T* Maximum = nullptr;
  T* Minimum = nullptr;
  T* ShapeIndex = nullptr;
  T* Curvedness = nullptr;
  T* Direction1 = nullptr;              ///< Unit vectors of kappa_1; their sign means nothing.
  T* Direction2 = nullptr;              ///< Unit vectors of kappa_2, likewise.
  unsigned char* SurfaceType = nullptr; ///< Values of enum SurfaceType.
  unsigned char* Valid = nullptr;       ///< 1 or 0.
};

}

#endif
