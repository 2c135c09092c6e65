#include "ChokingLoops/SurfaceGenerators.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <map>

namespace isthmus
{
namespace
{

/// The triangles that bound a loop, as ranks, latest first; what nothing fills ranks above them.
struct Column
{
  std::vector<std::int64_t> Ranks;
  std::vector<std::size_t> Sum;
};

template <typename T>
std::vector<T> SymmetricDifference(
  const std::vector<T>& a, const std::vector<T>& b, bool descending)
{
  std::vector<T> sum;
  sum.reserve(a.size() + b.size());
  if (descending)
  {
    std::set_symmetric_difference(
      a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum), std::greater<>());
  }
  else
  {
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum));
  }
  return sum;
}

}

std::vector<SurfaceGenerator> SurfaceGenerators(const SurfaceHomology& homology,
  const SurfaceInComplex& surface, const CellFiltration& f, const FiltrationPairs& pairs,
  const ProgressCallback& progress)
{
  std::vector<Column> columns(homology.Rank());
  ParallelFor(
    0, static_cast<std::int64_t>(columns.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        EdgeChain image;
        for (const SurfaceEdgeId e : homology.Loop(i))
        {
          const EdgeChain path = surface.Image(e);
          image.insert(image.end(), path.begin(), path.end());
        }
        columns[i] = { pairs.Bounding(image), { i } };
      }
    },
    Between(progress, 0.0, 0.8));

  std::map<std::int64_t, std::size_t> pivots;
  const auto triangles = static_cast<std::int64_t>(f.TriangleCount());
  std::vector<SurfaceGenerator> generators;
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    Report(progress, 0.8 + 0.2 * static_cast<double>(i) / static_cast<double>(columns.size()));
    Column& c = columns[i];
    while (!c.Ranks.empty() && pivots.count(c.Ranks.front()) > 0)
    {
      const Column& other = columns[pivots[c.Ranks.front()]];
      c.Ranks = SymmetricDifference(c.Ranks, other.Ranks, true);
      c.Sum = SymmetricDifference(c.Sum, other.Sum, false);
    }
    if (!c.Ranks.empty())
    {
      pivots[c.Ranks.front()] = i;
    }
  }
  for (const auto& [rank, i] : pivots)
  {
    if (rank < triangles)
    {
      const auto filler = TriangleRank::At(static_cast<std::size_t>(rank));
      generators.push_back({ f.TrianglesInOrder[filler], columns[i].Sum });
    }
  }
  return generators;
}

}
