#include "GridDistance.h"

#include "ParallelFor.h"
#include "TriangleStars.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

using Eigen::Vector3d;
using PointMap = Eigen::Map<const Vector3d>;

double SquaredDistanceToSegment(const Vector3d& x, const Vector3d& a, const Vector3d& b)
{
  const Vector3d d = b - a;
  const double dd = d.squaredNorm();
  const double t = dd > 0.0 ? std::clamp((x - a).dot(d) / dd, 0.0, 1.0) : 0.0;
  return (x - a - t * d).squaredNorm();
}

struct TriangleDistance
{
  double Squared;
  bool OverInside; ///< the nearest point is inside the triangle, not on its border
};

TriangleDistance DistanceTo(const SurfaceView& mesh, vtkIdType triangle, const Vector3d& x)
{
  const vtkIdType* const id = mesh.Triangle(triangle);
  const PointMap a(mesh.Point(id[0]));
  const PointMap b(mesh.Point(id[1]));
  const PointMap c(mesh.Point(id[2]));
  const Vector3d normal = (b - a).cross(c - a);
  const double nn = normal.squaredNorm();
  const bool flat = !(nn > 0.0);
  const bool beyond[3] = { flat || (b - a).cross(x - a).dot(normal) < 0.0,
    flat || (c - b).cross(x - b).dot(normal) < 0.0,
    flat || (a - c).cross(x - c).dot(normal) < 0.0 };
  if (!beyond[0] && !beyond[1] && !beyond[2])
  {
    const double height = normal.dot(x - a);
    return { height * height / nn, true };
  }
  // The nearest border point is on an edge that x is beyond.
  double nearest = std::numeric_limits<double>::infinity();
  if (beyond[0])
  {
    nearest = std::min(nearest, SquaredDistanceToSegment(x, a, b));
  }
  if (beyond[1])
  {
    nearest = std::min(nearest, SquaredDistanceToSegment(x, b, c));
  }
  if (beyond[2])
  {
    nearest = std::min(nearest, SquaredDistanceToSegment(x, c, a));
  }
  return { nearest, false };
}

class DistanceField
{
public:
  DistanceField(const SurfaceView& mesh, const GridShape& grid)
    : Mesh(mesh)
    , Grid(grid)
    , Step{ 1, grid.Dimensions[0], grid.Dimensions[0] * grid.Dimensions[1] }
    , Squared(static_cast<std::size_t>(grid.Size()), std::numeric_limits<double>::infinity())
    , Nearest(static_cast<std::size_t>(grid.Size()), -1)
  {
  }

  std::vector<double> Run(double band, const ProgressCallback& progress)
  {
    this->FillBand(band, Between(progress, 0.0, 0.4));
    this->SpreadUntilStable(Between(progress, 0.4, 0.7));
    this->Descend(band, Between(progress, 0.7, 0.95));
    this->SpreadUntilStable({});
    for (double& value : this->Squared)
    {
      value = std::sqrt(value);
    }
    return std::move(this->Squared);
  }

private:
  static constexpr std::int64_t SlabLayers = 4;

  Vector3d Node(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const auto& h = this->Grid.Spacing;
    return { static_cast<double>(i) * h[0], static_cast<double>(j) * h[1],
      static_cast<double>(k) * h[2] };
  }

  /// Nodes along `axis` within `band` of the triangle's box; empty if the second is the smaller.
  std::pair<std::int64_t, std::int64_t> Range(
    vtkIdType triangle, std::size_t axis, double band) const
  {
    const vtkIdType* const id = this->Mesh.Triangle(triangle);
    const auto at = [&](int c) { return this->Mesh.Point(id[c])[axis]; };
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
    for (vtkIdType triangle = 0; triangle < this->Mesh.NumberOfTriangles; ++triangle)
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
    const vtkIdType* const id = this->Mesh.Triangle(triangle);
    const PointMap a(this->Mesh.Point(id[0]));
    const Vector3d normal =
      (PointMap(this->Mesh.Point(id[1])) - a).cross(PointMap(this->Mesh.Point(id[2])) - a);
    const double limit = band * band * normal.squaredNorm();
    const std::int64_t lastLayer = std::min(z.second, (slab + 1) * SlabLayers - 1);
    for (std::int64_t k = std::max(z.first, slab * SlabLayers); k <= lastLayer; ++k)
    {
      for (std::int64_t j = y.first; j <= y.second; ++j)
      {
        for (std::int64_t i = x.first; i <= x.second; ++i)
        {
          const Vector3d node = this->Node(i, j, k);
          const double height = normal.dot(node - a); // times |normal|
          if (height * height <= limit)
          {
            this->Offer(i + this->Step[1] * j + this->Step[2] * k, triangle, node);
          }
        }
      }
    }
  }

  bool Offer(std::int64_t node, vtkIdType triangle, const Vector3d& position)
  {
    const auto n = static_cast<std::size_t>(node);
    const double squared = DistanceTo(this->Mesh, triangle, position).Squared;
    if (squared < this->Squared[n])
    {
      this->Squared[n] = squared;
      this->Nearest[n] = triangle;
      return true;
    }
    return false;
  }

  /// Offers `from`'s triangle to its neighbour (i, j, k), a spacing h away.
  bool Hand(std::int64_t from, std::int64_t i, std::int64_t j, std::int64_t k, double h)
  {
    const std::int64_t to = i + this->Step[1] * j + this->Step[2] * k;
    const auto f = static_cast<std::size_t>(from);
    const auto t = static_cast<std::size_t>(to);
    const vtkIdType triangle = this->Nearest[f];
    if (triangle < 0 || triangle == this->Nearest[t])
    {
      return false;
    }
    // The neighbour's triangle is at most h nearer to this node than to the neighbour.
    const double least = std::sqrt(this->Squared[f]) - h;
    if (least > 0.0 && least * least >= this->Squared[t])
    {
      return false;
    }
    return this->Offer(to, triangle, this->Node(i, j, k));
  }

  void SpreadUntilStable(const ProgressCallback& progress)
  {
    constexpr int mostRounds = 16; // two or three are usual; each costs less than the one before
    for (int round = 0; round < mostRounds && this->Spread(); ++round)
    {
      Report(progress, static_cast<double>(round + 1) / mostRounds);
    }
  }

  /// Nodes beyond the band look for nearer triangles around the corners of theirs, and around those
  /// of what they find, until they are at a minimum.
  void Descend(double band, const ProgressCallback& progress)
  {
    const TriangleStars stars(this->Mesh);
    const auto& size = this->Grid.Dimensions;
    ParallelFor(
      0, size[1] * size[2], 64,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t row = first; row < last; ++row)
        {
          for (std::int64_t i = 0; i < size[0]; ++i)
          {
            const std::int64_t node = i + row * size[0];
            if (this->Squared[static_cast<std::size_t>(node)] > band * band)
            {
              this->DescendAt(node, this->Node(i, row % size[1], row / size[1]), stars);
            }
          }
        }
      },
      progress);
  }

  void DescendAt(std::int64_t node, const Vector3d& position, const TriangleStars& stars)
  {
    for (bool found = true; found;)
    {
      const vtkIdType triangle = this->Nearest[static_cast<std::size_t>(node)];
      if (triangle < 0 || DistanceTo(this->Mesh, triangle, position).OverInside)
      {
        return;
      }
      found = false;
      for (int c = 0; c < 3; ++c)
      {
        const vtkIdType corner = this->Mesh.Triangle(triangle)[c];
        const vtkIdType* const around = stars.Triangles(corner);
        for (vtkIdType t = 0; t < stars.Size(corner); ++t)
        {
          found = this->Offer(node, around[t], position) || found;
        }
      }
    }
  }

  /// Once along each axis, both ways; true if any node found a nearer triangle.
  bool Spread()
  {
    const auto& size = this->Grid.Dimensions;
    std::vector<unsigned char> changed(static_cast<std::size_t>(std::max(size[1], size[2])), 0);
    const auto sweep = [&](std::size_t axis)
    {
      // Rows along x are worked off in order; what runs in parallel is never along `axis`.
      const std::size_t parallel = axis == 2 ? 1 : 2;
      const std::size_t other = axis == 2 ? 2 : 1;
      ParallelFor(0, size[parallel], 1,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t p = first; p < last; ++p)
          {
            bool any = false;
            for (const std::int64_t way : { 1, -1 })
            {
              for (std::int64_t q = 0; q < size[other]; ++q)
              {
                const std::int64_t o = way > 0 ? q : size[other] - 1 - q;
                any = this->SpreadAlongRow(axis, way, axis == 2 ? p : o, axis == 2 ? o : p) || any;
              }
            }
            if (any)
            {
              changed[static_cast<std::size_t>(p)] = 1;
            }
          }
        });
    };
    sweep(0);
    sweep(1);
    sweep(2);
    return std::any_of(changed.begin(), changed.end(), [](unsigned char c) { return c != 0; });
  }

  /// Hands triangles to the nodes of the row (j, k) from the nodes before them, `way` along `axis`.
  bool SpreadAlongRow(std::size_t axis, std::int64_t way, std::int64_t j, std::int64_t k)
  {
    const auto& size = this->Grid.Dimensions;
    const std::int64_t before[3] = { 0, j - way, k - way };
    if (axis != 0 && (before[axis] < 0 || before[axis] >= size[axis]))
    {
      return false;
    }
    const std::int64_t back = way * this->Step[axis];
    const double h = this->Grid.Spacing[axis];
    bool any = false;
    for (std::int64_t n = axis == 0 ? 1 : 0; n < size[0]; ++n)
    {
      const std::int64_t i = way > 0 ? n : size[0] - 1 - n;
      any = this->Hand(i + this->Step[1] * j + this->Step[2] * k - back, i, j, k, h) || any;
    }
    return any;
  }

  const SurfaceView& Mesh;
  const GridShape& Grid;
  const std::array<std::int64_t, 3> Step;
  std::vector<double> Squared;
  std::vector<vtkIdType> Nearest;
};

}

std::vector<double> DistanceToSurface(
  const SurfaceView& mesh, const GridShape& grid, double band, const ProgressCallback& progress)
{
  if (!(band > 0.0) || std::isinf(band))
  {
    throw std::invalid_argument("The band around the surface is " + std::to_string(band) +
      " wide, but exact distances need a positive width: choose two spacings or so.");
  }
  const double spacing = *std::max_element(grid.Spacing.begin(), grid.Spacing.end());
  return DistanceField(mesh, grid).Run(std::max(band, spacing), progress);
}

}
