/**
 * @file CubicalCycles.h
 * @brief Short loops of edges round the tunnels of a volume.
 */
#ifndef isthmus_CubicalCycles_h
#define isthmus_CubicalCycles_h

#include "Core/Progress.h"
#include "Persistence/ScalarFeatures.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

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
 * The edge that closes the loop is joined with the shortest way between its ends in what was there
 * before it (Dijkstra through the grid's cells, lengths by `spacing`), and it is checked that the
 * face that ends the feature fills this very loop, and not an earlier one: by reducing it. Where
 * the shortest way runs round another tunnel as well, the boundary that the pairing itself found is
 * taken and shortened arc by arc, each time with the check that what lies between is filled while
 * the feature lives. Such a boundary can have several loops; those filled by themselves are left
 * out.
 *
 * Costs the pairing once more, and a search of at most the whole volume for each cycle.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT std::vector<CubicalCycle> CubicalCycles(
  const VolumeView& volume, const std::array<double, 3>& spacing, const FeatureList& features,
  bool superlevel, std::size_t most, const ProgressCallback& progress = {});

}

#endif
