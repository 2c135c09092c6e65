#include "Surfaces/GridDistance.h"

#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Surfaces/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace isthmus
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Squared distances within the band, infinite elsewhere.
class Band
{
public:
  Band(const SurfaceView& mesh, const GridShape& grid)
    : Mesh(mesh)
    , Grid(grid)
    , Step{ 1, grid.Dimensions[0], grid.Dimensions[0] * grid.Dimensions[1] }
    , Squared(static_cast<std::size_t>(grid.Size()), Infinity)
  {
  }

  std::vector<double> Run(double band, const ProgressCallback& progress)
  {
    this->FillBand(band, progress);
    return std::move(this->Squared);
  }

private:
  // Threads take slabs of layers, and each writes to its own nodes only.
  static constexpr std::int64_t SlabLayers = 4;

  Point3 Node(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const auto& h = this->Grid.Spacing;
    return { static_cast<double>(i) * h[0], static_cast<double>(j) * h[1],
      static_cast<double>(k) * h[2] };
  }

  /// Nodes along `axis` within `band` of the triangle's box; empty if the second is the smaller.
  std::pair<std::int64_t, std::int64_t> Range(
    vtkIdType triangle, std::size_t axis, double band) const
  {
    const Triangle& id = this->Mesh.Corners(triangle);
    const auto at = [&](std::size_t c) { return this->Mesh.Point(id[c])[axis]; };
    const auto [low, high] = std::minmax({ at(0), at(1), at(2) });
    const double h = this->Grid.Spacing[axis];
    const auto last = static_cast<double>(this->Grid.Dimensions[axis] - 1);
    return { static_cast<std::int64_t>(std::clamp(std::ceil((low - band) / h), 0.0, last + 1.0)),
      static_cast<std::int64_t>(std::clamp(std::floor((high + band) / h), -1.0, last)) };
  }

  /// Triangles near each slab of layers, in their order.
  std::vector<std::vector<vtkIdType>> Slabs(double band) const
  {
    const std::int64_t count = (this->Grid.Dimensions[2] + SlabLayers - 1) / SlabLayers;
    std::vector<std::vector<vtkIdType>> slabs(static_cast<std::size_t>(count));
    for (vtkIdType triangle = 0; triangle < this->Mesh.NumberOfTriangles(); ++triangle)
    {
      const auto [first, last] = this->Range(triangle, 2, band);
      for (std::int64_t slab = first / SlabLayers; first <= last && slab <= last / SlabLayers;
           ++slab)
      {
        slabs[static_cast<std::size_t>(slab)].push_back(triangle);
      }
    }
    return slabs;
  }

  void FillBand(double band, const ProgressCallback& progress)
  {
    const auto slabs = this->Slabs(band);
    ParallelFor(
      0, static_cast<std::int64_t>(slabs.size()), 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t slab = first; slab < last; ++slab)
        {
          for (const vtkIdType triangle : slabs[static_cast<std::size_t>(slab)])
          {
            this->VisitNodesNear(triangle, slab, band);
          }
        }
      },
      progress);
  }

  void VisitNodesNear(vtkIdType triangle, std::int64_t slab, double band)
  {
    const auto x = this->Range(triangle, 0, band);
    const auto y = this->Range(triangle, 1, band);
    const auto z = this->Range(triangle, 2, band);
    const Triangle& id = this->Mesh.Corners(triangle);
    const std::array<Point3, 3> corners{ this->Mesh.Point(id[0]), this->Mesh.Point(id[1]),
      this->Mesh.Point(id[2]) };
    const Point3& a = corners[0];
    const Point3 normal = Cross(corners[1] - a, corners[2] - a);
    const double limit = band * band * Dot(normal, normal);
    const std::int64_t lastLayer = std::min(z.second, (slab + 1) * SlabLayers - 1);
    for (std::int64_t k = std::max(z.first, slab * SlabLayers); k <= lastLayer; ++k)
    {
      for (std::int64_t j = y.first; j <= y.second; ++j)
      {
        for (std::int64_t i = x.first; i <= x.second; ++i)
        {
          const Point3 node = this->Node(i, j, k);
          const double height = Dot(normal, node - a); // times |normal|
          // The distance from the plane is a cheap bound, which spares most of the exact ones.
          if (height * height <= limit)
          {
            double& nearest =
              this->Squared[static_cast<std::size_t>(i + this->Step[1] * j + this->Step[2] * k)];
            nearest = std::min(nearest, SquaredDistanceToTriangle(node, corners));
          }
        }
      }
    }
  }

  SurfaceView Mesh;
  const GridShape& Grid;
  const std::array<std::int64_t, 3> Step;
  std::vector<double> Squared;
};

/// The lower envelope of the parabolas f(q) + (x - q h)^2 at the nodes of a line. Its memory is
/// reused from line to line.
class Envelope
{
public:
  /// Replaces the `count` values at `first`, `step` apart.
  void Run(double* first, std::int64_t step, std::int64_t count, double h)
  {
    this->Parabolas.clear();
    for (std::int64_t q = 0; q < count; ++q)
    {
      if (std::isfinite(first[q * step]))
      {
        this->Add(static_cast<double>(q) * h, first[q * step]);
      }
    }
    std::size_t lowest = 0;
    for (std::int64_t q = 0; q < count && !this->Parabolas.empty(); ++q)
    {
      const double x = static_cast<double>(q) * h;
      while (lowest + 1 < this->Parabolas.size() && this->Parabolas[lowest + 1].From < x)
      {
        ++lowest;
      }
      const double offset = x - this->Parabolas[lowest].At;
      first[q * step] = offset * offset + this->Parabolas[lowest].Value;
    }
  }

private:
  struct Parabola
  {
    double At;
    double Value;
    double From; ///< where it becomes the lowest
  };

  void Add(double at, double value)
  {
    double from = -Infinity;
    while (!this->Parabolas.empty())
    {
      const Parabola& last = this->Parabolas.back();
      from = ((value + at * at) - (last.Value + last.At * last.At)) / (2.0 * (at - last.At));
      if (from > last.From)
      {
        break;
      }
      this->Parabolas.pop_back();
      from = -Infinity;
    }
    this->Parabolas.push_back({ at, value, from });
  }

  std::vector<Parabola> Parabolas;
};

/// Squared distance of all nodes from the crossings with grid lines along one axis.
class FarField
{
public:
  FarField(const GridShape& grid, const std::vector<GridCrossing>& crossings, int axis)
    : Grid(grid)
    , Step{ 1, grid.Dimensions[0], grid.Dimensions[0] * grid.Dimensions[1] }
    , Squared(static_cast<std::size_t>(grid.Size()), Infinity)
  {
    const auto a = static_cast<std::size_t>(axis);
    // Of the crossings between two nodes, the first is nearest to one and the last to the other.
    for (const GridCrossing& crossing : crossings)
    {
      if (crossing.Axis == axis)
      {
        const double below = crossing.Fraction * grid.Spacing[a];
        const double above = (1.0 - crossing.Fraction) * grid.Spacing[a];
        this->Lower(crossing.Node, below * below);
        this->Lower(crossing.Node + this->Step[a], above * above);
      }
    }
    this->RunAlongCrossings(a);
    this->RunAcross((a + 1) % 3);
    this->RunAcross((a + 2) % 3);
  }

  double At(std::size_t node) const { return this->Squared[node]; }

private:
  void Lower(std::int64_t node, double squared)
  {
    double& value = this->Squared[static_cast<std::size_t>(node)];
    value = std::min(value, squared);
  }

  /// Calls `run(first node of the line)` for each line along `axis`, in parallel.
  template <typename RunLine>
  void ForEachLine(std::size_t axis, RunLine&& run)
  {
    const std::size_t inner = axis == 0 ? 1 : 0;
    const std::size_t outer = axis == 2 ? 1 : 2;
    ParallelFor(0, this->Grid.Dimensions[outer], 1,
      [&](std::int64_t first, std::int64_t last)
      {
        Envelope envelope;
        for (std::int64_t o = first; o < last; ++o)
        {
          for (std::int64_t i = 0; i < this->Grid.Dimensions[inner]; ++i)
          {
            run(envelope, this->Squared.data() + o * this->Step[outer] + i * this->Step[inner]);
          }
        }
      });
  }

  /// On the line itself, the distance is that to the next crossing on either side.
  void RunAlongCrossings(std::size_t axis)
  {
    const std::int64_t count = this->Grid.Dimensions[axis];
    const std::int64_t step = this->Step[axis];
    const double h = this->Grid.Spacing[axis];
    this->ForEachLine(axis,
      [&](Envelope&, double* line)
      {
        const auto walk = [&](std::int64_t from, std::int64_t way)
        {
          double distance = Infinity;
          for (std::int64_t n = 0, q = from; n < count; ++n, q += way)
          {
            distance = std::min(distance + h, std::sqrt(line[q * step]));
            line[q * step] = distance * distance;
          }
        };
        walk(0, 1);
        walk(count - 1, -1);
      });
  }

  void RunAcross(std::size_t axis)
  {
    this->ForEachLine(axis,
      [&](Envelope& envelope, double* line) {
        envelope.Run(line, this->Step[axis], this->Grid.Dimensions[axis], this->Grid.Spacing[axis]);
      });
  }

  const GridShape& Grid;
  const std::array<std::int64_t, 3> Step;
  std::vector<double> Squared;
};

}

std::vector<double> DistanceToSurface(
  const SurfaceView& mesh, const GridShape& grid, double band, const ProgressCallback& progress)
{
  RequireAbove(
    "The width of the band", band, 0.0, Unlimited, "About two grid spacings are sufficient.");
  const double spacing = *std::max_element(grid.Spacing.begin(), grid.Spacing.end());
  band = std::max(band, spacing);
  std::vector<double> squared = Band(mesh, grid).Run(band, Between(progress, 0.0, 0.5));
  const auto crossings =
    SurfaceCrossings(mesh, grid, CrossingNormal::Triangles, Between(progress, 0.5, 0.6));
  if (crossings.empty() && mesh.NumberOfTriangles() > 0)
  {
    // It lies between the lines of the grid: a needle, or smaller than a cell.
    return ExactDistanceToSurface(mesh, grid, Between(progress, 0.6, 1.0));
  }
  // A node beyond the band takes the nearest of the crossings along x, y and z.
  // Three fields one after the other, since a crossing lies on a line of one axis.
  std::vector<double> far(squared.size(), Infinity);
  for (const int axis : { 0, 1, 2 })
  {
    const FarField field(grid, crossings, axis);
    for (std::size_t node = 0; node < far.size(); ++node)
    {
      far[node] = std::min(far[node], field.At(node));
    }
    Report(progress, 0.7 + 0.1 * axis);
  }
  for (std::size_t node = 0; node < far.size(); ++node)
  {
    squared[node] =
      std::sqrt(squared[node] <= band * band ? squared[node] : std::min(squared[node], far[node]));
  }
  return squared;
}

namespace
{

/// Nodes in blocks, whose nearest triangles lie together in the tree and in the caches.
class ExactField
{
public:
  ExactField(const SurfaceView& mesh, const GridShape& grid)
    : Tree(mesh)
    , Grid(grid)
    , Distance(static_cast<std::size_t>(grid.Size()))
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Blocks[axis] = (grid.Dimensions[axis] + Side - 1) / Side;
    }
  }

  std::vector<double> Run(const ProgressCallback& progress)
  {
    ParallelFor(
      0, this->Blocks[0] * this->Blocks[1] * this->Blocks[2], 4,
      [this](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t block = first; block < last; ++block)
        {
          const std::int64_t row = block / this->Blocks[0];
          this->FillBlock({ Side * (block % this->Blocks[0]), Side * (row % this->Blocks[1]),
            Side * (row / this->Blocks[1]) });
        }
      },
      progress);
    return std::move(this->Distance);
  }

private:
  static constexpr std::int64_t Side = 8;

  /// Back and forth along its lines, with the result of the neighbouring node as a guess; each
  /// block starts without one, so that results do not depend on the division into pieces.
  void FillBlock(const std::array<std::int64_t, 3>& low)
  {
    const auto& n = this->Grid.Dimensions;
    std::int64_t guess = -1;
    for (std::int64_t k = low[2]; k < std::min(low[2] + Side, n[2]); ++k)
    {
      for (std::int64_t j = low[1]; j < std::min(low[1] + Side, n[1]); ++j)
      {
        const std::int64_t count = std::min(Side, n[0] - low[0]);
        for (std::int64_t step = 0; step < count; ++step)
        {
          const std::int64_t i = low[0] + (j % 2 == 0 ? step : count - 1 - step);
          const Point3 node{ static_cast<double>(i) * this->Grid.Spacing[0],
            static_cast<double>(j) * this->Grid.Spacing[1],
            static_cast<double>(k) * this->Grid.Spacing[2] };
          const TriangleTree::Nearest nearest = this->Tree.Find(node, guess);
          guess = nearest.Guess;
          this->Distance[static_cast<std::size_t>((k * n[1] + j) * n[0] + i)] =
            std::sqrt(nearest.Squared);
        }
      }
    }
  }

  const TriangleTree Tree;
  const GridShape& Grid;
  std::array<std::int64_t, 3> Blocks;
  std::vector<double> Distance;
};

}

std::vector<double> ExactDistanceToSurface(
  const SurfaceView& mesh, const GridShape& grid, const ProgressCallback& progress)
{
  ExactField field(mesh, grid);
  Report(progress, 0.1);
  return field.Run(Between(progress, 0.1, 1.0));
}

}
