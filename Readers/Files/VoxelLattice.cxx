#include "Files/VoxelLattice.h"

#include <cmath>

namespace isthmus
{

std::array<double, 3> Times(const Matrix3& matrix, const std::array<double, 3>& v)
{
  std::array<double, 3> product{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    product[i] = matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2];
  }
  return product;
}

std::array<double, 3> VoxelLattice::Spacing() const
{
  std::array<double, 3> spacing{};
  for (std::size_t a = 0; a < 3; ++a)
  {
    spacing[a] = std::hypot(this->Steps[0][a], this->Steps[1][a], this->Steps[2][a]);
  }
  return spacing;
}

std::array<double, 3> VoxelLattice::At(const std::array<double, 3>& node) const
{
  const std::array<double, 3> moved = Times(this->Steps, node);
  return { this->Origin[0] + moved[0], this->Origin[1] + moved[1], this->Origin[2] + moved[2] };
}

std::array<double, 3> VoxelLattice::World(const std::array<double, 3>& position) const
{
  std::array<double, 3> world = Times(this->Rotation, position);
  for (std::size_t i = 0; i < 3; ++i)
  {
    world[i] += this->Translation[i];
  }
  return world;
}

VoxelLattice Selected(const VoxelLattice& lattice, const std::array<std::int64_t, 3>& first,
  const std::array<std::int64_t, 3>& count, const std::array<std::int64_t, 3>& stride)
{
  VoxelLattice selected = lattice;
  selected.Dimensions = count;
  selected.Origin = lattice.At({ static_cast<double>(first[0]), static_cast<double>(first[1]),
    static_cast<double>(first[2]) });
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      selected.Steps[i][a] *= static_cast<double>(stride[a]);
    }
  }
  return selected;
}

}
