#include "CellFiltration.h"

#include "ParallelFor.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace isthmus
{
namespace
{

std::size_t At(SimplexId i)
{
  return static_cast<std::size_t>(i);
}

constexpr std::size_t ReportEvery = 1 << 18;

/// Reports, now and then, that `i` of `n` are done.
void ReportSome(const ProgressCallback& progress, std::size_t i, std::size_t n)
{
  if (i % ReportEvery == 0)
  {
    Report(progress, static_cast<double>(i) / static_cast<double>(n));
  }
}

/// The triangle of each face, once for the two tetrahedra beside it.
void MakeTriangles(CellFiltration& f, const ProgressCallback& progress)
{
  f.Triangles.clear();
  f.TriangleSides.clear();
  f.Triangles.reserve(2 * f.Tetrahedra.size() + 1000);
  f.TriangleSides.reserve(2 * f.Tetrahedra.size() + 1000);
  for (std::size_t t = 0; t < f.Tetrahedra.size(); ++t)
  {
    ReportSome(progress, t, f.Tetrahedra.size());
    const auto id = static_cast<SimplexId>(t);
    for (std::size_t k = 0; k < 4; ++k)
    {
      const SimplexId other = f.Neighbours[t][k];
      if (other >= 0 && other < id)
      {
        continue;
      }
      const auto& p = f.Tetrahedra[t];
      std::array<SimplexId, 3> face{ p[(k + 1) % 4], p[(k + 2) % 4], p[(k + 3) % 4] };
      std::sort(face.begin(), face.end());
      f.Triangles.push_back(face);
      f.TriangleSides.push_back({ id, other });
    }
  }
}

/// Edges bucketed by their smaller point, so that finding one takes a look into a short list.
void MakeEdges(CellFiltration& f, const ProgressCallback& progress)
{
  std::vector<std::int64_t> first(f.Points.size() + 1, 0);
  for (const auto& t : f.Triangles)
  {
    first[At(t[0]) + 1] += 2;
    first[At(t[1]) + 1] += 1;
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<SimplexId> larger(static_cast<std::size_t>(first.back()));
  std::vector<std::int64_t> next(first.begin(), first.end() - 1);
  Report(progress, 0.1);
  for (const auto& t : f.Triangles)
  {
    larger[static_cast<std::size_t>(next[At(t[0])]++)] = t[1];
    larger[static_cast<std::size_t>(next[At(t[0])]++)] = t[2];
    larger[static_cast<std::size_t>(next[At(t[1])]++)] = t[2];
  }
  Report(progress, 0.3);
  const auto rest = Between(progress, 0.3, 1.0);
  f.Edges.clear();
  f.FirstEdge.assign(f.Points.size() + 1, 0);
  for (std::size_t p = 0; p < f.Points.size(); ++p)
  {
    ReportSome(rest, p, f.Points.size());
    const auto begin = larger.begin() + first[p];
    const auto end = larger.begin() + first[p + 1];
    std::sort(begin, end);
    for (auto q = begin, last = std::unique(begin, end); q != last; ++q)
    {
      f.Edges.push_back({ static_cast<SimplexId>(p), *q });
    }
    f.FirstEdge[p + 1] = static_cast<SimplexId>(f.Edges.size());
  }
}

void LinkTriangleEdges(CellFiltration& f, const ProgressCallback& progress)
{
  f.TriangleEdges.resize(f.Triangles.size());
  ParallelFor(
    0, static_cast<std::int64_t>(f.Triangles.size()), 4096,
    [&f](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const auto& p = f.Triangles[i];
        f.TriangleEdges[i] = { f.FindEdge(p[1], p[2]), f.FindEdge(p[0], p[2]),
          f.FindEdge(p[0], p[1]) };
      }
    },
    progress);
}

/// A simplex to be sorted.
struct Key
{
  double Value;
  SimplexId Id;

  bool operator<(const Key& other) const
  {
    return this->Value != other.Value ? this->Value < other.Value : this->Id < other.Id;
  }
};

/// Sorts pieces and merges them two by two: on all threads, and it can be stopped.
void SortInPieces(std::vector<Key>& keys, const ProgressCallback& progress)
{
  constexpr std::size_t Piece = 1 << 18;
  const std::size_t n = keys.size();
  const auto at = [&n](std::size_t i) { return static_cast<std::ptrdiff_t>(std::min(i, n)); };
  const auto inPairs = [n](std::size_t width)
  { return static_cast<std::int64_t>((n + 2 * width - 1) / (2 * width)); };
  ParallelFor(
    0, 2 * inPairs(Piece), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        std::sort(keys.begin() + at(i * Piece), keys.begin() + at((i + 1) * Piece));
      }
    },
    Between(progress, 0.0, 0.6));
  std::vector<Key> merged(n);
  double done = 0.6;
  for (std::size_t width = Piece; width < n; width *= 2)
  {
    ParallelFor(0, inPairs(width), 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (auto i = 2 * static_cast<std::size_t>(begin); i < 2 * static_cast<std::size_t>(end);
             i += 2)
        {
          const auto middle = keys.begin() + at((i + 1) * width);
          std::merge(keys.begin() + at(i * width), middle, middle,
            keys.begin() + at((i + 2) * width), merged.begin() + at(i * width));
        }
      });
    keys.swap(merged);
    done += 0.3 * (1.0 - done);
    Report(progress, done);
  }
}

/// Ids in ascending (first, value, id); `rank` becomes the inverse.
std::vector<SimplexId> Sorted(const std::vector<double>& value, const std::vector<char>& first,
  std::vector<SimplexId>& rank, const ProgressCallback& progress)
{
  std::vector<Key> keys(value.size());
  for (std::size_t i = 0; i < value.size(); ++i)
  {
    const bool isFirst = !first.empty() && first[i];
    keys[i] = { isFirst ? -1.0 : value[i], static_cast<SimplexId>(i) };
  }
  SortInPieces(keys, progress);
  std::vector<SimplexId> order(value.size());
  rank.resize(value.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    order[i] = keys[i].Id;
    rank[At(keys[i].Id)] = static_cast<SimplexId>(i);
  }
  return order;
}

}

void CellFiltration::Connect(const ProgressCallback& progress)
{
  if (2 * this->Tetrahedra.size() >
    static_cast<std::size_t>(std::numeric_limits<SimplexId>::max() / 2))
  {
    throw std::runtime_error("The tetrahedral complex has " +
      std::to_string(this->Tetrahedra.size()) +
      " cells, more than the 536 million that can be numbered: simplify the surface or raise the "
      "sample spacing.");
  }
  MakeTriangles(*this, Between(progress, 0.0, 0.3));
  MakeEdges(*this, Between(progress, 0.3, 0.7));
  LinkTriangleEdges(*this, Between(progress, 0.7, 1.0));
}

void CellFiltration::Order(const ProgressCallback& progress)
{
  this->TrianglesInOrder = Sorted(
    this->TriangleValue, this->TriangleFirst, this->TriangleRank, Between(progress, 0.0, 0.5));
  this->EdgesInOrder =
    Sorted(this->EdgeValue, this->EdgeFirst, this->EdgeRank, Between(progress, 0.5, 0.8));
  Sorted(this->TetrahedronValue, {}, this->TetrahedronRank, Between(progress, 0.8, 1.0));
}

SimplexId CellFiltration::FindEdge(SimplexId a, SimplexId b) const
{
  if (a > b)
  {
    std::swap(a, b);
  }
  const auto begin = this->Edges.begin() + this->FirstEdge[At(a)];
  const auto end = this->Edges.begin() + this->FirstEdge[At(a) + 1];
  const auto found = std::lower_bound(begin, end, b,
    [](const std::array<SimplexId, 2>& edge, SimplexId point) { return edge[1] < point; });
  return found != end && (*found)[1] == b ? static_cast<SimplexId>(found - this->Edges.begin())
                                          : -1;
}

}
