/**
 * @file ColumnStore.h
 * @brief The few columns of a boundary matrix that took a reduction, one after the other.
 */
#ifndef isthmus_ColumnStore_h
#define isthmus_ColumnStore_h

#include "Persistence/CellFiltration.h"

#include <bitset>

namespace isthmus
{

/**
 * Columns by the rank of their triangle, added in ascending order: the edges that are left, by
 * rank, latest first, and the ranks of the triangles whose columns were added to get there.
 *
 * One bit a triangle says which have one; counts of bits, word by word, say where it lies. That is
 * 1.5 bits a triangle, and 16 bytes a column beside its entries.
 */
class ColumnStore
{
public:
  explicit ColumnStore(std::size_t triangles)
    : Marks(triangles / 64 + 1, 0)
    , Before(triangles / 64 + 1, 0)
  {
  }

  /// @pre `rank` is above those added before.
  void Add(
    TriangleRank rank, const std::vector<EdgeRank>& edges, const std::vector<TriangleRank>& added)
  {
    const std::size_t word = rank.Index() / 64;
    for (; this->Counted < word; ++this->Counted)
    {
      this->Before[this->Counted + 1] = static_cast<std::uint32_t>(this->Edges.Count());
    }
    this->Marks[word] |= Bit(rank);
    this->Edges.Add(edges);
    this->Added.Add(added);
  }

  void Finish()
  {
    this->Edges.Fit();
    this->Added.Fit();
  }

  /// The place of a triangle's column; -1: it is its boundary as it stands.
  std::int64_t Find(TriangleRank rank) const
  {
    const std::size_t word = rank.Index() / 64;
    if ((this->Marks[word] & Bit(rank)) == 0)
    {
      return -1;
    }
    const std::uint64_t below = this->Marks[word] & (Bit(rank) - 1);
    return this->Before[word] + static_cast<std::int64_t>(std::bitset<64>(below).count());
  }

  template <typename Visit>
  void ForEdges(std::int64_t place, Visit&& visit) const
  {
    this->Edges.ForEach(static_cast<std::size_t>(place), visit);
  }

  template <typename Visit>
  void ForAdded(std::int64_t place, Visit&& visit) const
  {
    this->Added.ForEach(static_cast<std::size_t>(place), visit);
  }

private:
  /// Lists without a gap between them.
  template <typename Rank>
  class Lists
  {
  public:
    std::size_t Count() const { return this->First.size() - 1; }

    void Add(const std::vector<Rank>& list)
    {
      this->Entries.insert(this->Entries.end(), list.begin(), list.end());
      this->First.push_back(this->Entries.size());
    }

    void Fit()
    {
      this->Entries.shrink_to_fit();
      this->First.shrink_to_fit();
    }

    template <typename Visit>
    void ForEach(std::size_t list, Visit&& visit) const
    {
      for (std::size_t i = this->First[list]; i < this->First[list + 1]; ++i)
      {
        visit(this->Entries[i]);
      }
    }

  private:
    std::vector<Rank> Entries;
    std::vector<std::size_t> First{ 0 };
  };

  static std::uint64_t Bit(TriangleRank rank) { return std::uint64_t{ 1 } << (rank.Value % 64); }

  std::vector<std::uint64_t> Marks;
  std::vector<std::uint32_t> Before; ///< columns before each word, of the words counted so far
  std::size_t Counted = 0;
  Lists<EdgeRank> Edges;
  Lists<TriangleRank> Added;
};

}

#endif
