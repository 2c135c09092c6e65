/**
 * @file UnitScale.h
 * @brief Brings surfaces of any size at any place to about 1 near the origin, and back.
 */
#ifndef isthmus_UnitScale_h
#define isthmus_UnitScale_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersCoreModule.h"

#include <vector>

namespace isthmus
{

/// Largest ratio of a surface's extent to its shortest edge: if the extent is scaled to about 1,
/// sixth powers of edges (squared volumes) are still above 0.
constexpr double LargestReach = 1e50;

/**
 * Scales coordinates to about 1 for code that computes fourth powers of lengths, and moves surfaces
 * that are far from the origin there, for code whose tolerances grow with the coordinates: CGAL's
 * refinement does not end 1e7 diameters away. And back.
 *
 * A surface is moved along each axis on which its middle is more than 64 times its extent away, so
 * that differences of coordinates are exact. The factor is a power of two, so nothing is rounded;
 * it is 1 where the largest coordinate is then between 2^-20 and 2^20, so ordinary data are not
 * changed. Only coordinates that are smaller than the largest one by more than the factor
 * LargestReach become 0: products of lengths in which only these differ would underflow, and CGAL
 * divides by them. O(points).
 */
class VTKISTHMUSFILTERSCORE_EXPORT UnitScale
{
public:
  /// Points that are not finite are ignored.
  /// @throws std::invalid_argument, with the point, if a coordinate exceeds LargestLength, or if
  /// all are below SmallestLength but not 0.
  explicit UnitScale(const View<Point3>& points);

  /// The scale of the points of a surface.
  /// @throws std::invalid_argument also, with the triangle, if an edge is not 0 and is shorter than
  /// the largest coordinate by more than the factor LargestReach; one point far away makes all
  /// others almost coincide.
  explicit UnitScale(const SurfaceView& surface);

  /// Converts a length to the scaled unit.
  double Factor() const { return this->TheFactor; }
  /// Apply() would change nothing.
  bool IsOne() const
  {
    return this->TheFactor == 1.0 && this->Least == 0.0 && this->Middle == Point3{};
  }

  void Apply(std::vector<Point3>& points) const;
  void Undo(std::vector<Point3>& points) const;
  void Undo(Point3& point) const;

private:
  Point3 Middle{}; ///< becomes the origin
  double TheFactor = 1.0;
  double Least = 0.0; ///< smaller scaled coordinates become 0
};

}

#endif
