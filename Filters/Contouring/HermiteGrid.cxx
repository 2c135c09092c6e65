#include "Contouring/HermiteGrid.h"

#include "Core/Index.h"
#include "Surfaces/SurfaceCleaning.h"

#include <limits>
#include <tuple>

namespace isthmus
{

Bounds3 CellBox(
  const GridShape& shape, const std::array<std::int64_t, 3>& index, std::int64_t size, double reach)
{
  Bounds3 box;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto last = static_cast<double>(shape.Dimensions[a] - 1);
    const auto low = static_cast<double>(index[a]);
    const auto side = static_cast<double>(size);
    box.Min[a] = shape.Spacing[a] * std::max(-reach, low - reach * side);
    box.Max[a] = shape.Spacing[a] * std::min(last + reach, low + side + reach * side);
  }
  return box;
}

std::int64_t CellAt(const GridShape& grid, const Point3& x)
{
  std::array<std::int64_t, 3> index;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double at = std::floor(x[a] / grid.Spacing[a]);
    if (!(at >= 0.0 && at < static_cast<double>(grid.Dimensions[a] - 1)))
    {
      return -1;
    }
    index[a] = static_cast<std::int64_t>(at);
  }
  return index[0] + grid.Dimensions[0] * (index[1] + grid.Dimensions[1] * index[2]);
}

namespace
{

/// A side of a triangle with an area.
struct Side
{
  std::array<vtkIdType, 2> Ends; ///< ascending
  Point3 Normal;
};

std::vector<Side> CollectSides(const SurfaceView& surface)
{
  std::vector<Side> sides;
  sides.reserve(3 * surface.Triangles.size());
  for (const Triangle& t : MergedCorners(surface))
  {
    const Point3& first = surface.Point(t[0]);
    const Point3 n = Cross(surface.Point(t[1]) - first, surface.Point(t[2]) - first);
    const double length = Length(n);
    // A triangle without area has no normal to compare.
    for (std::size_t c = 0; c < 3 && length > 0.0; ++c)
    {
      const vtkIdType a = t[c], b = t[(c + 1) % 3];
      sides.push_back({ { std::min(a, b), std::max(a, b) }, (1.0 / length) * n });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    { return std::tie(a.Ends, a.Normal) < std::tie(b.Ends, b.Normal); });
  return sides;
}

/// A segment's end: its point, and the other end.
using End = std::array<vtkIdType, 2>;

std::vector<Point3> FindCorners(const SurfaceView& surface, std::vector<End> ends, double cosine)
{
  std::sort(ends.begin(), ends.end());
  const auto along = [&](const End& end)
  {
    const Point3 d = surface.Point(end[1]) - surface.Point(end[0]);
    return (1.0 / Length(d)) * d;
  };
  std::vector<Point3> corners;
  for (std::size_t i = 0, next = 0; i < ends.size(); i = next)
  {
    while (next < ends.size() && ends[next][0] == ends[i][0])
    {
      ++next;
    }
    if (next - i != 2 || -Dot(along(ends[i]), along(ends[i + 1])) < cosine)
    {
      corners.push_back(surface.Point(ends[i][0]));
    }
  }
  return corners;
}

}

SharpEdges FindSharpEdges(const SurfaceView& surface, double cosine)
{
  const std::vector<Side> sides = CollectSides(surface);
  SharpEdges sharp;
  std::vector<End> ends;
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next)
  {
    while (next < sides.size() && sides[next].Ends == sides[i].Ends)
    {
      ++next;
    }
    if (next - i > 2 || (next - i == 2 && Dot(sides[i].Normal, sides[i + 1].Normal) < cosine))
    {
      const auto [a, b] = sides[i].Ends;
      sharp.Segments.push_back({ surface.Point(a), surface.Point(b) });
      ends.push_back({ a, b });
      ends.push_back({ b, a });
    }
  }
  sharp.Corners = FindCorners(surface, std::move(ends), cosine);
  return sharp;
}

namespace
{

template <typename T>
auto FindRange(const std::vector<T>& sorted, std::int64_t cell)
{
  const auto first = std::lower_bound(sorted.begin(), sorted.end(), cell,
    [](const T& item, std::int64_t wanted) { return item.Cell < wanted; });
  auto last = first;
  while (last != sorted.end() && last->Cell == cell)
  {
    ++last;
  }
  return std::pair{ first, last };
}

/// The point nearest to x on the part of a line from fraction `low` to `high`.
Point3 NearestOn(const std::array<Point3, 2>& ends, double low, double high, const Point3& x)
{
  const Point3 along = ends[1] - ends[0];
  const double squared = Dot(along, along);
  const double t = squared > 0.0 ? Dot(x - ends[0], along) / squared : 0.5;
  return ends[0] + std::min(high, std::max(low, t)) * along;
}

struct Nearest
{
  Point3 To;
  std::optional<Point3> Place{};
  double Squared = std::numeric_limits<double>::infinity();

  void Take(const Point3& candidate)
  {
    const Point3 d = candidate - this->To;
    if (Dot(d, d) < this->Squared)
    {
      this->Squared = Dot(d, d);
      this->Place = candidate;
    }
  }
};

}

SharpFeatureGrid::SharpFeatureGrid(const SharpEdges& sharp, const GridShape& grid)
{
  for (const auto& segment : sharp.Segments)
  {
    this->AddPieces(segment, grid);
  }
  for (const Point3& corner : sharp.Corners)
  {
    const std::int64_t cell = CellAt(grid, corner);
    if (cell >= 0)
    {
      this->Corners.push_back({ cell, corner });
    }
  }
  const auto before = [](const auto& a, const auto& b) { return a.Cell < b.Cell; };
  std::stable_sort(this->Pieces.begin(), this->Pieces.end(), before);
  std::stable_sort(this->Corners.begin(), this->Corners.end(), before);
}

void SharpFeatureGrid::AddPieces(const std::array<Point3, 2>& segment, const GridShape& grid)
{
  const Point3 along = segment[1] - segment[0];
  // Cut at the planes of the grid, since a cell only uses the pieces in it.
  std::vector<double> stops{ 0.0, 1.0 };
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double from = segment[0][a] / grid.Spacing[a], to = segment[1][a] / grid.Spacing[a];
    for (double face = std::floor(std::min(from, to)) + 1.0; face < std::max(from, to); ++face)
    {
      stops.push_back((face - from) / (to - from));
    }
  }
  std::sort(stops.begin(), stops.end());
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
  {
    const double from = std::max(0.0, stops[i]), to = std::min(1.0, stops[i + 1]);
    const std::int64_t cell = CellAt(grid, segment[0] + 0.5 * (from + to) * along);
    if (to > from && cell >= 0)
    {
      this->Pieces.push_back({ cell, { segment[0] + from * along, segment[0] + to * along },
        { i > 0, i + 2 < stops.size() } });
    }
  }
}

std::optional<Point3> SharpFeatureGrid::NearestCorner(
  std::int64_t cell, const Point3& x, const Filter& isMine) const
{
  Nearest nearest{ x };
  const auto [first, last] = FindRange(this->Corners, cell);
  for (auto corner = first; corner != last; ++corner)
  {
    if (isMine(corner->Place))
    {
      nearest.Take(corner->Place);
    }
  }
  return nearest.Place;
}

std::optional<Point3> SharpFeatureGrid::NearestOnEdge(
  std::int64_t cell, const Point3& x, Part part, const Filter& isMine) const
{
  // A tenth next to each face is left to the neighbour, so that no two cells use the same point.
  const double beside = part == Part::Middle ? 0.1 : 0.0;
  Nearest nearest{ x };
  const auto [first, last] = FindRange(this->Pieces, cell);
  for (auto piece = first; piece != last; ++piece)
  {
    if (isMine(0.5 * (piece->Ends[0] + piece->Ends[1])))
    {
      nearest.Take(NearestOn(piece->Ends, piece->IsAtFace[0] ? beside : 0.0,
        piece->IsAtFace[1] ? 1.0 - beside : 1.0, x));
    }
  }
  return nearest.Place;
}

}
