#include "AreaQuantiles.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace isthmus
{

double TriangleArea(const SurfaceView& surface, vtkIdType triangle)
{
  const vtkIdType* corners = surface.Triangle(triangle);
  const double* a = surface.Point(corners[0]);
  const double* b = surface.Point(corners[1]);
  const double* c = surface.Point(corners[2]);
  const double u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  return 0.5 *
    std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

std::vector<double> PointAreas(const SurfaceView& surface)
{
  std::vector<double> areas(static_cast<std::size_t>(surface.NumberOfPoints), 0.0);
  for (vtkIdType t = 0; t < surface.NumberOfTriangles; ++t)
  {
    const double third = TriangleArea(surface, t) / 3.0;
    for (int corner = 0; corner < 3; ++corner)
    {
      areas[static_cast<std::size_t>(surface.Triangle(t)[corner])] += third;
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
    throw std::invalid_argument("There is no value with an area.");
  }
  if (!(fraction >= 0.0) || !(fraction <= 1.0))
  {
    throw std::invalid_argument("A quantile is from 0 to 1.");
  }
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
