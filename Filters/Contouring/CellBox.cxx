#include "Contouring/CellBox.h"

namespace isthmus
{

Bounds3 CellBox(
  const GridShape& shape, const std::array<std::int64_t, 3>& index, std::int64_t size, double reach)
{
  Bounds3 box;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto last = static_cast<double>(shape.Dimensions[a] - 1);
    const auto low = static_cast<double>(index[a]);
    const auto side = static_cast<double>(size);
    box.Min[a] = shape.Spacing[a] * std::max(-reach, low - reach * side);
    box.Max[a] = shape.Spacing[a] * std::min(last + reach, low + side + reach * side);
  }
  return box;
}

std::int64_t CellAt(const GridShape& grid, const Point3& x)
{
  std::array<std::int64_t, 3> index;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double at = std::floor(x[a] / grid.Spacing[a]);
    if (!(at >= 0.0 && at < static_cast<double>(grid.Dimensions[a] - 1)))
    {
      return -1;
    }
    index[a] = static_cast<std::int64_t>(at);
  }
  return index[0] + grid.Dimensions[0] * (index[1] + grid.Dimensions[1] * index[2]);
}

}
