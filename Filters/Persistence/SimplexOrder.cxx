#include "Persistence/SimplexOrder.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/RadixSort.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <mutex>
#include <utility>

namespace isthmus
{
namespace
{

constexpr std::int64_t Grain = 1 << 16;

/// 0 for what comes first, else the bits of the value as an integer in the order of entry.
class EntryKeys
{
public:
  EntryKeys(const std::vector<double>& value, const std::vector<char>& first)
    : Value(value)
    , First(first)
  {
    this->FindRange();
  }

  std::uint64_t Of(std::size_t i) const
  {
    if (!this->First.empty() && this->First[i])
    {
      return 0;
    }
    const double value = this->Value[i] + 0.0; // no -0.0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    return bits >> 63 != 0 ? ~bits : bits | Zero;
  }

  /// The leading bits in which keys differ, in the same order.
  std::uint32_t Short(std::size_t i) const
  {
    const std::uint64_t key = this->Of(i);
    return key <= this->Least ? 0 : static_cast<std::uint32_t>((key - this->Least) >> this->Shift);
  }

private:
  /// The key of value 0. Without negative values, the range begins with the first above it: the
  /// exponents between would take nearly all of it.
  static constexpr std::uint64_t Zero = std::uint64_t{ 1 } << 63;

  void FindRange()
  {
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t most = 0;
    std::mutex mutex;
    ParallelFor(0, static_cast<std::int64_t>(this->Value.size()), Grain,
      [&](std::int64_t begin, std::int64_t end)
      {
        std::uint64_t low = std::numeric_limits<std::uint64_t>::max();
        std::uint64_t high = 0;
        for (std::int64_t i = begin; i < end; ++i)
        {
          const std::uint64_t key = this->Of(At(i));
          low = key != 0 && key != Zero ? std::min(low, key) : low;
          high = std::max(high, key);
        }
        const std::lock_guard<std::mutex> lock(mutex);
        least = std::min(least, low);
        most = std::max(most, high);
      });
    this->Least = std::min(least, most);
    for (const std::uint64_t width = most - this->Least; width >> this->Shift >> 32 != 0;)
    {
      ++this->Shift;
    }
  }

  const std::vector<double>& Value;
  const std::vector<char>& First;
  std::uint64_t Least = 0;
  unsigned int Shift = 0;
};

/// An id below its short key.
using Entry = std::uint64_t;

std::size_t IdOf(Entry entry)
{
  return static_cast<std::size_t>(entry & 0xFFFFFFFFU);
}

/// Whether a run of entries stands in the order of whole keys already: most have one key.
bool IsInOrder(const Entry* begin, const Entry* end, const EntryKeys& keys)
{
  std::uint64_t before = keys.Of(IdOf(*begin));
  for (const Entry* entry = begin + 1; entry != end; ++entry)
  {
    const std::uint64_t key = keys.Of(IdOf(*entry));
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
        run.emplace_back(keys.Of(IdOf(entries[k])), entries[k]);
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
  for (std::int64_t p = 0; p < n; p += Grain)
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

/// Entries of ids 0 to n - 1, sorted by the lowest `bits` bits of key(id); equal ones stay in the
/// order of ids.
template <typename Key>
std::vector<Entry> SortedEntries(std::size_t n, unsigned int bits, const Key& key)
{
  std::vector<Entry> entries(n);
  ParallelFor(0, static_cast<std::int64_t>(n), Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        entries[At(i)] = Entry{ key(At(i)) } << 32 | static_cast<Entry>(i);
      }
    });
  RadixSort(entries, 32, 32 + bits, [](Entry entry) { return entry; });
  return entries;
}

/// Writes down the order and the ranks of the entries [begin, end).
template <typename Id, typename Rank>
void Number(const std::vector<Entry>& entries, std::size_t begin, std::size_t end,
  HandleVector<Rank, Id>& order, HandleVector<Id, Rank>& rank)
{
  for (std::size_t i = begin; i < end; ++i)
  {
    const auto id = Id::At(IdOf(entries[i]));
    order[Rank::At(i)] = id;
    rank[id] = Rank::At(i);
  }
}

}

template <typename Id, typename Rank>
HandleVector<Rank, Id> SimplexOrder(const HandleVector<Id, double>& value,
  const HandleVector<Id, char>& first, HandleVector<Id, Rank>& rank,
  const ProgressCallback& progress)
{
  const EntryKeys keys(value, first);
  Report(progress, 0.1);
  std::vector<Entry> entries =
    SortedEntries(value.size(), 32, [&keys](std::size_t i) { return keys.Short(i); });
  Report(progress, 0.6);
  HandleVector<Rank, Id> order(value.size());
  rank.resize(value.size());
  const std::vector<std::int64_t> starts = RunStarts(entries);
  ParallelFor(
    0, static_cast<std::int64_t>(starts.size()) - 1, 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t p = begin; p < end; ++p)
      {
        const std::size_t from = At(starts[At(p)]);
        const std::size_t to = At(starts[At(p) + 1]);
        SortRuns(entries, keys, from, to);
        Number(entries, from, to, order, rank);
      }
    },
    Between(progress, 0.6, 1.0));
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
  const std::vector<Entry> entries =
    SortedEntries(level.size(), bits, [&level](std::size_t i) { return level[Id::At(i)]; });
  Report(progress, 0.6);
  HandleVector<Rank, Id> order(level.size());
  rank.resize(level.size());
  ParallelFor(
    0, static_cast<std::int64_t>(level.size()), Grain,
    [&](std::int64_t begin, std::int64_t end) { Number(entries, At(begin), At(end), order, rank); },
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

}
