/**
 * @file CubicalCycles.h
 * @brief Short loops of edges round the tunnels of a volume.
 */
#ifndef isthmus_CubicalCycles_h
#define isthmus_CubicalCycles_h

#include "Progress.h"
#include "ScalarFeatures.h"

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
 * The edge that closes the loop is joined with the shortest path between its ends in what was there
 * before it (Dijkstra over the grid's edges, lengths by `spacing`), and it is checked that the face
 * that ends the feature fills this very loop: by reducing it with all faces up to that one. Where
 * the shortest path runs round another tunnel as well and is not filled then, the boundary that the
 * reduction itself found is taken: longer, but of the right class.
 *
 * Costs the pairing once more, and a search of at most the whole volume for each cycle.
 */
VTKISTHMUS_EXPORT std::vector<CubicalCycle> CubicalCycles(const VolumeView& volume,
  const std::array<double, 3>& spacing, const FeatureList& features, bool superlevel,
  std::size_t most, const ProgressCallback& progress = {});

}

#endif
