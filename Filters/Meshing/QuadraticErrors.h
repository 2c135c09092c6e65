/**
 * @file QuadraticErrors.h
 * @brief The point nearest to a set of planes within a box.
 */
#ifndef isthmus_QuadraticErrors_h
#define isthmus_QuadraticErrors_h

#include "TriangleMesh.h"

namespace isthmus
{

/// Sum over planes (through p, unit normal n) of (n . (x - p))^2, and the mean of the p.
class QuadraticErrors
{
public:
  void Add(const Point3& p, const Point3& n);

  /**
   * The x in `box` where the sum is least; in directions with an eigenvalue below `threshold` times
   * the largest, nearest to the mean of the points. Where the least of all space lies outside,
   * the sides, edges and corners of the box are searched, each exactly. @pre a plane was added, and
   * the points lie in the box.
   */
  Point3 Least(const Bounds3& box, double threshold) const;

private:
  double At(const Point3& fromMean) const;

  std::array<Point3, 3> Matrix{}; ///< sum of n n^T
  Point3 Sum{};                   ///< of the points
  std::vector<std::array<Point3, 2>> Planes;
};

}

#endif
