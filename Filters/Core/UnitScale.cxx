#include "Core/UnitScale.h"

#include "Core/RangeChecks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// Powers of two within which coordinates are not scaled.
constexpr int UsualExponent = 20;

/// Extents beyond which the origin is far away.
constexpr double FarAway = 64.0;

bool IsFinite(const Point3& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// The middle of the points along the axes on which it is far from the origin, 0 along others.
Point3 FarMiddle(const View<Point3>& points)
{
  Bounds3 box;
  bool isEmpty = true;
  for (const Point3& p : points)
  {
    if (IsFinite(p))
    {
      box = isEmpty ? Bounds3{ p, p } : box;
      box.Add(p);
      isEmpty = false;
    }
  }
  const Point3 size = box.Max - box.Min;
  const double extent = std::max({ size[0], size[1], size[2] });
  Point3 middle{};
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double at = 0.5 * box.Min[a] + 0.5 * box.Max[a];
    middle[a] = extent > 0.0 && std::abs(at) > FarAway * extent ? at : 0.0;
  }
  return middle;
}

}

UnitScale::UnitScale(const View<Point3>& points)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!IsFinite(points[i]))
    {
      continue;
    }
    for (const double x : points[i])
    {
      largest = std::max(largest, std::abs(x));
    }
    if (largest > LargestLength)
    {
      throw std::invalid_argument("Point " + std::to_string(i) + " has the coordinate " +
        FormatNumber(largest) + ": at most " + FormatNumber(LargestLength) +
        " is supported. Remove the point, or choose another unit of length.");
    }
  }
  if (largest == 0.0)
  {
    return;
  }
  if (largest < SmallestLength)
  {
    throw std::invalid_argument("The largest coordinate of the surface is " +
      FormatNumber(largest) + ": it should be at least " + FormatNumber(SmallestLength) +
      ". Choose another unit of length (Transform).");
  }
  this->Middle = FarMiddle(points);
  if (this->Middle != Point3{})
  {
    largest = 0.0;
    for (const Point3& p : points)
    {
      for (std::size_t a = 0; a < 3 && IsFinite(p); ++a)
      {
        largest = std::max(largest, std::abs(p[a] - this->Middle[a]));
      }
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  if (std::abs(exponent) > UsualExponent)
  {
    this->TheFactor = std::ldexp(1.0, -exponent);
  }
  const double least = largest / LargestReach;
  const auto isTrace = [least](double x) { return x != 0.0 && std::abs(x) < least; };
  if (std::any_of(points.begin(), points.end(),
        [&](const Point3& p)
        {
          const Point3 moved = p - this->Middle;
          return std::any_of(moved.begin(), moved.end(), isTrace);
        }))
  {
    this->Least = this->TheFactor * least;
  }
}

UnitScale::UnitScale(const SurfaceView& surface)
  : UnitScale(surface.Points)
{
  const auto isPoint = [&surface](vtkIdType id)
  { return id >= 0 && id < surface.NumberOfPoints(); };
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    const Triangle& t = surface.Triangles[i];
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (!isPoint(t[k]) || !isPoint(t[(k + 1) % 3]))
      {
        continue; // reported by the check of corners
      }
      const Point3 a = this->TheFactor * surface.Point(t[k]);
      const Point3 b = this->TheFactor * surface.Point(t[(k + 1) % 3]);
      const double edge = Distance(a, b);
      if (a != b && edge < 1.0 / LargestReach)
      {
        throw std::invalid_argument("Triangle " + std::to_string(i) + " has an edge of " +
          FormatNumber(edge / this->TheFactor) + ", and other points are more than " +
          FormatNumber(LargestReach) +
          " times as far away: they cannot be meshed together. Remove the points that are far away "
          "from "
          "the others.");
      }
    }
  }
}

void UnitScale::Apply(std::vector<Point3>& points) const
{
  for (Point3& p : points)
  {
    p = p - this->Middle;
    for (double& x : p)
    {
      x *= this->TheFactor;
      x = std::abs(x) < this->Least ? 0.0 : x;
    }
  }
}

void UnitScale::Undo(std::vector<Point3>& points) const
{
  for (Point3& p : points)
  {
    this->Undo(p);
  }
}

void UnitScale::Undo(Point3& point) const
{
  point = 1.0 / this->TheFactor * point + this->Middle;
}

}
