/**
 * @file GreedyMembrane.h
 * @brief The membrane of X. Feng, PhD thesis, 6.3.2, which grows from the choke triangle step by
 * step. For comparison with the thesis; that of MinimumCutMembrane.h is smaller.
 */
#ifndef isthmus_GreedyMembrane_h
#define isthmus_GreedyMembrane_h

#include "ChokingLoops/FeatureMembrane.h"

#include <optional>

namespace isthmus
{

/// Triangles grown from a choke triangle, and their cost.
struct GreedyPatches
{
  TriangleChain Triangles; ///< the choke triangle among them
  double Cost = 0.0;       ///< sum over the paths, in the unit of the points
  std::size_t Steps = 0;   ///< vertices whose one-ring was filled
};

/**
 * Grows a membrane by the method of X. Feng, PhD thesis, 6.3.2.
 *
 * The membrane starts as the choke triangle f, with its two tetrahedra in the left and the right
 * cluster. Each step processes the boundary vertex v with the largest value d. A path in the
 * one-ring of v replaces v between its two neighbours on the boundary; the triangles formed by the
 * path and v join the membrane, and the tetrahedra around v join the cluster on their side of these
 * triangles. The path is the cheapest (Dijkstra) along edges of the ring whose triangle with v
 * precedes f in the filtration and does not have both tetrahedra in the same cluster. A step from p
 * to q costs (|p - q| + d(q)) / 2: the length term keeps the area small, and the distance term
 * leads down to M. Boundary vertices are avoided if possible, and vertices processed before always,
 * so the growth terminates.
 *
 * The method is greedy: no step is ever undone, and the area is not minimal (unlike that of
 * MinimumCutTriangles()). All vertices of the final boundary lie on M. A step takes O(s log s) for
 * the s tetrahedra around a vertex.
 *
 * The result is empty if the growth gets stuck, if the ring of v is incomplete, or if M is not part
 * of the complex (all sample points lie on M, where d is 0). @pre `feature.Choke` is a triangle of
 * the complex.
 */
std::optional<GreedyPatches> GrowGreedily(
  const FeatureContext& context, const ShapeFeature& feature);

/// The membrane from GrowGreedily(), with the remaining edges off M replaced by the shortest paths
/// on M; empty if there is none or if such a path is missing.
std::optional<Membrane> GreedyMembrane(const FeatureContext& context, const ShapeFeature& feature);

}

#endif
