/**
 * @file HandleSupport.h
 * @brief How often the handles of a map are found again in resamples of it with other noise.
 */
#ifndef isthmus_HandleSupport_h
#define isthmus_HandleSupport_h

#include "ChokingLoops/ChokingLoopParameters.h"
#include "ChokingLoops/MapHandles.h"
#include "Core/Progress.h"

#include <cstdint>
#include <vector>

namespace isthmus
{

/// For each handle of the list.
struct HandleSupport
{
  std::vector<double> Support; ///< share of resamples with the handle
  std::vector<double> PValue;  ///< that noise caused it at the level; 1: not there at all
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
HandleSupport SupportOf(const std::vector<MapHandle>& handles, const VolumeView& volume,
  const FeatureParameters& parameters, double threshold, const std::vector<float>& noise,
  const SupportParameters& bootstrap, const ProgressCallback& progress = {});

}

#endif
