#include "Contouring/ContourPlaces.h"

#include "Contouring/CellBox.h"
#include "Core/Geometry.h"

namespace isthmus
{

ContourPlaces::ContourPlaces(
  const HermiteGrid& grid, const DualCells& cells, const DualContouringParameters& parameters)
  : Grid(grid)
  , Cells(cells)
  , Parameters(parameters)
  , Features(grid.Sharp, grid.Shape)
{
}

bool ContourPlaces::IsEmpty(std::int64_t cell) const
{
  const auto& active = this->Cells.Active();
  const std::size_t place = this->Cells.Find(cell);
  return place == active.size() || active[place] != cell;
}

Point3 ContourPlaces::Inside(std::int64_t cell, const QuadraticErrors& planes) const
{
  const Bounds3 box =
    CellBox(this->Grid.Shape, this->Cells.IndexOf(cell), 1, this->Parameters.Reach);
  return planes.Least(box, this->Parameters.FeatureThreshold);
}

bool ContourPlaces::PassBy(const QuadraticErrors& planes, const Point3& x, double spacings) const
{
  const auto& h = this->Grid.Shape.Spacing;
  const double off = spacings * std::min({ h[0], h[1], h[2] });
  return planes.At(x) <= off * off * static_cast<double>(planes.NumberOfPlanes());
}

bool ContourPlaces::MeetOnEdge(const QuadraticErrors& planes, const Point3& x) const
{
  const int rank = planes.Rank(this->Parameters.FeatureThreshold);
  return rank > 1 && planes.NumberOfPlanes() > rank && this->PassBy(planes, x, 0.02);
}

ContourPlace ContourPlaces::Place(
  std::int64_t cell, const QuadraticErrors* pieces, std::size_t count, std::size_t i) const
{
  const QuadraticErrors& mine = pieces[i];
  const bool areKnown = !this->Grid.Sharp.Segments.empty();
  const Bounds3 around = CellBox(this->Grid.Shape, this->Cells.IndexOf(cell), 1, 1.0);
  const Point3 best = mine.Least(around, this->Parameters.FeatureThreshold);
  // Normals of triangles have no noise: where a blunt edge is known, they show the way to it.
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
      [&](const QuadraticErrors& other)
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
  take(this->Features.NearestCorner(cell, x, fitsBest));
  if (place)
  {
    return { *place, true };
  }
  take(this->Features.NearestOnEdge(cell, x, ContourFeatures::Part::Middle, fitsBest));
  if (edges != cell && edges >= 0)
  {
    take(this->IsEmpty(edges) ? this->Features.NearestCorner(edges, x, any) : std::nullopt);
    // An edge of another sheet would draw polygons through this one.
    const auto beside = this->Features.NearestOnEdge(edges, x, ContourFeatures::Part::Whole, any);
    take(beside && this->PassBy(mine, *beside, 0.05) ? beside : std::nullopt);
  }
  return { place.value_or(x), place.has_value() };
}

}
