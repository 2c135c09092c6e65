/**
 * @file FlowField.h
 * @brief The level-set field of a surface flow: its grid, its narrow band, and steps of it.
 *
 * Signed distances in spacings on the nodes of a grid, negative inside. Only the nodes in a band of
 * +-4.5 spacings around the surface are changed by a step. Distances are clamped there, and the
 * band follows the surface. The formulas of the steps are in FlowKernels.h.
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
 * The nodes of a DensityGrid with a margin on each side. The margin ensures that the band around a
 * surface that is two or more spacings from the border, and the nodes that its stencils read,
 * always exist. The length of rows is a multiple of Chunk. Distances are in spacings.
 */
class FlowGrid
{
public:
  /// Number of nodes along x that are processed together: eight floats, one vector register.
  static constexpr std::int64_t Chunk = 8;
  /// Half the width of the band of nodes that move, in spacings; distances are clamped there.
  static constexpr float Band = 4.5F;

  explicit FlowGrid(const DensityGrid& inner);

  const DensityGrid& Inner() const { return this->InnerGrid; }
  const std::array<std::int64_t, 3>& Dimensions() const { return this->Size; }
  std::int64_t NumberOfNodes() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
  std::int64_t Row() const { return this->Size[0]; }
  std::int64_t Plane() const { return this->Size[0] * this->Size[1]; }
  double Spacing() const { return this->InnerGrid.Spacing; }
  /// Position of the first node, including the margin.
  std::array<double, 3> Origin() const;
  /// Index of a node of the inner grid.
  std::int64_t Index(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return i + Margin[0] + this->Size[0] * (j + Margin[1] + this->Size[1] * (k + Margin[2]));
  }

  /// Number of nodes, including the margin, of a grid with the given inner dimensions.
  static double NodesFor(const std::array<std::int64_t, 3>& inner);

private:
  // Band, one chunk and the reach of the stencils, minus the two spacings that a surface keeps from
  // the border.
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

/// The distances of a flow and their bounds, in spacings; each array has one value for each node.
struct FlowField
{
  /// Distance and Ceiling are +Band everywhere. Floor and Pull stay empty.
  explicit FlowField(const FlowGrid& grid);

  FlowGrid Grid;
  std::vector<float> Distance;     ///< negative inside
  std::vector<float> Next;         ///< output of a step; then the two are swapped
  std::vector<float> Ceiling;      ///< upper bound of Distance: the atoms are inside
  std::vector<float> Floor;        ///< lower bound of Distance, if there is a probe
  std::vector<float> Pull;         ///< V / gamma in spacings, if the solvent pulls
  std::vector<unsigned char> Free; ///< set by redistancing: 0 next to the surface
  std::vector<unsigned char> Near; ///< by chunk: has nodes in the band (1), first (2), last (4)
  std::vector<ChunkRun> Runs;      ///< chunks in the band, and their neighbours
};

/// Examines every chunk of the grid; for a field whose Distance has just been filled.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void FindBand(FlowField& field);

/// Follows the surface: chunks in the band and next to it become the runs of the field. Distances
/// are clamped to the band and copied to Next. Time O(nodes in the runs + chunks of the grid).
void MoveBand(FlowField& field);

/// Calls `work(first, last)` for the nodes of each run, in parallel.
template <typename Work>
void ForEachRun(const FlowField& field, Work work)
{
  constexpr std::int64_t runsAtOnce = 512; // about 10,000 nodes, to outweigh the start of a thread
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

/// One explicit step of dt = `lambda` squared spacings, at most 0.25; see FlowKernels.h. The
/// resulting distances are between floor and ceiling.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void Advance(FlowField& field, double lambda);

/// Restores distances in the band without moving the surface, and moves the band with the surface.
/// Each iteration extends the distances by 0.45 spacings from the surface. Values next to the
/// surface are also converted to distances, or used as they are if `trusted`.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void Redistance(
  FlowField& field, int iterations, bool trusted = false);

}

#endif
