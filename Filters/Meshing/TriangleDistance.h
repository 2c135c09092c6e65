/**
 * @file TriangleDistance.h
 * @brief Distance of a point from a segment and from a triangle.
 */
#ifndef isthmus_TriangleDistance_h
#define isthmus_TriangleDistance_h

#include <Eigen/Dense>

#include <algorithm>
#include <limits>

namespace isthmus
{

/// Squared distance of `x` from the segment a b.
inline double SquaredDistanceToSegment(
  const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  using Eigen::Vector3d;
  const Vector3d d = b - a;
  const double dd = d.squaredNorm();
  const double t = dd > 0.0 ? std::clamp((x - a).dot(d) / dd, 0.0, 1.0) : 0.0;
  return (x - a - t * d).squaredNorm();
}

/// Squared distance of `x` from the triangle: to its plane over the inside, else to its border.
inline double SquaredDistanceToTriangle(const Eigen::Vector3d& x, const Eigen::Vector3d& a,
  const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  using Eigen::Vector3d;
  const Vector3d normal = (b - a).cross(c - a);
  const double nn = normal.squaredNorm();
  const bool flat = !(nn > 0.0);
  const bool beyond[3] = { flat || (b - a).cross(x - a).dot(normal) < 0.0,
    flat || (c - b).cross(x - b).dot(normal) < 0.0,
    flat || (a - c).cross(x - c).dot(normal) < 0.0 };
  if (!beyond[0] && !beyond[1] && !beyond[2])
  {
    const double height = normal.dot(x - a);
    return height * height / nn;
  }
  // The nearest border point is on an edge that x is beyond.
  double nearest = std::numeric_limits<double>::infinity();
  if (beyond[0])
  {
    nearest = std::min(nearest, SquaredDistanceToSegment(x, a, b));
  }
  if (beyond[1])
  {
    nearest = std::min(nearest, SquaredDistanceToSegment(x, b, c));
  }
  if (beyond[2])
  {
    nearest = std::min(nearest, SquaredDistanceToSegment(x, c, a));
  }
  return nearest;
}

}

#endif
