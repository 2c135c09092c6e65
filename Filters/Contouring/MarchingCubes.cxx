#include "Contouring/MarchingCubes.h"

#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Core/VTKVersions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// Which edges and cells of a layer of nodes a level goes through.

using Flags = std::vector<std::uint8_t>; ///< inside or not, a layer of nodes

/// From a node to the next along each axis of a layer, and the edges that start at each node.
enum Axis : std::size_t
{
  X,
  Y,
  Z
};

/// The layers of a grid of `Nx` x `Ny` nodes, x fastest. Rows that the level does not cross cost
/// one comparison.
struct LayerCuts
{
  std::int64_t Nx = 0;
  std::int64_t Ny = 0;

  /// Calls visit(axis, i, j) for each cut edge within a layer, in the order of their numbers.
  template <typename Visit>
  void Within(const Flags& flags, Visit&& visit) const
  {
    const std::int64_t nx = this->Nx, ny = this->Ny;
    for (std::int64_t j = 0; j < ny; ++j)
    {
      const std::uint8_t* row = flags.data() + nx * j;
      const std::uint8_t* next = j + 1 < ny ? row + nx : row;
      if (std::equal(row, row + nx, next) && std::equal(row + 1, row + nx, row))
      {
        continue;
      }
      for (std::int64_t i = 0; i < nx; ++i)
      {
        if (i + 1 < nx && row[i] != row[i + 1])
        {
          visit(X, i, j);
        }
        if (row[i] != next[i])
        {
          visit(Y, i, j);
        }
      }
    }
  }

  /// The same for the edges from a layer to the next.
  template <typename Visit>
  void Between(const Flags& flags, const Flags& above, Visit&& visit) const
  {
    const std::int64_t nx = this->Nx;
    for (std::int64_t j = 0; j < this->Ny; ++j)
    {
      const std::uint8_t* row = flags.data() + nx * j;
      const std::uint8_t* top = above.data() + nx * j;
      if (std::equal(row, row + nx, top))
      {
        continue;
      }
      for (std::int64_t i = 0; i < nx; ++i)
      {
        if (row[i] != top[i])
        {
          visit(Z, i, j);
        }
      }
    }
  }

  /// Calls visit(case, i, j) for each cell between two layers that the level goes through.
  template <typename Visit>
  void Cells(
    const Flags& flags, const Flags& above, std::vector<std::uint8_t>& cases, Visit&& visit) const
  {
    const std::int64_t nx = this->Nx;
    cases.resize(static_cast<std::size_t>(nx));
    for (std::int64_t j = 0; j + 1 < this->Ny; ++j)
    {
      const std::uint8_t* a = flags.data() + nx * j;
      const std::uint8_t* b = above.data() + nx * j;
      std::uint8_t* cell = cases.data();
      for (std::int64_t i = 0; i + 1 < nx; ++i)
      {
        cell[i] = static_cast<std::uint8_t>(a[i] | a[i + 1] << 1 | a[i + nx + 1] << 2 |
          a[i + nx] << 3 | b[i] << 4 | b[i + 1] << 5 | b[i + nx + 1] << 6 | b[i + nx] << 7);
      }
      for (std::int64_t i = 0; i + 1 < nx; ++i)
      {
        if (cell[i] != 0 && cell[i] != 255)
        {
          visit(cell[i], i, j);
        }
      }
    }
  }
};

namespace
{

constexpr std::int64_t LayersAPiece = 8;

/// For each of VTK's twelve edges of a cell: where it starts within the cell, and along which axis.
struct CellEdge
{
  int I, J, K;
  Axis Along;
};
constexpr CellEdge EdgesOfCell[12] = { { 0, 0, 0, X }, { 1, 0, 0, Y }, { 0, 1, 0, X },
  { 0, 0, 0, Y }, { 0, 0, 1, X }, { 1, 0, 1, Y }, { 0, 1, 1, X }, { 0, 0, 1, Y }, { 0, 0, 0, Z },
  { 1, 0, 0, Z }, { 0, 1, 0, Z }, { 1, 1, 0, Z } };

int CountTriangles(std::uint8_t cell)
{
  const int* edges = MarchingCubesCase(cell);
  int count = 0;
  while (edges[3 * count] >= 0)
  {
    ++count;
  }
  return count;
}

/// The grid, with a layer of outside around it where the surface is to be closed.
template <typename T>
class CubeMarch
{
public:
  CubeMarch(const GridView<const T>& grid, const MarchingCubesParameters& parameters)
    : Grid(grid)
    , Level(parameters.Level)
    , Higher(parameters.InsideIsHigher)
    , Pad(parameters.CloseAtBorder ? 1 : 0)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->N[a] = grid.Dimensions[a] + 2 * this->Pad;
    }
    this->Cuts = { this->N[0], this->N[1] };
    for (int cell = 0; cell < 256; ++cell)
    {
      this->Counts[cell] = CountTriangles(static_cast<std::uint8_t>(cell));
    }
  }

  TriangleMesh Run(const ProgressCallback& progress)
  {
    if (*std::min_element(this->N.begin(), this->N.end()) < 2)
    {
      return {}; // no cells
    }
    const auto layers = static_cast<std::size_t>(this->N[2]);
    this->FirstPoint.assign(layers + 1, 0);
    this->FirstTriangle.assign(layers + 1, 0);
    ParallelFor(
      0, this->N[2], LayersAPiece,
      [this](std::int64_t first, std::int64_t last) { this->Count(first, last); },
      Between(progress, 0.0, 0.4));
    for (std::size_t k = 0; k < layers; ++k)
    {
      this->FirstPoint[k + 1] += this->FirstPoint[k];
      this->FirstTriangle[k + 1] += this->FirstTriangle[k];
    }
    TriangleMesh mesh;
    mesh.Points.resize(static_cast<std::size_t>(this->FirstPoint.back()));
    mesh.Triangles.resize(static_cast<std::size_t>(this->FirstTriangle.back()));
    ParallelFor(
      0, this->N[2], LayersAPiece,
      [this, &mesh](std::int64_t first, std::int64_t last) { this->Fill(first, last, mesh); },
      Between(progress, 0.4, 1.0));
    return mesh;
  }

private:
  /// Where the edge that starts at each node of a layer has its point.
  using Ids = std::array<std::vector<std::int64_t>, 3>;

  std::size_t LayerSize() const { return static_cast<std::size_t>(this->N[0] * this->N[1]); }

  bool Inside(T value) const
  {
    const auto v = static_cast<double>(value);
    return this->Higher ? v > this->Level : v < this->Level;
  }

  void Mark(std::int64_t layer, Flags& flags) const
  {
    flags.assign(this->LayerSize(), 0);
    const std::int64_t k = layer - this->Pad;
    if (k < 0 || k >= this->Grid.Dimensions[2])
    {
      return;
    }
    for (std::int64_t j = 0; j < this->Grid.Dimensions[1]; ++j)
    {
      const T* row = &this->Grid(0, j, k);
      std::uint8_t* out = flags.data() + this->Pad + this->N[0] * (j + this->Pad);
      for (std::int64_t i = 0; i < this->Grid.Dimensions[0]; ++i)
      {
        out[i] = this->Inside(row[i]) ? 1 : 0;
      }
    }
  }

  void Count(std::int64_t first, std::int64_t last)
  {
    Flags flags, above;
    std::vector<std::uint8_t> cases;
    this->Mark(first, flags);
    for (std::int64_t k = first; k < last; ++k)
    {
      std::int64_t points = 0, triangles = 0;
      const auto one = [&points](Axis, std::int64_t, std::int64_t) { ++points; };
      this->Cuts.Within(flags, one);
      if (k + 1 < this->N[2])
      {
        this->Mark(k + 1, above);
        this->Cuts.Between(flags, above, one);
        this->Cuts.Cells(flags, above, cases,
          [&](std::uint8_t cell, std::int64_t, std::int64_t) { triangles += this->Counts[cell]; });
        flags.swap(above);
      }
      this->FirstPoint[static_cast<std::size_t>(k) + 1] = points;
      this->FirstTriangle[static_cast<std::size_t>(k) + 1] = triangles;
    }
  }

  void Fill(std::int64_t first, std::int64_t last, TriangleMesh& mesh) const
  {
    Flags flags, above;
    std::vector<std::uint8_t> cases;
    Ids ids, next;
    for (std::size_t a = 0; a < 3; ++a)
    {
      ids[a].resize(this->LayerSize());
      next[a].resize(this->LayerSize());
    }
    this->Mark(first, flags);
    std::int64_t point = this->Number(first, flags, ids);
    for (std::int64_t k = first; k < last; ++k)
    {
      this->Cuts.Within(flags,
        [&](Axis axis, std::int64_t i, std::int64_t j)
        { this->SetPoint(axis, i, j, k, ids[axis][this->GetNode(i, j)], mesh); });
      if (k + 1 == this->N[2])
      {
        break;
      }
      this->Mark(k + 1, above);
      this->Cuts.Between(flags, above,
        [&](Axis axis, std::int64_t i, std::int64_t j)
        {
          ids[axis][this->GetNode(i, j)] = point;
          this->SetPoint(axis, i, j, k, point++, mesh);
        });
      point = this->Number(k + 1, above, next);
      std::int64_t triangle = this->FirstTriangle[static_cast<std::size_t>(k)];
      this->Cuts.Cells(flags, above, cases,
        [&](std::uint8_t signs, std::int64_t i, std::int64_t j)
        { this->AddCell(signs, i, j, ids, next, triangle, mesh); });
      flags.swap(above);
      ids.swap(next);
    }
  }

  std::size_t GetNode(std::int64_t i, std::int64_t j) const
  {
    return static_cast<std::size_t>(i + this->N[0] * j);
  }

  /// Numbers the points within a layer; returns the next number, where those upwards begin.
  std::int64_t Number(std::int64_t layer, const Flags& flags, Ids& ids) const
  {
    std::int64_t point = this->FirstPoint[static_cast<std::size_t>(layer)];
    this->Cuts.Within(flags,
      [&](Axis axis, std::int64_t i, std::int64_t j) { ids[axis][this->GetNode(i, j)] = point++; });
    return point;
  }

  /// `signs`: of its corners, a bit each.
  void AddCell(std::uint8_t signs, std::int64_t i, std::int64_t j, const Ids& ids, const Ids& next,
    std::int64_t& triangle, TriangleMesh& mesh) const
  {
    const int* edges = MarchingCubesCase(signs);
    for (; *edges >= 0; edges += 3)
    {
      Triangle& corners = mesh.Triangles[static_cast<std::size_t>(triangle++)];
      for (std::size_t c = 0; c < 3; ++c)
      {
        const CellEdge& edge = EdgesOfCell[edges[c]];
        // The triangles of VTK's cases face the lower values: outwards.
        corners[c] = (edge.K == 0 ? ids : next)[edge.Along][this->GetNode(i + edge.I, j + edge.J)];
      }
    }
  }

  /// Does nothing if `node` is in the layer around the grid.
  const T* ValueAt(const std::array<std::int64_t, 3>& node) const
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      if (node[a] < 0 || node[a] >= this->Grid.Dimensions[a])
      {
        return nullptr;
      }
    }
    return &this->Grid(node[0], node[1], node[2]);
  }

  void SetPoint(Axis axis, std::int64_t i, std::int64_t j, std::int64_t k, std::int64_t id,
    TriangleMesh& mesh) const
  {
    const std::array<std::int64_t, 3> start{ i - this->Pad, j - this->Pad, k - this->Pad };
    std::array<std::int64_t, 3> end = start;
    ++end[axis];
    const T* a = this->ValueAt(start);
    const T* b = this->ValueAt(end);
    double along = 0.5;
    if (a && b)
    {
      // Halves, so that the difference of huge values is finite.
      const double from = static_cast<double>(*a) / 2.0, to = static_cast<double>(*b) / 2.0;
      const double there = (this->Level / 2.0 - from) / (to - from);
      along = std::isfinite(there) ? std::clamp(there, 0.001, 0.999) : 0.5;
    }
    Point3& point = mesh.Points[static_cast<std::size_t>(id)];
    for (std::size_t a3 = 0; a3 < 3; ++a3)
    {
      point[a3] =
        this->Grid.Spacing[a3] * (static_cast<double>(start[a3]) + (a3 == axis ? along : 0.0));
    }
  }

  GridView<const T> Grid;
  double Level;
  bool Higher;
  std::int64_t Pad;
  std::array<std::int64_t, 3> N{};
  LayerCuts Cuts;
  std::array<int, 256> Counts{};
  std::vector<std::int64_t> FirstPoint;    ///< of each layer, and the number of all
  std::vector<std::int64_t> FirstTriangle; ///< of the cells above each layer
};

}

template <typename T>
TriangleMesh MarchingCubes(const GridView<const T>& grid, const MarchingCubesParameters& parameters,
  const ProgressCallback& progress)
{
  RequireRange("Level", parameters.Level, -Unlimited, Unlimited);
  return CubeMarch<T>(grid, parameters).Run(progress);
}

template TriangleMesh MarchingCubes(
  const GridView<const float>&, const MarchingCubesParameters&, const ProgressCallback&);
template TriangleMesh MarchingCubes(
  const GridView<const double>&, const MarchingCubesParameters&, const ProgressCallback&);

}
