/**
 * @file FundamentalForms.h
 * @brief The thesis' first method for the curvature of level sets, as a reference for the
 * implementation.
 *
 * Gaussian and mean curvature from the two fundamental forms of the level set z = f(x, y) (thesis
 * 5.30 to 5.41, with the square of S_y in 5.40 and S_xy in 5.41 restored). Positive for a sphere
 * where S is higher inside.
 */
#ifndef isthmus_FundamentalForms_h
#define isthmus_FundamentalForms_h

#include <cmath>

namespace isthmus::testing
{

/// First and second derivatives of S at one place.
struct Jet
{
  double X, Y, Z, XX, YY, ZZ, XY, XZ, YZ;
};

struct GaussianAndMean
{
  double Gaussian, Mean;
};

inline GaussianAndMean FundamentalForms(const Jet& s)
{
  const double g = s.X * s.X + s.Y * s.Y + s.Z * s.Z;
  const double mixed = s.X * s.Y * s.XZ * s.YZ + s.X * s.Z * s.XY * s.YZ + s.Y * s.Z * s.XY * s.XZ;
  const double crossed =
    s.X * s.Z * s.XZ * s.YY + s.Y * s.Z * s.XX * s.YZ + s.X * s.Y * s.XY * s.ZZ;
  const double squares =
    s.Z * s.Z * s.XX * s.YY + s.X * s.X * s.YY * s.ZZ + s.Y * s.Y * s.XX * s.ZZ;
  const double mixedSquares =
    s.X * s.X * s.YZ * s.YZ + s.Y * s.Y * s.XZ * s.XZ + s.Z * s.Z * s.XY * s.XY;
  const double bent = 2.0 * (s.X * s.Y * s.XY + s.X * s.Z * s.XZ + s.Y * s.Z * s.YZ) -
    (s.Y * s.Y + s.Z * s.Z) * s.XX - (s.X * s.X + s.Z * s.Z) * s.YY -
    (s.X * s.X + s.Y * s.Y) * s.ZZ;
  return { (2.0 * mixed - 2.0 * crossed + squares - mixedSquares) / (g * g),
    bent / (2.0 * g * std::sqrt(g)) };
}

}

#endif
