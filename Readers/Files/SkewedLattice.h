/**
 * @file SkewedLattice.h
 * @brief Values on a lattice that is not orthogonal, brought to a grid that is.
 */
#ifndef isthmus_SkewedLattice_h
#define isthmus_SkewedLattice_h

#include "Core/Progress.h"
#include "Files/VoxelLattice.h"

#include <array>
#include <cstdint>

namespace isthmus
{

/// Inclusive ranges of nodes: x first, x last, y first, ... Empty where last < first.
using NodeBox = std::array<std::int64_t, 6>;

/**
 * The axis-aligned grid (of the file's frame) around all nodes of `lattice`. Its spacings are the
 * lengths of the lattice's steps, and node (0, 0, 0) of the lattice is one of its nodes.
 * @throws ReaderError (BadRequest) when it would have more than 64 times the lattice's nodes, as
 * cells with angles near 0 or 180 degrees have.
 */
VoxelLattice GridAround(const VoxelLattice& lattice);

/// Nodes of `lattice` that ResampleValues() reads for the nodes `region` of `grid`; may be empty.
NodeBox NodesNeeded(const VoxelLattice& lattice, const VoxelLattice& grid, const NodeBox& region);

/**
 * Trilinear interpolation at the nodes `region` of `grid` (x fastest).
 *
 * `nodes` holds the values of `lattice` in the box `have` (from NodesNeeded()), x fastest, of
 * `components` each. T is signed char, unsigned char, short, unsigned short, float or double;
 * integers are rounded to the nearest. Outside the lattice `out` is 0 and `inside` 0, elsewhere
 * `inside` is 1; along an axis with a single node, inside reaches half a step. The value at a node
 * depends on the node alone, not on `region` or threads.
 * Time: about 10 ns a node and thread. No memory of its own.
 */
template <typename T>
void ResampleValues(int components, const VoxelLattice& lattice, const T* nodes,
  const NodeBox& have, const VoxelLattice& grid, const NodeBox& region, T* out,
  unsigned char* inside, const ProgressCallback& progress);

}

#endif
