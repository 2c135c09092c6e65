#include "Surfaces/SurfaceCrossings.h"

#include "Core/NumberText.h"
#include "Core/ParallelFor.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

namespace isthmus
{
namespace
{

using Eigen::Vector3d;
using PointMap = Eigen::Map<const Vector3d>;

/// A line of the grid through a triangle: weights of the corners at the intersection.
struct TriangleHit
{
  std::int64_t Line[2]; ///< indices on the axis after the line's, and on the one after that
  double Position;      ///< along the line, length
  std::array<double, 3> Weight;
};

/// Finds the lines along one axis through triangles, exactly on a lattice finer than the grid.
/// The decision is integer arithmetic, and each line is moved by an infinitesimal amount, the same
/// for all triangles: a line through an edge or a corner counts once or not at all, whatever
/// triangle it is asked of, so there are no duplicates to remove.
class Projection
{
public:
  Projection(const SurfaceView& mesh, const GridShape& grid, std::size_t axis)
    : Mesh(mesh)
    , Grid(grid)
    , Axis(axis)
    , Across{ (axis + 1) % 3, (axis + 2) % 3 }
    , Bits(LatticeBits(mesh, grid))
  {
  }

  template <typename Use>
  void ForEachHit(vtkIdType triangle, Use&& use) const
  {
    const Triangle& id = this->Mesh.Corners(triangle);
    std::int64_t corner[3][2];
    std::int64_t low[2], high[2];
    for (std::size_t a = 0; a < 2; ++a)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        corner[c][a] = this->Lattice(this->Mesh.Point(id[c])[this->Across[a]], this->Across[a]);
      }
      const auto [least, most] = std::minmax({ corner[0][a], corner[1][a], corner[2][a] });
      // First and last lines between the corners, in the grid.
      low[a] =
        std::max<std::int64_t>(0, (least + (std::int64_t{ 1 } << this->Bits) - 1) >> this->Bits);
      high[a] = std::min(this->Grid.Dimensions[this->Across[a]] - 1, most >> this->Bits);
    }
    TriangleHit hit;
    for (hit.Line[1] = low[1]; hit.Line[1] <= high[1]; ++hit.Line[1])
    {
      for (hit.Line[0] = low[0]; hit.Line[0] <= high[0]; ++hit.Line[0])
      {
        if (this->Passes(corner, hit))
        {
          hit.Position = 0.0;
          for (std::size_t c = 0; c < 3; ++c)
          {
            hit.Position += hit.Weight[c] * this->Mesh.Point(id[c])[this->Axis];
          }
          use(hit);
        }
      }
    }
  }

private:
  static int LatticeBits(const SurfaceView& mesh, const GridShape& grid)
  {
    double reach = 1.0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      reach = std::max(reach, static_cast<double>(grid.Dimensions[a]));
    }
    for (const Triangle& corners : mesh.Triangles)
    {
      for (const vtkIdType point : corners)
      {
        for (std::size_t a = 0; a < 3; ++a)
        {
          reach = std::max(reach, std::abs(mesh.Point(point)[a]) / grid.Spacing[a]);
        }
      }
    }
    // Lattice coordinates below 2^29 keep the products of their differences in 64 bits.
    const int bits = 29 - static_cast<int>(std::ceil(std::log2(reach + 1.0)));
    if (bits < 6)
    {
      throw std::invalid_argument("The surface reaches " + FormatNumber(reach) +
        " spacings away from the grid's first node, more than 2^22: choose a larger spacing, or a "
        "grid that lies at the surface.");
    }
    return std::min(bits, 20);
  }

  std::int64_t Lattice(double x, std::size_t axis) const
  {
    return std::llround(
      x / this->Grid.Spacing[axis] * static_cast<double>(std::int64_t{ 1 } << this->Bits));
  }

  /// Twice the area of (p, q, x); its sign, for x moved by (e, e^2) with an infinitesimal e.
  static int Side(const std::int64_t p[2], const std::int64_t q[2], const std::int64_t x[2],
    std::int64_t& twiceArea)
  {
    const std::int64_t d0 = q[0] - p[0];
    const std::int64_t d1 = q[1] - p[1];
    twiceArea = d0 * (x[1] - p[1]) - d1 * (x[0] - p[0]);
    if (twiceArea != 0)
    {
      return twiceArea > 0 ? 1 : -1;
    }
    return d1 != 0 ? (d1 < 0 ? 1 : -1) : (d0 > 0) - (d0 < 0);
  }

  bool Passes(const std::int64_t corner[3][2], TriangleHit& hit) const
  {
    const std::int64_t x[2] = { hit.Line[0] << this->Bits, hit.Line[1] << this->Bits };
    std::int64_t opposite[3];
    const int side = Side(corner[1], corner[2], x, opposite[0]);
    if (side == 0 || Side(corner[2], corner[0], x, opposite[1]) != side ||
      Side(corner[0], corner[1], x, opposite[2]) != side)
    {
      return false;
    }
    const double sum = static_cast<double>(opposite[0]) + static_cast<double>(opposite[1]) +
      static_cast<double>(opposite[2]);
    if (sum == 0.0)
    {
      return false; // no area on the lattice: the three signs cannot be equal
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      hit.Weight[c] = static_cast<double>(opposite[c]) / sum;
    }
    return true;
  }

  SurfaceView Mesh;
  const GridShape& Grid;
  const std::size_t Axis;
  const std::array<std::size_t, 2> Across;
  const int Bits;
};

Vector3d TriangleNormal(const SurfaceView& mesh, vtkIdType triangle)
{
  const Triangle& id = mesh.Corners(triangle);
  const PointMap a(mesh.Point(id[0]).data());
  return (PointMap(mesh.Point(id[1]).data()) - a).cross(PointMap(mesh.Point(id[2]).data()) - a);
}

std::vector<Vector3d> PointNormals(const SurfaceView& mesh)
{
  std::vector<Vector3d> normals(mesh.Points.size(), Vector3d::Zero());
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const Vector3d normal = TriangleNormal(mesh, t);
    for (const vtkIdType point : mesh.Corners(t))
    {
      normals[At(point)] += normal;
    }
  }
  for (Vector3d& normal : normals)
  {
    normal.normalize();
  }
  return normals;
}

/// Calls `collect(triangle, results)` for all triangles, in parallel, and joins the results in
/// order.
template <typename Result, typename Collect>
std::vector<Result> CollectFromTriangles(
  const SurfaceView& mesh, const ProgressCallback& progress, Collect&& collect)
{
  constexpr std::int64_t block = 8192;
  const std::int64_t blocks = (mesh.NumberOfTriangles() + block - 1) / block;
  std::vector<std::vector<Result>> parts(static_cast<std::size_t>(blocks));
  ParallelFor(
    0, blocks, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t b = first; b < last; ++b)
      {
        const vtkIdType end = std::min<vtkIdType>(mesh.NumberOfTriangles(), (b + 1) * block);
        for (vtkIdType triangle = b * block; triangle < end; ++triangle)
        {
          collect(triangle, parts[static_cast<std::size_t>(b)]);
        }
      }
    },
    progress);
  std::vector<Result> all;
  for (const auto& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}

std::vector<GridCrossing> SurfaceCrossings(const SurfaceView& mesh, const GridShape& grid,
  CrossingNormal normal, const ProgressCallback& progress)
{
  const std::array<std::int64_t, 3> step{ 1, grid.Dimensions[0],
    grid.Dimensions[0] * grid.Dimensions[1] };
  const std::vector<Vector3d> pointNormals =
    normal == CrossingNormal::Points ? PointNormals(mesh) : std::vector<Vector3d>{};
  std::vector<GridCrossing> all;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Projection projection(mesh, grid, axis);
    const auto collect = [&](vtkIdType triangle, std::vector<GridCrossing>& crossings)
    {
      projection.ForEachHit(triangle,
        [&](const TriangleHit& hit)
        {
          const double index = hit.Position / grid.Spacing[axis];
          const auto last = static_cast<double>(grid.Dimensions[axis] - 1);
          if (index < 0.0 || index > last)
          {
            return;
          }
          const double below = std::max(0.0, std::min(std::floor(index), last - 1.0));
          GridCrossing crossing;
          crossing.Axis = static_cast<int>(axis);
          crossing.Fraction = index - below;
          crossing.Node = static_cast<std::int64_t>(below) * step[axis] +
            hit.Line[0] * step[(axis + 1) % 3] + hit.Line[1] * step[(axis + 2) % 3];
          Vector3d direction = TriangleNormal(mesh, triangle);
          for (std::size_t c = 0; c < 3 && !pointNormals.empty(); ++c)
          {
            const std::size_t point = At(mesh.Corners(triangle)[c]);
            direction =
              (c == 0 ? Vector3d(0, 0, 0) : direction) + hit.Weight[c] * pointNormals[point];
          }
          Eigen::Map<Vector3d>(crossing.Normal.data()) = direction.normalized();
          crossings.push_back(crossing);
        });
    };
    const double from = static_cast<double>(axis) / 3.0;
    const std::vector<GridCrossing> found =
      CollectFromTriangles<GridCrossing>(mesh, Between(progress, from, from + 1.0 / 3.0), collect);
    all.insert(all.end(), found.begin(), found.end());
  }
  std::stable_sort(all.begin(), all.end(),
    [](const GridCrossing& a, const GridCrossing& b)
    { return std::tie(a.Node, a.Axis, a.Fraction) < std::tie(b.Node, b.Axis, b.Fraction); });
  return all;
}

std::vector<unsigned char> NodesInside(
  const SurfaceView& mesh, const GridShape& grid, const PlaceInWorld& inWorld)
{
  RequireShellsApart(mesh, inWorld);
  const Projection projection(mesh, grid, 0);
  using Crossed = std::pair<std::int64_t, double>; // line j + dimension_y k, position
  std::vector<Crossed> crossed = CollectFromTriangles<Crossed>(mesh, {},
    [&](vtkIdType triangle, std::vector<Crossed>& found)
    {
      projection.ForEachHit(triangle,
        [&](const TriangleHit& hit)
        { found.emplace_back(hit.Line[0] + grid.Dimensions[1] * hit.Line[1], hit.Position); });
    });
  std::sort(crossed.begin(), crossed.end());
  std::vector<unsigned char> inside(static_cast<std::size_t>(grid.Size()), 0);
  const auto clampedNode = [&](double position)
  {
    const double node = std::ceil(position / grid.Spacing[0]);
    return static_cast<std::int64_t>(
      std::clamp(node, 0.0, static_cast<double>(grid.Dimensions[0])));
  };
  for (std::size_t i = 0; i < crossed.size(); i += 2)
  {
    const std::int64_t line = crossed[i].first;
    if (i + 1 == crossed.size() || crossed[i + 1].first != line)
    {
      throw std::invalid_argument("The surface is not closed: the line of the grid at y index " +
        std::to_string(line % grid.Dimensions[1]) + ", z index " +
        std::to_string(line / grid.Dimensions[1]) +
        " crosses it an odd number of times. Close its holes first, or request only crossings.");
    }
    const auto row = inside.begin() + line * grid.Dimensions[0];
    std::fill(row + clampedNode(crossed[i].second), row + clampedNode(crossed[i + 1].second),
      static_cast<unsigned char>(1));
  }
  return inside;
}

std::vector<unsigned char> IrregularNodes(
  const std::vector<unsigned char>& inside, const GridShape& grid)
{
  std::vector<unsigned char> irregular(inside.size(), 0);
  const std::int64_t step[3] = { 1, grid.Dimensions[0], grid.Dimensions[0] * grid.Dimensions[1] };
  ParallelFor(0, grid.Dimensions[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first * step[2]; node < last * step[2]; ++node)
      {
        const std::int64_t index[3] = { node % step[1], node / step[1] % grid.Dimensions[1],
          node / step[2] };
        const auto differs = [&](std::int64_t other) {
          return inside[static_cast<std::size_t>(other)] != inside[static_cast<std::size_t>(node)];
        };
        bool any = false;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          any = any || (index[axis] > 0 && differs(node - step[axis])) ||
            (index[axis] + 1 < grid.Dimensions[axis] && differs(node + step[axis]));
        }
        irregular[static_cast<std::size_t>(node)] = any;
      }
    });
  return irregular;
}

}
