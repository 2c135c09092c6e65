/**
 * @file BindingSites.h
 * @brief Finds and ranks patches of a surface where a quantity is large: likely binding sites.
 *
 * **Patches.** Points of the same kind that are connected by edges and whose amplitude is above a
 * threshold. The threshold is a value, or the quantile q of the surface's area: the value exceeded
 * on a fraction 1 - q of the area (points without a kind count with amplitude 0). Patches of the
 * same kind with points no farther apart than MergeDistance (straight through space) are merged.
 *
 * **Measures**, with A_i the area of point i (a third of its triangles):
 * - Score = sum of A_i x amplitude_i, the integral over the patch;
 * - Area = sum of A_i; Center and MeanPotential: means weighted by A_i;
 * - MeanDepth: the mean distance of a point to the convex hull of the surface, depth(x) = min over
 *   unit vectors n of (max over surface points p of n.p) - n.x, over 1000 directions: HullDepth.h
 *   states by how much this is too large (about 0.2 angstrom for proteins). The hull needs no probe
 *   radius and no grid; a cavity's depth is its distance to the outside.
 *
 * A patch lines a pocket, so its Center, the mean of points on the wall, lies within the pocket.
 */
#ifndef isthmus_BindingSites_h
#define isthmus_BindingSites_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersPocketsModule.h" // for the export macro

#include <array>
#include <vector>

namespace isthmus
{

enum class SiteRanking
{
  Score = 0,
  Area = 1,
  MeanDepth = 2,
  MeanPotential = 3 ///< its absolute value
};

struct BindingSiteOptions
{
  bool AutomaticThreshold = true; ///< Quantile of the area
  double Quantile = 0.93;         ///< in [0, 1)
  double Threshold = 1.0;         ///< of the amplitude
  double MergeDistance = 1.0;     ///< length; 0: patches are not merged
  double MinimumArea = 5.0;       ///< length^2; smaller patches are dropped
  SiteRanking RankBy = SiteRanking::Score;
};

/// @throws std::invalid_argument with property, value and range.
VTKISTHMUSFILTERSPOCKETS_EXPORT void Check(const BindingSiteOptions& options);

/// One value for each point of the surface.
struct SiteFields
{
  std::vector<double> Amplitude;   ///< not negative; NaN: not part of any patch
  std::vector<unsigned char> Kind; ///< 0: not part of any patch
  std::vector<double> Potential;   ///< for the mean only; may be empty (mean NaN)
};

struct BindingSite
{
  unsigned char Kind = 0;
  double Score = 0.0;
  double Area = 0.0;
  double Volume = 0.0; ///< of the pocket, length^3; 0: a patch
  double MeanDepth = 0.0;
  double MeanPotential = 0.0;
  std::array<double, 3> Center{ 0.0, 0.0, 0.0 };
  vtkIdType Points = 0;
};

struct BindingSiteResult
{
  std::vector<BindingSite> Sites; ///< the first is the best; ties in the order of lowest point ids
  std::vector<int> Labels;        ///< for each point: 0, or 1 + index in Sites
  double Threshold = 0.0;         ///< the threshold used
};

/**
 * Finds and ranks the patches.
 *
 * Throws std::invalid_argument for a quantile outside [0, 1), and a threshold, distance or area
 * that is negative or not finite; Cancelled. Results are bitwise the same on any number of threads.
 * Time: O(n log n) for n points, plus 1000 n for the hull, in parallel, plus the number of pairs of
 * selected points within MergeDistance. Memory: 60 bytes per point.
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT BindingSiteResult FindBindingSites(const SurfaceView& mesh,
  const SiteFields& fields, const BindingSiteOptions& options,
  const ProgressCallback& progress = {});

}

#endif
