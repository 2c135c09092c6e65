#include "Pockets/FeatureTracks.h"

#include "Core/Handles.h"
#include "Core/RangeChecks.h"
#include "Pockets/Assignment.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// Two features with a higher total cost of distance, radii and residues are not the same.
constexpr double Alone = 2.0;

/// Features with this share of common residues are the same, independent of their positions.
constexpr double Alike = 1.0 / 3.0;

/// Number of last features by which a track is recognised, so that it survives a merge or split of
/// a single time step.
constexpr std::size_t Remembered = 4;

/// A feature by its index in its frame.
using FeaturePlace = Handle<struct PlaceInFrame, std::size_t>;

/// An occurrence of a track.
struct Sighting
{
  std::size_t Frame;
  FeaturePlace Feature;
};

struct OpenTrack
{
  int Number;
  int Whole;                       ///< the track from which it has split off; -1: none
  std::vector<Sighting> Sightings; ///< the last ones

  bool WasSeenBefore(std::size_t frame) const { return this->Sightings.back().Frame + 1 == frame; }
};

double CountCommonAtoms(const TrackedFeature& a, const TrackedFeature& b)
{
  std::vector<std::string> both;
  std::set_intersection(
    a.Lining.begin(), a.Lining.end(), b.Lining.begin(), b.Lining.end(), std::back_inserter(both));
  return static_cast<double>(both.size());
}

bool IsContainedIn(const TrackedFeature& part, const TrackedFeature& whole)
{
  return !part.Lining.empty() &&
    2.0 * CountCommonAtoms(part, whole) >= static_cast<double>(part.Lining.size());
}

/// The share of common residues (Jaccard); 0 where they are not known.
double Similarity(const TrackedFeature& a, const TrackedFeature& b)
{
  const double common = CountCommonAtoms(a, b);
  return common > 0.0 ? common / (static_cast<double>(a.Lining.size() + b.Lining.size()) - common)
                      : 0.0;
}

/// HUGE_VAL if the two cannot be the same.
double Cost(const TrackedFeature& a, const TrackedFeature& b, double furthest)
{
  const Point3 d = b.Place - a.Place;
  const double distance = Length(d) / furthest;
  const bool isKnown = !a.Lining.empty() && !b.Lining.empty();
  const double likeness = Similarity(a, b);
  const bool isNear = distance <= 1.0 && (!isKnown || likeness > 0.0);
  const bool isOneKind = a.Kind == b.Kind && a.Side == b.Side;
  if (!std::isfinite(distance) || !isOneKind || !(isNear || likeness >= Alike))
  {
    return HUGE_VAL;
  }
  double cost = std::min(distance, 1.0);
  const double mean = 0.5 * (a.Radius + b.Radius);
  if (mean > 0.0)
  {
    cost += std::fabs(a.Radius - b.Radius) / mean;
  }
  return isKnown ? cost + 1.0 - likeness : cost;
}

/// Processes the frames one after the other.
class Tracker
{
public:
  Tracker(const std::vector<TrackFrame>& frames, const TrackOptions& options)
    : Frames(frames)
    , Options(options)
  {
    this->Result.TrackOf.resize(frames.size());
  }

  void Step(std::size_t frame)
  {
    this->Result.TrackOf[frame].assign(this->Frames[frame].size(), -1);
    this->Forget(frame);
    std::vector<int> columnOf =
      AssignAtLeastCost(this->Costs(frame), this->Frames[frame].size(), Alone);
    this->ResolveConflicts(frame, columnOf);
    const std::vector<OpenTrack> before = this->Open;
    for (std::size_t i = 0; i < this->Open.size(); ++i)
    {
      if (columnOf[i] >= 0)
      {
        this->RecordSighting(
          this->Open[i], frame, FeaturePlace(static_cast<std::size_t>(columnOf[i])));
      }
    }
    this->NameMerged(frame);
    this->Begin(frame, before);
  }

  FeatureTracks Result;

private:
  const TrackedFeature& At(const Sighting& seen) const
  {
    return this->Frames[seen.Frame][seen.Feature.Index()];
  }

  void RecordSighting(OpenTrack& track, std::size_t frame, FeaturePlace feature)
  {
    track.Sightings.push_back({ frame, feature });
    if (track.Sightings.size() > Remembered)
    {
      track.Sightings.erase(track.Sightings.begin());
    }
    this->Result.TrackOf[frame][feature.Index()] = track.Number;
  }

  /// Closes the tracks that have been missing for too long.
  void Forget(std::size_t frame)
  {
    const auto isOld = [&](const OpenTrack& track)
    {
      const std::size_t missed = frame - track.Sightings.back().Frame - 1;
      return missed > static_cast<std::size_t>(this->Options.MaximumGap);
    };
    this->Open.erase(std::remove_if(this->Open.begin(), this->Open.end(), isOld), this->Open.end());
  }

  /// The cost of each open track with each feature: the minimum over the track's sightings.
  std::vector<std::vector<double>> Costs(std::size_t frame) const
  {
    std::vector<std::vector<double>> costs;
    for (const OpenTrack& track : this->Open)
    {
      auto& row = costs.emplace_back();
      for (const TrackedFeature& feature : this->Frames[frame])
      {
        double least = HUGE_VAL;
        for (const Sighting& seen : track.Sightings)
        {
          least = std::min(least, Cost(this->At(seen), feature, this->Options.MaximumDistance));
        }
        row.push_back(least);
      }
    }
    return costs;
  }

  /// `other` has split off from `track`, or was missing while `track` was not.
  bool HasPrecedence(const OpenTrack& track, const OpenTrack& other, std::size_t frame) const
  {
    return other.Whole == track.Number ||
      (track.WasSeenBefore(frame) && !other.WasSeenBefore(frame));
  }

  /// A track that takes precedence over another one takes over a similar feature of it rather than
  /// end.
  void ResolveConflicts(std::size_t frame, std::vector<int>& columnOf) const
  {
    for (std::size_t i = 0; i < this->Open.size(); ++i)
    {
      const TrackedFeature& last = this->At(this->Open[i].Sightings.back());
      for (std::size_t k = 0; k < this->Open.size() && columnOf[i] < 0; ++k)
      {
        if (columnOf[k] >= 0 && this->HasPrecedence(this->Open[i], this->Open[k], frame) &&
          Similarity(last, this->Frames[frame][static_cast<std::size_t>(columnOf[k])]) >= Alike)
        {
          std::swap(columnOf[i], columnOf[k]);
        }
      }
    }
  }

  /// Tracks that have just ended and whose residues now line another track have merged with it.
  /// They stay open, since they may reappear after a gap.
  void NameMerged(std::size_t frame)
  {
    const auto& trackOf = this->Result.TrackOf[frame];
    for (const OpenTrack& track : this->Open)
    {
      int into = -1;
      for (std::size_t k = 0; k < trackOf.size() && into < 0 && track.WasSeenBefore(frame); ++k)
      {
        if (trackOf[k] >= 0 &&
          IsContainedIn(this->At(track.Sightings.back()), this->Frames[frame][k]))
        {
          into = trackOf[k];
          this->Result.Events.push_back({ TrackEventKind::Merge, frame, track.Number, into });
        }
      }
    }
  }

  /// Features without a track start a new one.
  void Begin(std::size_t frame, const std::vector<OpenTrack>& before)
  {
    const TrackFrame& features = this->Frames[frame];
    for (std::size_t k = 0; k < features.size(); ++k)
    {
      if (this->Result.TrackOf[frame][k] >= 0)
      {
        continue;
      }
      OpenTrack track{ this->Result.NumberOfTracks++, -1, {} };
      for (const OpenTrack& old : before)
      {
        if (old.WasSeenBefore(frame) && IsContainedIn(features[k], this->At(old.Sightings.back())))
        {
          track.Whole = old.Number;
          this->Result.Events.push_back({ TrackEventKind::Split, frame, track.Number, old.Number });
          break;
        }
      }
      this->RecordSighting(track, frame, FeaturePlace(k));
      this->Open.push_back(std::move(track));
    }
  }

  const std::vector<TrackFrame>& Frames;
  const TrackOptions& Options;
  std::vector<OpenTrack> Open;
};

}

void Check(const TrackOptions& options)
{
  RequireAbove("MaximumDistance", options.MaximumDistance, 0.0, LargestLength, "It is a length.");
  RequireRange("MaximumGap", options.MaximumGap, 0, 1e6, "It is in time steps.");
}

FeatureTracks TrackFeatures(const std::vector<TrackFrame>& frames, const TrackOptions& options,
  const ProgressCallback& progress)
{
  Check(options);
  Tracker tracker(frames, options);
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    Report(progress, static_cast<double>(i) / static_cast<double>(frames.size()));
    tracker.Step(i);
  }
  return tracker.Result;
}

}
