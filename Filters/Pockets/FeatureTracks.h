/**
 * @file FeatureTracks.h
 * @brief Tracking of features over time steps: pockets, pores, loops.
 */
#ifndef isthmus_FeatureTracks_h
#define isthmus_FeatureTracks_h

#include "Core/Geometry.h"
#include "Core/Progress.h"
#include "vtkIsthmusFiltersPocketsModule.h"

#include <string>
#include <vector>

namespace isthmus
{

/// The properties by which a feature is recognised.
struct TrackedFeature
{
  Point3 Place{ 0.0, 0.0, 0.0 };
  double Radius = 0.0;             ///< NaN: not known
  std::vector<std::string> Lining; ///< names of residues, sorted; empty: not known
  int Kind = -1;                   ///< of a choking loop: handle, tunnel, ...; -1: not known
  int Side = -1;                   ///< of a choking loop: inside or outside; -1: not known
};

using TrackFrame = std::vector<TrackedFeature>;

struct TrackOptions
{
  double MaximumDistance =
    4.0;               ///< largest distance that a feature moves from one time step to the next
  int MaximumGap = 25; ///< number of time steps that a track may miss
};

/// @throws std::invalid_argument with property, value and range.
VTKISTHMUSFILTERSPOCKETS_EXPORT void Check(const TrackOptions& options);

enum class TrackEventKind
{
  Merge, ///< Track ended and continued in Other
  Split  ///< Track began as a part of Other
};

struct TrackEvent
{
  TrackEventKind Kind;
  std::size_t Frame;
  int Track;
  int Other;
};

struct FeatureTracks
{
  std::vector<std::vector<int>> TrackOf; ///< for each feature of each frame, from 0
  int NumberOfTracks = 0;                ///< tracks are numbered in the order in which they begin
  std::vector<TrackEvent> Events;
};

/**
 * Matches the features of each frame with the existing tracks by one optimal assignment
 * (Assignment.h).
 *
 * Cost of a pair: distance over MaximumDistance (at most 1), plus the difference of radii over
 * their mean, plus one minus the share of common residues (Jaccard); the cost is the minimum over
 * the track's last four features, so that a pocket is recognised after a time step in which it was
 * merged with another one. A pair is possible within MaximumDistance if, where residues are known,
 * they have at least one in common; or at any distance if they have a third of them in common,
 * since the center of a pocket that gains a chamber moves far. Pairs that cost more than 2 are
 * excluded, and so are pairs of different kind or side. A track that would otherwise end takes
 * precedence over one that has split off from it, or that was missing, for features that share at
 * least a third of its residues.
 *
 * If half of the residues of a track that ends line the next feature of another track, the first
 * has merged with the second; a track that begins in the same way has split off. A pocket that has
 * merged and reappears within MaximumGap continues its own track. Frames must be superposed.
 *
 * O(frames x n^3) for n features that compete for tracks. Throws std::invalid_argument for options
 * out of range; Cancelled.
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT FeatureTracks TrackFeatures(const std::vector<TrackFrame>& frames,
  const TrackOptions& options, const ProgressCallback& progress = {});

}

#endif
