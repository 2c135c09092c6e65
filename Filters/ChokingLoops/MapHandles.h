/**
 * @file MapHandles.h
 * @brief Bridges and windows of a map over its levels, and levels that nothing happens at.
 */
#ifndef isthmus_MapHandles_h
#define isthmus_MapHandles_h

#include "Persistence/ScalarFeatures.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/**
 * A saddle of the map: a bridge (1-saddle), where two parts or the two ends of a bow meet, or a
 * window (2-saddle), where what is open across closes.
 *
 * The elder rule says whether a saddle ends one class or begins another, and splits the saddles of
 * a symmetric map between the two; the saddles themselves are symmetric.
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

/// A run of levels at which nothing appears or goes, and what there is.
struct StableInterval
{
  double Low = 0.0;
  double High = 0.0;
  std::array<std::int64_t, 3> Betti{};

  double Middle() const { return this->Low + 0.5 * (this->High - this->Low); }
};

/// Bridges, then windows, each by FeatureId, of the features kept.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<MapHandle> MapHandles(
  const VolumeView& volume, const FeatureList& features, const FeatureParameters& parameters);

/**
 * The intervals between levels in `range` where a feature that is kept begins or ends, the longest
 * first. Those with nothing in them (no component) are left out.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<StableInterval> StableIntervals(
  const FeatureList& features, bool superlevel, const std::array<double, 2>& range);

/// Betti numbers of the features kept at one level.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::array<std::int64_t, 3> BettiAt(
  const FeatureList& features, bool superlevel, double level);

}

#endif
