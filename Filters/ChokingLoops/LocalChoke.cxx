#include "ChokingLoops/LocalChoke.h"

#include "Core/Index.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>

namespace isthmus
{
namespace
{

using Path = std::vector<Point3>;

/// Tetrahedra that a path through a choke may pass; usually it ends after a few.
constexpr std::size_t LongestPath = 200;

/// Additions of points; usually one or two are enough.
constexpr int MostRounds = 6;

/// Points added in one round: those nearest to the path.
constexpr std::size_t MostAdded = 100;

Point3 CellCenter(const CellFiltration& f, TetrahedronId cell)
{
  const auto& t = f.Tetrahedra[cell];
  return Circumcenter(
    f.Points[At(t[0])], f.Points[At(t[1])], f.Points[At(t[2])], f.Points[At(t[3])]);
}

/// Appends the part of a path on one side of the choke; false if it does not end.
bool LeaveChoke(const FeatureContext& context, TriangleId choke, std::size_t side, Path& path)
{
  const CellFiltration& f = context.Filtration;
  const double radius2 = f.TriangleValue[choke];
  TriangleId triangle = choke;
  TetrahedronId cell = f.TriangleSides(choke)[side];
  std::set<TetrahedronId> passed;
  while (cell.Exists() && passed.size() < LongestPath && passed.insert(cell).second)
  {
    const auto& corners = f.Tetrahedra[cell];
    const Point3& sample = f.Points[At(f.TrianglePoints(triangle)[0])];
    const Point3 from = path.back();
    const Point3 to = CellCenter(f, cell);
    // All corners of the triangle are as far away from an edge of the Voronoi diagram.
    const auto isFar = [&](double part)
    {
      const Point3 d = from + part * (to - from) - sample;
      return Dot(d, d) >= radius2 + context.SquaredError(corners, Dot(d, d));
    };
    if (isFar(1.0))
    {
      double low = 0.0, high = 1.0;
      for (int step = 0; step < 20; ++step)
      {
        const double middle = 0.5 * (low + high);
        (isFar(middle) ? high : low) = middle;
      }
      path.push_back(from + high * (to - from));
      return true;
    }
    path.push_back(to);
    TriangleId best = TriangleId::None();
    for (std::size_t k = 0; k < 4; ++k)
    {
      const TriangleId next = f.GetTriangle(cell, k);
      if (next != triangle && (!best.Exists() || f.EntersLater(next, best)))
      {
        best = next;
      }
    }
    if (f.TriangleValue[best] < radius2)
    {
      return true; // the deepest place on this side
    }
    triangle = best;
    cell = f.Across(triangle, cell);
  }
  // Outside of all samples, or back in a deep place that was passed.
  return passed.size() < LongestPath;
}

/// The bottleneck of the widest path between two places.
struct Bottleneck
{
  double Radius;
  Point3 Center;
  Path Way;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel,
  CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Kernel>,
    CGAL::Triangulation_cell_base_with_info_3<double, Kernel>>>;
using Cell = Triangulation::Cell_handle;

Point3 ToPoint3(const Kernel::Point_3& p)
{
  return { p.x(), p.y(), p.z() };
}

/// Voronoi diagram of samples, restricted to a ball.
class Surroundings
{
public:
  Surroundings(const std::vector<Point3>& samples, const Point3& center, double radius)
    : Center(center)
    , Radius(radius)
  {
    this->Add(samples);
  }

  void Add(const std::vector<Point3>& samples)
  {
    std::vector<Kernel::Point_3> points;
    points.reserve(samples.size());
    for (const Point3& p : samples)
    {
      points.emplace_back(p[0], p[1], p[2]);
    }
    this->Delaunay.insert(points.begin(), points.end());
  }

  /// The widest path between two places: the search always continues through the widest triangle
  /// reached (as in Prim's algorithm).
  std::optional<Bottleneck> FindPath(const Point3& from, const Point3& to) const;

  /// The largest ball between the samples.
  std::optional<Bottleneck> FindLargest() const;

private:
  std::optional<Point3> CenterWithin(Cell cell) const;
  double SquaredWidth(Cell cell, int facet, const Point3& here, const Point3& next) const;
  Cell Nearest(const Point3& place) const;

  Triangulation Delaunay;
  Point3 Center;
  double Radius;
};

/// The circumcenter of a cell, if it lies in the ball.
std::optional<Point3> Surroundings::CenterWithin(Cell cell) const
{
  if (this->Delaunay.is_infinite(cell))
  {
    return std::nullopt;
  }
  const Point3 center =
    Circumcenter(ToPoint3(cell->vertex(0)->point()), ToPoint3(cell->vertex(1)->point()),
      ToPoint3(cell->vertex(2)->point()), ToPoint3(cell->vertex(3)->point()));
  return Distance(center, this->Center) <= this->Radius ? std::optional(center) : std::nullopt;
}

/// The smallest squared distance from the samples on the edge of the Voronoi diagram between the
/// circumcenters of two cells.
double Surroundings::SquaredWidth(
  Cell cell, int facet, const Point3& here, const Point3& next) const
{
  const Point3 a = ToPoint3(cell->vertex((facet + 1) % 4)->point());
  const Point3 middle = Circumcenter(a, ToPoint3(cell->vertex((facet + 2) % 4)->point()),
    ToPoint3(cell->vertex((facet + 3) % 4)->point()));
  const bool isBetween =
    Dot(middle - here, next - here) > 0.0 && Dot(middle - next, here - next) > 0.0;
  const auto square = [&a](const Point3& p) { return Dot(p - a, p - a); };
  return isBetween ? square(middle) : std::min(square(here), square(next));
}

/// The cell where a path from a place begins: of those around the nearest sample, whose
/// circumcenters are the corners of its Voronoi cell, the one whose corner is nearest, preferably
/// one that is farther from the sample than the place.
Cell Surroundings::Nearest(const Point3& place) const
{
  const auto vertex = this->Delaunay.nearest_vertex({ place[0], place[1], place[2] });
  const Point3 sample = ToPoint3(vertex->point());
  std::vector<Cell> around;
  this->Delaunay.finite_incident_cells(vertex, std::back_inserter(around));
  const Point3 away = place - sample;
  Cell best;
  double least = HUGE_VAL;
  for (const Cell cell : around)
  {
    if (const std::optional<Point3> center = this->CenterWithin(cell))
    {
      const double behind = Dot(*center - place, away) < 0.0 ? 4.0 : 1.0;
      const double apart = behind * Distance(*center, place);
      best = apart < least ? cell : best;
      least = std::min(least, apart);
    }
  }
  return best;
}

std::optional<Bottleneck> Surroundings::FindPath(const Point3& from, const Point3& to) const
{
  const Cell first = this->Nearest(from);
  const Cell last = this->Nearest(to);
  if (first == Cell() || last == Cell() || first == last)
  {
    return std::nullopt;
  }
  struct Step
  {
    double Width;
    std::size_t Number; ///< for a result that does not depend on addresses
    Cell Where, Before;
    Point3 Center;
    bool operator<(const Step& other) const
    {
      return this->Width != other.Width ? this->Width < other.Width : this->Number > other.Number;
    }
  };
  std::map<Cell, Step> done;
  std::priority_queue<Step> queue;
  std::size_t number = 0;
  queue.push({ HUGE_VAL, number++, first, Cell(), *this->CenterWithin(first) });
  while (!queue.empty() && done.count(last) == 0)
  {
    const Step step = queue.top();
    queue.pop();
    if (!done.emplace(step.Where, step).second)
    {
      continue;
    }
    for (int k = 0; k < 4; ++k)
    {
      const Cell next = step.Where->neighbor(k);
      if (done.count(next) == 0)
      {
        if (const std::optional<Point3> center = this->CenterWithin(next))
        {
          queue.push({ this->SquaredWidth(step.Where, k, step.Center, *center), number++, next,
            step.Where, *center });
        }
      }
    }
  }
  if (done.count(last) == 0)
  {
    return std::nullopt;
  }
  Bottleneck found{ HUGE_VAL, {}, {} };
  for (Cell cell = last; cell != Cell(); cell = done.at(cell).Before)
  {
    const Step& step = done.at(cell);
    found.Way.push_back(step.Center);
    if (step.Width < found.Radius)
    {
      found.Radius = step.Width;
      const int k = step.Before->index(cell);
      found.Center = Circumcenter(ToPoint3(step.Before->vertex((k + 1) % 4)->point()),
        ToPoint3(step.Before->vertex((k + 2) % 4)->point()),
        ToPoint3(step.Before->vertex((k + 3) % 4)->point()));
    }
  }
  found.Radius = std::sqrt(found.Radius);
  return found;
}

std::optional<Bottleneck> Surroundings::FindLargest() const
{
  std::optional<Bottleneck> found;
  for (auto cell = this->Delaunay.finite_cells_begin(); cell != this->Delaunay.finite_cells_end();
       ++cell)
  {
    if (const std::optional<Point3> center = this->CenterWithin(cell))
    {
      const double radius = Distance(*center, ToPoint3(cell->vertex(0)->point()));
      if (!found || radius > found->Radius)
      {
        found = Bottleneck{ radius, *center, { *center } };
      }
    }
  }
  return found;
}

/// The samples in a ball.
std::vector<Point3> SamplesIn(
  const std::vector<Point3>& samples, const Point3& center, double radius)
{
  std::vector<Point3> inside;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(inside),
    [&](const Point3& p) { return Dot(p - center, p - center) <= radius * radius; });
  return inside;
}

/**
 * Adds points of the surface that are nearer to the way than its bottleneck and finds it again with
 * `find`, until none is nearer by more than `tolerance`.
 */
template <typename Find>
std::optional<LocalChoke> Settle(const FineSurface& fine, Surroundings& around, Bottleneck found,
  double tolerance, const Find& find)
{
  const double most = found.Radius;
  std::set<SimplexId> added;
  for (int round = 0; round < MostRounds; ++round)
  {
    const auto near = fine.PointsNear(found.Way, found.Radius);
    double lower = found.Radius * found.Radius;
    for (const auto& [distance, p] : near)
    {
      const double own = fine.OwnErrorAt(p);
      lower = std::min(lower, distance * distance - own * own);
    }
    if (near.empty() || near.front().first >= (1.0 - tolerance) * found.Radius)
    {
      return LocalChoke{ found.Radius, std::sqrt(std::max(0.0, lower)), found.Center };
    }
    std::vector<Point3> more;
    // Samples that touch the ball are as far away as the radius, up to rounding.
    for (std::size_t i = 0; i < near.size() && more.size() < MostAdded &&
         near[i].first < (1.0 - 0.1 * tolerance) * found.Radius;
         ++i)
    {
      if (added.insert(near[i].second).second)
      {
        more.push_back(fine.Mesh().Points[At(near[i].second)]);
      }
    }
    around.Add(more);
    const std::optional<Bottleneck> next = more.empty() ? std::nullopt : find();
    if (!next)
    {
      return std::nullopt;
    }
    found = *next;
    found.Radius = std::min(found.Radius, most);
  }
  return std::nullopt;
}

}

std::optional<LocalChoke> FindLocalChoke(
  const FeatureContext& context, const FineSurface& fine, TriangleId choke, double tolerance)
{
  const CellFiltration& f = context.Filtration;
  const auto corners = f.TrianglePoints(choke);
  const Point3 center =
    Circumcenter(f.Points[At(corners[0])], f.Points[At(corners[1])], f.Points[At(corners[2])]);
  Path back{ center }, path{ center };
  if (!LeaveChoke(context, choke, 0, back) || !LeaveChoke(context, choke, 1, path))
  {
    return std::nullopt;
  }
  path.insert(path.begin(), back.rbegin(), back.rend() - 1);
  const Point3 from = path.front(), to = path.back();
  const double radius = std::sqrt(f.TriangleValue[choke]);
  double reach = 0.0;
  for (const Point3& p : path)
  {
    reach = std::max(reach, Distance(p, center));
  }
  reach += 0.25 * radius;
  // Places within `reach` of the center are no farther from the samples than radius + reach.
  Surroundings around(SamplesIn(f.Points, center, radius + 2.0 * reach), center, reach);
  return Settle(
    fine, around, { radius, center, path }, tolerance, [&] { return around.FindPath(from, to); });
}

std::optional<LocalChoke> FindLocalDeath(const FeatureContext& context, const FineSurface& fine,
  const Point3& center, double radius, double tolerance)
{
  constexpr double moved = 0.15;
  Surroundings around(SamplesIn(context.Filtration.Points, center, (1.0 + 2.0 * moved) * radius),
    center, moved * radius);
  return Settle(
    fine, around, { radius, center, { center } }, tolerance, [&] { return around.FindLargest(); });
}

}
