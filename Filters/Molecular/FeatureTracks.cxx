#include "FeatureTracks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// A track, and the feature it had last.
struct OpenTrack
{
  int Number;
  std::size_t Frame;
  std::size_t Feature;
};

double Common(const TrackedFeature& a, const TrackedFeature& b)
{
  std::vector<std::string> both;
  std::set_intersection(
    a.Lining.begin(), a.Lining.end(), b.Lining.begin(), b.Lining.end(), std::back_inserter(both));
  return static_cast<double>(both.size());
}

/// HUGE_VAL where the two can't be one.
double Cost(const TrackedFeature& a, const TrackedFeature& b, double furthest)
{
  const Point3 d = b.Place - a.Place;
  const double distance = std::sqrt(Dot(d, d));
  if (!(distance <= furthest))
  {
    return HUGE_VAL;
  }
  double cost = distance / furthest;
  const double mean = 0.5 * (a.Radius + b.Radius);
  if (mean > 0.0)
  {
    cost += std::fabs(a.Radius - b.Radius) / mean;
  }
  if (!a.Lining.empty() && !b.Lining.empty())
  {
    const double common = Common(a, b);
    const auto all = static_cast<double>(a.Lining.size() + b.Lining.size()) - common;
    cost = common > 0.0 ? cost + 1.0 - common / all : HUGE_VAL;
  }
  return cost;
}

/**
 * For each row its column, or -1: as many rows as possible get one, at least cost. Shortest
 * augmenting paths with potentials; pairs that can't be are `none`, dearer than all others
 * together.
 */
std::vector<int> Assign(const std::vector<std::vector<double>>& costs, std::size_t columns)
{
  constexpr double none = 1e6;
  const std::size_t rows = costs.size();
  const std::size_t width = columns + rows; // each row has a column of its own to stay alone
  const auto cost = [&](std::size_t r, std::size_t c)
  {
    const bool known = c < columns && costs[r][c] < HUGE_VAL;
    return known ? costs[r][c] : (c == columns + r ? none : 4.0 * none);
  };
  std::vector<double> rowPrice(rows + 1, 0.0);
  std::vector<double> columnPrice(width + 1, 0.0);
  std::vector<std::size_t> rowOf(width + 1, 0); // from 1; 0: free
  for (std::size_t r = 1; r <= rows; ++r)
  {
    rowOf[0] = r;
    std::size_t at = 0;
    std::vector<double> least(width + 1, HUGE_VAL);
    std::vector<std::size_t> before(width + 1, 0);
    std::vector<char> seen(width + 1, 0);
    while (rowOf[at] != 0)
    {
      seen[at] = 1;
      const std::size_t row = rowOf[at];
      std::size_t next = 0;
      double step = HUGE_VAL;
      for (std::size_t c = 1; c <= width; ++c)
      {
        if (seen[c])
        {
          continue;
        }
        const double price = cost(row - 1, c - 1) - rowPrice[row] - columnPrice[c];
        if (price < least[c])
        {
          least[c] = price;
          before[c] = at;
        }
        if (least[c] < step)
        {
          step = least[c];
          next = c;
        }
      }
      for (std::size_t c = 0; c <= width; ++c)
      {
        if (seen[c])
        {
          rowPrice[rowOf[c]] += step;
          columnPrice[c] -= step;
        }
        else
        {
          least[c] -= step;
        }
      }
      at = next;
    }
    for (; at != 0; at = before[at])
    {
      rowOf[at] = rowOf[before[at]];
    }
  }
  std::vector<int> columnOf(rows, -1);
  for (std::size_t c = 1; c <= columns; ++c)
  {
    if (rowOf[c] != 0 && costs[rowOf[c] - 1][c - 1] < HUGE_VAL)
    {
      columnOf[rowOf[c] - 1] = static_cast<int>(c - 1);
    }
  }
  return columnOf;
}

/// Works off the frames one after the other.
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
    const TrackFrame& features = this->Frames[frame];
    auto& trackOf = this->Result.TrackOf[frame];
    trackOf.assign(features.size(), -1);
    const auto tooOld = [&](const OpenTrack& track)
    { return frame - track.Frame > static_cast<std::size_t>(this->Options.MaximumGap) + 1; };
    this->Open.erase(
      std::remove_if(this->Open.begin(), this->Open.end(), tooOld), this->Open.end());
    std::vector<std::vector<double>> costs;
    for (const OpenTrack& track : this->Open)
    {
      costs.emplace_back();
      for (const TrackedFeature& feature : features)
      {
        costs.back().push_back(Cost(this->Last(track), feature, this->Options.MaximumDistance));
      }
    }
    const std::vector<OpenTrack> before = this->Open;
    const std::vector<int> columnOf = Assign(costs, features.size());
    for (std::size_t i = 0; i < this->Open.size(); ++i)
    {
      if (columnOf[i] >= 0)
      {
        const auto feature = static_cast<std::size_t>(columnOf[i]);
        trackOf[feature] = this->Open[i].Number;
        this->Open[i] = { this->Open[i].Number, frame, feature };
      }
      else if (this->Open[i].Frame + 1 == frame)
      {
        this->MaybeMerged.emplace_back(this->Open[i], frame);
      }
    }
    this->Begin(frame, before);
  }

  FeatureTracks Result;

private:
  const TrackedFeature& Last(const OpenTrack& track) const
  {
    return this->Frames[track.Frame][track.Feature];
  }

  static bool IsPartOf(const TrackedFeature& part, const TrackedFeature& whole)
  {
    return !part.Lining.empty() &&
      2.0 * Common(part, whole) >= static_cast<double>(part.Lining.size());
  }

  /// Features without a track begin one; now merges and splits can be seen.
  void Begin(std::size_t frame, const std::vector<OpenTrack>& before)
  {
    const TrackFrame& features = this->Frames[frame];
    auto& trackOf = this->Result.TrackOf[frame];
    const std::vector<int> matched = trackOf;
    for (const auto& [ended, at] : this->MaybeMerged)
    {
      for (std::size_t k = 0; k < features.size(); ++k)
      {
        if (matched[k] >= 0 && IsPartOf(this->Last(ended), features[k]))
        {
          this->Result.Events.push_back({ TrackEventKind::Merge, at, ended.Number, matched[k] });
          break;
        }
      }
    }
    this->MaybeMerged.clear();
    for (std::size_t k = 0; k < features.size(); ++k)
    {
      if (trackOf[k] >= 0)
      {
        continue;
      }
      trackOf[k] = this->Result.NumberOfTracks++;
      this->Open.push_back({ trackOf[k], frame, k });
      for (const OpenTrack& old : before)
      {
        if (old.Frame + 1 == frame && IsPartOf(features[k], this->Last(old)))
        {
          this->Result.Events.push_back({ TrackEventKind::Split, frame, trackOf[k], old.Number });
          break;
        }
      }
    }
  }

  const std::vector<TrackFrame>& Frames;
  const TrackOptions& Options;
  std::vector<OpenTrack> Open;
  std::vector<std::pair<OpenTrack, std::size_t>> MaybeMerged;
};

}

FeatureTracks TrackFeatures(const std::vector<TrackFrame>& frames, const TrackOptions& options,
  const ProgressCallback& progress)
{
  if (!(options.MaximumDistance > 0.0) || std::isinf(options.MaximumDistance))
  {
    throw std::invalid_argument("MaximumDistance is " + std::to_string(options.MaximumDistance) +
      ", but it is a length: give a positive number.");
  }
  if (options.MaximumGap < 0)
  {
    throw std::invalid_argument("MaximumGap is " + std::to_string(options.MaximumGap) +
      ", but it is a number of time steps: give 0 or more.");
  }
  Tracker tracker(frames, options);
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    Report(progress, static_cast<double>(i) / static_cast<double>(frames.size()));
    tracker.Step(i);
  }
  return tracker.Result;
}

}
