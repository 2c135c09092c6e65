#include "PoreChannels.h"

#include "FiltrationPairs.h"
#include "Index.h"

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
double EdgeClearance(const RegularFiltration& f, SimplexId edge, double probe)
{
  const auto& e = f.Complex.Edges[At(edge)];
  const double r = std::max(f.Radii[At(e[0])], f.Radii[At(e[1])]);
  return std::sqrt(std::max(0.0, f.Complex.EdgeValue[At(edge)] + r * r)) - (r - probe);
}

/// The tetrahedra from `cell` on the widest way out, until a ball of radius `end` gets there.
std::vector<SimplexId> WayOut(
  const CellFiltration& c, const CellAccess& access, SimplexId cell, double end)
{
  std::vector<SimplexId> way;
  while (cell >= 0)
  {
    way.push_back(cell);
    if (access.Access[At(cell)] >= end)
    {
      break;
    }
    cell = Across(c, access.TowardsOut[At(cell)], cell);
  }
  return way;
}

bool AreDisjoint(const std::vector<SimplexId>& a, const std::vector<SimplexId>& b)
{
  const std::set<SimplexId> cells(a.begin(), a.end());
  return std::none_of(b.begin(), b.end(), [&](SimplexId cell) { return cells.count(cell) > 0; });
}

/// Centres along a way out. Those of flat tetrahedra at the border may lie anywhere outside: a
/// step is no longer than five times the channel's radius.
std::vector<Point3> CentresAlong(
  const RegularFiltration& f, const std::vector<SimplexId>& way, double radius)
{
  const double longest = 5.0 * radius;
  std::vector<Point3> centres;
  for (const SimplexId cell : way)
  {
    Point3 centre = f.Centres[At(cell)];
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

/// Both ways as one, from the end of `a` to that of `b`.
Channel Join(const RegularFiltration& f, const std::vector<SimplexId>& a,
  const std::vector<SimplexId>& b, double radius)
{
  Channel channel;
  channel.Radius = radius;
  channel.Way = CentresAlong(f, a, radius);
  std::reverse(channel.Way.begin(), channel.Way.end());
  channel.Narrowest = channel.Way.size() - 1;
  const auto rest = CentresAlong(f, b, radius);
  channel.Way.insert(channel.Way.end(), rest.begin(), rest.end());
  channel.Span = Length(channel.Way.front() - channel.Way.back());
  return channel;
}

/// The tetrahedron whose free room is nearest to a place.
SimplexId CellAt(const RegularFiltration& f, const CellAccess& access, const Point3& place)
{
  SimplexId best = -1;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < f.Centres.size(); ++i)
  {
    const double distance = Length(f.Centres[i] - place) - 0.5 * access.CellClearance[i];
    if (access.CellClearance[i] > 0.0 && distance < least)
    {
      least = distance;
      best = static_cast<SimplexId>(i);
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

/// A way that has come to `Cell` at some cost.
struct Step
{
  double Cost;
  SimplexId Cell;
  SimplexId From;

  bool operator<(const Step& other) const
  {
    return this->Cost != other.Cost ? this->Cost > other.Cost : this->Cell > other.Cell;
  }
};

}

std::vector<Channel> FindChannels(RegularFiltration& f, const CellAccess& access, double probe,
  const PoreOptions& options, const ProgressCallback& progress)
{
  CellFiltration& c = f.Complex;
  c.Order(Between(progress, 0.0, 0.3));
  const FiltrationPairs pairs(c, Between(progress, 0.3, 0.9));
  std::vector<Channel> channels;
  for (std::size_t i = 0; i < c.TriangleCount(); ++i)
  {
    const double radius = access.TriangleClearance[i];
    const SimplexId edge = pairs.LoopClosed(static_cast<SimplexId>(i));
    const auto sides = c.TriangleSides(i);
    if (edge < 0 || radius < options.MinimumRadius || sides[0] < 0 || sides[1] < 0 ||
      radius - EdgeClearance(f, edge, probe) < ShortestBar)
    {
      continue;
    }
    if (std::min(access.Access[At(sides[0])], access.Access[At(sides[1])]) < options.MinimumRadius)
    {
      continue; // narrower on the way to it
    }
    // A channel wider than EndRadius ends where it leaves the convex hull.
    const bool isWide = radius >= options.EndRadius;
    const double end = isWide ? HUGE_VAL : options.EndRadius;
    const auto first = WayOut(c, access, sides[0], end);
    const auto second = WayOut(c, access, sides[1], end);
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

Channel WayBetween(const RegularFiltration& f, const std::vector<std::array<SimplexId, 4>>& faces,
  const CellAccess& access, const Point3& first, const Point3& last, const PoreOptions& options)
{
  const SimplexId start = CellAt(f, access, first);
  const SimplexId goal = CellAt(f, access, last);
  std::vector<SimplexId> from(f.Centres.size(), -2);
  std::priority_queue<Step> steps;
  if (start >= 0)
  {
    steps.push({ 0.0, start, -1 });
  }
  while (!steps.empty() && from[At(goal)] == -2)
  {
    const Step step = steps.top();
    steps.pop();
    if (from[At(step.Cell)] != -2)
    {
      continue;
    }
    from[At(step.Cell)] = step.From;
    for (const SimplexId face : faces[At(step.Cell)])
    {
      const SimplexId next = Across(f.Complex, face, step.Cell);
      const double width = access.TriangleClearance[At(face)];
      if (next < 0 || from[At(next)] != -2 || width <= 0.0 ||
        (next != goal && FromLine(f.Centres[At(next)], first, last) > options.MaximumOffset))
      {
        continue;
      }
      const double length = Length(f.Centres[At(next)] - f.Centres[At(step.Cell)]);
      steps.push({ step.Cost + (length + 1e-6) / (width * width), next, step.Cell });
    }
  }
  if (start < 0 || from[At(goal)] == -2)
  {
    throw std::runtime_error("There is no way between the two points that stays within "
                             "MaximumOffset, " +
      std::to_string(options.MaximumOffset) +
      " angstrom, of the straight line: choose points in the pore, or a larger offset.");
  }
  Channel channel;
  for (SimplexId cell = goal; cell >= 0; cell = from[At(cell)])
  {
    channel.Way.push_back(f.Centres[At(cell)]);
  }
  std::reverse(channel.Way.begin(), channel.Way.end());
  channel.Span = Length(first - last);
  return channel;
}

}
