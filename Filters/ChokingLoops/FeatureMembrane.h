/**
 * @file FeatureMembrane.h
 * @brief Computes the loops on the surface and the spanning membrane of a feature from the triangle
 * where a ball gets stuck.
 */
#ifndef isthmus_FeatureMembrane_h
#define isthmus_FeatureMembrane_h

#include "ChokingLoops/FeatureDiagram.h"

#include <functional>
#include <optional>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// From the choke triangle, where a ball gets stuck, to a loop on the surface and its membrane.

/// Loops on M and the triangles that they bound. Ids refer to the points of the sampled surface.
struct Membrane
{
  /// Closed and simple loops, the longest first; consecutive points share an edge of M. Usually
  /// one; several where the ball is stuck between two parts of M, such as two rings side by side.
  std::vector<std::vector<SimplexId>> Loops;
  std::vector<std::array<SimplexId, 3>> Triangles;
  std::vector<Point3> Extra; ///< points off M; their ids follow those of the sampled surface
  bool OnSurface = true;   ///< false: an obstacle kept the loop from reaching M; it was closed on M
  double GrowthCost = 0.0; ///< GreedyPatches::Cost of a greedy membrane; otherwise 0
};

/**
 * Pushes the boundary of a feature's triangle downhill until it lies on M (thesis, 6.3.2, with the
 * discrete gradient in place of local patches): each edge that is not on M is replaced by the rest
 * of the loop that it closed, which was filled before, and the triangles passed form the membrane.
 * Short edges that close no such loop are replaced by the shortest path on M. If there are several
 * loops, the longest, those that are not zero in H1(M), and those on another component are kept;
 * the others are closed by fans.
 *
 * With `span`, the class of the loops must be independent of the classes in it and is added to it,
 * so that handles and tunnels get independent loops. If it is not independent (an obstacle was in
 * the way), the filling of the feature's sum of basis loops on its side is used instead; if that
 * fails too, Loops is empty. Time: proportional to the number of triangles passed.
 */
Membrane FeatureMembrane(const FeatureContext& context, SpaceRegions& regions,
  const ShapeFeature& feature, HomologySpan* span = nullptr);

/// The membrane from MinimumCutTriangles(), with all loops on M; empty if there is none. With
/// `chords`, edges off M between points of M are replaced by the shortest paths on M.
std::optional<Membrane> MinimumCutMembrane(const FeatureContext& context,
  const ShapeFeature& feature, const Point3& center, const ProgressCallback& progress = {},
  bool chords = false);

/// The membrane of `triangles`, whose boundary is `cycle`, with the edges off M replaced by the
/// shortest paths on M. Without Loops if there is no such path, or if `span` already contains the
/// class of the loops.
Membrane SpanningMembrane(const FeatureContext& context, const TriangleChain& triangles,
  const EdgeChain& cycle, HomologySpan* span);

/// Adds the fan of triangles from the first point of a closed loop to its edges.
void AddFan(const std::vector<SimplexId>& loop, std::vector<std::array<SimplexId, 3>>& triangles);

/// Splits a cycle of edges of M (every point in an even number of them) into simple loops of
/// points.
std::vector<std::vector<SimplexId>> SimpleLoops(
  const SurfaceAdjacency& surface, const SurfaceChain& edges);

/// The edges of M between consecutive points of a closed loop.
SurfaceChain LoopEdges(const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop);

/// A diagram, with the membrane and the choke point of each feature.
struct LocatedFeatures
{
  FeatureDiagram Diagram;
  std::vector<std::optional<Membrane>>
    Membranes;                 ///< computed at once for handles and tunnels, otherwise on first use
  std::vector<Point3> Centers; ///< of the ball that gets stuck
};

/// The sum of the classes of a membrane's loops.
HomologyClass MembraneClass(const FeatureContext& context, const Membrane& membrane);

/**
 * True if the loops of another membrane may replace those of a feature. For additional features
 * this is always true. For handles and tunnels it is true if the two classes differ by a sum of the
 * classes of previous features on the same side, so that all loops stay independent whichever are
 * exchanged.
 */
bool IsInterchangeable(const FeatureContext& context, const LocatedFeatures& features,
  std::size_t feature, const Membrane& other);

/// The classes of loops that bound on a side, i.e. those of its handles or of its tunnels.
HomologySpan BoundingClasses(
  const FeatureContext& context, const LocatedFeatures& features, SpaceSide side);

// ------------------------------------------------------------------------------------------
// Loops around a choke point that belong to another class than the cycle closed by its triangle.

/**
 * For a choke whose own loops are contractible on M or slide off the choke: the shortest loop of
 * each class of H1(M; Z/2) that bounds on the side of the feature, along edges and through one or
 * two of the points where the ball touches M. Loops are sorted by length; at most `most` loops of
 * length at most `longest` are returned. Such a class is not contractible, so it contains a
 * geodesic loop. The membrane is the fan from the choke point.
 *
 * Example: in a closed ring-shaped wall of blobs, two neighbouring blobs are separated by the
 * cross-section of the wall, since a single blob is only a bump.
 *
 * Source: J. Erickson, K. Whittlesey, "Greedy optimal homotopy and homology generators", SODA 2005,
 * section 2: the shortest loop of a class through a point is an edge closed through the tree of
 * shortest paths. Time for each contact: O(n log n) in the n points within half of `longest` (or
 * within three quarters of the longest loop found, once there are `most` loops).
 */
std::vector<Membrane> EncirclingMembranes(const FeatureContext& context,
  const LocatedFeatures& features, std::size_t feature, double longest, std::size_t most);

using AcceptClass = std::function<bool(const HomologyClass&)>;

/// The shortest such loop of an accepted class, with the fan from `center`.
std::optional<Membrane> EncirclingMembrane(const FeatureContext& context,
  const ShapeFeature& feature, const Point3& center, const AcceptClass& accepts, double longest);

/// The loop along shortest paths of edges from each contact to the next, if it bounds. This is the
/// last resort, since it may go back and forth. Each path has at most the length `longest`.
std::optional<Membrane> ContactMembrane(const FeatureContext& context,
  const LocatedFeatures& features, std::size_t feature, double longest);

}

#endif
