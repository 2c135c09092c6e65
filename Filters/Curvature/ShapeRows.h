/**
 * @file ShapeRows.h
 * @brief From rows of derivatives to rows of curvature: the inner step of HessianCurvature.
 *
 * Formulas, signs, units and what makes a place valid: HessianCurvature.h.
 */
#ifndef isthmus_ShapeRows_h
#define isthmus_ShapeRows_h

#include "Curvature/FiniteDifference.h"
#include "Curvature/HessianCurvatureParameters.h"

namespace isthmus
{

/// What decides sign and validity of a place.
struct ShapeRule
{
  bool InsideIsHigher = true;
  double Spacing = 1.0;       ///< Smallest spacing of the grid.
  double ValueRounding = 0.0; ///< Relative rounding of the grid's values, with its safety factor.
  double Largest = 0.0;       ///< Largest finite number of the type that results are stored in.
};

/// Makes `place` one where no gradient is, which WriteCurvature finds invalid.
void SetGradientless(DerivativeRows& derivatives, std::int64_t place);

/// Writes the curvature at places [0, count) of `derivatives` to places [at, at + count) of
/// `arrays`.
template <typename T>
void WriteCurvature(const DerivativeRows& derivatives, std::int64_t count, const ShapeRule& rule,
  const HessianCurvatureOptions& options, const CurvatureArrays<T>& arrays, std::int64_t at);

/// Writes zeros, not valid, to places [at, at + count) of `arrays`.
template <typename T>
void ClearCurvature(const CurvatureArrays<T>& arrays, std::int64_t at, std::int64_t count);

}

#endif
