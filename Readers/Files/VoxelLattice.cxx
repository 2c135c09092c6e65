#include "Files/VoxelLattice.h"

#include "Core/ParallelFor.h"
#include "Files/ReaderError.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

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

VoxelLattice SelectLattice(const VoxelLattice& lattice, const std::array<std::int64_t, 3>& first,
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

namespace
{

/// Tolerance of an index; positions in angstrom have rounding errors of this order in cells of any
/// size.
constexpr double tolerance = 1e-6;

using Point = std::array<double, 3>;

/// Takes nodes of an orthogonal grid to (fractional) nodes of a lattice in the same frame.
class NodeMap
{
public:
  NodeMap(const VoxelLattice& lattice, const VoxelLattice& grid)
  {
    double steps[3][3];
    double inverse[3][3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      std::copy(lattice.Steps[i].begin(), lattice.Steps[i].end(), steps[i]);
    }
    vtkMath::Invert3x3(steps, inverse);
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        this->Scale[i][j] = inverse[i][j] * grid.Steps[j][j];
        this->Shift[i] += inverse[i][j] * (grid.Origin[j] - lattice.Origin[j]);
      }
    }
  }

  Point operator()(double x, double y, double z) const
  {
    Point node{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      node[i] =
        this->Shift[i] + this->Scale[i][0] * x + this->Scale[i][1] * y + this->Scale[i][2] * z;
    }
    return node;
  }

private:
  Matrix3 Scale{};
  Point Shift{};
};

/// Where along one axis a value comes from: two nodes and the weight of the second.
struct Between1D
{
  std::int64_t Low = 0;
  std::int64_t High = 0;
  double Weight = 0.0;
};

bool Locate(double node, std::int64_t count, Between1D& found)
{
  const double last = static_cast<double>(count - 1);
  const double margin = count == 1 ? 0.5 : tolerance;
  if (!(node >= -margin && node <= last + margin))
  {
    return false;
  }
  node = std::clamp(node, 0.0, last);
  const double nearest = std::round(node);
  node = std::abs(node - nearest) < tolerance ? nearest : node; // nodes keep their values exactly
  found.Low = static_cast<std::int64_t>(node);
  found.Weight = node - static_cast<double>(found.Low);
  found.High = found.Weight > 0.0 ? found.Low + 1 : found.Low;
  return true;
}

template <typename T>
T RoundTo(double value)
{
  if constexpr (std::is_integral_v<T>)
  {
    return static_cast<T>(std::lround(value));
  }
  else
  {
    return static_cast<T>(value);
  }
}

template <typename T>
struct Sampler
{
  const T* Nodes;
  NodeBox Have;
  std::int64_t Components;

  const T* At(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const std::int64_t nx = this->Have[1] - this->Have[0] + 1;
    const std::int64_t ny = this->Have[3] - this->Have[2] + 1;
    return this->Nodes +
      ((i - this->Have[0]) + nx * ((j - this->Have[2]) + ny * (k - this->Have[4]))) *
      this->Components;
  }

  void operator()(const std::array<Between1D, 3>& where, T* out) const
  {
    for (std::int64_t c = 0; c < this->Components; ++c)
    {
      double value = 0.0;
      for (unsigned corner = 0; corner < 8; ++corner)
      {
        std::int64_t node[3];
        double weight = 1.0;
        for (unsigned a = 0; a < 3; ++a)
        {
          const bool high = (corner >> a) & 1u;
          node[a] = high ? where[a].High : where[a].Low;
          weight *= high ? where[a].Weight : 1.0 - where[a].Weight;
        }
        // With a weight of 0, an infinite or NaN neighbour must not affect the result.
        value +=
          weight > 0.0 ? weight * static_cast<double>(this->At(node[0], node[1], node[2])[c]) : 0.0;
      }
      out[c] = RoundTo<T>(value);
    }
  }
};

}

template <typename T>
void ResampleValues(int components, const VoxelLattice& lattice, const T* nodes,
  const NodeBox& have, const VoxelLattice& grid, const NodeBox& region, T* out,
  unsigned char* inside, const ProgressCallback& progress)
{
  const Sampler<T> sample{ nodes, have, components };
  const NodeMap map(lattice, grid);
  const std::int64_t nx = region[1] - region[0] + 1;
  const std::int64_t ny = region[3] - region[2] + 1;
  const std::int64_t rows = ny * (region[5] - region[4] + 1);
  const std::int64_t grain = std::max<std::int64_t>(1, 65536 / nx);
  const auto body = [&](std::int64_t first, std::int64_t last)
  {
    std::array<Between1D, 3> where;
    for (std::int64_t node = first * nx; node < last * nx; ++node)
    {
      const std::int64_t row = node / nx;
      const std::int64_t i = region[0] + node % nx, j = region[2] + row % ny;
      const std::int64_t k = region[4] + row / ny;
      const Point at = map(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
      T* const value = out + node * components;
      const bool within = Locate(at[0], lattice.Dimensions[0], where[0]) &&
        Locate(at[1], lattice.Dimensions[1], where[1]) &&
        Locate(at[2], lattice.Dimensions[2], where[2]);
      inside[node] = within ? 1 : 0;
      within ? sample(where, value) : static_cast<void>(std::fill_n(value, components, T(0)));
    }
  };
  ParallelFor(0, rows, grain, body, progress);
}

VoxelLattice GridAround(const VoxelLattice& lattice)
{
  VoxelLattice grid = lattice;
  const Point spacing = lattice.Spacing();
  double nodes = 1.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    double low = 0.0;
    double high = 0.0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double reach = lattice.Steps[i][a] * static_cast<double>(lattice.Dimensions[a] - 1);
      low += std::min(0.0, reach);
      high += std::max(0.0, reach);
      grid.Steps[i][a] = i == a ? spacing[i] : 0.0;
    }
    const double first = std::floor(low / spacing[i] + tolerance);
    const double last = std::ceil(high / spacing[i] - tolerance);
    grid.Origin[i] = lattice.Origin[i] + first * spacing[i];
    nodes *= last - first + 1.0;
    grid.Dimensions[i] = static_cast<std::int64_t>(std::min(last - first + 1.0, 2147483647.0));
  }
  const double had = static_cast<double>(lattice.Dimensions[0]) *
    static_cast<double>(lattice.Dimensions[1]) * static_cast<double>(lattice.Dimensions[2]);
  // The box around a needle-like cell may have any number of nodes.
  if (!(nodes <= 64.0 * had + 4096.0))
  {
    throw ReaderError(ReaderFailure::BadRequest,
      "an orthogonal grid around a cell this oblique needs more than 64 nodes for each of the "
      "map's. Set NonOrthogonalCell to KeepCellAxes.");
  }
  return grid;
}

NodeBox NodesNeeded(const VoxelLattice& lattice, const VoxelLattice& grid, const NodeBox& region)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const NodeMap map(lattice, grid);
  Point low{ infinity, infinity, infinity };
  Point high{ -infinity, -infinity, -infinity };
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const Point at = map(static_cast<double>(region[corner & 1u]),
      static_cast<double>(region[2 + ((corner >> 1) & 1u)]),
      static_cast<double>(region[4 + ((corner >> 2) & 1u)]));
    for (std::size_t a = 0; a < 3; ++a)
    {
      low[a] = std::min(low[a], at[a]);
      high[a] = std::max(high[a], at[a]);
    }
  }
  NodeBox box{};
  for (std::size_t a = 0; a < 3; ++a)
  {
    // One node more than needed on each side, since Locate() clamps and rounds.
    const double last = static_cast<double>(lattice.Dimensions[a] - 1);
    box[2 * a] = static_cast<std::int64_t>(std::clamp(std::floor(low[a]) - 1.0, 0.0, last + 1.0));
    box[2 * a + 1] = static_cast<std::int64_t>(std::clamp(std::ceil(high[a]) + 1.0, -1.0, last));
  }
  return box;
}

template void ResampleValues(int, const VoxelLattice&, const signed char*, const NodeBox&,
  const VoxelLattice&, const NodeBox&, signed char*, unsigned char*, const ProgressCallback&);
template void ResampleValues(int, const VoxelLattice&, const unsigned char*, const NodeBox&,
  const VoxelLattice&, const NodeBox&, unsigned char*, unsigned char*, const ProgressCallback&);
template void ResampleValues(int, const VoxelLattice&, const short*, const NodeBox&,
  const VoxelLattice&, const NodeBox&, short*, unsigned char*, const ProgressCallback&);
template void ResampleValues(int, const VoxelLattice&, const unsigned short*, const NodeBox&,
  const VoxelLattice&, const NodeBox&, unsigned short*, unsigned char*, const ProgressCallback&);
template void ResampleValues(int, const VoxelLattice&, const float*, const NodeBox&,
  const VoxelLattice&, const NodeBox&, float*, unsigned char*, const ProgressCallback&);
template void ResampleValues(int, const VoxelLattice&, const double*, const NodeBox&,
  const VoxelLattice&, const NodeBox&, double*, unsigned char*, const ProgressCallback&);

}
