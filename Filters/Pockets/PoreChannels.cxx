#include "Pockets/PoreChannels.h"

#include "Core/Index.h"
#include "Core/NumberText.h"
#include "Persistence/FiltrationPairs.h"
#include "Pockets/CellProgress.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace isthmus
{
namespace
{

/// Loops around a channel last longer than those in rings of atoms; in angstrom.
constexpr double ShortestBar = 0.3;

/// Clearance of an edge at its value, as for triangles and tetrahedra.
double EdgeClearance(const RegularFiltration& f, EdgeId edge, double probe)
{
  const auto& e = f.Complex.Edges[edge];
  const double r = std::max(f.Radii[At(e[0])], f.Radii[At(e[1])]);
  return std::sqrt(std::max(0.0, f.Complex.EdgeValue[edge] + r * r)) - (r - probe);
}

/// A path out, which may be empty: where a triangle of the hull closes a channel.
struct CellPath
{
  std::vector<TetrahedronId> Cells;
  /// The triangle of the hull that it leaves through; None: a ball of EndRadius gets to its end.
  TriangleId Exit = TriangleId::None();
};

/// The tetrahedra from the one behind `start`, `cell`, on the widest path out, until a ball of
/// radius `end` gets there.
CellPath WidestPathOut(const CellFiltration& c, const CellAccessibility& access, TriangleId start,
  TetrahedronId cell, double end)
{
  CellPath path;
  path.Exit = start;
  while (cell.Exists())
  {
    path.Cells.push_back(cell);
    if (access.Access[cell] >= end)
    {
      path.Exit = TriangleId::None();
      break;
    }
    path.Exit = access.TowardsOutside[cell];
    cell = c.Across(path.Exit, cell);
  }
  return path;
}

bool AreDisjoint(const CellPath& a, const CellPath& b)
{
  const std::set<TetrahedronId> cells(a.Cells.begin(), a.Cells.end());
  return std::none_of(
    b.Cells.begin(), b.Cells.end(), [&](TetrahedronId cell) { return cells.count(cell) > 0; });
}

/// The unit normal of a triangle of the hull, outwards.
Point3 OutwardNormal(const RegularFiltration& f, TriangleId exit)
{
  const CellFiltration& c = f.Complex;
  const auto t = c.TrianglePoints(exit);
  const Point3& a = c.Points[At(t[0])];
  const Point3 n = Cross(c.Points[At(t[1])] - a, c.Points[At(t[2])] - a);
  const double length = Length(n);
  const auto sides = c.TriangleSides(exit);
  const TetrahedronId inner = sides[0].Exists() ? sides[0] : sides[1];
  const bool inwards = Dot(n, c.Points[At(c.Opposite(inner, t))] - a) > 0.0;
  return length > 0.0 ? (inwards ? -1.0 : 1.0) / length * n : Point3{ 0.0, 0.0, 0.0 };
}

/**
 * Centers along a path out, beginning with that of the triangle that closes the channel. Those of
 * flat tetrahedra at the border may lie anywhere outside: a step is no longer than five times the
 * channel's radius. Whether there are any of them at a flat side of the hull depends on the last
 * bits of the atoms' places, so a path that leaves through a triangle ends `beyond` it, measured
 * along its normal, in any case; if `beyond` is 0, in its plane and not farther.
 */
std::vector<Point3> CentersAlong(const RegularFiltration& f, const CellPath& path, double radius,
  const Point3& start, double beyond)
{
  const double longest = 5.0 * radius;
  std::vector<Point3> centers{ start };
  for (const TetrahedronId cell : path.Cells)
  {
    Point3 center = f.Centers[cell];
    const Point3 step = center - centers.back();
    const double length = Length(step);
    center = length > longest ? centers.back() + (longest / length) * step : center;
    centers.push_back(center);
  }
  if (path.Exit.Exists())
  {
    const Point3 normal = OutwardNormal(f, path.Exit);
    const Point3& on = f.Complex.Points[At(f.Complex.TrianglePoints(path.Exit)[0])];
    const auto height = [&](const Point3& p) { return Dot(p - on, normal); };
    while (beyond == 0.0 && centers.size() > 1 && height(centers.back()) > 0.0)
    {
      centers.pop_back();
    }
    // The distance from the last center to the end.
    const double lacks = beyond - height(centers.back());
    if (lacks > 0.0)
    {
      centers.push_back(centers.back() + lacks * normal);
    }
  }
  return centers;
}

/// The center of the circle that is orthogonal to the balls of a triangle, in its plane.
Point3 TriangleCenter(const RegularFiltration& f, const std::array<SimplexId, 3>& t)
{
  const Point3& a = f.Complex.Points[At(t[0])];
  const Point3 u = f.Complex.Points[At(t[1])] - a, v = f.Complex.Points[At(t[2])] - a;
  const auto square = [](double x) { return x * x; };
  const double r = square(f.Radii[At(t[0])]);
  // x = a + s u + q v with 2 x.u = |u|^2 + r^2 - r_1^2 and so on.
  const double uu = Dot(u, u), vv = Dot(v, v), uv = Dot(u, v);
  const double p = 0.5 * (uu + r - square(f.Radii[At(t[1])]));
  const double q = 0.5 * (vv + r - square(f.Radii[At(t[2])]));
  const double det = uu * vv - uv * uv;
  if (!(det > 1e-12 * uu * vv))
  {
    return (1.0 / 3.0) * (a + f.Complex.Points[At(t[1])] + f.Complex.Points[At(t[2])]);
  }
  return a + ((p * vv - q * uv) / det) * u + ((q * uu - p * uv) / det) * v;
}

/// Both paths as one, from the end of `a` to that of `b`, through the triangle between them.
Channel Join(const RegularFiltration& f, TriangleId triangle, const CellPath& a, const CellPath& b,
  double radius, double beyond)
{
  Channel channel;
  channel.Radius = radius;
  const Point3 start = TriangleCenter(f, f.Complex.TrianglePoints(triangle));
  channel.Path = CentersAlong(f, a, radius, start, beyond);
  std::reverse(channel.Path.begin(), channel.Path.end());
  channel.Narrowest = channel.From = channel.Path.size() - 1;
  const auto rest = CentersAlong(f, b, radius, start, beyond);
  channel.Path.insert(channel.Path.end(), rest.begin() + 1, rest.end());
  channel.Span = Length(channel.Path.front() - channel.Path.back());
  return channel;
}

/// The tetrahedron whose free space is nearest to a place.
TetrahedronId CellAt(
  const RegularFiltration& f, const CellAccessibility& access, const Point3& place)
{
  TetrahedronId best = TetrahedronId::None();
  double least = HUGE_VAL;
  for (const TetrahedronId cell : f.Centers.Keys())
  {
    const double distance = Length(f.Centers[cell] - place) - 0.5 * access.CellClearance[cell];
    if (access.CellClearance[cell] > 0.0 && distance < least)
    {
      least = distance;
      best = cell;
    }
  }
  return best;
}

double DistanceToLine(const Point3& p, const Point3& a, const Point3& b)
{
  const Point3 d = b - a;
  const double t = std::clamp(Dot(p - a, d) / Dot(d, d), 0.0, 1.0);
  return Length(p - (a + t * d));
}

/// A path that has reached `Cell` at some cost.
struct Step
{
  double Cost;
  TetrahedronId Cell;
  TetrahedronId From;

  bool operator<(const Step& other) const
  {
    return this->Cost != other.Cost ? this->Cost > other.Cost : this->Cell > other.Cell;
  }
};

/// A tetrahedron of a crystal, moved by whole cells.
using MovedCell = std::pair<TetrahedronId, CellShift>;

struct HashOfMovedCell
{
  std::size_t operator()(const MovedCell& cell) const
  {
    std::size_t hash = cell.first.Index();
    for (const int shift : cell.second)
    {
      hash = 1000003 * hash + static_cast<std::size_t>(shift + 1000);
    }
    return hash;
  }
};

/// A path that has reached `Cell` at some cost, from the tetrahedron `From` through its face
/// opposite to `Corner`.
struct MovedStep
{
  double Cost;
  MovedCell Cell;
  MovedCell From;
  std::size_t Corner;

  bool operator<(const MovedStep& other) const
  {
    return this->Cost != other.Cost ? this->Cost > other.Cost : this->Cell > other.Cell;
  }
};

/// The center of a face's circle, in the stored copy of the tetrahedron; none if the face is
/// attached: then it is not narrower than the space on both sides of it.
std::optional<Point3> FaceCenter(const PeriodicSpace& space, const PeriodicFace& face)
{
  const RegularFiltration& f = space.Filtration;
  const auto& t = f.Complex.Tetrahedra[face.Cell];
  const Point3 center = TriangleCenter(
    f, { t[(face.Corner + 1) % 4], t[(face.Corner + 2) % 4], t[(face.Corner + 3) % 4] });
  const auto corner = At(t[(face.Corner + 1) % 4]);
  const Point3 d = center - f.Complex.Points[corner];
  const double power = Dot(d, d) - f.Radii[corner] * f.Radii[corner];
  // The values of copies differ by rounding.
  constexpr double rounding = 1e-7; // angstrom^2
  const bool isAttached =
    power < f.Complex.TriangleValue[space.Faces[face.Cell][face.Corner]] - rounding;
  return isAttached ? std::nullopt : std::optional<Point3>(center);
}

}

std::vector<Point3> PathAlongCell(
  const PeriodicSpace& space, std::size_t axis, const ProgressCallback& progress)
{
  const RegularFiltration& f = space.Filtration;
  const CellFiltration& c = f.Complex;
  const PeriodicCell& cell = space.Cell;
  const PeriodicPassage& passage = space.Passages[axis];
  if (!(passage.Radius > 0.0))
  {
    return {};
  }
  const auto center = [&](const MovedCell& at)
  { return f.Centers[at.first] + cell.Vector(at.second); };
  const MovedCell first(passage.Narrowest.Cell, NoCellShift);
  std::unordered_map<MovedCell, MovedStep, HashOfMovedCell> reached;
  reached.emplace(first, MovedStep{ 0.0, first, first, 0 });
  std::priority_queue<MovedStep> steps;
  const auto leave = [&](const MovedCell& from, std::size_t corner, double cost)
  {
    const MovedCell next(
      c.Neighbours[from.first][corner], Add(from.second, space.Steps[from.first][corner]));
    const double width = space.Access.TriangleClearance[space.Faces[from.first][corner]];
    if (width >= passage.Radius && reached.count(next) == 0)
    {
      const double length = Length(center(next) - center(from));
      steps.push({ cost + (length + 1e-6) / (width * width), next, from, corner });
    }
  };
  leave(first, passage.Narrowest.Corner, 0.0);
  const auto isGoal = [&](const MovedCell& at)
  {
    return at.first == first.first && at.second[axis] != 0 && at.second[(axis + 1) % 3] == 0 &&
      at.second[(axis + 2) % 3] == 0;
  };
  MovedCell last = first;
  while (!isGoal(last) && !steps.empty())
  {
    const MovedStep step = steps.top();
    steps.pop();
    if (!reached.emplace(step.Cell, step).second)
    {
      continue;
    }
    ReportCells(progress, reached.size(), std::max(reached.size(), f.Centers.size()));
    last = step.Cell;
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      leave(step.Cell, corner, step.Cost);
    }
  }
  if (!isGoal(last))
  {
    return {};
  }
  const std::optional<Point3> narrow = FaceCenter(space, passage.Narrowest);
  std::vector<Point3> path;
  if (narrow)
  {
    path.push_back(*narrow + cell.Vector(last.second));
  }
  path.push_back(center(last));
  for (MovedCell at = last; at != first;)
  {
    const MovedStep& step = reached.at(at);
    at = step.From;
    const std::optional<Point3> between =
      at == first ? narrow : FaceCenter(space, { at.first, step.Corner });
    if (between)
    {
      path.push_back(*between + cell.Vector(at.second));
    }
    if (at != first || !narrow)
    {
      path.push_back(center(at));
    }
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<Channel> FindChannels(RegularFiltration& f, const CellAccessibility& access,
  double probe, const PoreOptions& options, const ProgressCallback& progress)
{
  CellFiltration& c = f.Complex;
  c.Order(Between(progress, 0.0, 0.3));
  const FiltrationPairs pairs(c, Between(progress, 0.3, 0.9));
  std::vector<Channel> channels;
  const ProgressCallback triangles = Between(progress, 0.9, 1.0);
  for (const TriangleId t : c.Triangles())
  {
    ReportCells(triangles, t.Index(), c.TriangleCount());
    const double radius = access.TriangleClearance[t];
    const EdgeId edge = pairs.LoopClosed(t);
    const auto sides = c.TriangleSides(t);
    if (!edge.Exists() || radius < options.MinimumRadius ||
      radius - EdgeClearance(f, edge, probe) < ShortestBar)
    {
      continue;
    }
    const auto isNarrower = [&](TetrahedronId side)
    { return side.Exists() && access.Access[side] < options.MinimumRadius; };
    if (isNarrower(sides[0]) || isNarrower(sides[1]))
    {
      continue; // on the way to it
    }
    // A channel wider than EndRadius ends where it leaves the convex hull.
    const bool isWide = radius >= options.EndRadius;
    const double end = isWide ? HUGE_VAL : options.EndRadius;
    // Paths out may be long, and channels many.
    Report(triangles, static_cast<double>(t.Index()) / static_cast<double>(c.TriangleCount()));
    const auto first = WidestPathOut(c, access, t, sides[0], end);
    const auto second = WidestPathOut(c, access, t, sides[1], end);
    if (!AreDisjoint(first, second))
    {
      continue;
    }
    // At this distance from the hull, no atom is nearer than EndRadius.
    const double beyond =
      options.EndRadius + *std::max_element(f.Radii.begin(), f.Radii.end()) - probe;
    Channel channel = Join(f, t, first, second, radius, isWide ? 0.0 : beyond);
    channel.IsWide = isWide;
    if (channel.Span >= options.MinimumSpan)
    {
      channels.push_back(std::move(channel));
    }
  }
  std::stable_sort(channels.begin(), channels.end(),
    [](const Channel& a, const Channel& b) { return a.Span > b.Span; });
  channels.resize(std::min(channels.size(), static_cast<std::size_t>(options.MaximumPores)));
  return channels;
}

Channel PathBetween(const RegularFiltration& f, const FacesByCell& faces,
  const CellAccessibility& access, const Point3& first, const Point3& last,
  const PoreOptions& options, const ProgressCallback& progress)
{
  const TetrahedronId start = CellAt(f, access, first);
  const TetrahedronId goal = CellAt(f, access, last);
  constexpr TetrahedronId unmet(-2);
  HandleVector<TetrahedronId, TetrahedronId> from(f.Centers.size(), unmet);
  std::priority_queue<Step> steps;
  std::size_t reached = 0;
  if (start.Exists())
  {
    steps.push({ 0.0, start, TetrahedronId::None() });
  }
  while (!steps.empty() && from[goal] == unmet)
  {
    const Step step = steps.top();
    steps.pop();
    if (from[step.Cell] != unmet)
    {
      continue;
    }
    from[step.Cell] = step.From;
    ReportCells(progress, reached++, f.Centers.size());
    for (const TriangleId face : faces[step.Cell])
    {
      const TetrahedronId next = f.Complex.Across(face, step.Cell);
      const double width = access.TriangleClearance[face];
      if (!next.Exists() || from[next] != unmet || width <= 0.0 ||
        (next != goal && DistanceToLine(f.Centers[next], first, last) > options.MaximumOffset))
      {
        continue;
      }
      const double length = Length(f.Centers[next] - f.Centers[step.Cell]);
      steps.push({ step.Cost + (length + 1e-6) / (width * width), next, step.Cell });
    }
  }
  if (!start.Exists() || from[goal] == unmet)
  {
    throw std::runtime_error(
      "There is no path between the two points that stays within MaximumOffset, " +
      FormatNumber(options.MaximumOffset) +
      " angstrom, of the straight line: choose points in the pore, or a larger MaximumOffset.");
  }
  Channel channel;
  for (TetrahedronId cell = goal; cell.Exists(); cell = from[cell])
  {
    channel.Path.push_back(f.Centers[cell]);
  }
  std::reverse(channel.Path.begin(), channel.Path.end());
  channel.Span = Length(first - last);
  return channel;
}

}
