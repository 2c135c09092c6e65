#include "Pockets/PocketLabels.h"

#include "Core/DisjointSets.h"

#include <queue>

namespace isthmus
{
namespace
{

/// Empty room around a pocket that one of `Way`s has reached.
struct Way
{
  double Width;
  TetrahedronId Cell;
  PocketNumber Pocket;

  bool operator<(const Way& other) const
  {
    if (this->Width != other.Width)
    {
      return this->Width < other.Width;
    }
    return this->Cell != other.Cell ? this->Cell > other.Cell : this->Pocket > other.Pocket;
  }
};

}

PocketByCell PocketCores(
  const CellFiltration& c, const CellAccess& access, const PocketOptions& options)
{
  const auto inside = [&](TetrahedronId cell)
  {
    return cell.Exists() && access.CellClearance[cell] > options.InnerRadius &&
      access.Access[cell] < options.OuterRadius;
  };
  DisjointSets<TetrahedronId> sets(c.Tetrahedra.size());
  for (const TriangleId t : c.Triangles())
  {
    const auto sides = c.TriangleSides(t);
    if (access.TriangleClearance[t] > options.InnerRadius && inside(sides[0]) && inside(sides[1]))
    {
      sets.Join(sides[0], sides[1]);
    }
  }
  PocketByCell numbers(c.Tetrahedra.size(), PocketNumber::None());
  PocketByCell labels(c.Tetrahedra.size(), PocketNumber::None());
  std::size_t count = 0;
  for (const TetrahedronId cell : labels.Keys())
  {
    if (inside(cell))
    {
      PocketNumber& number = numbers[sets.Find(cell)];
      number = number.Exists() ? number : PocketNumber::At(count++);
      labels[cell] = number;
    }
  }
  return labels;
}

PocketByCell WithCrevices(const CellFiltration& c, const FacesByCell& faces,
  const CellAccess& access, double outer, const PocketByCell& cores)
{
  PocketByCell labels = cores;
  std::priority_queue<Way> ways;
  const auto leave = [&](TetrahedronId cell)
  {
    for (const TriangleId face : faces[cell])
    {
      const TetrahedronId next = c.Across(face, cell);
      if (next.Exists() && !labels[next].Exists() && c.TriangleValue[face] > 0.0 &&
        access.Access[next] < outer)
      {
        ways.push({ access.TriangleClearance[face], next, labels[cell] });
      }
    }
  };
  for (const TetrahedronId cell : cores.Keys())
  {
    if (cores[cell].Exists())
    {
      leave(cell);
    }
  }
  while (!ways.empty())
  {
    const Way way = ways.top();
    ways.pop();
    if (!labels[way.Cell].Exists())
    {
      labels[way.Cell] = way.Pocket;
      leave(way.Cell);
    }
  }
  return labels;
}

}
