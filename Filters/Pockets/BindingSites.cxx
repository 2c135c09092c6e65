#include "Pockets/BindingSites.h"

#include "Core/DisjointSets.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Pockets/HullDepth.h"
#include "Surfaces/AreaQuantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace isthmus
{
namespace
{

bool IsIncluded(const SiteFields& fields, std::size_t i)
{
  return fields.Kind[i] != 0 && fields.Amplitude[i] > 0.0; // false for NaN
}

/// The least amplitude such that at most 1 - quantile of the area has more.
double ComputeQuantile(const SiteFields& fields, const std::vector<double>& areas, double quantile)
{
  std::vector<std::pair<double, std::size_t>> order(areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    order[i] = { IsIncluded(fields, i) ? fields.Amplitude[i] : 0.0, i };
  }
  std::sort(order.begin(), order.end());
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  double below = 0.0;
  for (const auto& [amplitude, i] : order)
  {
    below += areas[i];
    if (below >= quantile * total)
    {
      return amplitude;
    }
  }
  return order.empty() ? 0.0 : order.back().first;
}

/// Joins selected points of one kind within `distance` of each other.
class Neighbours
{
public:
  Neighbours(const SurfaceView& mesh, const std::vector<unsigned char>& kinds, double distance)
    : Mesh(mesh)
    , Kinds(kinds)
    , Distance(distance)
  {
  }

  void Join(const std::vector<vtkIdType>& selected, DisjointSets<vtkIdType>& sets,
    const ProgressCallback& progress)
  {
    std::size_t done = 0;
    for (const vtkIdType point : selected)
    {
      const Cell home = this->FindCell(point);
      for (std::int64_t n = 0; n < 27; ++n)
      {
        const Cell near{ home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1 };
        const auto found = this->Cells.find(near);
        if (found != this->Cells.end())
        {
          this->JoinWith(point, found->second, sets);
        }
      }
      // After the search, so that each pair is processed once.
      this->Cells[home].push_back(point);
      if (++done % 4096 == 0)
      {
        Report(progress, static_cast<double>(done) / static_cast<double>(selected.size()));
      }
    }
  }

private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash
  {
    std::size_t operator()(const Cell& cell) const
    {
      std::uint64_t hash = 0;
      for (const std::int64_t i : cell)
      {
        hash = (hash ^ static_cast<std::uint64_t>(i)) * 0x9e3779b97f4a7c15ull;
        hash ^= hash >> 29;
      }
      return hash;
    }
  };

  Cell FindCell(vtkIdType point) const
  {
    Cell cell{};
    for (std::size_t a = 0; a < 3; ++a)
    {
      // Far away, cells are only larger than necessary.
      cell[a] = static_cast<std::int64_t>(
        std::clamp(std::floor(this->Mesh.Point(point)[a] / this->Distance), -1e15, 1e15));
    }
    return cell;
  }

  void JoinWith(
    vtkIdType point, const std::vector<vtkIdType>& others, DisjointSets<vtkIdType>& sets) const
  {
    const Point3& p = this->Mesh.Point(point);
    for (const vtkIdType other : others)
    {
      const Point3& q = this->Mesh.Point(other);
      if (this->Kinds[static_cast<std::size_t>(point)] ==
          this->Kinds[static_cast<std::size_t>(other)] &&
        std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= this->Distance)
      {
        sets.Join(point, other);
      }
    }
  }

  SurfaceView Mesh;
  const std::vector<unsigned char>& Kinds;
  double Distance;
  std::unordered_map<Cell, std::vector<vtkIdType>, Hash> Cells;
};

void JoinEdges(
  const SurfaceView& mesh, const std::vector<unsigned char>& kinds, DisjointSets<vtkIdType>& sets)
{
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const Triangle& corners = mesh.Corners(t);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const vtkIdType a = corners[c], b = corners[(c + 1) % 3];
      const unsigned char kind = kinds[static_cast<std::size_t>(a)];
      // Kind 0: below the threshold.
      if (kind != 0 && kind == kinds[static_cast<std::size_t>(b)])
      {
        sets.Join(a, b);
      }
    }
  }
}

double RankingValue(const BindingSite& site, SiteRanking ranking)
{
  switch (ranking)
  {
    case SiteRanking::Area:
      return site.Area;
    case SiteRanking::MeanDepth:
      return site.MeanDepth;
    case SiteRanking::MeanPotential:
      return std::isnan(site.MeanPotential) ? 0.0 : std::abs(site.MeanPotential);
    case SiteRanking::Score:
      break;
  }
  return site.Score;
}

/// Sums over the points of one patch, then divided by its area.
BindingSite Measure(const std::vector<vtkIdType>& points, const SurfaceView& mesh,
  const SiteFields& fields, const std::vector<double>& areas, const std::vector<double>& depths)
{
  BindingSite site;
  site.Kind = fields.Kind[static_cast<std::size_t>(points.front())];
  site.Points = static_cast<vtkIdType>(points.size());
  double potentialArea = 0.0;
  for (const vtkIdType point : points)
  {
    const auto i = static_cast<std::size_t>(point);
    site.Area += areas[i];
    site.Score += areas[i] * fields.Amplitude[i];
    site.MeanDepth += areas[i] * depths[i];
    if (!fields.Potential.empty() && std::isfinite(fields.Potential[i]))
    {
      site.MeanPotential += areas[i] * fields.Potential[i];
      potentialArea += areas[i];
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      site.Center[a] += areas[i] * mesh.Point(point)[a];
    }
  }
  site.MeanDepth /= site.Area;
  site.MeanPotential /= potentialArea; // NaN where there is none
  for (double& x : site.Center)
  {
    x /= site.Area;
  }
  return site;
}

std::vector<double> Depths(
  const SurfaceView& mesh, const std::vector<vtkIdType>& selected, const ProgressCallback& progress)
{
  std::vector<double> depths(mesh.Points.size(), 0.0);
  const HullDepth depth(mesh, Between(progress, 0.0, 0.8));
  const auto body = [&](std::int64_t first, std::int64_t last)
  {
    for (std::int64_t s = first; s < last; ++s)
    {
      const vtkIdType point = selected[static_cast<std::size_t>(s)];
      depths[static_cast<std::size_t>(point)] = depth(mesh.Point(point).data());
    }
  };
  ParallelFor(
    0, static_cast<std::int64_t>(selected.size()), 256, body, Between(progress, 0.8, 1.0));
  return depths;
}

/// The points of each patch, by its lowest point.
using Patches = std::map<vtkIdType, std::vector<vtkIdType>>;

/// Selected points of one kind that edges join, or that are no farther apart than `mergeDistance`.
Patches FindPatches(const SurfaceView& mesh, const std::vector<unsigned char>& kinds,
  const std::vector<vtkIdType>& selected, double mergeDistance, const ProgressCallback& progress)
{
  DisjointSets<vtkIdType> sets(mesh.NumberOfPoints());
  JoinEdges(mesh, kinds, sets);
  if (mergeDistance > 0.0)
  {
    Neighbours(mesh, kinds, mergeDistance).Join(selected, sets, progress);
  }
  Patches patches;
  for (const vtkIdType point : selected)
  {
    patches[sets.Find(point)].push_back(point);
  }
  return patches;
}

}

void Check(const BindingSiteOptions& options)
{
  RequireThat(options.Quantile >= 0.0 && options.Quantile < 1.0, "Quantile", options.Quantile,
    "it must be from 0 to below 1");
  RequireRange("Threshold", options.Threshold, 0.0, Unlimited);
  RequireRange("MergeDistance", options.MergeDistance, 0.0, LargestLength, "It is a length.");
  RequireRange("MinimumArea", options.MinimumArea, 0.0, Unlimited, "It is an area.");
  RequireChoice("RankBy", options.RankBy, SiteRanking::MeanPotential);
}

BindingSiteResult FindBindingSites(const SurfaceView& mesh, const SiteFields& fields,
  const BindingSiteOptions& options, const ProgressCallback& progress)
{
  Check(options);
  BindingSiteResult result;
  const auto count = mesh.Points.size();
  result.Labels.assign(count, 0);
  const std::vector<double> areas = PointAreas(mesh);
  result.Threshold = options.AutomaticThreshold ? ComputeQuantile(fields, areas, options.Quantile)
                                                : options.Threshold;
  Report(progress, 0.1);

  std::vector<unsigned char> kinds(count, 0);
  std::vector<vtkIdType> selected;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (IsIncluded(fields, i) && fields.Amplitude[i] > result.Threshold && areas[i] > 0.0)
    {
      kinds[i] = fields.Kind[i];
      selected.push_back(static_cast<vtkIdType>(i));
    }
  }
  if (selected.empty())
  {
    return result;
  }
  const Patches patches =
    FindPatches(mesh, kinds, selected, options.MergeDistance, Between(progress, 0.1, 0.4));
  const std::vector<double> depths = Depths(mesh, selected, Between(progress, 0.4, 1.0));
  std::vector<std::pair<BindingSite, const std::vector<vtkIdType>*>> ranked;
  for (const auto& [root, points] : patches)
  {
    const BindingSite site = Measure(points, mesh, fields, areas, depths);
    if (site.Area >= options.MinimumArea)
    {
      ranked.emplace_back(site, &points);
    }
  }
  std::stable_sort(ranked.begin(), ranked.end(),
    [&](const auto& a, const auto& b)
    { return RankingValue(a.first, options.RankBy) > RankingValue(b.first, options.RankBy); });
  for (const auto& [site, points] : ranked)
  {
    result.Sites.push_back(site);
    for (const vtkIdType point : *points)
    {
      result.Labels[static_cast<std::size_t>(point)] = static_cast<int>(result.Sites.size());
    }
  }
  return result;
}

}
