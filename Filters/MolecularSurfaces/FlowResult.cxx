#include "MolecularSurfaces/FlowResult.h"

#include "Core/ParallelFor.h"
#include "MolecularSurfaces/LevelMeasure.h"

#include <algorithm>

namespace isthmus
{

std::vector<float> InnerValues(
  const FlowGrid& grid, const std::vector<float>& values, float factor, float shift)
{
  const auto& n = grid.Inner().Dimensions;
  std::vector<float> inner(static_cast<std::size_t>(n[0] * n[1] * n[2]));
  ParallelFor(0, n[1] * n[2], 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t line = first; line < last; ++line)
      {
        const float* from = values.data() + grid.Index(0, line % n[1], line / n[1]);
        std::transform(from, from + n[0], inner.data() + n[0] * line,
          [=](float value) { return factor * value + shift; });
      }
    });
  return inner;
}

void StoreDistances(const FlowField& field, SurfaceFlowResult& result)
{
  const double h = field.Grid.Spacing();
  result.Grid = field.Grid.Inner();
  result.Band = static_cast<double>(FlowGrid::Band) * h;
  result.Distance = InnerValues(field.Grid, field.Distance, static_cast<float>(h), 0.0F);
}

void Record(const FlowField& field, double time, SurfaceFlowResult& result)
{
  const LevelMeasure measure = MeasureLevel(field);
  result.History.push_back({ time, field.Grid.Spacing(), measure.Area, measure.Volume });
}

}
