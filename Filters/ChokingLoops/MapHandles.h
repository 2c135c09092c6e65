/**
 * @file MapHandles.h
 * @brief Bridges and windows of a map over its levels, intervals of levels without topological
 * change, and which handles noise could have caused.
 */
#ifndef isthmus_MapHandles_h
#define isthmus_MapHandles_h

#include "ChokingLoops/ChokingLoopParameters.h"
#include "Core/Progress.h"
#include "Persistence/ScalarFeatures.h"

#include <array>
#include <cstdint>
#include <vector>

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

/// Betti numbers of the features at one level.
std::array<std::int64_t, 3> BettiAt(const FeatureList& features, bool superlevel, double level);

// ------------------------------------------------------------------------------------------
// How often the handles are found again in resamples of the map with other noise.

/// For each handle of the list.
struct HandleSupport
{
  std::vector<double> Support; ///< share of resamples with the handle
  std::vector<double> PValue;  ///< for the hypothesis that noise caused it; 1: absent at the level
};

/// Distance, in nodes, within which a handle of a resample can be the same handle.
constexpr double HandleMatchDistance = 8.0;

/**
 * Noise with the spectrum of `noise` within blocks of 16 nodes and its local deviation: each block
 * of a grid at a random place is a block of noise / deviation from elsewhere, with a random sign,
 * times the deviation in place. Deviation: root mean square in windows of 17 nodes. Nodes where
 * the noise is exactly 0, those outside of a mask, have none.
 */
class NoiseBootstrap
{
public:
  NoiseBootstrap(const std::vector<float>& noise, const std::array<std::int64_t, 3>& dimensions);

  /// Adds noise to `values`, float or double. Bitwise identical for the same seed.
  template <typename T>
  void AddTo(std::vector<T>& values, std::uint64_t seed) const;

private:
  std::array<std::int64_t, 3> Dimensions;
  std::vector<float> Unit;      ///< noise / deviation; 0: none
  std::vector<float> Deviation; ///< local
};

/**
 * Bootstrap of `handles` (found in `volume` with `parameters`): finds the handles of volume +
 * noise, with the same range and `threshold` (in units of the values), in each resample. Cost: that
 * of CubicalPersistence for each resample. @throws Cancelled
 */
HandleSupport ComputeSupport(const std::vector<MapHandle>& handles, const VolumeView& volume,
  const FeatureParameters& parameters, double threshold, const std::vector<float>& noise,
  const SupportParameters& bootstrap, const ProgressCallback& progress = {});

}

#endif
