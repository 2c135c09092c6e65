/**
 * @file HarmonicFit.h
 * @brief The reaction potential at a point inside, computed from the surrounding nodes inside.
 *
 * It is harmonic there, so a polynomial of degree 3 has 16 coefficients instead of 20: r^l Y_lm up
 * to l = 3, fitted by weighted least squares to the nodes inside within three spacings. If there
 * are too few nodes, the degree is 2, 1 or 0. Fourth order for degree 3.
 */
#ifndef isthmus_HarmonicFit_h
#define isthmus_HarmonicFit_h

#include "Electrostatics/LevelFunction.h"

#include <optional>

namespace isthmus
{

struct ValueAndGradient
{
  double Value = 0.0;
  Point3 Gradient{ 0.0, 0.0, 0.0 };
};

/// The fit of u at x (in the frame of the volume); nothing if no surrounding node is inside.
std::optional<ValueAndGradient> HarmonicAt(const SolverBox& box,
  const std::vector<unsigned char>& inside, const std::vector<double>& u, const Point3& x);

}

#endif
