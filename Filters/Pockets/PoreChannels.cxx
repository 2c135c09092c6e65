#include "Pockets/PoreChannels.h"

#include "Core/Index.h"
#include "Core/NumberText.h"
#include "Persistence/FiltrationPairs.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <set>
#include <stdexcept>

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

using CellPath = std::vector<TetrahedronId>;

/// The tetrahedra from `cell` on the widest path out, until a ball of radius `end` gets there.
CellPath WidestPathOut(
  const CellFiltration& c, const CellAccessibility& access, TetrahedronId cell, double end)
{
  CellPath path;
  while (cell.Exists())
  {
    path.push_back(cell);
    if (access.Access[cell] >= end)
    {
      break;
    }
    cell = c.Across(access.TowardsOutside[cell], cell);
  }
  return path;
}

bool AreDisjoint(const CellPath& a, const CellPath& b)
{
  const std::set<TetrahedronId> cells(a.begin(), a.end());
  return std::none_of(
    b.begin(), b.end(), [&](TetrahedronId cell) { return cells.count(cell) > 0; });
}

/// Centres along a path out. Those of flat tetrahedra at the border may lie anywhere outside: a
/// step is no longer than five times the channel's radius.
std::vector<Point3> CentresAlong(const RegularFiltration& f, const CellPath& path, double radius)
{
  const double longest = 5.0 * radius;
  std::vector<Point3> centres;
  for (const TetrahedronId cell : path)
  {
    Point3 centre = f.Centres[cell];
    if (!centres.empty())
    {
      const Point3 step = centre - centres.back();
      const double length = Length(step);
      centre = length > longest ? centres.back() + (longest / length) * step : centre;
    }
    centres.push_back(centre);
  }
  return centres;
}

/// Both paths as one, from the end of `a` to that of `b`.
Channel Join(const RegularFiltration& f, const CellPath& a, const CellPath& b, double radius)
{
  Channel channel;
  channel.Radius = radius;
  channel.Path = CentresAlong(f, a, radius);
  std::reverse(channel.Path.begin(), channel.Path.end());
  channel.Narrowest = channel.Path.size() - 1;
  const auto rest = CentresAlong(f, b, radius);
  channel.Path.insert(channel.Path.end(), rest.begin(), rest.end());
  channel.Span = Length(channel.Path.front() - channel.Path.back());
  return channel;
}

/// The tetrahedron whose free room is nearest to a place.
TetrahedronId CellAt(
  const RegularFiltration& f, const CellAccessibility& access, const Point3& place)
{
  TetrahedronId best = TetrahedronId::None();
  double least = HUGE_VAL;
  for (const TetrahedronId cell : f.Centres.Keys())
  {
    const double distance = Length(f.Centres[cell] - place) - 0.5 * access.CellClearance[cell];
    if (access.CellClearance[cell] > 0.0 && distance < least)
    {
      least = distance;
      best = cell;
    }
  }
  return best;
}

double FromLine(const Point3& p, const Point3& a, const Point3& b)
{
  const Point3 d = b - a;
  const double t = std::clamp(Dot(p - a, d) / Dot(d, d), 0.0, 1.0);
  return Length(p - (a + t * d));
}

/// A path that has come to `Cell` at some cost.
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

}

std::vector<Channel> FindChannels(RegularFiltration& f, const CellAccessibility& access,
  double probe, const PoreOptions& options, const ProgressCallback& progress)
{
  CellFiltration& c = f.Complex;
  c.Order(Between(progress, 0.0, 0.3));
  const FiltrationPairs pairs(c, Between(progress, 0.3, 0.9));
  std::vector<Channel> channels;
  for (const TriangleId t : c.Triangles())
  {
    const double radius = access.TriangleClearance[t];
    const EdgeId edge = pairs.LoopClosed(t);
    const auto sides = c.TriangleSides(t);
    if (!edge.Exists() || radius < options.MinimumRadius || !sides[0].Exists() ||
      !sides[1].Exists() || radius - EdgeClearance(f, edge, probe) < ShortestBar)
    {
      continue;
    }
    if (std::min(access.Access[sides[0]], access.Access[sides[1]]) < options.MinimumRadius)
    {
      continue; // narrower on the way to it
    }
    // A channel wider than EndRadius ends where it leaves the convex hull.
    const bool isWide = radius >= options.EndRadius;
    const double end = isWide ? HUGE_VAL : options.EndRadius;
    const auto first = WidestPathOut(c, access, sides[0], end);
    const auto second = WidestPathOut(c, access, sides[1], end);
    if (!AreDisjoint(first, second))
    {
      continue;
    }
    Channel channel = Join(f, first, second, radius);
    channel.IsWide = isWide;
    if (channel.Span >= options.MinimumSpan)
    {
      channels.push_back(std::move(channel));
    }
  }
  std::stable_sort(channels.begin(), channels.end(),
    [](const Channel& a, const Channel& b) { return a.Span > b.Span; });
  channels.resize(std::min(channels.size(), options.MaximumPores));
  return channels;
}

Channel PathBetween(const RegularFiltration& f, const FacesByCell& faces,
  const CellAccessibility& access, const Point3& first, const Point3& last,
  const PoreOptions& options)
{
  const TetrahedronId start = CellAt(f, access, first);
  const TetrahedronId goal = CellAt(f, access, last);
  constexpr TetrahedronId unmet(-2);
  HandleVector<TetrahedronId, TetrahedronId> from(f.Centres.size(), unmet);
  std::priority_queue<Step> steps;
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
    for (const TriangleId face : faces[step.Cell])
    {
      const TetrahedronId next = f.Complex.Across(face, step.Cell);
      const double width = access.TriangleClearance[face];
      if (!next.Exists() || from[next] != unmet || width <= 0.0 ||
        (next != goal && FromLine(f.Centres[next], first, last) > options.MaximumOffset))
      {
        continue;
      }
      const double length = Length(f.Centres[next] - f.Centres[step.Cell]);
      steps.push({ step.Cost + (length + 1e-6) / (width * width), next, step.Cell });
    }
  }
  if (!start.Exists() || from[goal] == unmet)
  {
    throw std::runtime_error("There is no way between the two points that stays within "
                             "MaximumOffset, " +
      FormatNumber(options.MaximumOffset) +
      " angstrom, of the straight line: choose points in the pore, or a larger offset.");
  }
  Channel channel;
  for (TetrahedronId cell = goal; cell.Exists(); cell = from[cell])
  {
    channel.Path.push_back(f.Centres[cell]);
  }
  std::reverse(channel.Path.begin(), channel.Path.end());
  channel.Span = Length(first - last);
  return channel;
}

}
