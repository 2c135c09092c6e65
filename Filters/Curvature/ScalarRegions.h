/**
 * @file ScalarRegions.h
 * @brief Areas of the parts of a triangle surface between thresholds of one or two scalars.
 *
 * n thresholds t_1 < ... < t_n cut the values of a scalar into n + 1 regions: region 0 contains the
 * values below t_1, region i those in [t_i, t_{i+1}), and region n those from t_n upwards.
 *
 * **Fractional areas.** Scalars are linear within a triangle. If a threshold separates corner k
 * from the corners i and j, it cuts off the area s t A with s = |f_k| / (|f_k| + |f_i|) and t =
 * |f_k| / (|f_k| + |f_j|), where f is the scalar minus the threshold; for several thresholds and
 * two scalars, the polygon is cut repeatedly. **Whole triangles** is the quick rule: a triangle
 * counts for the region that contains at least two of its corners, or for the middle one if the
 * corners are in three regions. Source: X. Feng's thesis, Fig. 4.1, Tables 4.6 to 4.8.
 *
 * With either rule the areas form a partition, up to rounding: their sum is the area of the
 * surface, and summing a joint table over the regions of one scalar gives the areas of the other.
 */
#ifndef isthmus_ScalarRegions_h
#define isthmus_ScalarRegions_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"

#include <vector>

namespace isthmus
{

/// A scalar on the points of a surface and its thresholds, ascending.
struct ThresholdedScalar
{
  std::vector<double> Values; ///< one for each point
  std::vector<double> Thresholds;

  std::size_t Regions() const { return this->Thresholds.size() + 1; }

  /// Region of a value, in [0, Regions()).
  std::size_t GetRegion(double value) const;
};

enum class AreaRule
{
  Fractional = 0,
  WholeTriangles = 1
};

/// Region of a triangle by the quick rule: the middle one of the regions of its three corners.
std::size_t MiddleRegion(std::size_t a, std::size_t b, std::size_t c);

/**
 * Area of each pair of regions: entry i x second.Regions() + j belongs to region i of `first` and
 * region j of `second`. A scalar without thresholds has one region; use one as `second` to get a
 * single table.
 *
 * O(triangles x regions), in parallel, bitwise the same on any number of threads.
 * @throws std::invalid_argument for thresholds that do not ascend or are not numbers, and for a
 * value at a used point that is not finite; Cancelled.
 */
std::vector<double> RegionAreas(const SurfaceView& mesh, const ThresholdedScalar& first,
  const ThresholdedScalar& second, AreaRule rule, const ProgressCallback& progress = {});

}

#endif
