/**
 * @file WayRound.h
 * @brief Shortest ways through a volume's complex, for the cycles round its tunnels.
 */
#ifndef isthmus_WayRound_h
#define isthmus_WayRound_h

#include "Persistence/CubicalGradient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace isthmus
{

/**
 * Shortest ways through the complex just before a node enters (Dijkstra, by cells: along edges and
 * across faces and cubes). Cost: the part of the volume within the length of the way.
 */
template <typename Gradient>
class WayRound
{
public:
  using Nodes = std::vector<std::int64_t>;

  WayRound(const Gradient& gradient, const std::array<double, 3>& spacing)
    : Cells(gradient)
  {
    for (std::size_t cell = 0; cell < 26; ++cell)
    {
      double squared = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double step = Star::Steps[cell][axis] * spacing[axis];
        squared += step * step;
      }
      this->Lengths[cell] = std::sqrt(squared);
    }
  }

  /// From the far end of an edge round to its node, which is the one that enters: nodes, both ends
  /// included. Empty where there is no way.
  Nodes Round(std::int64_t node, std::int64_t far)
  {
    return this->Find(far, node, node, std::numeric_limits<double>::infinity());
  }

  /// Between two nodes that were there before `latest`, if there is a way shorter than `limit`.
  Nodes Between(std::int64_t from, std::int64_t to, std::int64_t latest, double limit)
  {
    return this->Find(from, to, latest, limit);
  }

  double StepLength(StarCell cell) const { return this->Lengths[cell.Index()]; }

private:
  Nodes Find(std::int64_t from, std::int64_t to, std::int64_t latest, double limit)
  {
    this->Start = from;
    this->Goal = to;
    this->Latest = latest;
    this->Reached.clear();
    Open open;
    this->Offer(open, from, 0.0, from);
    while (!open.empty())
    {
      const auto [length, at] = open.top();
      open.pop();
      if (length >= limit)
      {
        break;
      }
      if (at == to)
      {
        return this->Trace();
      }
      if (length <= this->Reached[at].Length)
      {
        this->Spread(open, at, length);
      }
    }
    return {};
  }

  struct Visit
  {
    double Length;
    std::int64_t From;
  };
  using Entry = std::pair<double, std::int64_t>;
  using Open = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  void Offer(Open& open, std::int64_t node, double length, std::int64_t from)
  {
    const auto [visit, isNew] = this->Reached.try_emplace(node, Visit{ length, from });
    if (isNew || length < visit->second.Length)
    {
      visit->second = { length, from };
      open.push({ length, node });
    }
  }

  void Spread(Open& open, std::int64_t at, double length)
  {
    const LowerStars& stars = this->Cells.Lower();
    for (const StarCell cell : HandleRange<StarCell>(Star::Node))
    {
      if (!this->StaysInside(at, cell))
      {
        continue;
      }
      const std::int64_t next = at + stars.Offset(cell);
      // The last step is along another edge of the node; diagonals keep away from it, so that
      // they do not run along the edge itself.
      const bool arrives = next == this->Latest && next == this->Goal &&
        cell.Value < Star::FirstFace && at != this->Start;
      if (arrives || this->WasThere(at, cell))
      {
        this->Offer(open, next, length + this->StepLength(cell), at);
      }
    }
  }

  bool StaysInside(std::int64_t node, StarCell cell) const
  {
    const LowerStars& stars = this->Cells.Lower();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int64_t at = node / stars.Stride(axis) % stars.Dimensions()[axis];
      const std::int64_t to = at + Star::Steps[cell.Index()][axis];
      if (to < 0 || to >= stars.Dimensions()[axis])
      {
        return false;
      }
    }
    return true;
  }

  /// Whether all corners of the cell entered before the latest.
  bool WasThere(std::int64_t node, StarCell cell) const
  {
    const auto& step = Star::Steps[cell.Index()];
    for (int corner = 1; corner < 8; ++corner)
    {
      std::int64_t at = node;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        at += (corner >> axis & 1) != 0 ? step[axis] * this->Cells.Lower().Stride(axis) : 0;
      }
      if (!this->Cells.IsLater(this->Latest, at))
      {
        return false;
      }
    }
    return true;
  }

  Nodes Trace()
  {
    Nodes nodes{ this->Goal };
    while (nodes.back() != this->Start)
    {
      nodes.push_back(this->Reached[nodes.back()].From);
    }
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

  const Gradient& Cells;
  std::array<double, 26> Lengths{};
  std::int64_t Goal = 0;
  std::int64_t Start = 0;
  std::int64_t Latest = 0;
  std::unordered_map<std::int64_t, Visit> Reached;
};

}

#endif
