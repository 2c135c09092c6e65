#include "VoidPairs.h"

#include "Index.h"
#include "ParallelFor.h"

#include <algorithm>
#include <numeric>

namespace isthmus
{
namespace
{

constexpr std::int64_t Grain = 1 << 14;

/// Basins of tetrahedra by rank; the root of each is its latest one, so that the elder rule is
/// which of two roots is the greater number.
class Basins
{
public:
  explicit Basins(std::size_t n)
    : Parent(n)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), SimplexId{ 0 });
  }

  SimplexId Find(SimplexId i)
  {
    while (this->Parent[At(i)] != i)
    {
      this->Parent[At(i)] = this->Parent[At(this->Parent[At(i)])];
      i = this->Parent[At(i)];
    }
    return i;
  }

  void Drain(SimplexId younger, SimplexId elder) { this->Parent[At(younger)] = elder; }

private:
  std::vector<SimplexId> Parent;
};

/// The ranks of the tetrahedra beside the triangles ranked [first, last); the exterior comes last.
void GatherSides(const CellFiltration& f, std::size_t first, std::size_t last,
  std::vector<std::array<SimplexId, 2>>& sides)
{
  const auto rank = [&f](SimplexId cell)
  { return cell < 0 ? static_cast<SimplexId>(f.Tetrahedra.size()) : f.TetrahedronRank[At(cell)]; };
  sides.resize(last - first);
  ParallelFor(static_cast<std::int64_t>(first), static_cast<std::int64_t>(last), Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const auto& beside = f.TriangleSides[At(f.TrianglesInOrder[i])];
        sides[i - first] = { rank(beside[0]), rank(beside[1]) };
      }
    });
}

}

std::vector<SimplexId> VoidPairs(const CellFiltration& f, const ProgressCallback& progress)
{
  constexpr std::size_t block = 1 << 18;
  const std::size_t count = f.Triangles.size();
  const std::size_t cells = f.Tetrahedra.size();
  std::vector<SimplexId> inOrder(cells);
  for (std::size_t c = 0; c < cells; ++c)
  {
    inOrder[At(f.TetrahedronRank[c])] = static_cast<SimplexId>(c);
  }
  Basins basins(cells + 1); // the last one is the exterior
  std::vector<SimplexId> filledBy(count, -1);
  std::vector<std::array<SimplexId, 2>> sides;
  for (std::size_t last = count; last > 0;)
  {
    Report(progress, 1.0 - static_cast<double>(last) / static_cast<double>(count));
    const std::size_t first = last > block ? last - block : 0;
    GatherSides(f, first, last, sides);
    for (std::size_t i = last; i-- > first;)
    {
      const SimplexId a = basins.Find(sides[i - first][0]);
      const SimplexId b = basins.Find(sides[i - first][1]);
      if (a != b)
      {
        basins.Drain(std::min(a, b), std::max(a, b));
        filledBy[At(f.TrianglesInOrder[i])] = inOrder[At(std::min(a, b))];
      }
    }
    last = first;
  }
  return filledBy;
}

}
