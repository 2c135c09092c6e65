#include "Persistence/CellFiltration.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/RadixSort.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace isthmus
{

void ReleaseFreeMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

namespace
{

constexpr std::int64_t ValuesPerTask = 1 << 16;

/// Values as integers in the same order, and their leading bits, with which the first entries come
/// before all others.
class EntryKeys
{
public:
  EntryKeys(const std::vector<double>& value, const std::vector<char>& first)
    : Value(value)
    , First(first)
  {
    this->FindRanges();
  }

  std::uint64_t GetKey(std::size_t i) const
  {
    const double value = this->Value[i] + 0.0; // no -0.0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    return bits >> 63 != 0 ? ~bits : bits | Zero;
  }

  /// The leading bits in which keys differ, in the order of entry; the first of each range for keys
  /// below it.
  std::uint32_t Short(std::size_t i) const
  {
    const std::uint64_t key = this->GetKey(i);
    const Range& range = this->Ranges[this->GetRange(i)];
    return range.Before +
      (key < range.Least ? 0 : 1 + static_cast<std::uint32_t>((key - range.Least) >> this->Shift));
  }

private:
  /// The key of value 0. Without negative values, a range begins with the first above it: the
  /// exponents between would take nearly all of it.
  static constexpr std::uint64_t Zero = std::uint64_t{ 1 } << 63;

  struct Range
  {
    std::uint64_t Least = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t Most = 0;
    std::uint32_t Before = 0; ///< short keys of the ranges before

    void Add(std::uint64_t low, std::uint64_t high)
    {
      this->Least = std::min(this->Least, low);
      this->Most = std::max(this->Most, high);
    }

    std::uint64_t ShortKeys(unsigned int shift) const
    {
      return this->Most == 0 ? 0 : 2 + ((this->Most - std::min(this->Least, this->Most)) >> shift);
    }
  };

  std::size_t GetRange(std::size_t i) const
  {
    return !this->First.empty() && this->First[i] != 0 ? 0 : 1;
  }

  void FindRanges()
  {
    std::mutex mutex;
    ParallelFor(0, static_cast<std::int64_t>(this->Value.size()), ValuesPerTask,
      [&](std::int64_t begin, std::int64_t end)
      {
        std::array<Range, 2> found;
        for (auto i = At(begin); i < At(end); ++i)
        {
          const std::uint64_t key = this->GetKey(i);
          Range& range = found[this->GetRange(i)];
          range.Add(key != Zero ? key : range.Least, key);
        }
        const std::lock_guard<std::mutex> lock(mutex);
        for (std::size_t r = 0; r < found.size(); ++r)
        {
          this->Ranges[r].Add(found[r].Least, found[r].Most);
        }
      });
    while (
      (this->Ranges[0].ShortKeys(this->Shift) + this->Ranges[1].ShortKeys(this->Shift)) >> 32 != 0)
    {
      ++this->Shift;
    }
    this->Ranges[1].Before = static_cast<std::uint32_t>(this->Ranges[0].ShortKeys(this->Shift));
  }

  const std::vector<double>& Value;
  const std::vector<char>& First;
  std::array<Range, 2> Ranges; ///< of the first entries, and of the others
  unsigned int Shift = 0;
};

/// An id below its short key.
using Entry = std::uint64_t;

std::size_t GetId(Entry entry)
{
  return static_cast<std::size_t>(entry & 0xFFFFFFFFU);
}

/// Whether a run of entries is already in the order of whole keys: most have one key.
bool IsInOrder(const Entry* begin, const Entry* end, const EntryKeys& keys)
{
  std::uint64_t before = keys.GetKey(GetId(*begin));
  for (const Entry* entry = begin + 1; entry != end; ++entry)
  {
    const std::uint64_t key = keys.GetKey(GetId(*entry));
    if (key < before)
    {
      return false;
    }
    before = key;
  }
  return true;
}

/// Sorts runs of equal short keys, which [begin, end) has whole, by whole keys, then ids: they come
/// in the order of ids.
void SortRuns(
  std::vector<Entry>& entries, const EntryKeys& keys, std::size_t begin, std::size_t end)
{
  std::vector<std::pair<std::uint64_t, Entry>> run;
  for (std::size_t i = begin; i < end;)
  {
    std::size_t next = i + 1;
    while (next < end && entries[next] >> 32 == entries[i] >> 32)
    {
      ++next;
    }
    if (next > i + 1 && !IsInOrder(entries.data() + i, entries.data() + next, keys))
    {
      run.clear();
      for (std::size_t k = i; k < next; ++k)
      {
        run.emplace_back(keys.GetKey(GetId(entries[k])), entries[k]);
      }
      std::sort(run.begin(), run.end());
      std::transform(run.begin(), run.end(), entries.begin() + static_cast<std::ptrdiff_t>(i),
        [](const auto& one) { return one.second; });
    }
    i = next;
  }
}

/// Where pieces begin that have runs of equal short keys whole; the end last.
std::vector<std::int64_t> RunStarts(const std::vector<Entry>& entries)
{
  const auto n = static_cast<std::int64_t>(entries.size());
  std::vector<std::int64_t> starts;
  for (std::int64_t p = 0; p < n; p += ValuesPerTask)
  {
    std::int64_t start = std::max(p, starts.empty() ? 0 : starts.back());
    while (start > 0 && start < n && entries[At(start - 1)] >> 32 == entries[At(start)] >> 32)
    {
      ++start;
    }
    starts.push_back(start);
  }
  starts.push_back(n);
  return starts;
}

/// Stores the order and the ranks of the entries [begin, end); `before` others come first.
template <typename Id, typename Rank>
void Number(const std::vector<Entry>& entries, std::size_t begin, std::size_t end,
  std::size_t before, HandleVector<Rank, Id>& order, HandleVector<Id, Rank>& rank)
{
  for (std::size_t i = begin; i < end; ++i)
  {
    const auto id = Id::At(GetId(entries[i]));
    order[Rank::At(before + i)] = id;
    rank[id] = Rank::At(before + i);
  }
}

/// Entries of ids 0 to n - 1 in pieces of ascending short keys, one after the other, so that
/// sorting them takes half of the memory.
class PiecesByKey
{
public:
  PiecesByKey(std::size_t n, const EntryKeys& keys)
    : Count(n)
    , Keys(keys)
  {
    this->FindEnds(std::clamp<std::size_t>(n / LeastEntries, 1, MostPieces));
    this->CountEntries();
  }

  std::size_t Pieces() const { return this->Ends.size(); }

  /// The entries of a piece, by id.
  std::vector<Entry> Entries(std::size_t piece) const
  {
    const std::size_t blocks = this->Blocks();
    std::vector<std::size_t> place(blocks + 1, 0);
    for (std::size_t b = 0; b < blocks; ++b)
    {
      place[b + 1] = place[b] + this->InBlock[b][piece];
    }
    std::vector<Entry> entries(place.back());
    const std::uint32_t start = piece == 0 ? 0 : this->Ends[piece - 1];
    this->ForEachBlock(
      [&](std::size_t b, std::size_t i)
      {
        const std::uint32_t key = this->Keys.Short(i);
        if ((key >> BinShift) - start < this->Ends[piece] - start)
        {
          entries[place[b]++] = Entry{ key } << 32 | static_cast<Entry>(i);
        }
      });
    return entries;
  }

private:
  static constexpr std::size_t MostPieces = 2;
  static constexpr std::size_t LeastEntries = 1 << 16; ///< of a piece
  static constexpr unsigned int BinShift = 21;
  using Bins = std::array<std::size_t, std::size_t{ 1 } << (32 - BinShift)>;

  std::size_t Blocks() const { return (this->Count + ValuesPerTask - 1) / ValuesPerTask; }

  /// Calls visit(block, id) for all ids; blocks run in parallel.
  template <typename Visit>
  void ForEachBlock(const Visit& visit) const
  {
    ParallelFor(0, static_cast<std::int64_t>(this->Blocks()), 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::size_t b = At(begin); b < At(end); ++b)
        {
          const std::size_t last = std::min(this->Count, (b + 1) * std::size_t{ ValuesPerTask });
          for (std::size_t i = b * ValuesPerTask; i < last; ++i)
          {
            visit(b, i);
          }
        }
      });
  }

  /// Ends of the pieces: the leading bits of the keys of the first that is not in one.
  void FindEnds(std::size_t pieces)
  {
    std::vector<Bins> ofBlock(pieces == 1 ? 0 : this->Blocks(), Bins{});
    if (pieces > 1)
    {
      this->ForEachBlock(
        [&](std::size_t b, std::size_t i) { ++ofBlock[b][this->Keys.Short(i) >> BinShift]; });
    }
    std::size_t counted = 0;
    for (std::size_t bin = 0; bin < Bins{}.size() && this->Ends.size() + 1 < pieces; ++bin)
    {
      for (const Bins& bins : ofBlock)
      {
        counted += bins[bin];
      }
      if (counted * pieces >= (this->Ends.size() + 1) * this->Count)
      {
        this->Ends.push_back(static_cast<std::uint32_t>(bin + 1));
      }
    }
    this->Ends.push_back(std::numeric_limits<std::uint32_t>::max());
  }

  void CountEntries()
  {
    this->InBlock.assign(this->Blocks(), {});
    this->ForEachBlock([&](std::size_t b, std::size_t i)
      { ++this->InBlock[b][this->FindPiece(this->Keys.Short(i))]; });
  }

  std::size_t FindPiece(std::uint32_t key) const
  {
    std::size_t piece = 0;
    while (key >> BinShift >= this->Ends[piece])
    {
      ++piece;
    }
    return piece;
  }

  std::size_t Count;
  const EntryKeys& Keys;
  std::vector<std::uint32_t> Ends;
  std::vector<std::array<std::size_t, MostPieces>> InBlock; ///< entries of each block and piece
};

}

/// The bits of doubles, inverted for negative numbers, have the order of the values. The 32 leading
/// bits in which the values differ are sorted by three stable passes of 11 bits, and runs of equal
/// ones by the value itself; two pieces of ascending values come one after the other, to halve the
/// memory.
template <typename Id, typename Rank>
HandleVector<Rank, Id> SimplexOrder(const HandleVector<Id, double>& value,
  const HandleVector<Id, char>& first, HandleVector<Id, Rank>& rank,
  const ProgressCallback& progress)
{
  const EntryKeys keys(value, first);
  Report(progress, 0.1);
  const PiecesByKey pieces(value.size(), keys);
  HandleVector<Rank, Id> order(value.size());
  rank.resize(value.size());
  std::size_t before = 0;
  for (std::size_t piece = 0; piece < pieces.Pieces(); ++piece)
  {
    std::vector<Entry> entries = pieces.Entries(piece);
    RadixSort(entries, 32, 64, [](Entry entry) { return entry; });
    const std::vector<std::int64_t> starts = RunStarts(entries);
    ParallelFor(0, static_cast<std::int64_t>(starts.size()) - 1, 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t p = begin; p < end; ++p)
        {
          const std::size_t from = At(starts[At(p)]);
          const std::size_t to = At(starts[At(p) + 1]);
          SortRuns(entries, keys, from, to);
          Number(entries, from, to, before, order, rank);
        }
      });
    before += entries.size();
    Report(
      progress, 0.2 + 0.8 * static_cast<double>(piece + 1) / static_cast<double>(pieces.Pieces()));
  }
  return order;
}

template <typename Id, typename Rank>
HandleVector<Rank, Id> SimplexOrder(const HandleVector<Id, std::uint32_t>& level,
  HandleVector<Id, Rank>& rank, const ProgressCallback& progress)
{
  const std::uint32_t most = level.empty() ? 0 : *std::max_element(level.begin(), level.end());
  unsigned int bits = 0;
  while (bits < 32 && most >> bits != 0)
  {
    ++bits;
  }
  std::vector<Entry> entries(level.size());
  ParallelFor(0, static_cast<std::int64_t>(level.size()), ValuesPerTask,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::size_t i = At(begin); i < At(end); ++i)
      {
        entries[i] = Entry{ level[Id::At(i)] } << 32 | static_cast<Entry>(i);
      }
    });
  RadixSort(entries, 32, 32 + bits, [](Entry entry) { return entry; });
  Report(progress, 0.6);
  HandleVector<Rank, Id> order(level.size());
  rank.resize(level.size());
  ParallelFor(
    0, static_cast<std::int64_t>(level.size()), ValuesPerTask,
    [&](std::int64_t begin, std::int64_t end)
    { Number(entries, At(begin), At(end), 0, order, rank); },
    Between(progress, 0.6, 1.0));
  return order;
}

template HandleVector<EdgeRank, EdgeId> SimplexOrder(const HandleVector<EdgeId, double>&,
  const HandleVector<EdgeId, char>&, HandleVector<EdgeId, EdgeRank>&, const ProgressCallback&);
template HandleVector<TriangleRank, TriangleId> SimplexOrder(
  const HandleVector<TriangleId, double>&, const HandleVector<TriangleId, char>&,
  HandleVector<TriangleId, TriangleRank>&, const ProgressCallback&);
template HandleVector<TetrahedronRank, TetrahedronId> SimplexOrder(
  const HandleVector<TetrahedronId, double>&, const HandleVector<TetrahedronId, char>&,
  HandleVector<TetrahedronId, TetrahedronRank>&, const ProgressCallback&);
template HandleVector<EdgeRank, EdgeId> SimplexOrder(const HandleVector<EdgeId, std::uint32_t>&,
  HandleVector<EdgeId, EdgeRank>&, const ProgressCallback&);
template HandleVector<TriangleRank, TriangleId> SimplexOrder(
  const HandleVector<TriangleId, std::uint32_t>&, HandleVector<TriangleId, TriangleRank>&,
  const ProgressCallback&);

namespace
{

constexpr std::size_t CellsOfPiece = 1 << 14;
constexpr std::ptrdiff_t FewEdges =
  24; ///< counting them is faster than bisection with mispredicted branches

/// Calls visit(cell, corner) for the faces that are triangles of the cells of piece `p`: of two
/// tetrahedra the one with the smaller id has it.
template <typename Visit>
void ForEachFace(const CellFiltration& f, std::size_t p, Visit&& visit)
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
    [&](std::size_t p) { ForEachFace(f, p, [&](TetrahedronId, std::size_t) { ++first[p + 1]; }); });
  std::partial_sum(first.begin(), first.end(), first.begin());
  f.TriangleFaces.resize(first.back());
  forPieces(Between(progress, 0.3, 1.0),
    [&](std::size_t p)
    {
      TriangleId next = TriangleId::At(first[p]);
      ForEachFace(f, p,
        [&](TetrahedronId t, std::size_t k)
        {
          f.TriangleFaces[next] = static_cast<SimplexId>(4 * t.Index() + k);
          ++next.Value;
        });
    });
}

/// See TriangleBlocks.
std::vector<SimplexId> FindTriangleBlocks(const CellFiltration& f)
{
  std::vector<SimplexId> blocks;
  blocks.reserve(f.Tetrahedra.size() / CellFiltration::CellsPerBlock + 2);
  for (const TriangleId t : f.Triangles())
  {
    const auto block =
      static_cast<std::uint32_t>(f.TriangleFaces[t]) / (4 * CellFiltration::CellsPerBlock);
    blocks.resize(std::max<std::size_t>(blocks.size(), block + 1), t.Value);
  }
  blocks.resize(f.Tetrahedra.size() / CellFiltration::CellsPerBlock + 2,
    static_cast<SimplexId>(f.TriangleCount()));
  return blocks;
}

/// `begin` to the end returned: the ids of [begin, end) in ascending order, each once. A point's
/// neighbours come about five times each, and are few: they are inserted one by one.
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

/// Edges bucketed by their smaller point, so that finding one requires searching a short list.
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

/// The edges opposite to the points of a triangle. Two begin at its lowest point: if few edges do,
/// one pass over them finds both.
std::array<EdgeId, 3> FindEdges(const CellFiltration& f, const std::array<SimplexId, 3>& p)
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

void FindEdgePlaces(CellFiltration& f, const ProgressCallback& progress)
{
  const auto place = [&f](EdgeId edge, SimplexId point)
  {
    return static_cast<unsigned char>(
      std::min<SimplexId>(CellFiltration::FarPlace, edge.Value - f.FirstEdge[At(point)].Value));
  };
  f.EdgePlaces.resize(f.TriangleCount());
  ParallelFor(
    0, static_cast<std::int64_t>(f.TriangleCount()), 4096,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (const TriangleId t : HandleRange<TriangleId>(begin, end))
      {
        const auto p = f.TrianglePoints(t);
        const auto edges = FindEdges(f, p);
        f.EdgePlaces[t] = { place(edges[0], p[1]), place(edges[1], p[0]), place(edges[2], p[0]) };
      }
    },
    progress);
}

}

void CellFiltration::RequireNumbers() const
{
  if (this->Tetrahedra.size() > static_cast<std::size_t>(std::numeric_limits<SimplexId>::max() / 4))
  {
    throw std::runtime_error("The tetrahedral complex has " +
      std::to_string(this->Tetrahedra.size()) +
      " cells, more than the 536 million that can be numbered: simplify the surface or raise the "
      "sample spacing.");
  }
}

void CellFiltration::Connect(const ProgressCallback& progress)
{
  this->RequireNumbers();
  MakeTriangles(*this, Between(progress, 0.0, 0.3));
  this->TriangleBlocks = FindTriangleBlocks(*this);
  MakeEdges(*this, Between(progress, 0.3, 0.7));
  FindEdgePlaces(*this, Between(progress, 0.7, 1.0));
}

void CellFiltration::Order(const ProgressCallback& progress)
{
  this->TrianglesInOrder = SimplexOrder(this->TriangleValue, this->TriangleIndistinct,
    this->RankOfTriangle, Between(progress, 0.0, 0.6));
  this->EdgesInOrder = SimplexOrder(
    this->EdgeValue, this->EdgeIndistinct, this->RankOfEdge, Between(progress, 0.6, 1.0));
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
