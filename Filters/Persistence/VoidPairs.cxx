#include "Persistence/VoidPairs.h"

#include "Core/DisjointSets.h"
#include "Core/ParallelFor.h"
#include "Persistence/SimplexOrder.h"

#include <algorithm>

namespace isthmus
{
namespace
{

constexpr std::int64_t Grain = 1 << 14;
constexpr std::size_t ReportEvery = 1 << 18;

using Sides = HandleVector<TriangleRank, std::array<TetrahedronRank, 2>>;

/// For each triangle, by rank, the ranks of the tetrahedra beside it; the exterior comes last.
/// Triangles are gone through as they are numbered, since their tetrahedra then lie near each
/// other.
Sides SidesInOrder(
  const CellFiltration& f, const HandleVector<TetrahedronId, TetrahedronRank>& cellRank)
{
  const auto rank = [&cellRank](TetrahedronId cell)
  { return cell.Exists() ? cellRank[cell] : TetrahedronRank::At(cellRank.size()); };
  Sides sides(f.TriangleCount());
  ParallelFor(0, static_cast<std::int64_t>(sides.size()), Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (const TriangleId t : HandleRange<TriangleId>(begin, end))
      {
        const auto beside = f.TriangleSides(t);
        sides[f.RankOfTriangle[t]] = { rank(beside[0]), rank(beside[1]) };
      }
    });
  return sides;
}

}

HandleVector<TriangleId, TetrahedronId> VoidPairs(
  const CellFiltration& f, const ProgressCallback& progress)
{
  const std::size_t count = f.TriangleCount();
  HandleVector<TetrahedronId, TetrahedronRank> rank;
  const auto inOrder = SimplexOrder(f.TetrahedronValue, {}, rank, Between(progress, 0.0, 0.2));
  // Basins of tetrahedra by rank, the last one the exterior. The root of each is its latest one, so
  // that the elder rule is which of two roots is the greater number.
  DisjointSets<TetrahedronRank> basins(inOrder.size() + 1);
  HandleVector<TriangleId, TetrahedronId> filledBy(count, TetrahedronId::None());
  const Sides sides = SidesInOrder(f, rank);
  HandleVector<TetrahedronId, TetrahedronRank>().swap(rank);
  for (std::size_t i = count; i-- > 0;)
  {
    if (i % ReportEvery == 0)
    {
      Report(progress, 1.0 - 0.8 * static_cast<double>(i) / static_cast<double>(count));
    }
    const auto triangle = TriangleRank::At(i);
    const TetrahedronRank a = basins.Find(sides[triangle][0]);
    const TetrahedronRank b = basins.Find(sides[triangle][1]);
    if (a != b)
    {
      basins.JoinUnder(std::min(a, b), std::max(a, b));
      filledBy[f.TrianglesInOrder[triangle]] = inOrder[std::min(a, b)];
    }
  }
  return filledBy;
}

}
