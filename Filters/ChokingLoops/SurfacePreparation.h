/**
 * @file SurfacePreparation.h
 * @brief From the input surface to its samples: checks, repair, refinement.
 */
#ifndef isthmus_SurfacePreparation_h
#define isthmus_SurfacePreparation_h

#include "Core/Geometry.h"
#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "Persistence/CellFiltration.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Repair of small defects of a surface before its analysis.

/// The repairs made to a surface.
struct RepairReport
{
  std::int64_t Changed = 0;   ///< number of triangles of the input that were removed
  std::vector<Point3> Places; ///< their centers
  std::string Message;        ///< message to the user; empty if nothing was repaired
};

/// A repair may change at most this fraction of the volume.
constexpr double RepairableShare = 0.01;

/**
 * Makes `surface` closed, manifold and oriented, without thin triangles and, unless
 * `allowCrossings`, without crossings. Needles and caps are removed as in ThinTriangles.h, double
 * triangles and crossings as in SurfaceRepair.h. Points where sheets touch are duplicated, and each
 * copy is moved by a hundredth of the way to the mean of its neighbours.
 *
 * Throws std::invalid_argument if the repair fails or changes the volume by more than
 * RepairableShare. `what` describes the defect and is the beginning of that message.
 */
TriangleMesh RepairedForAnalysis(const SurfaceView& surface, const std::string& what,
  bool allowCrossings, RepairReport& report, const ProgressCallback& progress = {});

// ------------------------------------------------------------------------------------------
// Checks of the requirements on a surface; messages name the triangles that violate them.

/**
 * Returns `surface` with coinciding points merged and unused ones dropped, if it is closed,
 * manifold, consistently oriented, finite, between 1e-32 and 1e32 in size, not in a plane and,
 * unless `allowCrossings`, free of self-intersections. Otherwise throws std::invalid_argument with
 * a message that names the triangles.
 *
 * With `report`, a closed and oriented surface that has crossings, touching parts, double triangles
 * or thin triangles is repaired by RepairedForAnalysis(), and `report` describes the repairs.
 */
TriangleMesh CheckedSurface(TriangleMesh surface, bool allowCrossings,
  const ProgressCallback& progress = {}, RepairReport* report = nullptr);

// ------------------------------------------------------------------------------------------
// Splits a surface so finely that its points represent it.

/**
 * For each point of `mesh`: the largest distance e from a point of a triangle to the nearest corner
 * of that triangle, over the triangles round the point and those with a corner within 2 e of it:
 * the samples nearest to a point of a triangle are at most that far from its corners.
 *
 * For a surface M whose points S are samples, d_M^2 <= d_S^2 <= d_M^2 + e^2 everywhere: a feature
 * of S with death^2 - birth^2 > e^2 is a feature of M, and a radius d of S corresponds to a radius
 * of M between sqrt(d^2 - e^2) and d. O(n).
 */
std::vector<double> SamplingErrors(const SurfaceView& mesh);

/// Largest cosine of the angle between normals on opposite sides of a wall or a gap; those at an
/// edge of the wall are less apart.
constexpr double OppositeNormals = -0.7;

/// The errors that samples of a surface M cause.
struct SampleErrors
{
  std::vector<double> Point; ///< SamplingErrors(); empty if M itself is part of a complex
  /// How far M is from the samples' triangles (AdaptiveSamples.h); empty if they are M.
  std::vector<double> Deviation{};
  std::vector<Point3> Normal{}; ///< of the samples' triangles at their points

  /**
   * The largest possible d_S^2 - d_M^2 (AdaptiveSamples.h) where d_M^2 is `squared`, by the errors
   * at the corners of a simplex: e^2 for samples on M, e^2 + h^2 + 2 h d_M with a deviation h; with
   * a margin for rounding.
   */
  double Squared(const SimplexId* corners, std::size_t count, double squared = 0.0) const
  {
    double e = 0.0;
    double h = 0.0;
    for (std::size_t k = 0; k < count; ++k)
    {
      const auto p = static_cast<std::size_t>(corners[k]);
      e = std::max(e, this->Point.empty() ? 0.0 : this->Point[p]);
      h = std::max(h, this->Deviation.empty() ? 0.0 : this->Deviation[p]);
    }
    // The sampling error of M itself is included in e, so that sqrt(d_M^2 + t^2) is at most this.
    return (1.0 + 1e-7) * (e * e + h * (h + 2.0 * std::sqrt(squared + e * e)));
  }

  /// The squared distance up to which a simplex is not distinct from M. Below 0 if its corners are
  /// on opposite sides of a wall or a gap: it is not part of M, however thin that is.
  double SquaredDistance(const SimplexId* corners, std::size_t count) const
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      const Point3& normal = this->Normal[static_cast<std::size_t>(corners[k])];
      for (std::size_t j = 0; j < k; ++j)
      {
        if (Dot(normal, this->Normal[static_cast<std::size_t>(corners[j])]) < OppositeNormals)
        {
          return -1.0;
        }
      }
    }
    return this->Squared(corners, count);
  }
};

/// Edge length that spreads about `points` samples evenly over the area of `mesh`.
double EdgeLengthFor(const SurfaceView& mesh, double points);

/**
 * Splits edges longer than `limit(point, point)`, called with the two ends, at their midpoints
 * until none is left. Surface and orientation are the same; the original points come first.
 *
 * Returns an empty mesh if this would need more than `maximumPoints` points.
 */
TriangleMesh SplitLongEdges(TriangleMesh mesh,
  const std::function<double(const Point3&, const Point3&)>& limit, std::size_t maximumPoints,
  const ProgressCallback& progress = {});

// ------------------------------------------------------------------------------------------
// Sampling of a surface for its choking loops, and local refinement.

/// A place where the samples should be denser: the longest edge wanted there, and how far the
/// surface may be from the samples' triangles.
struct Refinement
{
  Point3 Center;
  double Radius;
  double EdgeLength;
  double Deviation = HUGE_VAL;
};

/// Surfaces with more points than this are analysed on coarser samples (AdaptiveSamples.h).
constexpr std::size_t MostUsualSamples = 40000;

/// If more places than this need refinement, the sampling is considered too coarse everywhere.
constexpr std::size_t ManyPlaces = 64;

/**
 * The surface split until no edge is longer than `spacing`. If that is 0, it is set to the spacing
 * of about 20,000 evenly spread samples, or to a larger one if needles would need many more.
 *
 * @throws std::invalid_argument for an invalid spacing, or one that needs more than 20 million
 * points along the edges alone; std::runtime_error if more are needed in total; Cancelled.
 */
TriangleMesh FirstSamples(
  const SurfaceView& surface, double& spacing, const ProgressCallback& progress = {});

/// `mesh` split further near the places given, or everywhere to 0.6 of `spacing` if there are more
/// than ManyPlaces. Returns an empty mesh if this would need too many points, or if even the
/// spacing `finest`, the limit of such rounds, would resolve less than half of many places (e.g. on
/// a flat surface or a needle).
TriangleMesh Refined(const SurfaceView& mesh, const std::vector<Refinement>& wanted, double spacing,
  double finest, const ProgressCallback& progress = {});

}

#endif
