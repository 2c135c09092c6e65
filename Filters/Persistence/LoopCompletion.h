/**
 * @file LoopCompletion.h
 * @brief Closes a reduced column, from which edges that join components were left out.
 */
#ifndef isthmus_LoopCompletion_h
#define isthmus_LoopCompletion_h

#include "Persistence/CubicalGradient.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace isthmus
{

/**
 * The edges that join components are a spanning tree of the grid: gradient paths down to minima,
 * and critical edges between these. What is missing from a column is the only set of them that
 * makes its ends meet, and it lies below the column.
 */
template <typename Gradient>
class LoopCompletion
{
public:
  using Key = typename Gradient::Key;
  using Nodes = std::vector<std::int64_t>;

  LoopCompletion(
    const Gradient& gradient, const std::vector<Key>& edges, const std::vector<char>& negative)
    : Cells(gradient)
    , Edges(edges)
    , Negative(negative)
  {
  }

  /// Closed ways that together run along the column and what it lacks.
  std::vector<Nodes> Close(const std::vector<Key>& column)
  {
    if (this->Above.empty())
    {
      this->MakeTree();
    }
    this->Chain.clear();
    std::set<std::int64_t> odd;
    for (const Key& edge : column)
    {
      const auto ends = this->Cells.EndsOf(edge);
      this->ToggleEdge(ends[0], ends[1]);
      Toggle(odd, ends[0]);
      Toggle(odd, ends[1]);
    }
    for (const std::int64_t node : odd)
    {
      this->ToggleWayToRoot(node);
    }
    return this->TakeLoops();
  }

private:
  struct Link
  {
    std::int64_t Minimum; ///< towards the root
    std::size_t Edge;     ///< number of the critical edge between
  };

  template <typename T>
  static void Toggle(std::set<T>& set, const T& member)
  {
    if (!set.insert(member).second)
    {
      set.erase(member);
    }
  }

  void ToggleEdge(std::int64_t a, std::int64_t b)
  {
    Toggle(this->Chain, std::make_pair(std::min(a, b), std::max(a, b)));
  }

  std::int64_t Below(std::int64_t node) const
  {
    const int edge = this->Cells.Lower()[node].Partner[Star::Node];
    return edge == Star::Node ? node : node + this->Cells.Lower().Offset(StarCell(edge));
  }

  std::int64_t MinimumOf(std::int64_t node) const
  {
    for (std::int64_t next = this->Below(node); next != node; next = this->Below(node))
    {
      node = next;
    }
    return node;
  }

  /// Descends from `node` to its minimum, toggling the way.
  std::int64_t ToggleDescent(std::int64_t node)
  {
    for (std::int64_t next = this->Below(node); next != node; next = this->Below(node))
    {
      this->ToggleEdge(node, next);
      node = next;
    }
    return node;
  }

  void ToggleWayToRoot(std::int64_t node)
  {
    std::int64_t minimum = this->ToggleDescent(node);
    for (auto link = this->Above.find(minimum); link->second.Minimum >= 0;
         link = this->Above.find(minimum))
    {
      const auto ends = this->Cells.EndsOf(this->Edges[link->second.Edge]);
      this->ToggleEdge(ends[0], ends[1]);
      this->ToggleDescent(ends[0]);
      this->ToggleDescent(ends[1]);
      minimum = link->second.Minimum;
    }
  }

  void MakeTree()
  {
    std::map<std::int64_t, std::vector<Link>> neighbours;
    for (std::size_t i = 0; i < this->Edges.size(); ++i)
    {
      if (this->Negative[i])
      {
        const auto ends = this->Cells.EndsOf(this->Edges[i]);
        const std::int64_t a = this->MinimumOf(ends[0]);
        const std::int64_t b = this->MinimumOf(ends[1]);
        neighbours[a].push_back({ b, i });
        neighbours[b].push_back({ a, i });
      }
    }
    const std::int64_t root = this->MinimumOf(0);
    this->Above[root] = { -1, 0 };
    Nodes open{ root };
    while (!open.empty())
    {
      const std::int64_t minimum = open.back();
      open.pop_back();
      for (const Link& link : neighbours[minimum])
      {
        if (this->Above.try_emplace(link.Minimum, Link{ minimum, link.Edge }).second)
        {
          open.push_back(link.Minimum);
        }
      }
    }
  }

  /// Takes closed ways off the chain until nothing is left. Every node has an even number of edges.
  std::vector<Nodes> TakeLoops()
  {
    std::map<std::int64_t, std::set<std::int64_t>> beside;
    for (const auto& edge : this->Chain)
    {
      beside[edge.first].insert(edge.second);
      beside[edge.second].insert(edge.first);
    }
    std::vector<Nodes> loops;
    while (!beside.empty())
    {
      Nodes way{ beside.begin()->first };
      std::map<std::int64_t, std::size_t> at{ { way.front(), 0 } };
      for (;;)
      {
        const std::int64_t here = way.back();
        const std::int64_t next = *beside[here].begin();
        Remove(beside, here, next);
        Remove(beside, next, here);
        const auto [seen, isNew] = at.try_emplace(next, way.size());
        if (!isNew)
        {
          // A loop has closed; what leads to it is taken up again later.
          loops.emplace_back(way.begin() + static_cast<std::ptrdiff_t>(seen->second), way.end());
          for (std::size_t i = 0; i < seen->second; ++i)
          {
            beside[way[i]].insert(way[i + 1]);
            beside[way[i + 1]].insert(way[i]);
          }
          break;
        }
        way.push_back(next);
      }
    }
    return loops;
  }

  static void Remove(
    std::map<std::int64_t, std::set<std::int64_t>>& beside, std::int64_t from, std::int64_t to)
  {
    const auto found = beside.find(from);
    found->second.erase(to);
    if (found->second.empty())
    {
      beside.erase(found);
    }
  }

  const Gradient& Cells;
  const std::vector<Key>& Edges;
  const std::vector<char>& Negative;
  std::map<std::int64_t, Link> Above; ///< from each minimum towards the root
  std::set<std::pair<std::int64_t, std::int64_t>> Chain;
};

}

#endif
