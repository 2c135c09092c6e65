#include "Contouring/HermiteGrid.h"

#include "Contouring/CellBox.h"

#include <limits>

namespace isthmus
{
namespace
{

template <typename T>
auto RangeOf(const std::vector<T>& sorted, std::int64_t cell)
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

/// Of the line from end to end, from fraction `low` to `high`.
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

ContourFeatures::ContourFeatures(const SharpEdges& sharp, const GridShape& grid)
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

void ContourFeatures::AddPieces(const std::array<Point3, 2>& segment, const GridShape& grid)
{
  const Point3 along = segment[1] - segment[0];
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

std::optional<Point3> ContourFeatures::NearestCorner(
  std::int64_t cell, const Point3& x, const Filter& isMine) const
{
  Nearest nearest{ x };
  const auto [first, last] = RangeOf(this->Corners, cell);
  for (auto corner = first; corner != last; ++corner)
  {
    if (isMine(corner->Place))
    {
      nearest.Take(corner->Place);
    }
  }
  return nearest.Place;
}

std::optional<Point3> ContourFeatures::NearestOnEdge(
  std::int64_t cell, const Point3& x, Part part, const Filter& isMine) const
{
  const double beside = part == Part::Middle ? 0.1 : 0.0;
  Nearest nearest{ x };
  const auto [first, last] = RangeOf(this->Pieces, cell);
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
