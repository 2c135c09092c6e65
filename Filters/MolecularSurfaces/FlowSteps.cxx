#include "MolecularSurfaces/FlowSteps.h"

#include "MolecularSurfaces/FlowBand.h"
#include "MolecularSurfaces/FlowLoops.h"

#include <utility>

namespace isthmus
{

void Advance(FlowField& field, double lambda)
{
  const FlowStep step{ field.Distance.data(), field.Next.data(), field.Ceiling.data(),
    field.Floor.empty() ? nullptr : field.Floor.data(),
    field.Pull.empty() ? nullptr : field.Pull.data(), static_cast<float>(lambda) };
  const FlowStrides strides{ field.Grid.Row(), field.Grid.Plane() };
  ForEachRun(
    field, [&](std::int64_t first, std::int64_t last) { AdvanceRow(step, strides, first, last); });
  std::swap(field.Distance, field.Next);
}

void Redistance(FlowField& field, int iterations, bool trusted)
{
  const FlowStrides strides{ field.Grid.Row(), field.Grid.Plane() };
  ForEachRun(field,
    [&](std::int64_t first, std::int64_t last)
    {
      HoldSurfaceRow(
        field.Distance.data(), field.Next.data(), field.Free.data(), trusted, strides, first, last);
    });
  std::swap(field.Distance, field.Next);
  for (int i = 0; i < iterations; ++i)
  {
    ForEachRun(field,
      [&](std::int64_t first, std::int64_t last)
      {
        RedistanceRow(
          field.Distance.data(), field.Next.data(), field.Free.data(), strides, first, last);
      });
    std::swap(field.Distance, field.Next);
  }
  MoveBand(field);
}

}
