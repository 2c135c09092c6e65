#include "Pockets/PocketSites.h"

#include "Atoms/PointBins.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isthmus
{
namespace
{

/// Density and the mean of the places around, by their share of it.
struct Mean
{
  double Density = 0.0;
  Point3 Place{ 0.0, 0.0, 0.0 };
};

/// A kernel of the squared distance.
double Kernel(double squared, double reach)
{
  const double inside = 1.0 - squared / (reach * reach);
  return inside * inside;
}

/// value(i) for each i.
template <typename Value>
std::vector<double> Evaluate(std::size_t count, Value&& value)
{
  std::vector<double> values(count);
  ParallelFor(0, static_cast<std::int64_t>(count), 64,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        values[i] = value(i);
      }
    });
  return values;
}

/// The weight of each place in the density.
std::vector<double> ComputeWeights(
  const std::vector<Point3>& places, const std::vector<double>& probabilities)
{
  const PointBins bins(places, CrowdingReach);
  return Evaluate(places.size(),
    [&](std::size_t i)
    {
      double crowding = 0.0;
      bins.Near(places[i], CrowdingReach,
        [&](std::int64_t, double squared) { crowding += Kernel(squared, CrowdingReach); });
      return probabilities[i] / std::sqrt(std::max(crowding, 1.0));
    });
}

class Density
{
public:
  Density(const std::vector<Point3>& places, const std::vector<double>& probabilities)
    : Places(places)
    , Weights(ComputeWeights(places, probabilities))
    , Bins(places, 0.5 * DensityReach)
  {
  }

  double At(const Point3& place) const
  {
    double density = 0.0;
    this->Bins.Near(place, DensityReach,
      [&](std::int64_t id, double squared)
      { density += this->Weights[static_cast<std::size_t>(id)] * Kernel(squared, DensityReach); });
    return density;
  }

  /// The mode that mean shift reaches from `place`; that of one of `sites` within AtMode of the
  /// way.
  Mean Mode(Point3 place, const std::vector<PocketSite>& sites) const
  {
    constexpr int limit = 300;
    constexpr double rest = 1e-4; // angstrom
    constexpr double around = 1.5;
    Point3 gatheredAt = place;
    std::vector<Weighted> near = this->GatherNear(place, DensityReach + around);
    std::vector<Point3> modes = ModesNear(place, sites, AtMode + around);
    Mean mean = MeanAt(place, near);
    for (int step = 0; step < limit && Distance(mean.Place, place) > rest; ++step)
    {
      place = mean.Place;
      const auto at = std::find_if(modes.begin(), modes.end(),
        [&](const Point3& mode) { return Distance(mode, place) < AtMode; });
      if (at != modes.end())
      {
        return { mean.Density, *at };
      }
      if (Distance(place, gatheredAt) > 0.999 * around)
      {
        gatheredAt = place;
        near = this->GatherNear(place, DensityReach + around);
        modes = ModesNear(place, sites, AtMode + around);
      }
      mean = MeanAt(place, near);
    }
    return { mean.Density, place };
  }

  template <typename Visit>
  void Near(const Point3& place, double reach, Visit&& visit) const
  {
    this->Bins.Near(
      place, reach, [&](std::int64_t id, double) { visit(static_cast<std::size_t>(id)); });
  }

private:
  static constexpr double AtMode = 0.5; // angstrom

  static std::vector<Point3> ModesNear(
    const Point3& place, const std::vector<PocketSite>& sites, double reach)
  {
    std::vector<Point3> modes;
    for (const PocketSite& site : sites)
    {
      const Point3 d = site.Center - place;
      if (Dot(d, d) < reach * reach)
      {
        modes.push_back(site.Center);
      }
    }
    return modes;
  }

  struct Weighted
  {
    Point3 Place;
    double Weight;
  };

  std::vector<Weighted> GatherNear(const Point3& place, double reach) const
  {
    std::vector<Weighted> near;
    this->Near(place, reach,
      [&](std::size_t i) {
        near.push_back({ this->Places[i], this->Weights[i] });
      });
    return near;
  }

  /// `near`: all within DensityReach, and others.
  static Mean MeanAt(const Point3& place, const std::vector<Weighted>& near)
  {
    Mean mean;
    for (const Weighted& one : near)
    {
      const Point3 d = one.Place - place;
      // Those beyond DensityReach have the weight 0, without a branch.
      const double inside = std::max(0.0, 1.0 - Dot(d, d) / (DensityReach * DensityReach));
      const double weight = one.Weight * inside * inside;
      mean.Density += weight;
      mean.Place = mean.Place + weight * one.Place;
    }
    mean.Place = mean.Density > 0.0 ? (1.0 / mean.Density) * mean.Place : place;
    return mean;
  }

  const std::vector<Point3>& Places;
  std::vector<double> Weights;
  PointBins Bins;
};

/// Assigns each place to the nearest site within SiteSpacing. O(places x sites near).
void AddPlaces(const std::vector<Point3>& places, std::vector<PocketSite>& sites)
{
  std::vector<Point3> centers;
  centers.reserve(sites.size());
  for (const PocketSite& site : sites)
  {
    centers.push_back(site.Center);
  }
  const PointBins bins(centers, SiteSpacing);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    double least = SiteSpacing * SiteSpacing;
    std::int64_t nearest = -1;
    bins.Near(places[i], SiteSpacing,
      [&](std::int64_t id, double squared)
      {
        if (squared < least || (squared == least && nearest < 0))
        {
          least = squared;
          nearest = id;
        }
      });
    if (nearest >= 0)
    {
      sites[static_cast<std::size_t>(nearest)].Places.push_back(i);
    }
  }
}

}

std::vector<PocketSite> FindSites(
  const std::vector<Point3>& places, const std::vector<double>& probabilities)
{
  const Density density(places, probabilities);
  const std::vector<double> values =
    Evaluate(places.size(), [&](std::size_t i) { return density.At(places[i]); });
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  std::vector<PocketSite> sites;
  std::vector<char> isTaken(places.size(), 0);
  for (const std::size_t i : order)
  {
    if (values[i] < LeastDensity * values[order.front()])
    {
      break;
    }
    if (isTaken[i])
    {
      continue;
    }
    const Mean mode = density.Mode(places[i], sites);
    // A shoulder of an existing site converges to its mode.
    const bool isNew = std::none_of(sites.begin(), sites.end(),
      [&](const PocketSite& site)
      {
        const Point3 d = site.Center - mode.Place;
        return Dot(d, d) < 0.25 * SiteSpacing * SiteSpacing;
      });
    if (isNew)
    {
      sites.push_back({ mode.Place, mode.Density, {} });
      density.Near(mode.Place, SiteSpacing, [&](std::size_t near) { isTaken[near] = 1; });
    }
    isTaken[i] = 1;
  }
  AddPlaces(places, sites);
  std::stable_sort(sites.begin(), sites.end(),
    [](const PocketSite& a, const PocketSite& b) { return a.Density > b.Density; });
  return sites;
}

}
