#include "DualContouring.h"

#include "DualCells.h"
#include "ParallelFor.h"
#include "QuadraticErrors.h"

#include <stdexcept>

namespace isthmus
{
namespace
{

class Contourer
{
public:
  Contourer(const HermiteGrid& grid, const DualContouringParameters& parameters)
    : Grid(grid)
    , Parameters(parameters)
    , Cells(grid)
  {
    std::int64_t points = 0;
    for (const auto& pieces : this->Cells.Pieces())
    {
      this->FirstPoint.push_back(points);
      points += 1 + *std::max_element(pieces.begin(), pieces.end());
    }
    this->Result.Points.resize(static_cast<std::size_t>(points));
  }

  void PlacePoints(const ProgressCallback& progress)
  {
    ParallelFor(
      0, static_cast<std::int64_t>(this->Cells.Active().size()), 256,
      [this](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t c = first; c < last; ++c)
        {
          this->PlacePointsOf(static_cast<std::size_t>(c));
        }
      },
      progress);
  }

  void AddPolygons()
  {
    for (std::size_t c = 0; c < this->Cells.Active().size(); ++c)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        this->AddPolygonOf(this->Cells.Active()[c], axis);
      }
    }
  }

  DualContour Result;

private:
  const GridCrossing& CrossingOf(std::int64_t node, std::size_t axis) const
  {
    const auto before = [](const GridCrossing& a, const GridCrossing& b)
    { return a.Node != b.Node ? a.Node < b.Node : a.Axis < b.Axis; };
    GridCrossing wanted;
    wanted.Node = node;
    wanted.Axis = static_cast<int>(axis);
    const auto [first, last] =
      std::equal_range(this->Grid.Crossings.begin(), this->Grid.Crossings.end(), wanted, before);
    if (first == last)
    {
      throw std::runtime_error("The surface changes sides without a crossing between two nodes: it "
                               "is not closed, or passes right through nodes; move the grid.");
    }
    return first[(last - first) / 2];
  }

  Point3 PositionOf(const GridCrossing& crossing) const
  {
    const auto index = this->Cells.IndexOf(crossing.Node);
    Point3 p;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double more = static_cast<int>(a) == crossing.Axis ? crossing.Fraction : 0.0;
      p[a] = this->Grid.Shape.Spacing[a] * (static_cast<double>(index[a]) + more);
    }
    return p;
  }

  void PlacePointsOf(std::size_t c)
  {
    const std::int64_t cell = this->Cells.Active()[c];
    const auto& pieces = this->Cells.Pieces()[c];
    std::array<QuadraticErrors, 4> errors;
    int count = 0;
    for (std::size_t e = 0; e < CellEdges; ++e)
    {
      if (pieces[e] != DualCells::NoPiece)
      {
        const GridCrossing& crossing = this->CrossingOf(this->Cells.NodeOfEdge(cell, e), e / 4);
        errors[static_cast<std::size_t>(pieces[e])].Add(
          this->PositionOf(crossing), crossing.Normal);
        count = std::max(count, pieces[e] + 1);
      }
    }
    const auto index = this->Cells.IndexOf(cell);
    Bounds3 box;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double reach = this->Parameters.Reach;
      box.Min[a] = this->Grid.Shape.Spacing[a] * (static_cast<double>(index[a]) - reach);
      box.Max[a] = this->Grid.Shape.Spacing[a] * (static_cast<double>(index[a] + 1) + reach);
    }
    for (int piece = 0; piece < count; ++piece)
    {
      this->Result.Points[static_cast<std::size_t>(this->FirstPoint[c] + piece)] =
        errors[static_cast<std::size_t>(piece)].Least(box, this->Parameters.FeatureThreshold);
    }
  }

  /// The polygon around the edge along `axis` that begins at the lowest node of `cell`.
  void AddPolygonOf(std::int64_t cell, std::size_t axis)
  {
    const auto index = this->Cells.IndexOf(cell);
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (!this->Cells.IsCrossed(cell, axis) || index[u] == 0 || index[v] == 0)
    {
      return;
    }
    constexpr std::array<std::array<std::size_t, 2>, 4> around{ { { 1, 1 }, { 0, 1 }, { 0, 0 },
      { 1, 0 } } };
    std::array<std::int64_t, 4> polygon;
    for (std::size_t i = 0; i < 4; ++i)
    {
      auto other = index;
      other[u] -= static_cast<std::int64_t>(around[i][0]);
      other[v] -= static_cast<std::int64_t>(around[i][1]);
      const std::size_t c = this->Cells.Find(this->Cells.NodeOf(other));
      const std::size_t edge = 4 * axis + around[i][0] + 2 * around[i][1];
      polygon[i] = this->FirstPoint[c] + this->Cells.Pieces()[c][edge];
    }
    if (!this->Cells.IsInside(cell))
    {
      std::swap(polygon[1], polygon[3]);
    }
    if (this->Parameters.Triangles)
    {
      this->AddHalves(polygon, this->CrossingOf(cell, axis).Normal);
    }
    else
    {
      this->Result.Polygons.push_back(polygon);
    }
  }

  /// Cosine of the angle between triangle and `normal`; -1 for triangles without area.
  double Agreement(std::int64_t a, std::int64_t b, std::int64_t c, const Point3& normal) const
  {
    const auto at = [this](std::int64_t id)
    { return this->Result.Points[static_cast<std::size_t>(id)]; };
    const Point3 n = Cross(at(b) - at(a), at(c) - at(a));
    const double length = std::sqrt(Dot(n, n));
    return length > 0.0 ? Dot(n, normal) / length : -1.0;
  }

  void AddHalves(const std::array<std::int64_t, 4>& q, const Point3& normal)
  {
    const double first = std::min(
      this->Agreement(q[0], q[1], q[2], normal), this->Agreement(q[0], q[2], q[3], normal));
    const double second = std::min(
      this->Agreement(q[1], q[2], q[3], normal), this->Agreement(q[1], q[3], q[0], normal));
    if (first >= second)
    {
      this->Result.Polygons.push_back({ q[0], q[1], q[2], -1 });
      this->Result.Polygons.push_back({ q[0], q[2], q[3], -1 });
      return;
    }
    this->Result.Polygons.push_back({ q[1], q[2], q[3], -1 });
    this->Result.Polygons.push_back({ q[1], q[3], q[0], -1 });
  }

  const HermiteGrid& Grid;
  const DualContouringParameters& Parameters;
  const DualCells Cells;
  std::vector<std::int64_t> FirstPoint; ///< of each active cell
};

}

DualContour DualContouring(const HermiteGrid& grid, const DualContouringParameters& parameters,
  const ProgressCallback& progress)
{
  if (!(parameters.FeatureThreshold >= 0.0 && parameters.FeatureThreshold <= 1.0))
  {
    throw std::invalid_argument("The feature threshold must be from 0 to 1.");
  }
  if (!(parameters.Reach >= 0.0 && parameters.Reach <= 1.0))
  {
    throw std::invalid_argument("The reach of a vertex must be from 0 to 1 spacings.");
  }
  const auto& n = grid.Shape.Dimensions;
  if (n[0] < 2 || n[1] < 2 || n[2] < 2)
  {
    throw std::invalid_argument("The grid has fewer than two nodes along an axis.");
  }
  Contourer contourer(grid, parameters);
  Report(progress, 0.3);
  contourer.PlacePoints(Between(progress, 0.3, 0.8));
  contourer.AddPolygons();
  Report(progress, 1.0);
  return std::move(contourer.Result);
}

}
