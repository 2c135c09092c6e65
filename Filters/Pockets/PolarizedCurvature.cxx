#include "Pockets/PolarizedCurvature.h"

#include "Core/ParallelFor.h"
#include "Core/TrilinearField.h"

#include <cmath>
#include <limits>

namespace isthmus
{

const char* SiteClassName(SiteClass site)
{
  switch (site)
  {
    case SiteClass::NegativeProtein:
      return "site for a negatively charged protein";
    case SiteClass::NegativeLigand:
      return "site for a negatively charged small ligand";
    case SiteClass::PositiveProtein:
      return "site for a positively charged protein";
    case SiteClass::PositiveLigand:
      return "site for a positively charged small ligand";
    case SiteClass::None:
      break;
  }
  return "none";
}

template <typename T>
void SamplePotential(const GridView<const T>& grid, const GridTransform& toGrid,
  const double* points, vtkIdType count, double* values, const ProgressCallback& progress)
{
  constexpr double tolerance = 1e-9;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  GridView<const T> nodes = grid;
  nodes.Spacing = { 1.0, 1.0, 1.0 };
  const TrilinearField<T> field{ nodes, 0.0 };
  const auto body = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType i = first; i < last; ++i)
    {
      std::array<double, 3> at{};
      bool inside = true;
      for (std::size_t a = 0; a < 3; ++a)
      {
        const double* row = toGrid.data() + 4 * a;
        const double end = static_cast<double>(grid.Dimensions[a] - 1);
        const double x =
          row[0] * points[3 * i] + row[1] * points[3 * i + 1] + row[2] * points[3 * i + 2] + row[3];
        inside = inside && x >= -tolerance && x <= end + tolerance;
        at[a] = std::clamp(x, 0.0, end);
      }
      const double value = inside ? field(at) : nan;
      values[i] = std::isfinite(value) ? value : nan;
    }
  };
  ParallelFor(0, count, 4096, body, progress);
}

template void SamplePotential(const GridView<const float>&, const GridTransform&, const double*,
  vtkIdType, double*, const ProgressCallback&);
template void SamplePotential(const GridView<const double>&, const GridTransform&, const double*,
  vtkIdType, double*, const ProgressCallback&);

}
