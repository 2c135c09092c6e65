/**
 * @file MapHandles.h
 * @brief Bridges and windows of a map over its levels, and intervals of levels without topological
 * change.
 */
#ifndef isthmus_MapHandles_h
#define isthmus_MapHandles_h

#include "Persistence/ScalarFeatures.h"

namespace isthmus
{

/**
 * A saddle of the map: a bridge (1-saddle), where two parts of the object or the two ends of an arc
 * meet, or a window (2-saddle), where an opening through the object closes.
 *
 * The elder rule decides whether a saddle ends one class or begins another, so equivalent saddles
 * of a symmetric map may be assigned differently; the saddles themselves are symmetric.
 */
struct MapHandle
{
  bool IsBridge = true;
  std::int64_t Feature = 0; ///< number of the class (FeatureList)
  std::int64_t Node = 0;    ///< where the map has the value of the saddle
  double Level = 0.0;       ///< that value
  /// Levels between which there is a bridge or an open window, within the range.
  std::array<double, 2> Interval{};
};

/// An interval of levels in which nothing appears or disappears, and its Betti numbers.
struct StableInterval
{
  double Low = 0.0;
  double High = 0.0;
  std::array<std::int64_t, 3> Betti{};

  double Middle() const { return this->Low + 0.5 * (this->High - this->Low); }
};

/// Bridges, then windows, each sorted by FeatureId, of the features kept.
std::vector<MapHandle> MapHandles(
  const VolumeView& volume, const FeatureList& features, const FeatureParameters& parameters);

/**
 * The intervals between levels in `range` where a feature that is kept begins or ends, the longest
 * first. Intervals without any component are omitted.
 */
std::vector<StableInterval> StableIntervals(
  const FeatureList& features, bool superlevel, const std::array<double, 2>& range);

/// Betti numbers of the features kept at one level.
std::array<std::int64_t, 3> BettiAt(const FeatureList& features, bool superlevel, double level);

}

#endif
