/**
 * @file VoxelLattice.h
 * @brief Positions of the nodes of a volume in a file, and resampling of skewed lattices. Angstrom.
 */
#ifndef isthmus_VoxelLattice_h
#define isthmus_VoxelLattice_h

#include "Core/Progress.h"

#include <array>
#include <cstdint>

namespace isthmus
{

/// Three rows of three.
using Matrix3 = std::array<std::array<double, 3>, 3>;

/// The product of a matrix and a column.
std::array<double, 3> Times(const Matrix3& matrix, const std::array<double, 3>& v);

/**
 * Nodes of a volume: node (i, j, k) lies at Origin + Steps (i, j, k) in the frame of the map, which
 * is transformed to the world by x_world = Rotation x_map + Translation.
 */
struct VoxelLattice
{
  std::array<std::int64_t, 3> Dimensions{ 1, 1, 1 };
  Matrix3 Steps{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } }; ///< column a: one node along axis a
  std::array<double, 3> Origin{ 0.0, 0.0, 0.0 };
  Matrix3 Rotation{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  std::array<double, 3> Translation{ 0.0, 0.0, 0.0 };

  /// Lengths of the three steps.
  std::array<double, 3> Spacing() const;
  /// Position of a node, or of a place between nodes, in the frame of the map.
  std::array<double, 3> At(const std::array<double, 3>& node) const;
  /// `position` of the map's frame in the world.
  std::array<double, 3> World(const std::array<double, 3>& position) const;
};

/// `lattice` reduced to nodes first, first + stride, ... (`count` of them) along each axis.
VoxelLattice SelectLattice(const VoxelLattice& lattice, const std::array<std::int64_t, 3>& first,
  const std::array<std::int64_t, 3>& count, const std::array<std::int64_t, 3>& stride);

/// Inclusive ranges of nodes: x first, x last, y first, ... Empty where last < first.
using NodeBox = std::array<std::int64_t, 6>;

/**
 * The axis-aligned grid (in the frame of the file) around all nodes of `lattice`. Its spacings are
 * the lengths of the lattice's steps, and node (0, 0, 0) of the lattice is one of its nodes.
 * @throws ReaderError (BadRequest) if it would have more than 64 times as many nodes as the
 * lattice, which happens for cells with angles near 0 or 180 degrees.
 */
VoxelLattice GridAround(const VoxelLattice& lattice);

/// Nodes of `lattice` that ResampleValues() reads for the nodes `region` of `grid`; may be empty.
NodeBox NodesNeeded(const VoxelLattice& lattice, const VoxelLattice& grid, const NodeBox& region);

/**
 * Trilinear interpolation at the nodes `region` of `grid`, with x varying fastest.
 *
 * `nodes` holds the values of `lattice` in the box `have` (from NodesNeeded()), x fastest, of
 * `components` each. T is signed char, unsigned char, short, unsigned short, float or double;
 * integers are rounded to the nearest. Outside the lattice, the values and the flags in `inside`
 * are 0; elsewhere the flags are 1. Along an axis with a single node, the inside extends half a
 * step. The value at a node depends only on the node, not on `region` or the threads. O(nodes).
 * Allocates nothing.
 */
template <typename T>
void ResampleValues(int components, const VoxelLattice& lattice, const T* nodes,
  const NodeBox& have, const VoxelLattice& grid, const NodeBox& region, T* out,
  unsigned char* inside, const ProgressCallback& progress);

}

#endif
