#include "Imaging/ResidualReturn.h"

#include "Core/ParallelFor.h"
#include "Imaging/HighOrderDiffusion.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// Replaces a[n] by body(a[n], b[n]), in parallel.
template <typename T, typename Body>
void Combine(std::int64_t size, T* a, const T* b, Body&& body)
{
  ParallelFor(0, size, 1 << 16,
    [=](std::int64_t first, std::int64_t last)
    { std::transform(a + first, a + last, b + first, a + first, body); });
}

}

template <typename T>
void ReturnResidual(const DiffusionGrid<T>& grid, double deviation, T* residual, T* values,
  const ProgressCallback& progress)
{
  Combine(grid.Size(), residual, values, [](T input, T value) { return input - value; });
  DiffusionParameters heat;
  heat.Order = 0;
  heat.EdgeStopping = DiffusionParameters::EdgeStoppingType::None;
  heat.Time = deviation * deviation / 2.0;
  // Explicit steps of 0.6 of the limit leave next to nothing of the shortest waves, which are
  // noise; super steps would halve them at best.
  heat.Integrator = DiffusionParameters::IntegratorType::ForwardEuler;
  heat.Steps =
    static_cast<int>(std::ceil(heat.Time / (0.6 * ExplicitStepLimit(heat, grid.Spacing))));
  Diffuse<T>(grid, heat, residual, nullptr, nullptr, progress);
  Combine(grid.Size(), values, residual, [](T value, T back) { return value + back; });
}

template void ReturnResidual(
  const DiffusionGrid<float>&, double, float*, float*, const ProgressCallback&);
template void ReturnResidual(
  const DiffusionGrid<double>&, double, double*, double*, const ProgressCallback&);

}
