/**
 * @file FeatureMembrane.h
 * @brief From the triangle where a ball gets stuck to loops on the surface and the membrane that
 * spans them.
 */
#ifndef isthmus_FeatureMembrane_h
#define isthmus_FeatureMembrane_h

#include "ChokingLoops/FeatureDiagram.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <optional>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// From the triangle where a ball gets stuck to a loop on the surface and what spans it.

/// Loops on M and the triangles that they bound. Ids are those of the sampled surface's points.
struct Membrane
{
  /// Closed and simple; consecutive points share an edge of M. The longest first. Mostly one: more
  /// where the ball is stuck between two parts of M, such as two rings side by side.
  std::vector<std::vector<SimplexId>> Loops;
  std::vector<std::array<SimplexId, 3>> Triangles;
  std::vector<Point3> Extra; ///< points off M: their ids follow those of the sampled surface
  bool OnSurface = true;   ///< false: an obstacle kept the loop from reaching M; it was closed on M
  double GrowthCost = 0.0; ///< GreedyPatches::Cost, of a membrane that grew; 0: it did not
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

/// The membrane that MinimumCutTriangles() finds, with all of its loops on M; nothing where it
/// finds none. With `chords`, edges off M between its points are replaced by the shortest paths on
/// it.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::optional<Membrane> MinimumCutMembrane(
  const FeatureContext& context, const ShapeFeature& feature, const Point3& centre,
  const ProgressCallback& progress = {}, bool chords = false);

/// The membrane that GrowGreedily() finds, its last edges replaced by the shortest paths on M;
/// nothing where it finds none or where such a path is missing.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::optional<Membrane> GreedyMembrane(
  const FeatureContext& context, const ShapeFeature& feature);

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

/// A diagram, and for each of its features what spans it and where it is.
struct LocatedFeatures
{
  FeatureDiagram Diagram;
  std::vector<std::optional<Membrane>> Membranes; ///< made for handles and tunnels, else when asked
  std::vector<Point3> Centres;                    ///< of the ball that gets stuck
};

/// The sum of the classes of a membrane's loops.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT HomologyClass ClassOf(
  const FeatureContext& context, const Membrane& membrane);

/**
 * True when the loops of another membrane may stand for those of a feature: always for additional
 * ones; for handles and tunnels when the two differ by a sum of the classes of those before it on
 * its side, so that all of them together stay independent, whichever are exchanged.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT bool IsInterchangeable(const FeatureContext& context,
  const LocatedFeatures& features, std::size_t feature, const Membrane& other);

/// The classes of loops that bound on a side: those of its handles, or of its tunnels.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT HomologySpan BoundingClasses(
  const FeatureContext& context, const LocatedFeatures& features, SpaceSide side);

// ------------------------------------------------------------------------------------------
// Loops around a choke point in other classes than the cycle that its triangle closed.

/**
 * For a choke whose own loops can be contracted on M, or slide off it: the shortest loops along
 * edges through one or two of the points where the ball touches M, of each class of H1(M; Z/2) that
 * bounds on the side of the feature, ascending by length, `longest` at most, the first `most` of
 * them. Such a class is not
 * contractible, so there is something tight in it. The membrane is the fan seen from the choke
 * point.
 *
 * A wall of blobs that closes to a ring, for instance: what separates two neighbours in it is the
 * wall's own cross-section, since a blob by itself is only a bump.
 *
 * Source: J. Erickson, K. Whittlesey, "Greedy optimal homotopy and homology generators", SODA 2005,
 * section 2: the shortest loop of a class through a point is an edge closed through the tree of
 * shortest paths. O(n log n) in the points within half of `longest`, for each contact; where there
 * are as many as `most`, of no more than three quarters of the longest of them.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<Membrane> EncirclingMembranes(
  const FeatureContext& context, const LocatedFeatures& features, std::size_t feature,
  double longest, std::size_t most);

/// The loop straight along edges from each contact to the next, where it bounds: the last resort,
/// since it may go back and forth. Paths are `longest` at most.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::optional<Membrane> ContactMembrane(
  const FeatureContext& context, const LocatedFeatures& features, std::size_t feature,
  double longest);

}

#endif
