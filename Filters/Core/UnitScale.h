/**
 * @file UnitScale.h
 * @brief Scales very large and very small surfaces to about 1 and back.
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
 * Scales coordinates to about 1 for code that computes fourth powers of lengths, and back.
 *
 * The factor is a power of two, so nothing is rounded; it is 1 where the largest coordinate is
 * between 2^-20 and 2^20, so ordinary data are not changed. Only coordinates below the largest by
 * more than LargestReach become 0: products of lengths in which they alone differ would underflow,
 * and CGAL divides by them. O(points).
 */
class VTKISTHMUSFILTERSCORE_EXPORT UnitScale
{
public:
  /// Points that are not finite are ignored.
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
