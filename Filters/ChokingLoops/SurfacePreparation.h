/**
 * @file SurfacePreparation.h
 * @brief From the surface given to samples: checked, repaired, refined.
 */
#ifndef isthmus_SurfacePreparation_h
#define isthmus_SurfacePreparation_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <functional>
#include <string>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Repair of small defects of a surface before its analysis.

/// What was done to a surface.
struct RepairReport
{
  std::int64_t Changed = 0;   ///< triangles of the input that are no longer there
  std::vector<Point3> Places; ///< their centres
  std::string Message;        ///< one message; empty: nothing was done
};

/// More than this share of the volume is not changed.
constexpr double RepairableShare = 0.01;

/**
 * `surface` closed, manifold and oriented, without thin triangles and, unless `allowCrossings`,
 * without crossings: needles and caps as in ThinTriangles.h, double triangles and crossings as in
 * SurfaceRepair.h; points where sheets touch become several, each drawn a hundredth of the way to
 * the middle of its neighbours.
 *
 * std::invalid_argument with a message when that fails or changes the volume by more than
 * RepairableShare. `what` says what is wrong and begins that message.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleMesh RepairedForAnalysis(const SurfaceView& surface,
  const std::string& what, bool allowCrossings, RepairReport& report,
  const ProgressCallback& progress = {});

// ------------------------------------------------------------------------------------------
// Requirements on a surface; messages name the triangles that violate them.

/**
 * `surface` with coinciding points merged and unused ones left out, if it is closed, manifold,
 * consistently oriented, finite, between 1e-32 and 1e32 in size, not in a plane and, unless
 * `allowCrossings`, free of self-intersections. Else std::invalid_argument with a message that
 * names the triangles.
 *
 * With `report`, what is closed and oriented but has crossings, touching or double parts or thin
 * triangles is repaired as RepairedForAnalysis() does, and it holds what was done.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleMesh CheckedSurface(TriangleMesh surface,
  bool allowCrossings, const ProgressCallback& progress = {}, RepairReport* report = nullptr);

// ------------------------------------------------------------------------------------------
// A surface split so finely that its points stand for the whole of it.

/**
 * For each point of `mesh`: the largest distance e from a point of a triangle to the nearest corner
 * of that triangle, over the triangles round the point and round its neighbours.
 *
 * For a surface M whose points S are samples, d_M^2 <= d_S^2 <= d_M^2 + e^2 everywhere: a feature
 * of S with death^2 - birth^2 > e^2 is one of M, and a radius d of S means one of M between
 * sqrt(d^2 - e^2) and d. O(n).
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<double> SamplingErrors(const SurfaceView& mesh);

/// Edge length that spreads about `points` samples evenly over the area of `mesh`.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double EdgeLengthFor(const SurfaceView& mesh, double points);

/**
 * Splits edges longer than `limit(point, point)` at their midpoints, again and again, until none is
 * left. Same surface, same orientation, first points unchanged. `limit` gets the two ends.
 *
 * An empty mesh when that takes more than `maximumPoints`.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleMesh SplitLongEdges(TriangleMesh mesh,
  const std::function<double(const Point3&, const Point3&)>& limit, std::size_t maximumPoints,
  const ProgressCallback& progress = {});

// ------------------------------------------------------------------------------------------
// How finely a surface is sampled for its choking loops, and where more finely.

/// Where the samples should lie closer, and how close.
struct Refinement
{
  Point3 Centre;
  double Radius;
  double EdgeLength;
};

/// More places than this to be refined mean that the sampling is too coarse everywhere.
constexpr std::size_t ManyPlaces = 64;

/**
 * The surface split until no edge is longer than `spacing`; where that is 0, it becomes the spacing
 * of about 20,000 samples spread evenly, longer where needles would take many more.
 *
 * @throws std::invalid_argument for a spacing that is no length, or takes more than 20 million
 * points along the edges alone; std::runtime_error when it takes more; Cancelled.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleMesh FirstSamples(
  const SurfaceView& surface, double& spacing, const ProgressCallback& progress = {});

/// `mesh` split again near the places wanted, or everywhere to 0.6 of `spacing` where these are
/// more than ManyPlaces. An empty mesh when that takes too many points, or when less than half of
/// many places would be settled by `finest`, to which rounds like this one come: a flat surface, a
/// needle.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleMesh Refined(const SurfaceView& mesh,
  const std::vector<Refinement>& wanted, double spacing, double finest,
  const ProgressCallback& progress = {});

}

#endif
