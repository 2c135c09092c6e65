/**
 * @file QuadricError.h
 * @brief Quadric errors: finds the point that best fits a set of planes within a box.
 */
#ifndef isthmus_QuadricError_h
#define isthmus_QuadricError_h

#include "Core/Geometry.h"

#include <cstdint>
#include <vector>

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// The point nearest to a set of planes within a box.

/**
 * Sum over planes (through p, with unit normal n) of (n . (x - p))^2, and the mean of the points p.
 * It is stored as the quadratic form of x around the p of the first plane, so that sums of many
 * cells take as little memory as that of one: 160 bytes.
 */
class QuadricError
{
public:
  void Add(const Point3& p, const Point3& n);
  void Add(const QuadricError& other);

  std::int64_t NumberOfPlanes() const { return this->Count; }
  /// Mean of the points. @pre a plane was added.
  Point3 Mean() const;
  /// The sum at `x`; the rounding error is 1e-16 of the squared distance to the points of the
  /// planes.
  double At(const Point3& x) const;

  /**
   * The x in `box` where the sum is least; in directions with an eigenvalue below `threshold` times
   * the largest, nearest to the mean of the points. If the minimum over all space lies outside the
   * box, the faces, edges and corners of the box are searched, each exactly. @pre a plane was
   * added, and the points lie in the box.
   */
  Point3 Least(const Bounds3& box, double threshold) const;

  /// Number of directions in which the normals vary: that of eigenvalues above `threshold` times
  /// the largest.
  int Rank(double threshold) const;

private:
  /// The matrix times `d`.
  Point3 Times(const Point3& d) const;

  std::int64_t Count = 0;
  Point3 Origin{};                ///< the first p; everything else is relative to it
  std::array<Point3, 3> Matrix{}; ///< sum of n n^T
  Point3 Vector{};                ///< sum of (n . p) n
  double Constant = 0.0;          ///< sum of (n . p)^2
  Point3 Sum{};                   ///< of the p
};

//--------------------------------------------------------------------------------------------------
// The planes of a piece of surface in a cell, of faces that bend.
//
// The tangent planes of a curved face do not meet on it: relative to a point x of a sphere of
// radius R, the tangent plane at a distance s passes s^2 / 2 R outside. The plane through the
// crossing p_i whose normal is halfway between the normals at p_i and at x,
//
//     (n_i + n(x)) . (x - p_i) = 0,
//
// passes through x for every sphere and, with n the gradient, for every quadric (the trapezoid rule
// along the chord is exact for linear gradients). n(x) is n(p) + k (x - p) with p and n the means
// of a face's crossings in the cell and k the curvature that fits them best. A face consists of
// crossings that can be linked by normals differing by less than 30 degrees.

struct TangentPlane
{
  Point3 Place;
  Point3 Normal; ///< unit
};

/**
 * The planes that meet best in `around`: the tangent planes, or those halfway if they meet better,
 * as on edges and corners of curved faces. If the normals vary in only one direction, as judged by
 * `threshold` (QuadricError::Rank), the tangent planes are used. O(n^2), n <= 12 in a cell.
 * @pre `planes` is not empty; `around` contains their points.
 */
QuadricError FitQuadricError(
  const std::vector<TangentPlane>& planes, const Bounds3& around, double threshold);

}

#endif
