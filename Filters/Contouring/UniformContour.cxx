#include "Contouring/UniformContour.h"

#include "Contouring/CellBox.h"
#include "Contouring/ContourPlaces.h"
#include "Contouring/MeetingPlanes.h"
#include "Core/Geometry.h"
#include "Core/ParallelFor.h"

#include <numeric>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr std::size_t MostPieces = CellEdges / 3; // each crosses three edges or more

class Contourer
{
public:
  Contourer(const HermiteGrid& grid, const DualContouringParameters& parameters)
    : Grid(grid)
    , Cells(grid)
    , Places(grid, this->Cells, parameters)
    , FeatureThreshold(parameters.FeatureThreshold)
  {
    this->Result.Shape = grid.Shape;
    for (std::size_t c = 0; c < this->Cells.Active().size(); ++c)
    {
      const auto& pieces = this->Cells.Pieces()[c];
      this->FirstPoint.push_back(static_cast<std::int64_t>(this->Result.Cells.size()));
      this->Result.Cells.insert(this->Result.Cells.end(),
        static_cast<std::size_t>(1 + *std::max_element(pieces.begin(), pieces.end())),
        this->Cells.IndexOf(this->Cells.Active()[c]));
    }
    this->Result.Errors.resize(this->Result.Cells.size());
    this->Result.Points.resize(this->Result.Cells.size());
    this->Result.IsSharp.resize(this->Result.Cells.size());
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
    this->Part();
  }

  void AddEdges()
  {
    for (const std::int64_t cell : this->Cells.Active())
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        this->AddEdge(cell, axis);
      }
    }
  }

  UniformContour Result;

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

  Point3 PositionOf(const GridCrossing& crossing, double offEnds) const
  {
    const auto index = this->Cells.IndexOf(crossing.Node);
    const double fraction = std::min(1.0 - offEnds, std::max(offEnds, crossing.Fraction));
    Point3 p;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double more = static_cast<int>(a) == crossing.Axis ? fraction : 0.0;
      p[a] = this->Grid.Shape.Spacing[a] * (static_cast<double>(index[a]) + more);
    }
    return p;
  }

  void PlacePointsOf(std::size_t c)
  {
    const std::int64_t cell = this->Cells.Active()[c];
    const auto& pieces = this->Cells.Pieces()[c];
    const auto first = static_cast<std::size_t>(this->FirstPoint[c]);
    std::size_t count = 0;
    std::array<std::vector<TangentPlane>, MostPieces> planes;
    for (std::size_t e = 0; e < CellEdges; ++e)
    {
      if (pieces[e] != DualCells::NoPiece)
      {
        const std::size_t piece = static_cast<unsigned char>(pieces[e]);
        const GridCrossing& crossing =
          this->CrossingOf(this->Cells.NodeOfEdge(cell, DualEdge(e)), e / 4);
        planes[piece].push_back({ this->PositionOf(crossing, 0.0), crossing.Normal });
        this->Result.Errors[first + piece].Add(planes[piece].back().Place, crossing.Normal);
        count = std::max(count, piece + 1);
      }
    }
    std::array<QuadraticErrors, MostPieces> errors;
    const Bounds3 around = CellBox(this->Grid.Shape, this->Cells.IndexOf(cell), 1, 1.0);
    for (std::size_t i = 0; i < count; ++i)
    {
      // The triangles of a surface are flat, and its edges are known.
      errors[i] = this->Grid.Sharp.Segments.empty()
        ? MeetingPlanes(planes[i], around, this->FeatureThreshold)
        : this->Result.Errors[first + i];
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const ContourPlace place = this->Places.Place(cell, errors.data(), count, i);
      this->Result.Points[first + i] = place.At;
      this->Result.IsSharp[first + i] = place.IsSharp ? 1 : 0;
    }
  }

  /// Of points that went to the same place all but the first return to their cells.
  void Part()
  {
    std::vector<std::size_t> order(this->Result.Points.size());
    std::iota(order.begin(), order.end(), std::size_t{ 0 });
    const auto& points = this->Result.Points;
    std::stable_sort(order.begin(), order.end(),
      [&points](std::size_t a, std::size_t b) { return points[a] < points[b]; });
    std::vector<std::size_t> late;
    for (std::size_t i = 1; i < order.size(); ++i)
    {
      if (points[order[i]] == points[order[i - 1]])
      {
        late.push_back(order[i]);
      }
    }
    for (const std::size_t i : late)
    {
      this->Result.Points[i] =
        this->Places.Inside(this->Cells.NodeOf(this->Result.Cells[i]), this->Result.Errors[i]);
      this->Result.IsSharp[i] = 0;
    }
  }

  /// The edge along `axis` that begins at the lowest node of `cell`.
  void AddEdge(std::int64_t cell, std::size_t axis)
  {
    const auto index = this->Cells.IndexOf(cell);
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (!this->Cells.IsCrossed(cell, axis) || index[u] == 0 || index[v] == 0)
    {
      return;
    }
    constexpr std::array<std::array<std::size_t, 2>, 4> around{ { { 1, 1 }, { 0, 1 }, { 0, 0 },
      { 1, 0 } } };
    const GridCrossing& crossing = this->CrossingOf(cell, axis);
    constexpr double offEnds = 1e-3; // no triangle at a crossing then has area 0
    UniformContour::Edge edge{ {}, this->PositionOf(crossing, offEnds), crossing.Normal };
    for (std::size_t i = 0; i < 4; ++i)
    {
      auto other = index;
      other[u] -= static_cast<std::int64_t>(around[i][0]);
      other[v] -= static_cast<std::int64_t>(around[i][1]);
      const std::size_t c = this->Cells.Find(this->Cells.NodeOf(other));
      const std::size_t edgeThere = 4 * axis + around[i][0] + 2 * around[i][1];
      edge.Around[i] = this->FirstPoint[c] + this->Cells.Pieces()[c][edgeThere];
    }
    if (!this->Cells.IsInside(cell))
    {
      std::swap(edge.Around[1], edge.Around[3]);
    }
    this->Result.Edges.push_back(edge);
  }

  const HermiteGrid& Grid;
  const DualCells Cells;
  const ContourPlaces Places;
  const double FeatureThreshold;
  std::vector<std::int64_t> FirstPoint; ///< of each active cell
};

}

UniformContour MakeUniformContour(const HermiteGrid& grid,
  const DualContouringParameters& parameters, const ProgressCallback& progress)
{
  Contourer contourer(grid, parameters);
  contourer.PlacePoints(progress);
  contourer.AddEdges();
  return std::move(contourer.Result);
}

}
