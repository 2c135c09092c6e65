/**
 * @file EncirclingLoops.h
 * @brief Loops round a choke point of other classes than the cycle that its triangle closed.
 */
#ifndef isthmus_EncirclingLoops_h
#define isthmus_EncirclingLoops_h

#include "ChokingLoops/GeneratorCompletion.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/**
 * For a choke whose own loops can be drawn together on M, or slide off it: the shortest loops along
 * edges through one or two of the points where the ball touches M, of each class of H1(M; Z/2) that
 * bounds on the side of the feature, ascending by length, `longest` at most, the first `most` of
 * them. Such a class can't be
 * drawn together, so there is something tight in it. The membrane is the fan seen from the choke
 * point.
 *
 * A wall of blobs that closes to a ring, for instance: what parts two neighbours in it is the
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
/// since it may go to and fro. Paths are `longest` at most.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::optional<Membrane> ContactMembrane(
  const FeatureContext& context, const LocatedFeatures& features, std::size_t feature,
  double longest);

}

#endif
