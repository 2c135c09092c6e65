/**
 * @file FeatureRows.h
 * @brief The features of two analyses, matched one to one.
 */
#ifndef isthmus_FeatureRows_h
#define isthmus_FeatureRows_h

#include "ChokingLoops/ChokingLoops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace isthmus::testing
{

/// A feature that must have a counterpart if it is clearly above the threshold, and may have one if
/// it is near.
struct FeatureRow
{
  double Radius = 0.0;
  double Uncertainty = 0.0;
  Point3 Center{};
  bool IsTrusted = false;
  bool IsClear = false;
};

/// Two analyses may differ by `Length` and by `Share` of a radius or death.
struct FeatureTolerance
{
  double Length = 0.0;
  double Share = 0.0;
};

/// Handles or tunnels, or additional features with a persistence above or near `threshold`.
inline std::vector<FeatureRow> RowsOf(const ChokingLoops& loops, FeatureKind kind, SpaceSide side,
  double threshold, const FeatureTolerance& tolerance)
{
  std::vector<FeatureRow> rows;
  for (std::size_t i = 0; i < loops.Diagram().Features.size(); ++i)
  {
    const ShapeFeature& f = loops.Diagram().Features[i];
    const double margin =
      2.0 * (tolerance.Share * f.Death + tolerance.Length) + ComputeUncertainty(f);
    const bool mayCount = IsGenerator(f) || f.Persistence() > threshold - margin;
    if (f.Kind == kind && f.Side == side && mayCount)
    {
      rows.push_back({ f.Radius(), ComputeUncertainty(f), loops.ChokePoint(i), f.Trusted,
        IsGenerator(f) || f.Persistence() > threshold + margin });
    }
  }
  return rows;
}

struct FeatureComparison
{
  std::size_t Features = 0;
  std::size_t Untrusted = 0; ///< only in the other analysis
  double Worst = 0.0;        ///< relative difference of two radii, beyond their uncertainty
};

/// Each clear feature of one analysis has its own counterpart in the other.
inline void ExpectCounterparts(const std::string& name, const std::vector<FeatureRow>& of,
  const std::vector<FeatureRow>& in, const FeatureTolerance& tolerance, FeatureComparison& result)
{
  std::vector<char> isTaken(in.size(), 0);
  for (const FeatureRow& row : of)
  {
    std::size_t best = in.size();
    double least = HUGE_VAL;
    for (std::size_t k = 0; k < in.size(); ++k)
    {
      // Several in one place differ by the radius, equal ones (symmetry) by the place.
      const double apart = std::abs(in[k].Radius - row.Radius) / row.Radius +
        0.1 * Distance(in[k].Center, row.Center) / row.Radius;
      if (!isTaken[k] && apart < least)
      {
        least = apart;
        best = k;
      }
    }
    if (best == in.size())
    {
      EXPECT_FALSE(row.IsClear) << name << ": no counterpart of radius " << row.Radius;
      continue;
    }
    const double off = std::abs(in[best].Radius - row.Radius);
    const double allowed =
      tolerance.Length + tolerance.Share * row.Radius + row.Uncertainty + in[best].Uncertainty;
    if (off > allowed && !row.IsClear)
    {
      continue;
    }
    EXPECT_LE(off, allowed) << name << ": radius " << row.Radius << ", the nearest is "
                            << in[best].Radius;
    isTaken[best] = 1;
    ++result.Features;
    result.Untrusted += row.IsTrusted && !in[best].IsTrusted ? 1 : 0;
    if (row.IsTrusted && in[best].IsTrusted)
    {
      result.Worst = std::max(
        result.Worst, std::max(0.0, off - row.Uncertainty - in[best].Uncertainty) / row.Radius);
    }
  }
}

}

#endif
