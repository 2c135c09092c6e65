#include "Persistence/FullereneStability.h"

#include "Core/RangeChecks.h"
#include "Persistence/DelaunayFiltration.h"
#include "Persistence/FiltrationPairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace isthmus
{
namespace
{

/// The atoms, each place once. Throws where one is not finite.
std::vector<Point3> Places(const std::vector<Point3>& atoms)
{
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    if (!std::isfinite(atoms[i][0]) || !std::isfinite(atoms[i][1]) || !std::isfinite(atoms[i][2]))
    {
      throw std::invalid_argument(
        "Atom " + std::to_string(i) + " has a coordinate that is not a finite number.");
    }
  }
  std::vector<Point3> places(atoms);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// How flat a set of points is.
struct Spread
{
  double Size = 0.0;   ///< greatest distance from the first point
  double Width = 0.0;  ///< greatest distance from the line to that point
  double Height = 0.0; ///< greatest distance from the plane to a third one
  Point3 Normal{ 0.0, 0.0, 0.0 };
};

/// The member of `points` with the greatest `measure`, and that measure.
template <typename Measure>
std::pair<Point3, double> Farthest(const std::vector<Point3>& points, Measure&& measure)
{
  std::pair<Point3, double> best{ points.front(), 0.0 };
  for (const Point3& point : points)
  {
    const double value = measure(point);
    best = value > best.second ? std::make_pair(point, value) : best;
  }
  return best;
}

Spread ComputeSpread(const std::vector<Point3>& points)
{
  Spread spread;
  const Point3 first = points.front();
  const auto far = Farthest(points, [&](const Point3& p) { return Length(p - first); });
  spread.Size = far.second;
  if (!(spread.Size > 0.0))
  {
    return spread;
  }
  const Point3 along = (1.0 / spread.Size) * (far.first - first);
  const auto wide =
    Farthest(points, [&](const Point3& p) { return Length(Cross(along, p - first)); });
  spread.Width = wide.second;
  if (spread.Width > 0.0)
  {
    spread.Normal = (1.0 / spread.Width) * Cross(along, wide.first - first);
    spread.Height = Farthest(points,
      [&](const Point3& p) {
        return std::abs(Dot(spread.Normal, p - first));
      }).second;
  }
  return spread;
}

/// Relative to the size: the deviation of rounded coordinates from a line or a plane.
constexpr double Flat = 1e-12;

/// Atoms on one circle or sphere cause bars whose length is only the rounding of radii, whose
/// relative error is at most this (DelaunayFiltration.h): they are omitted.
constexpr double Rounding = 1e-9;

/// Values of the filtration are squared radii.
void AddBar(int dimension, double birth, double death, std::vector<DistanceBar>& bars)
{
  const DistanceBar bar{ dimension, std::sqrt(birth), std::sqrt(death) };
  if (bar.Length() > Rounding * bar.Death)
  {
    bars.push_back(bar);
  }
}

}

void Check(const StabilityParameters& parameters)
{
  Check(static_cast<const GridDistanceParameters&>(parameters));
  RequireChoice("Method", parameters.Method, StabilityMethod::Grid);
  RequireRange(
    "FilterDelta", parameters.FilterDelta, 0.0, LargestLength, "It is the length of a bar.");
  if (parameters.ScaleByRadius && parameters.Method == StabilityMethod::Exact)
  {
    throw std::invalid_argument("ScaleByRadius needs the method Grid, since the exact alpha "
                                "complex is for balls of equal size.");
  }
}

std::vector<DistanceBar> AlphaBars(
  const std::vector<Point3>& atoms, const ProgressCallback& progress)
{
  std::vector<Point3> places = Places(atoms);
  if (places.size() < 3)
  {
    return {};
  }
  const Spread spread = ComputeSpread(places);
  if (spread.Width <= Flat * spread.Size)
  {
    return {}; // in a line
  }
  const bool inPlane = spread.Height <= Flat * spread.Size;
  double end = std::numeric_limits<double>::infinity();
  if (inPlane)
  {
    // Simplices with the far point enter at half its distance or later; in the plane the last ones
    // enter at the radius of the largest circle, which for obtuse triangles can be large as well,
    // but no ring ends there.
    places.push_back(places.front() + (1e4 * spread.Size) * spread.Normal);
    end = spread.Size * spread.Size * 1e6;
  }
  const CellFiltration filtration = DelaunayFiltration(places, Between(progress, 0.0, 0.7));
  const FiltrationPairs pairs(filtration, Between(progress, 0.7, 1.0));
  std::vector<DistanceBar> bars;
  for (const EdgeId edge : filtration.Edges.Keys())
  {
    const TriangleId filler = pairs.LoopFilled(edge);
    if (filler.Exists() && filtration.EdgeValue[edge] < end)
    {
      AddBar(1, filtration.EdgeValue[edge], filtration.TriangleValue[filler], bars);
    }
  }
  for (const TriangleId triangle : filtration.Triangles())
  {
    const TetrahedronId filler = pairs.VoidFilled(triangle);
    if (filler.Exists() && !inPlane)
    {
      AddBar(2, filtration.TriangleValue[triangle], filtration.TetrahedronValue[filler], bars);
    }
  }
  SortBars(bars);
  return bars;
}

FullereneStability ComputeStability(const std::vector<Point3>& atoms,
  const std::vector<DistanceBar>& bars, double filterDelta, double theta)
{
  FullereneStability row;
  row.Atoms = static_cast<std::int64_t>(Places(atoms).size());
  for (const DistanceBar& bar : bars)
  {
    if (bar.Dimension == 2)
    {
      row.Cavity = std::max(row.Cavity, bar.Length());
      continue;
    }
    row.Integral += bar.Length();
    if (bar.Length() >= filterDelta || bar.Death >= theta)
    {
      ++row.Bars;
      row.FilteredIntegral += bar.Length();
    }
  }
  for (std::size_t axis = 0; axis < 3 && !atoms.empty(); ++axis)
  {
    const auto ends = std::minmax_element(atoms.begin(), atoms.end(),
      [axis](const Point3& a, const Point3& b) { return a[axis] < b[axis]; });
    row.BoxLength = std::max(row.BoxLength, (*ends.second)[axis] - (*ends.first)[axis]);
  }
  row.EnergyProxy = atoms.empty() ? 0.0 : -row.FilteredIntegral / static_cast<double>(row.Atoms);
  return row;
}

}
