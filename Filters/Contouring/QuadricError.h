/**
 * @file QuadricError.h
 * @brief The point nearest to a set of planes within a box.
 */
#ifndef isthmus_QuadricError_h
#define isthmus_QuadricError_h

#include "Core/Geometry.h"

#include <cstdint>

namespace isthmus
{

/**
 * Sum over planes (through p, unit normal n) of (n . (x - p))^2, and the mean of the p. Kept as the
 * quadratic form of x around the first plane's p, so that sums of many cells are as small as that
 * of one; 160 bytes.
 */
class QuadraticErrors
{
public:
  void Add(const Point3& p, const Point3& n);
  void Add(const QuadraticErrors& other);

  std::int64_t NumberOfPlanes() const { return this->Count; }
  /// Mean of the points. @pre a plane was added.
  Point3 Mean() const;
  /// The sum at `x`; rounding leaves 1e-16 of the squared distance to the planes' points.
  double At(const Point3& x) const;

  /**
   * The x in `box` where the sum is least; in directions with an eigenvalue below `threshold` times
   * the largest, nearest to the mean of the points. Where the least of all space lies outside,
   * the sides, edges and corners of the box are searched, each exactly. @pre a plane was added, and
   * the points lie in the box.
   */
  Point3 Least(const Bounds3& box, double threshold) const;

  /// In how many directions the normals vary: eigenvalues above `threshold` times the largest.
  int Rank(double threshold) const;

private:
  /// The matrix times `d`.
  Point3 Times(const Point3& d) const;

  std::int64_t Count = 0;
  Point3 Origin{};                ///< the first p; all else is relative to it
  std::array<Point3, 3> Matrix{}; ///< sum of n n^T
  Point3 Vector{};                ///< sum of (n . p) n
  double Constant = 0.0;          ///< sum of (n . p)^2
  Point3 Sum{};                   ///< of the p
};

}

#endif
