#include "Pockets/PocketScore.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace isthmus
{

namespace
{

/// Whether two densities differ by no more than symmetry explains: at an axis of symmetry, either
/// of two triangulations may be chosen.
bool AreTied(const Pocket& a, const Pocket& b)
{
  constexpr double slack = 2e-4;
  return std::fabs(a.Density - b.Density) <= slack * std::max(a.Density, b.Density);
}

}

void ScorePocket(Pocket& pocket)
{
  Point3 sum{ 0.0, 0.0, 0.0 };
  for (const PocketCell& cell : pocket.Cells)
  {
    const double share = cell.Volume * BurialWeight(static_cast<double>(cell.Burial));
    pocket.Volume += cell.Volume;
    pocket.Score += share;
    sum = sum + share * cell.Center;
    pocket.Radius = std::max(pocket.Radius, cell.IsFlat ? 0.0 : cell.Clearance);
    pocket.Access = std::max(pocket.Access, cell.Access);
  }
  if (pocket.Score > 0.0)
  {
    pocket.Center = (1.0 / pocket.Score) * sum;
    return;
  }
  // Only if the mouths take more volume than there is among many atoms: then the volume without
  // them is used.
  double weights = 0.0;
  pocket.Score = 0.0;
  for (const PocketCell& cell : pocket.Cells)
  {
    const double weight = std::max(0.0, cell.Volume);
    weights += weight;
    pocket.Center = pocket.Center + weight * cell.Center;
  }
  pocket.Center = (weights > 0.0 ? 1.0 / weights : 0.0) * pocket.Center;
}

/// A site has no walls towards the rest of its pocket, so sectors of distant balls may make its
/// computed empty volume negative (EmptySpace.h: values of single tetrahedra may be).
void ScoreSite(Pocket& site)
{
  const Point3 mode = site.Center;
  for (PocketCell& cell : site.Cells)
  {
    cell.Volume = std::clamp(cell.Volume, 0.0, cell.Size);
  }
  site.Center = { 0.0, 0.0, 0.0 };
  ScorePocket(site);
  site.Center = mode;
}

void OrderTiedSites(const std::vector<SiteName>& names, std::vector<Pocket>& sites)
{
  std::vector<std::size_t> order(sites.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  for (auto first = order.begin(); first != order.end();)
  {
    const auto last = std::find_if(
      first, order.end(), [&](std::size_t i) { return !AreTied(sites[*first], sites[i]); });
    std::map<std::int64_t, std::size_t> firstOf; // of each group
    std::for_each(first, last, [&](std::size_t i) { firstOf.emplace(sites[i].Group, i); });
    const auto key = [&](std::size_t i)
    {
      const std::size_t copy = firstOf.at(sites[i].Group);
      return std::tie(sites[copy].Chain, names[copy], sites[i].Group);
    };
    std::stable_sort(first, last, [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    first = std::max(last, first + 1); // a density may be NaN
  }
  std::vector<Pocket> sorted;
  std::map<std::int64_t, std::int64_t> parents;
  for (const std::size_t i : order)
  {
    sorted.push_back(std::move(sites[i]));
    std::int64_t& parent = sorted.back().Parent;
    if (parent > 0)
    {
      parent = parents.emplace(parent, static_cast<std::int64_t>(parents.size()) + 1).first->second;
    }
  }
  sites = std::move(sorted);
}

void RankPockets(std::vector<Pocket>& pockets)
{
  std::stable_sort(pockets.begin(), pockets.end(),
    [](const Pocket& a, const Pocket& b) { return a.Score > b.Score; });
}

void WeightScoresByCurvature(const SurfaceView& surface, const PocketSurfaceFields& fields,
  bool rank, std::vector<Pocket>& pockets, std::vector<PocketSurfaceMeans>& means)
{
  const PocketSurfaceMeans whole = MeasureWholeSurface(surface, fields);
  means = MeasurePocketSurfaces(surface, fields, pockets);
  for (std::size_t p = 0; p < pockets.size(); ++p)
  {
    const double ratio = means[p].Polarized / whole.Polarized;
    pockets[p].Score *= std::isfinite(ratio) ? std::sqrt(ratio) : 1.0;
  }
  if (!rank)
  {
    return;
  }
  std::vector<std::size_t> order(pockets.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return pockets[a].Score > pockets[b].Score; });
  std::vector<Pocket> sorted;
  std::vector<PocketSurfaceMeans> sortedMeans;
  for (const std::size_t i : order)
  {
    sorted.push_back(std::move(pockets[i]));
    sortedMeans.push_back(means[i]);
  }
  pockets = std::move(sorted);
  means = std::move(sortedMeans);
}

}
