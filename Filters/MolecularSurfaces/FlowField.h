/**
 * @file FlowField.h
 * @brief The level-set field of a surface flow: its grid, its narrow band, and steps of it.
 *
 * Signed distances in spacings on the nodes of a grid, negative inside. Only the nodes of a band of
 * +-4.5 spacings around the surface take part in a step; distances are cut there, and the band
 * follows the surface. The formulas of the steps are in FlowKernels.h.
 */
#ifndef isthmus_FlowField_h
#define isthmus_FlowField_h

#include "Atoms/MolecularDensity.h"
#include "Core/ParallelFor.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/**
 * Nodes of a DensityGrid with a margin on each side, so that a band of nodes around a surface two
 * or more spacings from the border, and what its stencils read, is always there. Rows are a
 * multiple of Chunk long. Distances on it are in spacings.
 */
class FlowGrid
{
public:
  /// Nodes along x that are worked on together: eight floats, one vector register.
  static constexpr std::int64_t Chunk = 8;
  /// Half the width of the band of nodes that move, in spacings; distances are cut there.
  static constexpr float Band = 4.5F;

  explicit FlowGrid(const DensityGrid& inner);

  const DensityGrid& Inner() const { return this->InnerGrid; }
  const std::array<std::int64_t, 3>& Dimensions() const { return this->Size; }
  std::int64_t NumberOfNodes() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
  std::int64_t Row() const { return this->Size[0]; }
  std::int64_t Plane() const { return this->Size[0] * this->Size[1]; }
  double Spacing() const { return this->InnerGrid.Spacing; }
  /// Place of the first node, margin included.
  std::array<double, 3> Origin() const;
  /// Index of a node of the inner grid.
  std::int64_t Index(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return i + Margin[0] + this->Size[0] * (j + Margin[1] + this->Size[1] * (k + Margin[2]));
  }

  /// Nodes, margin included, of a grid with the given inner dimensions.
  static double NodesFor(const std::array<std::int64_t, 3>& inner);

private:
  // Band, a chunk and the reach of the stencils, less the two spacings that a surface keeps.
  static constexpr std::array<std::int64_t, 3> Margin{ 8, 7, 7 };

  DensityGrid InnerGrid;
  std::array<std::int64_t, 3> Size{};
};

/// Chunks that lie next to each other along x.
struct ChunkRun
{
  std::int64_t First; ///< node
  std::int64_t Nodes; ///< a multiple of FlowGrid::Chunk
};

/// The distances of a flow and what bounds them, in spacings; each array has one value a node.
struct FlowField
{
  /// Distance is +Band everywhere; `Ceiling` too. Floor and Pull stay empty.
  explicit FlowField(const FlowGrid& grid);

  FlowGrid Grid;
  std::vector<float> Distance;     ///< negative inside
  std::vector<float> Next;         ///< where a step writes; then the two change places
  std::vector<float> Ceiling;      ///< Distance stays below: the atoms are inside
  std::vector<float> Floor;        ///< Distance stays above, where there is a probe
  std::vector<float> Pull;         ///< V / gamma in spacings, where the solvent pulls
  std::vector<unsigned char> Free; ///< by redistancing: 0 next to the surface
  std::vector<unsigned char> Near; ///< by chunk: has nodes in the band (1), first (2), last (4)
  std::vector<ChunkRun> Runs;      ///< chunks in the band, and their neighbours
};

/// Looks at every chunk of the grid; for a field whose Distance was just filled.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void FindBand(FlowField& field);

/// Follows the surface: chunks in the band and next to it become the field's runs, distances are
/// cut at the band and Next made equal to them. Time O(nodes in the runs + chunks of the grid).
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void MoveBand(FlowField& field);

/// Calls `work(first, last)` for the nodes of each run, in parallel.
template <typename Work>
void ForEachRun(const FlowField& field, Work work)
{
  constexpr std::int64_t runsAtOnce = 512; // about 10,000 nodes, to pay for a thread's start
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

/// One explicit step of dt = `lambda` squared spacings, at most 0.25; see FlowKernels.h. Distances
/// end up between floor and ceiling.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void Advance(FlowField& field, double lambda);

/// Makes distances of the values in the band, the surface staying where it is, and moves the band
/// along. Each iteration carries the distance 0.45 spacings further from the surface. Values next
/// to the surface are made distances as well, or where `trusted` taken as such.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void Redistance(
  FlowField& field, int iterations, bool trusted = false);

}

#endif
