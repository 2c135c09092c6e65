/**
 * @file VoxelLattice.h
 * @brief Where the nodes of a volume in a file lie in space. Lengths are in angstrom.
 */
#ifndef isthmus_VoxelLattice_h
#define isthmus_VoxelLattice_h

#include <array>
#include <cstdint>

namespace isthmus
{

/// Three rows of three.
using Matrix3 = std::array<std::array<double, 3>, 3>;

/// The product of a matrix and a column.
std::array<double, 3> Times(const Matrix3& matrix, const std::array<double, 3>& v);

/**
 * Nodes of a volume: node (i, j, k) lies at Origin + Steps (i, j, k) in the map's own frame, and
 * the map's frame in the world by x_world = Rotation x_map + Translation.
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
  /// Position of a node, whole or between nodes, in the map's frame.
  std::array<double, 3> At(const std::array<double, 3>& node) const;
  /// `position` of the map's frame in the world.
  std::array<double, 3> World(const std::array<double, 3>& position) const;
};

/// `lattice` reduced to nodes first, first + stride, ... (`count` of them) along each axis.
VoxelLattice Selected(const VoxelLattice& lattice, const std::array<std::int64_t, 3>& first,
  const std::array<std::int64_t, 3>& count, const std::array<std::int64_t, 3>& stride);

}

#endif
