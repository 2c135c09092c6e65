#include "Solvation/ChannelPassage.h"

#include "Core/DisjointSets.h"
#include "Core/RangeChecks.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

/// Nodes of a grid as sets, two more for the baths.
class Joined
{
public:
  explicit Joined(const TransportGrid& grid)
    : Nodes(grid.Domain.Size())
    , Sets(this->Nodes + 2)
  {
    for (std::int64_t node = 0; node < this->Nodes; ++node)
    {
      const unsigned char bath = grid.Baths[static_cast<std::size_t>(node)];
      if (bath != 0)
      {
        this->Sets.Join(node, this->Nodes + bath - 1);
      }
    }
  }

  void Join(std::int64_t p, std::int64_t q) { this->Sets.Join(p, q); }
  bool Through() { return this->Sets.Find(this->Nodes) == this->Sets.Find(this->Nodes + 1); }
  bool ToBath(std::int64_t node)
  {
    const std::int64_t root = this->Sets.Find(node);
    return root == this->Sets.Find(this->Nodes) || root == this->Sets.Find(this->Nodes + 1);
  }

private:
  const std::int64_t Nodes;
  DisjointSets<std::int64_t> Sets;
};

constexpr const char* Suggestion =
  " Choose a smaller ProbeRadius, a larger LumenRadius (without a hole the membrane is closed), or "
  "move MembraneCenter and MembraneNormal to the channel's axis.";

}

ChannelPassage FindPassage(const TransportGrid& grid)
{
  const TransportDomain& d = grid.Domain;
  const std::array<std::int64_t, 3> steps = d.Steps();
  const auto distance = [&grid](std::int64_t node)
  { return grid.Distance[static_cast<std::size_t>(node)]; };
  std::vector<std::int64_t> order;
  for (std::int64_t node = 0; node < d.Size(); ++node)
  {
    bool within = false;
    for (const auto& permittivity : grid.Permittivity)
    {
      within = within || permittivity[static_cast<std::size_t>(node)] > 0.0F;
    }
    if (within)
    {
      order.push_back(node);
    }
  }
  std::sort(order.begin(), order.end(),
    [&](std::int64_t a, std::int64_t b)
    { return distance(a) != distance(b) ? distance(a) > distance(b) : a < b; });
  Joined joined(grid);
  for (const std::int64_t node : order)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::int64_t next = node + steps[a];
      const std::int64_t before = node - steps[a];
      const auto edge = [&](std::int64_t at)
      { return grid.Permittivity[a][static_cast<std::size_t>(at)] > 0.0F; };
      if (edge(node) && distance(next) >= distance(node))
      {
        joined.Join(node, next);
      }
      if (before >= 0 && edge(before) && distance(before) >= distance(node))
      {
        joined.Join(node, before);
      }
    }
    if (joined.Through())
    {
      const Point3 place = d.Place(node);
      return { place, d.AxialAndRadial(place)[0], static_cast<double>(distance(node)) };
    }
  }
  throw std::runtime_error("The grid does not connect the two baths." + std::string(Suggestion));
}

void RequireOpen(const ChannelPassage& passage)
{
  if (passage.Radius > 0.0)
  {
    return;
  }
  const Point3& at = passage.Bottleneck;
  throw std::runtime_error(
    "The channel is not open from bath to bath: its widest path is blocked at (" +
    FormatNumber(at[0]) + ", " + FormatNumber(at[1]) + ", " + FormatNumber(at[2]) + "), " +
    FormatNumber(passage.Along) +
    " angstrom along the normal from the membrane's center, where atoms and membrane leave a "
    "radius of " +
    FormatNumber(passage.Radius) + " angstrom." + Suggestion);
}

bool IsRimOpen(
  const TransportGrid& grid, const std::vector<Ball>& atoms, const MembraneSlab& membrane)
{
  constexpr double rim = 1.75; // spacings
  const TransportDomain& d = grid.Domain;
  const double half = 0.5 * membrane.MembraneThickness;
  const bool hasAtoms = std::any_of(atoms.begin(), atoms.end(),
    [&](const Ball& ball)
    {
      const auto [along, off] = d.AxialAndRadial(ball.Center);
      return std::abs(along) < half && off - ball.Radius < membrane.LumenRadius;
    });
  // The rim is nearer than the atoms, which in a pore are before it.
  const auto isOfRim = [&](std::int64_t node)
  {
    const auto [along, off] = d.AxialAndRadial(d.Place(node));
    const double distance = grid.Distance[static_cast<std::size_t>(node)];
    const double toRim = membrane.LumenRadius - off;
    return distance > 0.0 && std::abs(along) <= half && toRim >= 0.0 && toRim < rim * d.Spacing &&
      distance > toRim - MembraneExcess * d.Spacing - 1e-3 * d.Spacing;
  };
  const std::array<std::int64_t, 3> steps = d.Steps();
  const std::int64_t below = d.Size();
  DisjointSets<std::int64_t> sets(d.Size() + 2);
  for (std::int64_t node = 0; hasAtoms && node < d.Size(); ++node)
  {
    if (!isOfRim(node))
    {
      continue;
    }
    const double along = d.AxialAndRadial(d.Place(node))[0];
    if (half - std::abs(along) < d.Spacing)
    {
      sets.Join(node, along < 0.0 ? below : below + 1);
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::int64_t next = node + steps[a];
      if (grid.Aperture[a][static_cast<std::size_t>(node)] > 0.0F && isOfRim(next))
      {
        sets.Join(node, next);
      }
    }
  }
  return sets.Find(below) == sets.Find(below + 1);
}

void CloseIsolatedPockets(TransportGrid& grid)
{
  const std::array<std::int64_t, 3> steps = grid.Domain.Steps();
  Joined joined(grid);
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::int64_t node = 0; node < grid.Domain.Size(); ++node)
    {
      if (grid.Aperture[a][static_cast<std::size_t>(node)] > 0.0F)
      {
        joined.Join(node, node + steps[a]);
      }
    }
  }
  if (!joined.Through())
  {
    throw std::runtime_error(
      "The channel is narrower than the grid can resolve: choose a smaller Spacing." +
      std::string(Suggestion));
  }
  for (std::int64_t node = 0; node < grid.Domain.Size(); ++node)
  {
    if (!joined.ToBath(node))
    {
      const auto p = static_cast<std::size_t>(node);
      grid.Water[p] = 0.0F;
      for (auto& aperture : grid.Aperture)
      {
        aperture[p] = 0.0F;
      }
    }
  }
}

}
