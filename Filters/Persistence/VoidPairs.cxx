#include "VoidPairs.h"

#include "DisjointSets.h"
#include "Index.h"
#include "ParallelFor.h"
#include "SimplexOrder.h"

#include <algorithm>

namespace isthmus
{
namespace
{

constexpr std::int64_t Grain = 1 << 14;

/// The ranks of the tetrahedra beside the triangles ranked [first, last); the exterior comes last.
void GatherSides(const CellFiltration& f, const std::vector<SimplexId>& cellRank, std::size_t first,
  std::size_t last, std::vector<std::array<SimplexId, 2>>& sides)
{
  const auto rank = [&cellRank](SimplexId cell)
  { return cell < 0 ? static_cast<SimplexId>(cellRank.size()) : cellRank[At(cell)]; };
  sides.resize(last - first);
  ParallelFor(static_cast<std::int64_t>(first), static_cast<std::int64_t>(last), Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const auto beside = f.TriangleSides(At(f.TrianglesInOrder[i]));
        sides[i - first] = { rank(beside[0]), rank(beside[1]) };
      }
    });
}

}

std::vector<SimplexId> VoidPairs(const CellFiltration& f, const ProgressCallback& progress)
{
  constexpr std::size_t block = 1 << 18;
  const std::size_t count = f.TriangleCount();
  std::vector<SimplexId> rank;
  const std::vector<SimplexId> inOrder =
    SimplexOrder(f.TetrahedronValue, {}, rank, Between(progress, 0.0, 0.2));
  // Basins of tetrahedra by rank, the last one the exterior. The root of each is its latest one, so
  // that the elder rule is which of two roots is the greater number.
  DisjointSets<SimplexId> basins(static_cast<SimplexId>(inOrder.size() + 1));
  std::vector<SimplexId> filledBy(count, -1);
  std::vector<std::array<SimplexId, 2>> sides;
  for (std::size_t last = count; last > 0;)
  {
    Report(progress, 1.0 - 0.8 * static_cast<double>(last) / static_cast<double>(count));
    const std::size_t first = last > block ? last - block : 0;
    GatherSides(f, rank, first, last, sides);
    for (std::size_t i = last; i-- > first;)
    {
      const SimplexId a = basins.Find(sides[i - first][0]);
      const SimplexId b = basins.Find(sides[i - first][1]);
      if (a != b)
      {
        basins.JoinUnder(std::min(a, b), std::max(a, b));
        filledBy[At(f.TrianglesInOrder[i])] = inOrder[At(std::min(a, b))];
      }
    }
    last = first;
  }
  return filledBy;
}

}
