#include "PocketLabels.h"

#include "DisjointSets.h"
#include "Index.h"

#include <queue>

namespace isthmus
{
namespace
{

/// Empty room around a pocket that one of `Way`s has reached.
struct Way
{
  double Width;
  SimplexId Cell;
  SimplexId Pocket;

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

std::vector<SimplexId> PocketCores(
  const CellFiltration& c, const CellAccess& access, const PocketOptions& options)
{
  const auto inside = [&](SimplexId cell)
  {
    return cell >= 0 && access.CellClearance[At(cell)] > options.InnerRadius &&
      access.Access[At(cell)] < options.OuterRadius;
  };
  DisjointSets<SimplexId> sets(static_cast<SimplexId>(c.Tetrahedra.size()));
  for (std::size_t i = 0; i < c.TriangleCount(); ++i)
  {
    const auto sides = c.TriangleSides(i);
    if (access.TriangleClearance[i] > options.InnerRadius && inside(sides[0]) && inside(sides[1]))
    {
      sets.Join(sides[0], sides[1]);
    }
  }
  std::vector<SimplexId> numbers(c.Tetrahedra.size(), -1);
  std::vector<SimplexId> labels(c.Tetrahedra.size(), -1);
  SimplexId count = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    if (inside(static_cast<SimplexId>(i)))
    {
      SimplexId& number = numbers[At(sets.Find(static_cast<SimplexId>(i)))];
      number = number < 0 ? count++ : number;
      labels[i] = number;
    }
  }
  return labels;
}

std::vector<SimplexId> WithCrevices(const CellFiltration& c,
  const std::vector<std::array<SimplexId, 4>>& faces, const CellAccess& access, double outer,
  const std::vector<SimplexId>& cores)
{
  std::vector<SimplexId> labels = cores;
  std::priority_queue<Way> ways;
  const auto leave = [&](SimplexId cell)
  {
    for (const SimplexId face : faces[At(cell)])
    {
      const SimplexId next = Across(c, face, cell);
      if (next >= 0 && labels[At(next)] < 0 && c.TriangleValue[At(face)] > 0.0 &&
        access.Access[At(next)] < outer)
      {
        ways.push({ access.TriangleClearance[At(face)], next, labels[At(cell)] });
      }
    }
  };
  for (std::size_t i = 0; i < cores.size(); ++i)
  {
    if (cores[i] >= 0)
    {
      leave(static_cast<SimplexId>(i));
    }
  }
  while (!ways.empty())
  {
    const Way way = ways.top();
    ways.pop();
    if (labels[At(way.Cell)] < 0)
    {
      labels[At(way.Cell)] = way.Pocket;
      leave(way.Cell);
    }
  }
  return labels;
}

}
