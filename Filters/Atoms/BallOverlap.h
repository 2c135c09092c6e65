/**
 * @file BallOverlap.h
 * @brief Common volume and surface of two and three balls, and angles of tetrahedra.
 */
#ifndef isthmus_BallOverlap_h
#define isthmus_BallOverlap_h

#include "Atoms/Ball.h"
#include "Core/Geometry.h"
#include "vtkIsthmusFiltersAtomsModule.h"

#include <array>

namespace isthmus
{

/// Volume of the intersection of balls, and the parts of its surface on the sphere of each ball.
template <std::size_t N>
struct Overlap
{
  double Volume = 0.0;
  std::array<double, N> Area{};
};

VTKISTHMUSFILTERSATOMS_EXPORT Overlap<1> WholeBall(const Ball& a);

/// The lens of two balls whose spheres meet.
VTKISTHMUSFILTERSATOMS_EXPORT Overlap<2> Lens(const Ball& a, const Ball& b);

/**
 * One half of the intersection of three balls, on one side of the plane of their centers. Their
 * spheres must intersect in two points x, x'.
 *
 * The balls cover the tetrahedron of their centers and x, so its volume is given by inclusion and
 * exclusion: sectors of the balls, minus slices of the lenses, plus the requested half (H.
 * Edelsbrunner, P. Fu, in "Measuring space filling diagrams and voids", 1994).
 */
VTKISTHMUSFILTERSATOMS_EXPORT Overlap<3> HalfTripleIntersection(
  const Ball& a, const Ball& b, const Ball& c);

/// Fraction of all directions from `p` that point into the tetrahedron p, a, b, c.
VTKISTHMUSFILTERSATOMS_EXPORT double SolidAngle(
  const Point3& p, const Point3& a, const Point3& b, const Point3& c);

/// Fraction of the full turn around the edge p, q that lies between the half-planes of a and b.
VTKISTHMUSFILTERSATOMS_EXPORT double DihedralAngle(
  const Point3& p, const Point3& q, const Point3& a, const Point3& b);

}

#endif
