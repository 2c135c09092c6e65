#include "Pockets/PocketSites.h"

#include "Atoms/PointBins.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <numeric>

namespace isthmus
{
namespace
{

/// Density and the mean of the places around, by their part of it.
struct Mean
{
  double Density = 0.0;
  Point3 Place{ 0.0, 0.0, 0.0 };
};

class Density
{
public:
  Density(const std::vector<Point3>& places, const std::vector<double>& probabilities)
    : Places(places)
    , Probabilities(probabilities)
    , Bins(places, 0.5 * SiteReach)
  {
  }

  Mean At(const Point3& place) const
  {
    Mean mean;
    this->Bins.Near(place, SiteReach,
      [&](std::int64_t id, double squared)
      {
        const auto i = static_cast<std::size_t>(id);
        const double inside = 1.0 - squared / (SiteReach * SiteReach);
        const double weight = this->Probabilities[i] * inside * inside;
        mean.Density += weight;
        mean.Place = mean.Place + weight * this->Places[i];
      });
    mean.Place = mean.Density > 0.0 ? (1.0 / mean.Density) * mean.Place : place;
    return mean;
  }

  /// The mode that mean shift reaches from `place`.
  Mean Mode(Point3 place) const
  {
    constexpr int limit = 300;
    constexpr double rest = 1e-4; // angstrom
    Mean mean = this->At(place);
    for (int step = 0; step < limit && Distance(mean.Place, place) > rest; ++step)
    {
      place = mean.Place;
      mean = this->At(place);
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
  const std::vector<Point3>& Places;
  const std::vector<double>& Probabilities;
  PointBins Bins;
};

/// Each place to the nearest site within SiteSpacing. O(places x sites near).
void AddPlaces(const std::vector<Point3>& places, std::vector<PocketSite>& sites)
{
  std::vector<Point3> centres;
  centres.reserve(sites.size());
  for (const PocketSite& site : sites)
  {
    centres.push_back(site.Centre);
  }
  const PointBins bins(centres, SiteSpacing);
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
  std::vector<double> values(places.size());
  ParallelFor(0, static_cast<std::int64_t>(places.size()), 64,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        values[i] = density.At(places[i]).Density;
      }
    });
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
    const Mean mode = density.Mode(places[i]);
    // A shoulder of a site that is there already climbs to its mode.
    const bool isNew = std::none_of(sites.begin(), sites.end(),
      [&](const PocketSite& site)
      { return Distance(site.Centre, mode.Place) < 0.5 * SiteSpacing; });
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
