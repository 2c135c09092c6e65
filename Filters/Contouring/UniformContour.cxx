#include "Contouring/UniformContour.h"

#include "Contouring/HermiteGrid.h"
#include "Contouring/QuadricError.h"
#include "Core/Geometry.h"
#include "Core/ParallelFor.h"

#include <numeric>
#include <stdexcept>

namespace isthmus
{

DualCells::DualCells(const HermiteGrid& grid)
  : Grid(grid)
  , Stride{ 1, grid.Shape.Dimensions[0], grid.Shape.Dimensions[0] * grid.Shape.Dimensions[1] }
{
  this->FindActive();
  constexpr int mostRounds = 8; // each pass flips faces of other cells than the previous one
  for (int round = 0; round < mostRounds; ++round)
  {
    this->PieceOfEdge.clear();
    for (const std::int64_t cell : this->Cells)
    {
      this->PieceOfEdge.push_back(this->GetPieces(cell));
    }
    if (!this->FlipDoubleFaces())
    {
      break;
    }
  }
}

DualCells::Index DualCells::GetIndex(std::int64_t node) const
{
  return { node % this->Stride[1], node % this->Stride[2] / this->Stride[1],
    node / this->Stride[2] };
}

std::int64_t DualCells::GetNode(const Index& i) const
{
  return i[0] + i[1] * this->Stride[1] + i[2] * this->Stride[2];
}

std::int64_t DualCells::NodeOfEdge(std::int64_t cell, DualEdge edge) const
{
  const std::size_t axis = edge.Value / 4;
  return cell + static_cast<std::int64_t>(edge.Value & 1) * this->Stride[(axis + 1) % 3] +
    static_cast<std::int64_t>(edge.Value >> 1 & 1) * this->Stride[(axis + 2) % 3];
}

std::size_t DualCells::Find(std::int64_t cell) const
{
  return static_cast<std::size_t>(
    std::lower_bound(this->Cells.begin(), this->Cells.end(), cell) - this->Cells.begin());
}

void DualCells::FindActive()
{
  const auto& n = this->Grid.Shape.Dimensions;
  for (std::int64_t k = 0; k + 1 < n[2]; ++k)
  {
    for (std::int64_t j = 0; j + 1 < n[1]; ++j)
    {
      for (std::int64_t i = 0; i + 1 < n[0]; ++i)
      {
        const std::int64_t cell = this->GetNode({ i, j, k });
        int inside = 0;
        for (std::size_t corner = 0; corner < 8; ++corner)
        {
          inside += this->IsInside(cell + static_cast<std::int64_t>(corner & 1) +
                      static_cast<std::int64_t>(corner >> 1 & 1) * this->Stride[1] +
                      static_cast<std::int64_t>(corner >> 2) * this->Stride[2])
            ? 1
            : 0;
        }
        if (inside > 0 && inside < 8)
        {
          this->Cells.push_back(cell);
        }
      }
    }
  }
}

DualCells::Face DualCells::GetFace(std::int64_t cell, std::size_t axis, std::size_t side) const
{
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  // Around the face: below, right, above, left.
  const std::array<std::size_t, 4> edges{ 4 * u + 2 * side, 4 * v + side + 2, 4 * u + 1 + 2 * side,
    4 * v + side };
  Face face{ {}, 0 };
  std::array<std::size_t, 4> crossed;
  for (const std::size_t edge : edges)
  {
    if (this->IsCrossed(this->NodeOfEdge(cell, DualEdge(edge)), edge / 4))
    {
      crossed[static_cast<std::size_t>(face.Crossed++)] = edge;
    }
  }
  if (face.Crossed == 2)
  {
    face.Pairs = { crossed[0], crossed[1], 0, 0 };
  }
  if (face.Crossed == 4)
  {
    const std::int64_t corner = cell + static_cast<std::int64_t>(side) * this->Stride[axis];
    const bool turned = this->Turned.count({ corner, axis }) > 0;
    // Whether the corner between left and below is cut off alone.
    face.Pairs = this->IsInside(corner) != turned
      ? std::array<std::size_t, 4>{ edges[3], edges[0], edges[1], edges[2] }
      : std::array<std::size_t, 4>{ edges[0], edges[1], edges[2], edges[3] };
  }
  return face;
}

std::array<signed char, CellEdges> DualCells::GetPieces(std::int64_t cell) const
{
  std::array<std::size_t, CellEdges> parent;
  std::iota(parent.begin(), parent.end(), std::size_t{ 0 });
  const auto root = [&parent](std::size_t e)
  {
    while (parent[e] != e)
    {
      e = parent[e];
    }
    return e;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const std::size_t side : { 0u, 1u })
    {
      const Face face = this->GetFace(cell, axis, side);
      for (int pair = 0; pair < face.Crossed / 2; ++pair)
      {
        const auto at = static_cast<std::size_t>(2 * pair);
        parent[root(face.Pairs[at])] = root(face.Pairs[at + 1]);
      }
    }
  }
  std::array<signed char, CellEdges> pieces, names;
  pieces.fill(NoPiece);
  names.fill(NoPiece);
  signed char next = 0;
  for (std::size_t e = 0; e < CellEdges; ++e)
  {
    if (this->IsCrossed(this->NodeOfEdge(cell, DualEdge(e)), e / 4))
    {
      signed char& name = names[root(e)];
      name = name == NoPiece ? next++ : name;
      pieces[e] = name;
    }
  }
  return pieces;
}

/// Turns faces over which two cells are joined twice; returns whether there were any.
bool DualCells::FlipDoubleFaces()
{
  bool any = false;
  for (std::size_t c = 0; c < this->Cells.size(); ++c)
  {
    const std::int64_t cell = this->Cells[c];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const Face face = this->GetFace(cell, axis, 0);
      if (face.Crossed != 4 || this->GetIndex(cell)[axis] == 0 ||
        this->Turned.count({ cell, axis }) > 0)
      {
        continue;
      }
      const auto& mine = this->PieceOfEdge[c];
      const auto& theirs = this->PieceOfEdge[this->Find(cell - this->Stride[axis])];
      const Face other = this->GetFace(cell - this->Stride[axis], axis, 1);
      if (mine[face.Pairs[0]] == mine[face.Pairs[2]] &&
        theirs[other.Pairs[0]] == theirs[other.Pairs[2]])
      {
        this->Turned.insert({ cell, axis });
        any = true;
      }
    }
  }
  return any;
}

VertexPlacement::VertexPlacement(
  const HermiteGrid& grid, const DualCells& cells, const DualContouringParameters& parameters)
  : Grid(grid)
  , Cells(cells)
  , Parameters(parameters)
  , Features(grid.Sharp, grid.Shape)
{
}

bool VertexPlacement::IsEmpty(std::int64_t cell) const
{
  const auto& active = this->Cells.Active();
  const std::size_t place = this->Cells.Find(cell);
  return place == active.size() || active[place] != cell;
}

Point3 VertexPlacement::Inside(std::int64_t cell, const QuadricError& planes) const
{
  const Bounds3 box =
    CellBox(this->Grid.Shape, this->Cells.GetIndex(cell), 1, this->Parameters.Reach);
  return planes.Least(box, this->Parameters.FeatureThreshold);
}

bool VertexPlacement::AllPassNear(
  const QuadricError& planes, const Point3& x, double spacings) const
{
  const auto& h = this->Grid.Shape.Spacing;
  const double off = spacings * std::min({ h[0], h[1], h[2] });
  return planes.At(x) <= off * off * static_cast<double>(planes.NumberOfPlanes());
}

bool VertexPlacement::MeetOnEdge(const QuadricError& planes, const Point3& x) const
{
  const int rank = planes.Rank(this->Parameters.FeatureThreshold);
  // More planes than always intersect: two always meet in a line, three in a point.
  return rank > 1 && planes.NumberOfPlanes() > rank && this->AllPassNear(planes, x, 0.02);
}

PlacedVertex VertexPlacement::Place(
  std::int64_t cell, const QuadricError* pieces, std::size_t count, std::size_t i) const
{
  const QuadricError& mine = pieces[i];
  const bool areKnown = !this->Grid.Sharp.Segments.empty();
  const Bounds3 around = CellBox(this->Grid.Shape, this->Cells.GetIndex(cell), 1, 1.0);
  const Point3 best = mine.Least(around, this->Parameters.FeatureThreshold);
  // Normals of triangles have no noise: near a known blunt edge, they point to it.
  constexpr double blunt = 0.01;
  const Point3 towards =
    areKnown ? mine.Least(around, std::min(blunt, this->Parameters.FeatureThreshold)) : best;
  const std::int64_t there = CellAt(this->Grid.Shape, best);
  const std::int64_t edges = CellAt(this->Grid.Shape, towards);
  const bool isEmpty = there != cell && there >= 0 && this->IsEmpty(there);
  const bool isOnEdge = there >= 0 && count == 1 && !areKnown && this->MeetOnEdge(mine, best);
  const Point3 x = there == cell || isEmpty || isOnEdge ? best : this->Inside(cell, mine);
  const auto fitsBest = [&](const Point3& p)
  {
    const double error = mine.At(p) / static_cast<double>(mine.NumberOfPlanes());
    return std::all_of(pieces, pieces + count,
      [&](const QuadricError& other)
      { return error <= other.At(p) / static_cast<double>(other.NumberOfPlanes()); });
  };
  const auto any = [](const Point3&) { return true; };
  std::optional<Point3> place;
  const auto take = [&](const std::optional<Point3>& candidate)
  {
    if (candidate && (!place || mine.At(*candidate) < mine.At(*place)))
    {
      place = candidate;
    }
  };
  // A corner takes precedence over an edge: the cell has only one point.
  take(this->Features.NearestCorner(cell, x, fitsBest));
  if (place)
  {
    return { *place, true };
  }
  take(this->Features.NearestOnEdge(cell, x, SharpFeatureGrid::Part::Middle, fitsBest));
  if (edges != cell && edges >= 0)
  {
    take(this->IsEmpty(edges) ? this->Features.NearestCorner(edges, x, any) : std::nullopt);
    // An edge of another sheet would draw polygons through this one.
    const auto beside = this->Features.NearestOnEdge(edges, x, SharpFeatureGrid::Part::Whole, any);
    take(beside && this->AllPassNear(mine, *beside, 0.05) ? beside : std::nullopt);
  }
  return { place.value_or(x), place.has_value() };
}

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
        this->Cells.GetIndex(this->Cells.Active()[c]));
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
          this->PlaceCellPoints(static_cast<std::size_t>(c));
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
  const GridCrossing& FindCrossing(std::int64_t node, std::size_t axis) const
  {
    const auto before = [](const GridCrossing& a, const GridCrossing& b)
    { return a.Node != b.Node ? a.Node < b.Node : a.Axis < b.Axis; };
    GridCrossing wanted;
    wanted.Node = node;
    wanted.Axis = static_cast<int>(axis);
    const auto [first, last] =
      std::equal_range(this->Grid.Crossings.begin(), this->Grid.Crossings.end(), wanted, before);
    // Inside tests and crossings are computed separately, so they may contradict at a node exactly
    // on the surface.
    if (first == last)
    {
      throw std::runtime_error("The surface changes sides without a crossing between two nodes: it "
                               "is not closed, or passes exactly through nodes; shift the grid.");
    }
    return first[(last - first) / 2];
  }

  Point3 ComputePosition(const GridCrossing& crossing, double offEnds) const
  {
    const auto index = this->Cells.GetIndex(crossing.Node);
    const double fraction = std::min(1.0 - offEnds, std::max(offEnds, crossing.Fraction));
    Point3 p;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double more = static_cast<int>(a) == crossing.Axis ? fraction : 0.0;
      p[a] = this->Grid.Shape.Spacing[a] * (static_cast<double>(index[a]) + more);
    }
    return p;
  }

  void PlaceCellPoints(std::size_t c)
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
          this->FindCrossing(this->Cells.NodeOfEdge(cell, DualEdge(e)), e / 4);
        planes[piece].push_back({ this->ComputePosition(crossing, 0.0), crossing.Normal });
        this->Result.Errors[first + piece].Add(planes[piece].back().Place, crossing.Normal);
        count = std::max(count, piece + 1);
      }
    }
    std::array<QuadricError, MostPieces> errors;
    const Bounds3 around = CellBox(this->Grid.Shape, this->Cells.GetIndex(cell), 1, 1.0);
    for (std::size_t i = 0; i < count; ++i)
    {
      // The triangles of a surface are flat, and its edges are known.
      errors[i] = this->Grid.Sharp.Segments.empty()
        ? FitQuadricError(planes[i], around, this->FeatureThreshold)
        : this->Result.Errors[first + i];
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const PlacedVertex place = this->Places.Place(cell, errors.data(), count, i);
      this->Result.Points[first + i] = place.At;
      this->Result.IsSharp[first + i] = place.IsSharp ? 1 : 0;
    }
  }

  /// Of coincident points, all but the first return to their cells.
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
        this->Places.Inside(this->Cells.GetNode(this->Result.Cells[i]), this->Result.Errors[i]);
      this->Result.IsSharp[i] = 0;
    }
  }

  /// The edge along `axis` that begins at the lowest node of `cell`.
  void AddEdge(std::int64_t cell, std::size_t axis)
  {
    const auto index = this->Cells.GetIndex(cell);
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (!this->Cells.IsCrossed(cell, axis) || index[u] == 0 || index[v] == 0)
    {
      return;
    }
    constexpr std::array<std::array<std::size_t, 2>, 4> around{ { { 1, 1 }, { 0, 1 }, { 0, 0 },
      { 1, 0 } } };
    const GridCrossing& crossing = this->FindCrossing(cell, axis);
    constexpr double offEnds = 1e-3; // no triangle at a crossing then has area 0
    UniformContour::Edge edge{ {}, this->ComputePosition(crossing, offEnds), crossing.Normal };
    for (std::size_t i = 0; i < 4; ++i)
    {
      auto other = index;
      other[u] -= static_cast<std::int64_t>(around[i][0]);
      other[v] -= static_cast<std::int64_t>(around[i][1]);
      const std::size_t c = this->Cells.Find(this->Cells.GetNode(other));
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
  const VertexPlacement Places;
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
