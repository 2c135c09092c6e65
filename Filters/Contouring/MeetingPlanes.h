/**
 * @file MeetingPlanes.h
 * @brief The planes of a piece of surface in a cell, of faces that bend.
 *
 * The tangent planes of a curved face do not meet on it: seen from a point x of a sphere of radius
 * R, the tangent plane at a distance s passes s^2 / 2 R outside. The plane through the crossing p_i
 * whose normal is halfway between that there and that at x,
 *
 *     (n_i + n(x)) . (x - p_i) = 0,
 *
 * passes through x for every sphere and, with n the gradient, for every quadric (the trapezoid rule
 * along the chord is exact for linear gradients). n(x) is n(p) + k (x - p) with p and n the means
 * of a face's crossings in the cell and k the curvature that fits them best. A face is crossings
 * whose normals differ by less than 30 degrees, one by one.
 */
#ifndef isthmus_MeetingPlanes_h
#define isthmus_MeetingPlanes_h

#include "Contouring/QuadricError.h"
#include "Core/Geometry.h"

#include <vector>

namespace isthmus
{

struct TangentPlane
{
  Point3 Place;
  Point3 Normal; ///< unit
};

/**
 * The planes that meet best in `around`: the tangent ones, or those halfway where they meet better,
 * which is on edges and corners of curved faces. Where the normals vary in one direction only, as
 * told by `threshold` (QuadraticErrors::Rank), the tangent ones. O(n^2), n <= 12 in a cell.
 * @pre `planes` is not empty; `around` has their places.
 */
QuadraticErrors MeetingPlanes(
  const std::vector<TangentPlane>& planes, const Bounds3& around, double threshold);

}

#endif
