/**
 * @file HessianCurvatureRows.h
 * @brief Options and arrays of HessianCurvature, and its inner loop: derivatives to curvature, row
 * by row.
 *
 * Formulas, signs, units and the criteria of validity are in HessianCurvature.h.
 */
#ifndef isthmus_HessianCurvatureRows_h
#define isthmus_HessianCurvatureRows_h

#include "Curvature/CurvatureDescriptors.h"
#include "Curvature/FiniteDifference.h"

#include <array>

namespace isthmus
{

struct HessianCurvatureOptions : CurvatureDescriptorOptions
{
  int Accuracy = 2;           ///< Order of the differences: 2 or 4.
  bool InsideIsHigher = true; ///< Whether the scalar grows inwards.
  /// Row-major 3 x 3 matrix, columns the grid's axes in the world; only directions depend on it.
  std::array<double, 9> Axes{ 1, 0, 0, 0, 1, 0, 0, 0, 1 };
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSCURVATURE_EXPORT void Check(const HessianCurvatureOptions& options);

/// Destinations of the results, with one value (three for directions) per place; null if not
/// requested.
template <typename T>
struct CurvatureArrays
{
  T* Gaussian = nullptr;
  T* Mean = nullptr;
  T* Maximum = nullptr;
  T* Minimum = nullptr;
  T* ShapeIndex = nullptr;
  T* Curvedness = nullptr;
  T* Direction1 = nullptr;              ///< Unit vectors of kappa_1; their sign is arbitrary.
  T* Direction2 = nullptr;              ///< Unit vectors of kappa_2, likewise.
  unsigned char* SurfaceType = nullptr; ///< Values of enum SurfaceType.
  unsigned char* Valid = nullptr;       ///< 1 or 0.
  T* Gradient = nullptr;                ///< Length of the gradient, 0 where not valid.
  T* Normal = nullptr;                  ///< Unit vectors that point outwards.
};

/// The parameters that determine sign and validity at a place.
struct ShapeRule
{
  bool InsideIsHigher = true;
  double Spacing = 1.0;       ///< Smallest spacing of the grid.
  double ValueRounding = 0.0; ///< Relative rounding of the grid's values, with its safety factor.
  double Largest = 0.0;       ///< Largest finite number of the type that results are stored in.
};

/// Sets the gradient at `place` to zero, so that WriteCurvature() marks it as invalid.
void SetZeroGradient(DerivativeRows& derivatives, std::int64_t place);

/// Writes the curvature at places [0, count) of `derivatives` to places [at, at + count) of
/// `arrays`.
template <typename T>
void WriteCurvature(const DerivativeRows& derivatives, std::int64_t count, const ShapeRule& rule,
  const HessianCurvatureOptions& options, const CurvatureArrays<T>& arrays, std::int64_t at);

/// Writes zeros, marked as not valid, to places [at, at + count) of `arrays`.
template <typename T>
void ClearCurvature(const CurvatureArrays<T>& arrays, std::int64_t at, std::int64_t count);

}

#endif
