#include "Pockets/PocketSurface.h"

#include "Atoms/PointBins.h"
#include "Core/ParallelFor.h"
#include "Surfaces/AreaQuantiles.h"

#include <cmath>

namespace isthmus
{
namespace
{

/// Sums by area over some points.
struct AreaSums
{
  double Area = 0.0, Polarized = 0.0;
  double PotentialArea = 0.0, Potential = 0.0;

  void Add(const PocketSurfaceFields& fields, std::size_t point, double area)
  {
    if (!std::isnan(fields.Polarized[point]))
    {
      this->Area += area;
      this->Polarized += area * std::fabs(fields.Polarized[point]);
    }
    if (!fields.Potential.empty() && !std::isnan(fields.Potential[point]))
    {
      this->PotentialArea += area;
      this->Potential += area * fields.Potential[point];
    }
  }

  PocketSurfaceMeans Means() const
  {
    return { this->Potential / this->PotentialArea, this->Polarized / this->Area, this->Area };
  }
};

}

std::vector<PocketSurfaceMeans> MeasurePocketSurfaces(const SurfaceView& surface,
  const PocketSurfaceFields& fields, const std::vector<Pocket>& pockets, double reach)
{
  const std::vector<double> areas = PointAreas(surface);
  const PointBins bins(surface.Points, 3.0);
  std::vector<PocketSurfaceMeans> means;
  std::vector<std::size_t> seenBy(surface.Points.size(), pockets.size());
  for (std::size_t p = 0; p < pockets.size(); ++p)
  {
    AreaSums sums;
    for (const PocketCell& cell : pockets[p].Cells)
    {
      bins.Near(cell.Center, cell.Clearance + reach,
        [&](std::int64_t id, double)
        {
          const auto point = static_cast<std::size_t>(id);
          if (seenBy[point] != p)
          {
            seenBy[point] = p;
            sums.Add(fields, point, areas[point]);
          }
        });
    }
    means.push_back(sums.Means());
  }
  return means;
}

PocketSurfaceMeans MeasureWholeSurface(
  const SurfaceView& surface, const PocketSurfaceFields& fields)
{
  const std::vector<double> areas = PointAreas(surface);
  AreaSums whole;
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    whole.Add(fields, i, areas[i]);
  }
  return whole.Means();
}

std::vector<double> SiteProbabilities(
  const SurfaceView& surface, const std::vector<SitePlace>& places)
{
  constexpr double reach = 5.0;
  std::vector<Point3> centers;
  centers.reserve(places.size());
  for (const SitePlace& place : places)
  {
    centers.push_back(place.Center);
  }
  const PointBins bins(centers, reach);
  std::vector<double> values(surface.Points.size(), 0.0);
  ParallelFor(0, static_cast<std::int64_t>(values.size()), 1024,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        double sum = 0.0, weights = 0.0;
        bins.Near(surface.Points[i], reach,
          [&](std::int64_t id, double squared)
          {
            const double inside = 1.0 - std::sqrt(squared) / reach;
            weights += inside * inside;
            sum += inside * inside * places[static_cast<std::size_t>(id)].Probability;
          });
        values[i] = weights > 0.0 ? sum / weights : 0.0;
      }
    });
  return values;
}

std::vector<int> LabelPocketSurfaces(
  const SurfaceView& surface, const std::vector<Pocket>& pockets, double reach)
{
  const PointBins bins(surface.Points, 3.0);
  std::vector<int> labels(surface.Points.size(), 0);
  for (std::size_t p = 0; p < pockets.size(); ++p)
  {
    for (const PocketCell& cell : pockets[p].Cells)
    {
      bins.Near(cell.Center, cell.Clearance + reach,
        [&](std::int64_t id, double)
        {
          int& label = labels[static_cast<std::size_t>(id)];
          label = label == 0 ? static_cast<int>(p) + 1 : label;
        });
    }
  }
  return labels;
}

}
