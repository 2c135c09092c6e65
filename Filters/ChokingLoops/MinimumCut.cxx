#include "MinimumCut.h"

#include "Index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus
{
namespace
{

constexpr std::int64_t Unbounded = std::numeric_limits<std::int64_t>::max();

/// Arc 2 l runs along link l, arc 2 l + 1 against it. Node `nodes` feeds the sources, the one after
/// it drains the sinks.
class Network
{
public:
  Network(std::int32_t nodes, const std::vector<FlowLink>& links,
    const std::vector<std::int32_t>& sources, const std::vector<std::int32_t>& sinks)
    : Feed(nodes)
    , Drain(nodes + 1)
    , First(At(nodes) + 3, 0)
    , Level(At(nodes) + 2)
  {
    const std::size_t arcs = 2 * (links.size() + sources.size() + sinks.size());
    this->Target.reserve(arcs);
    this->Left.reserve(arcs);
    for (const FlowLink& link : links)
    {
      this->Add(link.Nodes[0], link.Nodes[1], link.Capacity, link.Capacity);
    }
    for (const std::int32_t node : sources)
    {
      this->Add(this->Feed, node, Unbounded, 0);
    }
    for (const std::int32_t node : sinks)
    {
      this->Add(node, this->Drain, Unbounded, 0);
    }
    this->Index();
  }

  /// Distances to the drain along arcs that are not full, as far as the feed is; false: there is no
  /// way from it. Measured from there, a way that begins at the feed hardly ever ends elsewhere.
  bool Measure();

  /// Per node, 1 where flow from the feed could still get.
  std::vector<char> Reached() const;

  /// Fills shortest paths until each has a full arc.
  void Block();

private:
  std::int32_t From(std::int32_t arc) const { return this->Target[At(arc ^ 1)]; }

  void Add(std::int32_t from, std::int32_t to, std::int64_t along, std::int64_t against)
  {
    this->Target.insert(this->Target.end(), { to, from });
    this->Left.insert(this->Left.end(), { along, against });
    ++this->First[At(from) + 1];
    ++this->First[At(to) + 1];
  }

  void Index()
  {
    for (std::size_t i = 1; i < this->First.size(); ++i)
    {
      this->First[i] += this->First[i - 1];
    }
    std::vector<std::int32_t> next(this->First.begin(), this->First.end() - 1);
    this->Arcs.resize(this->Target.size());
    for (std::size_t a = 0; a < this->Target.size(); ++a)
    {
      const auto arc = static_cast<std::int32_t>(a);
      this->Arcs[At(next[At(this->From(arc))]++)] = arc;
    }
  }

  /// As much along a path as it takes, and the place of its first arc that is full then.
  std::size_t Fill(const std::vector<std::int32_t>& path)
  {
    std::int64_t least = Unbounded;
    std::size_t full = 0;
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      if (this->Left[At(path[i])] < least)
      {
        least = this->Left[At(path[i])];
        full = i;
      }
    }
    for (const std::int32_t arc : path)
    {
      this->Left[At(arc)] -= this->Left[At(arc)] == Unbounded ? 0 : least;
      this->Left[At(arc ^ 1)] += least;
    }
    return full;
  }

  std::int32_t Feed;
  std::int32_t Drain;
  std::vector<std::int32_t> First; ///< arcs that leave node n: Arcs[First[n]] to Arcs[First[n + 1]]
  std::vector<std::int32_t> Arcs;
  std::vector<std::int32_t> Target;
  std::vector<std::int64_t> Left; ///< what an arc can still take
  std::vector<std::int32_t> Level;
};

bool Network::Measure()
{
  std::fill(this->Level.begin(), this->Level.end(), -1);
  std::vector<std::int32_t> queue{ this->Drain };
  this->Level[At(this->Drain)] = 0;
  for (std::size_t i = 0; i < queue.size() && this->Level[At(this->Feed)] < 0; ++i)
  {
    for (std::int32_t k = this->First[At(queue[i])]; k < this->First[At(queue[i]) + 1]; ++k)
    {
      const std::int32_t arc = this->Arcs[At(k)];
      const std::int32_t from = this->Target[At(arc)];
      if (this->Left[At(arc ^ 1)] > 0 && this->Level[At(from)] < 0)
      {
        this->Level[At(from)] = this->Level[At(queue[i])] + 1;
        queue.push_back(from);
      }
    }
  }
  return this->Level[At(this->Feed)] >= 0;
}

std::vector<char> Network::Reached() const
{
  std::vector<char> reached(this->Level.size(), 0);
  std::vector<std::int32_t> queue{ this->Feed };
  reached[At(this->Feed)] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    for (std::int32_t k = this->First[At(queue[i])]; k < this->First[At(queue[i]) + 1]; ++k)
    {
      const std::int32_t arc = this->Arcs[At(k)];
      const std::int32_t to = this->Target[At(arc)];
      if (this->Left[At(arc)] > 0 && reached[At(to)] == 0)
      {
        reached[At(to)] = 1;
        queue.push_back(to);
      }
    }
  }
  return reached;
}

void Network::Block()
{
  std::vector<std::int32_t> next(this->First.begin(), this->First.end() - 1);
  std::vector<std::int32_t> path;
  std::int32_t node = this->Feed;
  for (;;)
  {
    if (node == this->Drain)
    {
      const std::size_t full = this->Fill(path);
      node = this->From(path[full]);
      path.resize(full); // what leads there can take more
      continue;
    }
    std::int32_t& k = next[At(node)];
    if (k == this->First[At(node) + 1])
    {
      if (path.empty())
      {
        return;
      }
      node = this->From(path.back());
      path.pop_back();
      ++next[At(node)];
      continue;
    }
    const std::int32_t arc = this->Arcs[At(k)];
    const std::int32_t to = this->Target[At(arc)];
    if (this->Left[At(arc)] > 0 && this->Level[At(to)] == this->Level[At(node)] - 1)
    {
      path.push_back(arc);
      node = to;
    }
    else
    {
      ++k;
    }
  }
}

}

std::vector<char> MinimumCut(std::int32_t nodes, const std::vector<FlowLink>& links,
  const std::vector<std::int32_t>& sources, const std::vector<std::int32_t>& sinks,
  const ProgressCallback& progress)
{
  Network network(nodes, links, sources, sinks);
  for (int sweep = 0; network.Measure(); ++sweep)
  {
    Report(progress, 1.0 - std::pow(0.95, sweep)); // nobody knows how many there will be
    network.Block();
  }
  std::vector<char> reached = network.Reached();
  reached.resize(At(nodes)); // without feed and drain
  return reached;
}

}
