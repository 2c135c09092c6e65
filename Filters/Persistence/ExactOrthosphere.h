/**
 * @file ExactOrthosphere.h
 * @brief Spheres of tetrahedra that are too flat for computations in double precision.
 */
#ifndef isthmus_ExactOrthosphere_h
#define isthmus_ExactOrthosphere_h

#include "Core/Geometry.h"

#include <array>

namespace isthmus
{

/// A sphere orthogonal to the balls of a simplex: its center, and its squared radius (power).
struct Orthosphere
{
  Point3 Center;
  double Power;
};

/**
 * The sphere orthogonal to four balls with these centers, which do not lie in one plane, and
 * squared radii. With radii 0 it is the circumscribed sphere.
 *
 * With a, b, c the edges from the first center p, and w_i the squared radii, the center is
 *
 *     p + (A b x c + B c x a + C a x b) / (2 a . (b x c)),   A = a . a + w_0 - w_1, and so on.
 *
 * Numerators and denominators are exact; the quotients are rounded. (Rational numbers would look
 * for common divisors after each operation.)
 */
Orthosphere ExactOrthosphere(
  const std::array<Point3, 4>& centers, const std::array<double, 4>& squaredRadii);

}

#endif
