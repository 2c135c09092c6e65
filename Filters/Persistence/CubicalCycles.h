/**
 * @file CubicalCycles.h
 * @brief Short loops of edges around the tunnels of a volume.
 */
#ifndef isthmus_CubicalCycles_h
#define isthmus_CubicalCycles_h

#include "Core/Progress.h"
#include "Persistence/ScalarFeatures.h"

#include <array>
#include <vector>

namespace isthmus
{

/// A loop in the complex at the level where its feature is born.
struct CubicalCycle
{
  std::int64_t Feature = 0;
  std::vector<std::int64_t> Nodes; ///< neighbours on the grid; the last one meets the first
  double Length = 0.0;             ///< in the unit of the spacing
};

/**
 * A cycle for each of the first `most` features of dimension 1 that are kept.
 *
 * The edge that closes the loop is combined with the shortest path between its ends in the complex
 * before it enters (Dijkstra's algorithm through the cells of the grid, with lengths by spacing). A
 * reduction then checks that the face that ends the feature fills exactly this loop, and not an
 * earlier one. If the shortest path also runs around another tunnel, the boundary found by the
 * pairing is used and shortened arc by arc, checking each time that the difference is filled while
 * the feature exists. Such a boundary can have several loops; those that are filled on their own
 * are dropped.
 *
 * This costs another pairing, and for each cycle a search of at most the whole volume.
 */
std::vector<CubicalCycle> CubicalCycles(const VolumeView& volume,
  const std::array<double, 3>& spacing, const FeatureList& features, bool superlevel,
  std::size_t most, const ProgressCallback& progress = {});

}

#endif
