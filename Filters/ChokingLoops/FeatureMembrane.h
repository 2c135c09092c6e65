/**
 * @file FeatureMembrane.h
 * @brief From the triangle where a ball gets stuck to a loop on the surface and what spans it.
 */
#ifndef isthmus_FeatureMembrane_h
#define isthmus_FeatureMembrane_h

#include "ChokingLoops/FeatureDiagram.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <optional>

namespace isthmus
{

/// Loops on M and the triangles that they bound. Ids are those of the sampled surface's points.
struct Membrane
{
  /// Closed and simple; consecutive points share an edge of M. The longest first. Mostly one: more
  /// where the ball is stuck between two parts of M, such as two rings side by side.
  std::vector<std::vector<SimplexId>> Loops;
  std::vector<std::array<SimplexId, 3>> Triangles;
  std::vector<Point3> Extra; ///< points off M: their ids follow those of the sampled surface
  bool OnSurface = true; ///< false: an obstacle kept the loop from reaching M; it was closed on M
};

/**
 * Pushes the boundary of a feature's triangle downhill until it lies on M (thesis, 6.3.2, with the
 * discrete gradient in place of local patches): each edge that is not one of M is replaced by the
 * rest of the loop that it closed and that was filled before, and the triangles passed are the
 * membrane. Short edges that nothing precedes are replaced by the shortest path on M. Of several
 * loops the longest is kept and those that are not zero in H1(M) or lie on another component, the
 * others are closed by fans.
 *
 * With `span`, the loops' class must raise the rank of the classes in it, and is added to it: so
 * handles and tunnels end up with independent loops. Where it does not (an obstacle in the way),
 * what fills the feature's sum of basis loops on its side is taken instead, and if that fails too,
 * Loops is empty.
 * Time: proportional to what is passed.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT Membrane FeatureMembrane(const FeatureContext& context,
  SpaceRegions& regions, const ShapeFeature& feature, HomologySpan* span = nullptr);

/// The membrane that TightestCut() finds, with all of its loops on M; nothing where it finds none.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::optional<Membrane> TightMembrane(
  const FeatureContext& context, const ShapeFeature& feature, const Point3& centre,
  const ProgressCallback& progress = {});

/// Adds the fan that a closed loop of points bounds, seen from its first point.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void AddFan(
  const std::vector<SimplexId>& loop, std::vector<std::array<SimplexId, 3>>& triangles);

/// Splits a cycle of edges of M (every point in an even number of them) into simple loops of
/// points.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<std::vector<SimplexId>> SimpleLoops(
  const SurfaceAdjacency& surface, const SurfaceChain& edges);

/// The edges of M between consecutive points of a closed loop.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT SurfaceChain LoopEdges(
  const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop);

}

#endif
