#include "MolecularSurfaces/AtomsInside.h"

#include "Core/NumberText.h"

#include <vtkImageData.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// Interpolates between the eight nodes around `index` (continuous, from the first node).
double ValueBetween(
  const std::array<int, 3>& dimensions, const std::vector<float>& values, const Point3& index)
{
  std::array<std::int64_t, 3> low{};
  std::array<double, 3> part{};
  for (std::size_t a = 0; a < 3; ++a)
  {
    const int last = dimensions[a] - 1;
    if (!(index[a] >= 0.0 && index[a] <= last))
    {
      return HUGE_VAL;
    }
    low[a] = std::max(0, std::min(static_cast<int>(index[a]), last - 1));
    part[a] = index[a] - static_cast<double>(low[a]);
  }
  double sum = 0.0;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    std::int64_t node = 0;
    std::int64_t stride = 1;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const bool high = ((corner >> a) & 1U) != 0;
      weight *= high ? part[a] : 1.0 - part[a];
      node += stride * std::min<std::int64_t>(low[a] + (high ? 1 : 0), dimensions[a] - 1);
      stride *= dimensions[a];
    }
    sum +=
      weight > 0.0 ? weight * static_cast<double>(values[static_cast<std::size_t>(node)]) : 0.0;
  }
  return sum;
}

}

std::string CheckAtomsInside(vtkImageData* grid, const std::vector<float>& distances,
  const std::vector<Point3>& centers, const std::string& what)
{
  const int* const extent = grid->GetExtent();
  const std::array<int, 3> dimensions{ grid->GetDimensions()[0], grid->GetDimensions()[1],
    grid->GetDimensions()[2] };
  std::size_t outside = 0;
  Point3 first{};
  for (const Point3& center : centers)
  {
    double index[3];
    grid->TransformPhysicalPointToContinuousIndex(center.data(), index);
    const Point3 place{ index[0] - extent[0], index[1] - extent[2], index[2] - extent[4] };
    if (!(ValueBetween(dimensions, distances, place) < 0.0))
    {
      first = outside++ == 0 ? center : first;
    }
  }
  if (outside == 0)
  {
    return {};
  }
  const std::string text =
    JoinText(std::to_string(outside), " of ", std::to_string(centers.size()), " ", what,
      " lie outside the surface, the first at (", first[0], ", ", first[1], ", ", first[2], "). ");
  if (2 * outside > centers.size())
  {
    throw std::invalid_argument(
      text + "Is it the surface of these atoms, at their place and in the same unit (angstrom)?");
  }
  return text + "The result is that of the surface as it is: use one farther out, or of all atoms.";
}

}
