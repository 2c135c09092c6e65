/**
 * @file AdaptiveSamples.h
 * @brief Samples of a fine surface that are only as dense as its features need.
 */
#ifndef isthmus_AdaptiveSamples_h
#define isthmus_AdaptiveSamples_h

#include "ChokingLoops/SurfacePaths.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "Core/Progress.h"
#include "Surfaces/SurfaceCoarsening.h"

#include <future>
#include <memory>
#include <utility>
#include <vector>

namespace isthmus
{

/// The points and triangles N that represent a surface M in the analysis, and the error that this
/// causes.
struct SurfaceSamples
{
  TriangleMesh Mesh;
  /// SamplingErrors() of Mesh, with those of M added in quadrature where Mesh is coarser than M.
  SampleErrors Errors{};
  std::vector<SimplexId> Origin; ///< of each point: the point of M; empty if they are the same
};

/**
 * A surface with more points than its analysis needs. Its samples are some of its points, joined by
 * triangles that stay close to it (SurfaceCoarsening.h).
 *
 * With distance d_M from M and d_S from the samples S, which lie on M: d_M <= d_S. The nearest
 * point of M to a place is within t of a point of M (its own sampling error), which is within h of
 * Mesh (Deviation), and each point of Mesh is within e of the nearest corner of its triangle, so
 * that d_S^2 <= (sqrt(d_M^2 + t^2) + h)^2 + e^2.
 */
class FineSurface
{
public:
  /// Samples with edges of at most `spacing`, shorter where the surface is thin. They do not cross
  /// themselves unless `allowCrossings`. @pre `surface` has passed CheckedSurface().
  FineSurface(TriangleMesh surface, double spacing, bool allowCrossings);

  const TriangleMesh& Mesh() const { return this->Surface; }

  /// Half edges of Mesh(), which are collected on another thread; waits for them.
  const SurfaceAdjacency& Adjacency() const;

  SurfaceSamples Sample(const ProgressCallback& progress = {});

  /// Requires denser samples at these places; false if the surface has no more points there.
  bool Refine(const std::vector<Refinement>& wanted);

  /// The points of the surface that are nearer to a polyline than `radius`, with their distance,
  /// the nearest first.
  std::vector<std::pair<double, SimplexId>> PointsNear(
    const std::vector<Point3>& path, double radius) const;

  /// The sampling error of the surface itself around a point.
  double OwnErrorAt(SimplexId point) const
  {
    return this->OwnError[static_cast<std::size_t>(point)];
  }

private:
  void AdaptToThickness(const ProgressCallback& progress);
  void Grade();
  CoarseSurface Coarse(const ProgressCallback& progress);

  TriangleMesh Surface;
  bool AllowCrossings;
  bool IsAdapted = false; ///< Size to the thickness of the surface
  std::vector<double> OwnError;
  std::vector<Bounds3> Boxes;    ///< around consecutive points
  std::vector<double> Size;      ///< by point: longest edge of the samples,
  std::vector<double> Tolerance; ///< and largest deviation
  mutable std::future<std::unique_ptr<SurfaceAdjacency>> Making;
  mutable std::unique_ptr<SurfaceAdjacency> HalfEdges;
};

}

#endif
