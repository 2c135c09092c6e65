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
constexpr std::size_t ReportEvery = 1 << 18;

using Sides = std::vector<std::array<SimplexId, 2>>;

/// For each triangle, by rank, the ranks of the tetrahedra beside it; the exterior comes last.
/// Triangles are gone through as they are numbered, since their tetrahedra then lie near each
/// other.
Sides SidesInOrder(const CellFiltration& f, const std::vector<SimplexId>& cellRank)
{
  const auto rank = [&cellRank](SimplexId cell)
  { return cell < 0 ? static_cast<SimplexId>(cellRank.size()) : cellRank[At(cell)]; };
  Sides sides(f.TriangleCount());
  ParallelFor(0, static_cast<std::int64_t>(sides.size()), Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto t = static_cast<std::size_t>(begin); t < static_cast<std::size_t>(end); ++t)
      {
        const auto beside = f.TriangleSides(t);
        sides[At(f.TriangleRank[t])] = { rank(beside[0]), rank(beside[1]) };
      }
    });
  return sides;
}

}

std::vector<SimplexId> VoidPairs(const CellFiltration& f, const ProgressCallback& progress)
{
  const std::size_t count = f.TriangleCount();
  std::vector<SimplexId> rank;
  const std::vector<SimplexId> inOrder =
    SimplexOrder(f.TetrahedronValue, {}, rank, Between(progress, 0.0, 0.2));
  // Basins of tetrahedra by rank, the last one the exterior. The root of each is its latest one, so
  // that the elder rule is which of two roots is the greater number.
  DisjointSets<SimplexId> basins(static_cast<SimplexId>(inOrder.size() + 1));
  std::vector<SimplexId> filledBy(count, -1);
  const Sides sides = SidesInOrder(f, rank);
  std::vector<SimplexId>().swap(rank);
  for (std::size_t i = count; i-- > 0;)
  {
    if (i % ReportEvery == 0)
    {
      Report(progress, 1.0 - 0.8 * static_cast<double>(i) / static_cast<double>(count));
    }
    const SimplexId a = basins.Find(sides[i][0]);
    const SimplexId b = basins.Find(sides[i][1]);
    if (a != b)
    {
      basins.JoinUnder(std::min(a, b), std::max(a, b));
      filledBy[At(f.TrianglesInOrder[i])] = inOrder[At(std::min(a, b))];
    }
  }
  return filledBy;
}

}
