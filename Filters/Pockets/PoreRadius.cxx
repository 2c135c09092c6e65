#include "Pockets/PoreRadius.h"

#include "Core/Geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace isthmus
{
namespace
{

std::vector<Point3> CollectCenters(const std::vector<Ball>& atoms)
{
  std::vector<Point3> centers(atoms.size());
  std::transform(
    atoms.begin(), atoms.end(), centers.begin(), [](const Ball& atom) { return atom.Center; });
  return centers;
}

/// 4 angstrom for molecules; more for balls farther apart (another unit, coarse models), whose
/// clearances would span thousands of bins. A stray ball far away does not count.
double BinSizeFor(const std::vector<Ball>& atoms)
{
  double size = 4.0;
  std::vector<std::array<double, 3>> bins(atoms.size());
  const auto areFew = [&]()
  {
    std::transform(atoms.begin(), atoms.end(), bins.begin(),
      [size](const Ball& atom)
      {
        return std::array<double, 3>{ std::floor(atom.Center[0] / size),
          std::floor(atom.Center[1] / size), std::floor(atom.Center[2] / size) };
      });
    std::sort(bins.begin(), bins.end());
    const auto occupied = std::unique(bins.begin(), bins.end()) - bins.begin();
    return 3 * static_cast<std::size_t>(occupied) <= 2 * atoms.size() + 2;
  };
  while (!areFew())
  {
    size *= 2.0;
  }
  return size;
}

/// value + slope . d, a linear model over the plane's two coordinates.
struct Linear
{
  double Value;
  std::array<double, 2> Slope;

  double operator()(const std::array<double, 2>& d) const
  {
    return this->Value + this->Slope[0] * d[0] + this->Slope[1] * d[1];
  }
};

double Least(const std::vector<Linear>& models, const std::array<double, 2>& d)
{
  double least = HUGE_VAL;
  for (const Linear& model : models)
  {
    least = std::min(least, model(d));
  }
  return least;
}

/**
 * Where in the square |d| <= size the least of the models is greatest. That is a corner of the
 * polyhedron under all of them: where three of the models or sides of the square meet.
 */
std::array<double, 2> BestStep(const std::vector<Linear>& models, double size)
{
  std::array<double, 2> best{ 0.0, 0.0 };
  double bestValue = Least(models, best);
  const auto offer = [&](const std::array<double, 2>& d)
  {
    constexpr double slack = 1.0 + 1e-12;
    if (std::fabs(d[0]) <= size * slack && std::fabs(d[1]) <= size * slack)
    {
      const double value = Least(models, d);
      if (value > bestValue)
      {
        bestValue = value;
        best = d;
      }
    }
  };
  const std::size_t n = models.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = i + 1; j < n; ++j)
    {
      // Equal values of i and j lie on a line; it meets the sides, and the lines of others.
      const double a = models[i].Slope[0] - models[j].Slope[0];
      const double b = models[i].Slope[1] - models[j].Slope[1];
      const double c = models[j].Value - models[i].Value;
      for (const double side : { -size, size })
      {
        offer({ side, (c - a * side) / b });
        offer({ (c - b * side) / a, side });
      }
      for (std::size_t k = j + 1; k < n; ++k)
      {
        const double e = models[i].Slope[0] - models[k].Slope[0];
        const double f = models[i].Slope[1] - models[k].Slope[1];
        const double g = models[k].Value - models[i].Value;
        const double det = a * f - b * e;
        offer({ (c * f - b * g) / det, (a * g - c * e) / det });
      }
    }
  }
  for (const double x : { -size, size })
  {
    offer({ x, size });
    offer({ x, -size });
  }
  return best;
}

/// Two directions of length 1 that span the plane.
std::array<Point3, 2> Axes(const Point3& normal)
{
  const std::size_t least = std::fabs(normal[0]) <= std::fabs(normal[1])
    ? (std::fabs(normal[0]) <= std::fabs(normal[2]) ? 0 : 2)
    : (std::fabs(normal[1]) <= std::fabs(normal[2]) ? 1 : 2);
  Point3 helper{ 0.0, 0.0, 0.0 };
  helper[least] = 1.0;
  const Point3 cross = Cross(normal, helper);
  const Point3 u = (1.0 / Length(cross)) * cross;
  return { u, Cross(normal, u) };
}

double ClearanceAt(const std::vector<Ball>& atoms, const Point3& place)
{
  double least = HUGE_VAL;
  for (const Ball& atom : atoms)
  {
    least = std::min(least, Length(place - atom.Center) - atom.Radius);
  }
  return least;
}

/// Linear models, at `place` where the clearance is `least`, of the distances that may matter
/// within `size`: the nearest ones.
std::vector<Linear> ModelsAt(const std::vector<Ball>& atoms, const Point3& place,
  const std::array<Point3, 2>& axes, double size, double least)
{
  constexpr std::size_t most = 8;
  std::vector<Linear> models;
  for (const Ball& atom : atoms)
  {
    const Point3 d = place - atom.Center;
    const double length = Length(d);
    if (length - atom.Radius <= least + 2.0 * std::sqrt(2.0) * size && length > 0.0)
    {
      models.push_back(
        { length - atom.Radius, { Dot(d, axes[0]) / length, Dot(d, axes[1]) / length } });
    }
  }
  const std::size_t count = std::min(models.size(), most);
  std::partial_sort(models.begin(), models.begin() + static_cast<std::ptrdiff_t>(count),
    models.end(), [](const Linear& a, const Linear& b) { return a.Value < b.Value; });
  models.resize(count);
  return models;
}

}

AtomField::AtomField(const std::vector<Ball>& atoms)
  : Atoms(atoms)
  , Bins(CollectCenters(atoms), BinSizeFor(atoms))
{
  for (const Ball& atom : atoms)
  {
    this->Largest = std::max(this->Largest, atom.Radius);
  }
}

AtomField::Clearance AtomField::At(const Point3& place, double guess) const
{
  constexpr double furthest = 1e4;
  constexpr double growth = 1.26; // twice the volume
  Clearance clearance{ HUGE_VAL, -1 };
  double reach = std::max(guess, 4.0);
  const auto look = [&]()
  {
    this->Bins.Near(place, reach + this->Largest,
      [&](std::int64_t id, double squared)
      {
        const double radius = std::sqrt(squared) - this->Atoms[static_cast<std::size_t>(id)].Radius;
        if (radius < clearance.Radius || (radius == clearance.Radius && id < clearance.Atom))
        {
          clearance = { radius, id };
        }
      });
  };
  for (look(); clearance.Radius > reach && reach < furthest; look())
  {
    reach = std::min(growth * reach, clearance.Radius);
  }
  return clearance;
}

std::vector<std::int64_t> AtomField::Touching(const Point3& place, double reach) const
{
  std::vector<std::int64_t> near;
  this->Bins.Near(place, reach + this->Largest,
    [&](std::int64_t id, double squared)
    {
      const double distance = reach + this->Atoms[static_cast<std::size_t>(id)].Radius;
      if (squared <= distance * distance)
      {
        near.push_back(id);
      }
    });
  return near;
}

std::vector<Ball> AtomField::Near(const Point3& place, double reach) const
{
  std::vector<Ball> near;
  for (const std::int64_t id : this->Touching(place, reach))
  {
    near.push_back(this->Atoms[static_cast<std::size_t>(id)]);
  }
  return near;
}

PlaneBall ClimbInPlane(
  const AtomField& field, const Plane& plane, const Point3& start, const Climb& climb)
{
  const auto axes = Axes(plane.Normal);
  Point3 place = start - Dot(start - plane.Origin, plane.Normal) * plane.Normal;
  const Point3 first = place;
  double radius = field.At(place, climb.Clearance - Length(place - start)).Radius;
  // In a wide channel, all steps would cross a small part of it, and each searches many atoms.
  const double largest = std::max(0.5, radius / 16.0);
  double size = largest;
  // Atoms fetched once suffice while the place moves by at most `fetched`.
  double fetched = 3.0 * largest;
  const auto fetch = [&]() { return field.Near(place, radius + 2.0 * fetched); };
  std::vector<Ball> atoms = fetch();
  Point3 fetchedAt = place;
  for (int step = 0; step < 200 && size > climb.Tolerance && radius < climb.Enough; ++step)
  {
    const bool areTooMany = fetched > std::max(1.5, 24.0 * size);
    if (areTooMany || Length(place - fetchedAt) + 1.5 * size > fetched)
    {
      fetched = std::max(1.5, 3.0 * size);
      fetchedAt = place;
      atoms = fetch();
    }
    const auto models = ModelsAt(atoms, place, axes, size, radius);
    const auto d = BestStep(models, size);
    const Point3 next = place + d[0] * axes[0] + d[1] * axes[1];
    const double promised = Least(models, d) - radius;
    const double gained = ClearanceAt(atoms, next) - radius;
    const bool inside = Length(next - first) <= climb.Reach;
    if (inside && gained > 0.1 * promised && gained > 0.0)
    {
      place = next;
      radius += gained;
      size = gained > 0.7 * promised ? std::min(largest, 2.0 * size) : size;
    }
    else
    {
      size *= 0.25;
    }
  }
  return { place, field.At(place, radius).Radius };
}

PlaneBall LargestBallInPlane(const AtomField& field, const Plane& plane,
  const std::vector<Point3>& starts, double width, double enough)
{
  const auto axes = Axes(plane.Normal);
  Climb rough{ 2.0 * std::max(width, 1.0), enough, 1e-2, width };
  PlaneBall best = ClimbInPlane(field, plane, starts.front(), rough);
  const PlaneBall first = best;
  const auto offer = [&](const Point3& start)
  {
    // Searches that end in the same place differ by less: the first of them is kept. A center
    // outside of the first ball belongs to another place: a wider vestibule or another pore.
    rough.Clearance = first.Radius - Length(start - first.Center);
    const PlaneBall ball = ClimbInPlane(field, plane, start, rough);
    const bool here = Length(ball.Center - first.Center) <= std::max(first.Radius, 1.0);
    best = here && ball.Radius > best.Radius + 1e-4 ? ball : best;
  };
  std::for_each(starts.begin() + 1, starts.end(), offer);
  constexpr int around = 6;
  for (int i = 0; i < 2 * around && best.Radius < enough; ++i)
  {
    const double angle = Pi / around * (2 * (i % around) + (i < around ? 0 : 1));
    const double r = (i < around ? 0.5 : 0.9) * std::max(width, 0.0);
    offer(starts.front() + r * std::cos(angle) * axes[0] + r * std::sin(angle) * axes[1]);
  }
  return best.Radius < enough
    ? ClimbInPlane(field, plane, best.Center, { rough.Reach, enough, 1e-11, best.Radius })
    : best;
}

}
