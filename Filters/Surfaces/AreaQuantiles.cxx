#include "Surfaces/AreaQuantiles.h"

#include "Core/RangeChecks.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace isthmus
{

double TriangleArea(const SurfaceView& surface, vtkIdType triangle)
{
  const Triangle& corners = surface.Corners(triangle);
  const Point3& a = surface.Point(corners[0]);
  const Point3 normal = Cross(surface.Point(corners[1]) - a, surface.Point(corners[2]) - a);
  return 0.5 * std::hypot(normal[0], normal[1], normal[2]);
}

std::vector<double> PointAreas(const SurfaceView& surface)
{
  std::vector<double> areas(surface.Points.size(), 0.0);
  for (vtkIdType t = 0; t < surface.NumberOfTriangles(); ++t)
  {
    const double third = TriangleArea(surface, t) / 3.0;
    for (const vtkIdType point : surface.Corners(t))
    {
      areas[At(point)] += third;
    }
  }
  return areas;
}

double WeightedQuantile(const std::vector<WeightedValue>& sorted, double fraction)
{
  double total = 0.0;
  for (const WeightedValue& value : sorted)
  {
    total += value.second;
  }
  if (!(total > 0.0))
  {
    throw std::invalid_argument("None of the values has an area.");
  }
  RequireRange("The fraction", fraction, 0.0, 1.0);
  double below = 0.0;
  for (const WeightedValue& value : sorted)
  {
    below += value.second;
    if (below >= fraction * total && value.second > 0.0)
    {
      return value.first;
    }
  }
  return sorted.back().first; // rounding of the sums
}

}
