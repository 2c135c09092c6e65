#include "Pockets/HullDepth.h"

#include "Core/Geometry.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus
{
namespace
{

constexpr int directionCount = 1000;

double HeightAlong(const std::array<double, 3>& n, const double* p)
{
  return n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
}

}

HullDepth::HullDepth(const SurfaceView& mesh, const ProgressCallback& progress)
  : Directions(directionCount)
  , Heights(directionCount, -std::numeric_limits<double>::infinity())
{
  // Fibonacci lattice: turning by the golden angle spreads the directions evenly over the sphere.
  const double golden = Pi * (3.0 - std::sqrt(5.0));
  for (int d = 0; d < directionCount; ++d)
  {
    const double z = 1.0 - (2.0 * d + 1.0) / directionCount;
    const double r = std::sqrt(1.0 - z * z);
    this->Directions[static_cast<std::size_t>(d)] = { r * std::cos(golden * d),
      r * std::sin(golden * d), z };
  }
  // Points that no triangle uses would enlarge the hull.
  std::vector<vtkIdType> used;
  used.reserve(3 * mesh.Triangles.size());
  for (const Triangle& t : mesh.Triangles)
  {
    used.insert(used.end(), t.begin(), t.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const auto body = [&](std::int64_t first, std::int64_t last)
  {
    for (auto d = static_cast<std::size_t>(first); d < static_cast<std::size_t>(last); ++d)
    {
      const std::array<double, 3> n = this->Directions[d];
      double height = this->Heights[d];
      for (const vtkIdType point : used)
      {
        height = std::max(height, Dot(n, mesh.Point(point)));
      }
      this->Heights[d] = height;
    }
  };
  ParallelFor(0, directionCount, 10, body, progress);
}

double HullDepth::operator()(const double* point) const
{
  // The intersection of the half spaces contains the hull, so the depth is never too small.
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t d = 0; d < this->Directions.size(); ++d)
  {
    depth = std::min(depth, this->Heights[d] - HeightAlong(this->Directions[d], point));
  }
  return depth;
}

}
