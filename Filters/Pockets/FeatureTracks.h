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

/// What a feature is recognised by.
struct TrackedFeature
{
  Point3 Place{ 0.0, 0.0, 0.0 };
  double Radius = 0.0;             ///< NaN: not known
  std::vector<std::string> Lining; ///< names of residues, sorted; empty: not known
};

using TrackFrame = std::vector<TrackedFeature>;

struct TrackOptions
{
  double MaximumDistance = 4.0; ///< that a feature moves from one time step to the next
  int MaximumGap = 25;          ///< time steps that a track may miss
};

enum class TrackEventKind
{
  Merge, ///< Track ended and went on in Other
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
  int NumberOfTracks = 0;                ///< numbered in the order in which they begin
  std::vector<TrackEvent> Events;
};

/**
 * Matches the features of each frame with the tracks so far, all at once (Assignment.h).
 *
 * Cost of a pair: distance over MaximumDistance (at most 1), plus the difference of radii over
 * their mean, plus one minus the share of common residues (Jaccard); the least over the track's
 * last four features counts, so that a pocket is recognised after a time step in which it was one
 * with another. A pair is possible within MaximumDistance and, where residues are known, with one
 * in common; or at any distance with a third of them in common: the centre of a pocket that gains a
 * room moves far. Pairs that cost more than 2 are none. A track that would end goes before one that
 * has split off from it, or that has been missing, in what is a third like it.
 *
 * A track that ends while half of its residues line another track's next feature has merged with
 * it; one that begins so has split off. A pocket that has merged, and comes back within MaximumGap,
 * has its own track again. Frames must be superposed.
 *
 * O(frames x n^3) for n features that could be mixed up. Throws std::invalid_argument for options
 * out of range; Cancelled.
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT FeatureTracks TrackFeatures(const std::vector<TrackFrame>& frames,
  const TrackOptions& options, const ProgressCallback& progress = {});

}

#endif
