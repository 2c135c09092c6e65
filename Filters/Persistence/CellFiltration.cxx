#include "Persistence/CellFiltration.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Persistence/SimplexOrder.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr std::size_t CellsOfPiece = 1 << 14;
constexpr std::ptrdiff_t FewEdges = 24; ///< are counted sooner than halves are guessed right

/// Calls visit(cell, corner) for the faces that are triangles of the cells of piece `p`: of two
/// tetrahedra the one with the smaller id has it.
template <typename Visit>
void ForFaces(const CellFiltration& f, std::size_t p, Visit&& visit)
{
  const std::size_t end = std::min((p + 1) * CellsOfPiece, f.Tetrahedra.size());
  for (const TetrahedronId t : HandleRange<TetrahedronId>(p * CellsOfPiece, end))
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      const TetrahedronId other = f.Neighbours[t][k];
      if (!other.Exists() || other > t)
      {
        visit(t, k);
      }
    }
  }
}

/// The triangle of each face, once for the two tetrahedra beside it.
void MakeTriangles(CellFiltration& f, const ProgressCallback& progress)
{
  const std::size_t pieces = (f.Tetrahedra.size() + CellsOfPiece - 1) / CellsOfPiece;
  std::vector<std::size_t> first(pieces + 1, 0);
  const auto forPieces = [pieces](const ProgressCallback& part, auto&& work)
  {
    ParallelFor(
      0, static_cast<std::int64_t>(pieces), 1,
      [&work](std::int64_t begin, std::int64_t end)
      {
        for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
        {
          work(p);
        }
      },
      part);
  };
  forPieces(Between(progress, 0.0, 0.3),
    [&](std::size_t p) { ForFaces(f, p, [&](TetrahedronId, std::size_t) { ++first[p + 1]; }); });
  std::partial_sum(first.begin(), first.end(), first.begin());
  f.TriangleFaces.resize(first.back());
  forPieces(Between(progress, 0.3, 1.0),
    [&](std::size_t p)
    {
      TriangleId next = TriangleId::At(first[p]);
      ForFaces(f, p,
        [&](TetrahedronId t, std::size_t k)
        {
          f.TriangleFaces[next] = static_cast<SimplexId>(4 * t.Index() + k);
          ++next.Value;
        });
    });
}

/// See TriangleBlocks.
std::vector<SimplexId> BlocksOf(const CellFiltration& f)
{
  std::vector<SimplexId> blocks;
  blocks.reserve(f.Tetrahedra.size() / CellFiltration::CellsOfBlock + 2);
  for (const TriangleId t : f.Triangles())
  {
    const auto block =
      static_cast<std::uint32_t>(f.TriangleFaces[t]) / (4 * CellFiltration::CellsOfBlock);
    blocks.resize(std::max<std::size_t>(blocks.size(), block + 1), t.Value);
  }
  blocks.resize(f.Tetrahedra.size() / CellFiltration::CellsOfBlock + 2,
    static_cast<SimplexId>(f.TriangleCount()));
  return blocks;
}

/// `begin` to the end returned: the ids of [begin, end) in ascending order, each once. A point's
/// neighbours come about five times each, and are few: they are put in their places one by one.
SimplexId* SortOnce(SimplexId* begin, SimplexId* end)
{
  constexpr std::ptrdiff_t few = 128;
  if (end - begin > few)
  {
    std::sort(begin, end);
    return std::unique(begin, end);
  }
  SimplexId* kept = begin;
  for (const SimplexId* next = begin; next != end; ++next)
  {
    const SimplexId id = *next;
    SimplexId* place = kept;
    while (place != begin && place[-1] > id)
    {
      --place;
    }
    if (place == begin || place[-1] != id)
    {
      std::copy_backward(place, kept, kept + 1);
      *place = id;
      ++kept;
    }
  }
  return kept;
}

/// Edges bucketed by their smaller point, so that finding one takes a look into a short list.
void MakeEdges(CellFiltration& f, const ProgressCallback& progress)
{
  std::vector<std::int64_t> first(f.Points.size() + 1, 0);
  for (const TriangleId triangle : f.Triangles())
  {
    const auto t = f.TrianglePoints(triangle);
    first[At(t[0]) + 1] += 2;
    first[At(t[1]) + 1] += 1;
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<SimplexId> larger(static_cast<std::size_t>(first.back()));
  std::vector<std::int64_t> next(first.begin(), first.end() - 1);
  Report(progress, 0.1);
  for (const TriangleId triangle : f.Triangles())
  {
    const auto t = f.TrianglePoints(triangle);
    larger[static_cast<std::size_t>(next[At(t[0])]++)] = t[1];
    larger[static_cast<std::size_t>(next[At(t[0])]++)] = t[2];
    larger[static_cast<std::size_t>(next[At(t[1])]++)] = t[2];
  }
  Report(progress, 0.3);
  f.FirstEdge.assign(f.Points.size() + 1, EdgeId(0));
  const auto forPoints = [&f](const ProgressCallback& part, auto&& work)
  {
    ParallelFor(
      0, static_cast<std::int64_t>(f.Points.size()), 4096,
      [&work](std::int64_t begin, std::int64_t end)
      {
        for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
        {
          work(p);
        }
      },
      part);
  };
  forPoints(Between(progress, 0.3, 0.9),
    [&](std::size_t p)
    {
      SimplexId* const begin = larger.data() + first[p];
      f.FirstEdge[p + 1].Value =
        static_cast<SimplexId>(SortOnce(begin, larger.data() + first[p + 1]) - begin);
    });
  std::partial_sum(f.FirstEdge.begin(), f.FirstEdge.end(), f.FirstEdge.begin(),
    [](EdgeId before, EdgeId count) { return EdgeId(before.Value + count.Value); });
  f.Edges.resize(f.FirstEdge.back().Index());
  forPoints(Between(progress, 0.9, 1.0),
    [&](std::size_t p)
    {
      const auto point = static_cast<SimplexId>(p);
      const SimplexId* other = larger.data() + first[p];
      for (const EdgeId e : f.EdgesAbove(point))
      {
        f.Edges[e] = { point, *other++ };
      }
    });
}

/// The edges opposite to the points of a triangle. Two begin at its least point: where few do, both
/// are counted out of one look at them.
std::array<EdgeId, 3> EdgesOf(const CellFiltration& f, const std::array<SimplexId, 3>& p)
{
  const EdgeId first = f.FirstEdge[At(p[0])];
  const EdgeId end = f.FirstEdge[At(p[0]) + 1];
  if (end.Value - first.Value > FewEdges)
  {
    return { f.FindEdge(p[1], p[2]), f.FindEdge(p[0], p[2]), f.FindEdge(p[0], p[1]) };
  }
  SimplexId middle = first.Value, last = first.Value;
  for (SimplexId e = first.Value; e < end.Value; ++e)
  {
    const SimplexId other = f.Edges[EdgeId(e)][1];
    middle += other < p[1] ? 1 : 0;
    last += other < p[2] ? 1 : 0;
  }
  return { f.FindEdge(p[1], p[2]), EdgeId(last), EdgeId(middle) };
}

void LinkTriangleEdges(CellFiltration& f, const ProgressCallback& progress)
{
  f.TriangleEdges.resize(f.TriangleCount());
  ParallelFor(
    0, static_cast<std::int64_t>(f.TriangleCount()), 4096,
    [&f](std::int64_t begin, std::int64_t end)
    {
      for (const TriangleId t : HandleRange<TriangleId>(begin, end))
      {
        f.TriangleEdges[t] = EdgesOf(f, f.TrianglePoints(t));
      }
    },
    progress);
}

}

void CellFiltration::Connect(const ProgressCallback& progress)
{
  if (this->Tetrahedra.size() > static_cast<std::size_t>(std::numeric_limits<SimplexId>::max() / 4))
  {
    throw std::runtime_error("The tetrahedral complex has " +
      std::to_string(this->Tetrahedra.size()) +
      " cells, more than the 536 million that can be numbered: simplify the surface or raise the "
      "sample spacing.");
  }
  MakeTriangles(*this, Between(progress, 0.0, 0.3));
  this->TriangleBlocks = BlocksOf(*this);
  MakeEdges(*this, Between(progress, 0.3, 0.7));
  LinkTriangleEdges(*this, Between(progress, 0.7, 1.0));
}

void CellFiltration::Order(const ProgressCallback& progress)
{
  this->TrianglesInOrder = SimplexOrder(
    this->TriangleValue, this->TriangleFirst, this->RankOfTriangle, Between(progress, 0.0, 0.6));
  this->EdgesInOrder =
    SimplexOrder(this->EdgeValue, this->EdgeFirst, this->RankOfEdge, Between(progress, 0.6, 1.0));
}

EdgeId CellFiltration::FindEdge(SimplexId a, SimplexId b) const
{
  if (a > b)
  {
    std::swap(a, b);
  }
  using Edge = std::array<SimplexId, 2>;
  const Edge* const begin = this->Edges.data() + this->FirstEdge[At(a)].Value;
  const Edge* const end = this->Edges.data() + this->FirstEdge[At(a) + 1].Value;
  const Edge* found = begin;
  if (end - begin > FewEdges)
  {
    found = std::lower_bound(
      begin, end, b, [](const Edge& edge, SimplexId point) { return edge[1] < point; });
  }
  else
  {
    found += std::count_if(begin, end, [b](const Edge& edge) { return edge[1] < b; });
  }
  return found != end && (*found)[1] == b
    ? EdgeId::At(static_cast<std::size_t>(found - this->Edges.data()))
    : EdgeId::None();
}

}
