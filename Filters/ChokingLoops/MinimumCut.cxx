#include "ChokingLoops/MinimumCut.h"

#include "Core/Index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace isthmus
{
namespace
{

constexpr std::int64_t Unbounded = std::numeric_limits<std::int64_t>::max();

/// An arc of the network, beside the others that leave its node: what searches look at comes in
/// rows.
struct Arc
{
  std::int64_t Left; ///< what it can still take
  std::int64_t Both; ///< with what its twin can
  std::int32_t Target;
  std::int32_t Twin; ///< the arc the other way

  /// What the twin can still take.
  std::int64_t Back() const { return this->Both - this->Left; }
};

/// Node `nodes` feeds the sources, the one after it drains the sinks.
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
    this->Queue.reserve(At(nodes) + 2);
    const auto forAll = [&](auto&& visit)
    {
      for (const FlowLink& link : links)
      {
        visit(link.Nodes[0], link.Nodes[1], link.Capacity, link.Capacity);
      }
      for (const std::int32_t node : sources)
      {
        visit(this->Feed, node, Unbounded, std::int64_t{ 0 });
      }
      for (const std::int32_t node : sinks)
      {
        visit(node, this->Drain, Unbounded, std::int64_t{ 0 });
      }
    };
    forAll(
      [this](std::int32_t from, std::int32_t to, std::int64_t, std::int64_t)
      {
        ++this->First[At(from) + 1];
        ++this->First[At(to) + 1];
      });
    std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
    this->Arcs.resize(At(this->First.back()));
    std::vector<std::int32_t> next(this->First.begin(), this->First.end() - 1);
    forAll(
      [this, &next](std::int32_t from, std::int32_t to, std::int64_t along, std::int64_t against)
      {
        const std::int32_t there = next[At(from)]++;
        const std::int32_t back = next[At(to)]++;
        this->Arcs[At(there)] = { along, along + against, to, back };
        this->Arcs[At(back)] = { against, along + against, from, there };
      });
  }

  /// Distances to the drain along arcs that are not full, as far as the feed is; false: there is no
  /// way from it. Measured from there, a way that begins at the feed hardly ever ends elsewhere.
  bool Measure();

  /// Per node, 1 where flow from the feed could still get.
  std::vector<char> Reached() const;

  /// Fills shortest paths until each has a full arc.
  void Block();

private:
  std::int32_t From(std::int32_t arc) const
  {
    return this->Arcs[At(this->Arcs[At(arc)].Twin)].Target;
  }

  /// As much along a path as it takes, and the place of its first arc that is full then.
  std::size_t Fill(const std::vector<std::int32_t>& path)
  {
    std::int64_t least = Unbounded;
    std::size_t full = 0;
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      if (this->Arcs[At(path[i])].Left < least)
      {
        least = this->Arcs[At(path[i])].Left;
        full = i;
      }
    }
    for (const std::int32_t at : path)
    {
      Arc& arc = this->Arcs[At(at)];
      if (arc.Left != Unbounded) // from the feed and to the drain, which nothing comes back from
      {
        arc.Left -= least;
        this->Arcs[At(arc.Twin)].Left += least;
      }
    }
    return full;
  }

  std::int32_t Feed;
  std::int32_t Drain;
  std::vector<std::int32_t> First; ///< arcs that leave node n: Arcs[First[n]] to Arcs[First[n + 1]]
  std::vector<Arc> Arcs;
  std::vector<std::int32_t> Level;
  std::vector<std::int32_t> Queue; ///< of Measure()
};

bool Network::Measure()
{
  std::fill(this->Level.begin(), this->Level.end(), -1);
  std::vector<std::int32_t>& queue = this->Queue;
  queue.assign(1, this->Drain);
  this->Level[At(this->Drain)] = 0;
  for (std::size_t i = 0; i < queue.size() && this->Level[At(this->Feed)] < 0; ++i)
  {
    for (std::int32_t k = this->First[At(queue[i])]; k < this->First[At(queue[i]) + 1]; ++k)
    {
      const Arc& arc = this->Arcs[At(k)];
      if (arc.Back() > 0 && this->Level[At(arc.Target)] < 0)
      {
        this->Level[At(arc.Target)] = this->Level[At(queue[i])] + 1;
        queue.push_back(arc.Target);
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
      const Arc& arc = this->Arcs[At(k)];
      if (arc.Left > 0 && reached[At(arc.Target)] == 0)
      {
        reached[At(arc.Target)] = 1;
        queue.push_back(arc.Target);
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
    const std::int32_t end = this->First[At(node) + 1];
    const std::int32_t below = this->Level[At(node)] - 1;
    const auto leadsOn = [&](const Arc& arc)
    { return arc.Left > 0 && this->Level[At(arc.Target)] == below; };
    while (k < end && !leadsOn(this->Arcs[At(k)]))
    {
      ++k;
    }
    if (k < end)
    {
      path.push_back(k);
      node = this->Arcs[At(k)].Target;
      continue;
    }
    if (path.empty())
    {
      return;
    }
    node = this->From(path.back());
    path.pop_back();
    ++next[At(node)];
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
