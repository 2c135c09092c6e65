/**
 * @file FlowBand.h
 * @brief Which nodes of a flow's grid are near enough to the surface to be worked on.
 */
#ifndef isthmus_FlowBand_h
#define isthmus_FlowBand_h

#include "Core/ParallelFor.h"
#include "MolecularSurfaces/FlowGrid.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h"

namespace isthmus
{

/// Looks at every chunk of the grid; for a field whose Distance was just filled.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void FindBand(FlowField& field);

/// Follows the surface: chunks in the band and next to it become the field's runs, distances are
/// cut at the band and Next made equal to them. Time O(nodes in the runs + chunks of the grid).
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void MoveBand(FlowField& field);

/// Calls `work(first, last)` for the nodes of each run, in parallel.
template <typename Work>
void ForEachRun(const FlowField& field, Work work)
{
  constexpr std::int64_t runsAtOnce = 512; // some 10,000 nodes, to pay for a thread's start
  ParallelFor(0, static_cast<std::int64_t>(field.Runs.size()), runsAtOnce,
    [&](std::int64_t firstRun, std::int64_t lastRun)
    {
      for (std::int64_t r = firstRun; r < lastRun; ++r)
      {
        const ChunkRun& run = field.Runs[static_cast<std::size_t>(r)];
        work(run.First, run.First + run.Nodes);
      }
    });
}

}

#endif
