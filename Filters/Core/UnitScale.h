/**
 * @file UnitScale.h
 * @brief Very large and very small surfaces, brought to about 1 and back.
 */
#ifndef isthmus_UnitScale_h
#define isthmus_UnitScale_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersCoreModule.h"

#include <vector>

namespace isthmus
{

/// How much longer than the shortest edge a surface may reach: where that is brought to about 1,
/// sixth powers of edges, which squared volumes are, are just above 0.
constexpr double LargestReach = 1e50;

/**
 * Brings coordinates to about 1 for code that takes fourth powers of lengths, and back.
 *
 * The factor is a power of two, so nothing is rounded; it is 1 where the largest coordinate is
 * between 2^-20 and 2^20, so ordinary data come as they are. Only coordinates below the largest by
 * more than LargestReach become 0: products of lengths in which they alone differ are no doubles,
 * and CGAL divides by them. O(points).
 */
class VTKISTHMUSFILTERSCORE_EXPORT UnitScale
{
public:
  /// Points that are not finite are not looked at.
  /// @throws std::invalid_argument, with the point, for a coordinate beyond LargestLength, and
  /// where all are below SmallestLength but not 0.
  explicit UnitScale(const View<Point3>& points);

  /// Of the surface's points.
  /// @throws std::invalid_argument, with the triangle, too, for an edge that is not 0, and shorter
  /// than the largest coordinate by more than LargestReach: one point far away makes all others
  /// next to one.
  explicit UnitScale(const SurfaceView& surface);

  /// Of a length, to the scale that is worked in.
  double Factor() const { return this->TheFactor; }
  /// Apply() would change nothing.
  bool IsOne() const { return this->TheFactor == 1.0 && this->Least == 0.0; }

  void Apply(std::vector<Point3>& points) const;
  void Undo(std::vector<Point3>& points) const;

private:
  double TheFactor = 1.0;
  double Least = 0.0; ///< what is below, scaled, becomes 0
};

}

#endif
