/**
 * @file CurvatureDescriptors.h
 * @brief Descriptors of local shape from the mean curvature and the difference of the principal
 * curvatures.
 *
 * All descriptors are computed from two numbers at a point of a surface,
 *
 *     mean curvature     H = (kappa_1 + kappa_2) / 2
 *     half difference    d = (kappa_1 - kappa_2) / 2 = sqrt(H^2 - K) >= 0
 *
 * with kappa_1 >= kappa_2 the principal curvatures and K = kappa_1 kappa_2 the Gaussian curvature.
 * Sign: bending away from the outward normal is positive, so a sphere of radius r has kappa_1 =
 * kappa_2 = +1/r. Units: 1/length for H, d and the curvedness, 1/length^2 for K (angstrom for
 * molecular maps); the shape index has no unit.
 *
 * Sources: X. Feng's thesis, Table 2.1, eqs. 2.6 to 2.9; J. J. Koenderink and A. J. van Doorn,
 * "Surface shape and curvature scales", Image and Vision Computing 10 (1992) 557,
 * doi:10.1016/0262-8856(92)90076-F, for shape index and curvedness.
 *
 * All functions are O(1), allocate no memory, have no state and, except for ClassifySurface(), have
 * no branches that would keep a compiler from vectorising a loop over them.
 */
#ifndef isthmus_CurvatureDescriptors_h
#define isthmus_CurvatureDescriptors_h

#include "vtkIsthmusFiltersCurvatureModule.h" // for the export macro

#include "Core/Geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus
{

/// Half difference of the principal curvatures from Gaussian and mean curvature. Returns 0 if K >
/// H^2 because of rounding (at an umbilic).
inline double HalfDifference(double gaussian, double mean)
{
  return std::sqrt(std::max(0.0, mean * mean - gaussian));
}

/// Curvedness sqrt((kappa_1^2 + kappa_2^2) / 2) = sqrt(H^2 + d^2) (thesis 2.9): the amount of
/// bending, regardless of direction.
inline double Curvedness(double mean, double halfDifference)
{
  return std::sqrt(mean * mean + halfDifference * halfDifference);
}

/**
 * atan2(y, x) for x >= 0, in [-pi/2, pi/2], to 1e-15 absolute; 0 if both are 0.
 *
 * Implemented here because the library's atan2 is a function call per value and would take a third
 * of the time of a curvature pass. The smaller of |x|, |y| is divided by the larger; beyond
 * tan(pi/8) the angle is measured from pi/4, so that the polynomial (Chebyshev interpolation of
 * atan(t)/t in t^2, fitted by us) is only needed for |t| <= tan(pi/8).
 */
inline double ArcTangent(double y, double x)
{
  constexpr double tanPiOver8 = 0.41421356237309504880;
  const double a = std::abs(y);
  const double smaller = std::min(a, x);
  const double larger = std::max(std::max(a, x), std::numeric_limits<double>::min());
  const bool far = smaller > tanPiOver8 * larger;
  const double t = (far ? smaller - larger : smaller) / (far ? smaller + larger : larger);
  const double z = t * t;
  double p = -0.0253164795737764757;
  p = p * z + 0.0502476211894012803;
  p = p * z - 0.0650598296717083992;
  p = p * z + 0.0767353542818328602;
  p = p * z - 0.0908952995656230736;
  p = p * z + 0.111110488537512957;
  p = p * z - 0.142857126616847938;
  p = p * z + 0.199999999783926621;
  p = p * z - 0.33333333333221434;
  p = p * z + 0.999999999999999041;
  const double small = (far ? Pi / 4.0 : 0.0) + p * t;
  return std::copysign(a > x ? Pi / 2.0 - small : small, y);
}

/// Which end of the shape index is a peak.
enum class ShapeIndexConvention
{
  Thesis = 0,    ///< Peak -1, ridge -1/2, saddle 0, valley +1/2, pit +1 (thesis 2.8).
  Koenderink = 1 ///< Peak +1, ridge +1/2, saddle 0, valley -1/2, pit -1.
};

/// Shape index s = -/+ (2/pi) atan2(H, d), in [-1, 1]; 0 where the surface is flat (H = d = 0) and
/// the index is undefined. At umbilics (d = 0) it is -/+ sign(H).
inline double ShapeIndex(double mean, double halfDifference, ShapeIndexConvention convention)
{
  constexpr double twoOverPi = 0.63661977236758134308;
  const double sign = convention == ShapeIndexConvention::Thesis ? -twoOverPi : twoOverPi;
  return sign * ArcTangent(mean, halfDifference);
}

/// Surface types by the signs of K and H (thesis Table 2.1). The numbers are those in the label
/// arrays, in the order of the thesis, from concave to convex.
enum class SurfaceType : unsigned char
{
  None =
    0, ///< No curvature at this point, or an impossible combination of signs (K > 0 with H = 0).
  Pit = 1,            ///< K > 0, H < 0
  Valley = 2,         ///< K = 0, H < 0
  SaddleRidge = 3,    ///< K < 0, H > 0
  Flat = 4,           ///< K = 0, H = 0
  MinimalSurface = 5, ///< K < 0, H = 0
  SaddleValley = 6,   ///< K < 0, H < 0
  Ridge = 7,          ///< K = 0, H > 0
  Peak = 8            ///< K > 0, H > 0
};

constexpr int NumberOfSurfaceTypes = 9;

/// English name of a surface type, for example "Saddle ridge".
VTKISTHMUSFILTERSCURVATURE_EXPORT const char* SurfaceTypeName(SurfaceType type);

/**
 * Tolerances below which values count as zero in Table 2.1. They have no unit and are relative to
 * the point itself.
 *
 * Tolerances relative to a maximum over the data would change with cropping and with the number of
 * MPI ranks, and a single near-critical point would make all other points flat. Therefore they are
 * relative to the local curvedness c.
 */
struct SurfaceTypeTolerance
{
  double FlatTolerance = 1e-3;     ///< Flat if c x (grid spacing) is at most this.
  double GaussianTolerance = 1e-3; ///< K counts as 0 if |K| is at most this times c^2.
  double MeanTolerance = 1e-3;     ///< H counts as 0 if |H| is at most this times c.
};

/// What determines the descriptors besides the principal curvatures.
struct CurvatureDescriptorOptions : SurfaceTypeTolerance
{
  isthmus::ShapeIndexConvention ShapeIndexConvention = isthmus::ShapeIndexConvention::Thesis;
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSCURVATURE_EXPORT void Check(const CurvatureDescriptorOptions& options);

/// Type of the surface by Table 2.1; `spacing` is the (smallest) grid spacing.
VTKISTHMUSFILTERSCURVATURE_EXPORT SurfaceType ClassifySurface(
  double mean, double halfDifference, double spacing, const SurfaceTypeTolerance& tolerance);

}

#endif
