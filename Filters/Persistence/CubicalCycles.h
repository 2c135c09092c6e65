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
 * The edge that closes the loop, with the shortest path between its ends in the complex before it
 * enters, if the face that ends the feature fills exactly this loop; otherwise the boundary that
 * the pairing found, shortened within its class. This costs another pairing, and for each cycle a
 * search of at most the whole volume.
 */
std::vector<CubicalCycle> CubicalCycles(const VolumeView& volume,
  const std::array<double, 3>& spacing, const FeatureList& features, bool superlevel,
  std::size_t most, const ProgressCallback& progress = {});

}

#endif
