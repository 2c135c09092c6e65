/**
 * @file FiltrationPairs.h
 * @brief Persistent homology over Z/2 of a tetrahedral complex: birth and death of voids and loops.
 */
#ifndef isthmus_FiltrationPairs_h
#define isthmus_FiltrationPairs_h

#include "Persistence/CellFiltration.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

#include <bitset>
#include <functional>

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// The few columns of a boundary matrix that needed a reduction, one after the other.

/**
 * Columns by the rank of their triangle, added in ascending order. A column has the remaining edges
 * by rank, latest first, and the ranks of the triangles whose columns were added to obtain them.
 *
 * One bit for each triangle states whether it has a column, and counts of the bits of each word
 * give its position. This takes 1.5 bits for each triangle, and 16 bytes for each column in
 * addition to its entries.
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

  /// The position of the column of a triangle; -1 if the column is its unreduced boundary.
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
  void ForEachEdge(std::int64_t place, Visit&& visit) const
  {
    this->Edges.ForEach(static_cast<std::size_t>(place), visit);
  }

  template <typename Visit>
  void ForEachAdded(std::int64_t place, Visit&& visit) const
  {
    this->Added.ForEach(static_cast<std::size_t>(place), visit);
  }

private:
  /// Lists that are stored consecutively.
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

//--------------------------------------------------------------------------------------------------
// Persistence of voids: which tetrahedron fills what a triangle closes.

/**
 * For each triangle, the tetrahedron that fills the void it closes, or None if it does not close a
 * void, by values.
 *
 * Tetrahedra are joined across triangles from the last to the first; the younger of two basins,
 * i.e. the one whose latest tetrahedron enters earlier, ends there (the elder rule for the
 * complement; C. J. A. Delfinado, H. Edelsbrunner, 1995). All data are ordered by rank, so that
 * simplices that enter together are stored together. Nearly linear; 12 bytes for each
 * tetrahedron and 2 for each triangle in addition to the result.
 */
HandleVector<TriangleId, TetrahedronId> VoidPairs(
  const CellFiltration& f, const ProgressCallback& progress = {});

/**
 * Every triangle either closes a void (positive) or fills a loop (negative); with indistinct
 * simplices, whose ranks do not follow their values, one may do both.
 *
 * A void that triangle t closes is filled by tetrahedron VoidFilled[t]; a loop that edge e closes
 * is filled by triangle LoopFilled[e].
 */
class FiltrationPairs
{
public:
  /**
   * Pairs all simplices of `f`, which must outlive this object. f.DropTriangleRanks() is allowed
   * afterwards.
   *
   * Voids are paired by union-find over tetrahedra in descending order (the elder rule for the
   * complement), in nearly linear time. Loops are paired by reduction of the columns of negative
   * triangles. All but a few percent of the columns of an alpha complex need no reduction; the
   * worst case is cubic. Time and memory are nearly linear for samples of surfaces. `progress` can
   * abort it.
   */
  VTKISTHMUSFILTERSPERSISTENCE_EXPORT explicit FiltrationPairs(
    const CellFiltration& f, const ProgressCallback& progress = {});

  /// The tetrahedron that fills the void closed by `triangle`. None if it does not close a void, or
  /// only the exterior fills it.
  TetrahedronId VoidFilled(TriangleId triangle) const;

  /// The triangle that fills the loop closed by `edge`, or None.
  TriangleId LoopFilled(EdgeId edge) const;

  /// The edge that closes the loop filled by `triangle`; None if it does not fill a loop.
  EdgeId LoopClosed(TriangleId triangle) const;

  /// The triangles whose boundary is the reduced boundary of a negative triangle: a cycle whose
  /// latest edge is LoopClosed(triangle).
  VTKISTHMUSFILTERSPERSISTENCE_EXPORT TriangleChain Filling(TriangleId triangle) const;

  /// True for an edge that must be removed from the cycle.
  using Unwanted = std::function<bool(EdgeId edge)>;

  /**
   * Pushes cycle `z` downhill: while it has an unwanted edge whose loop was filled by a triangle
   * that enters before `limit`, that loop's boundary is added, latest edge first. Returns the new
   * cycle; the triangles passed are added (mod 2) to `swept`, so that z + result is the boundary of
   * `swept`.
   */
  VTKISTHMUSFILTERSPERSISTENCE_EXPORT EdgeChain Push(
    const EdgeChain& z, TriangleId limit, const Unwanted& unwanted, TriangleChain& swept) const;

  /**
   * Ranks of triangles, latest first, whose reduced boundaries add up to a cycle of edges; edges
   * that occur twice cancel. An edge whose loop is never filled is represented by its own rank plus
   * the number of triangles.
   */
  VTKISTHMUSFILTERSPERSISTENCE_EXPORT std::vector<std::int64_t> Bounding(const EdgeChain& z) const;

private:
  void PairLoops(const ProgressCallback& progress);
  HandleVector<TriangleRank, EdgeRank> Pivots() const;
  struct Reduction;
  bool Reduce(TriangleRank rank, const HandleVector<EdgeRank, TriangleRank>& filler,
    EdgeRank& pivot, Reduction& work, const std::function<void()>& tick);
  std::array<EdgeRank, 3> GetBoundary(TriangleRank rank) const;
  TriangleRank FindRank(TriangleId triangle) const;
  TriangleChain Filling(TriangleRank rank) const;
  template <typename Heap>
  void AddColumn(TriangleRank rank, EdgeRank pivot, Heap& heap) const;

  const CellFiltration& F;
  /// Per triangle: the edge that closes the loop which it fills; -1: it fills none; below that,
  /// -2 - the tetrahedron that fills the void which it closes. No triangle does both.
  HandleVector<TriangleId, SimplexId> Partner;
  HandleVector<TriangleId, TetrahedronId> ByValue; ///< VoidPairs(), if these are different
  HandleVector<EdgeRank, TriangleRank> Filler;     ///< of the loop that an edge closes, or None
  ColumnStore Columns;
};

inline TetrahedronId FiltrationPairs::VoidFilled(TriangleId triangle) const
{
  return this->ByValue.empty() ? TetrahedronId(std::max(-1, -2 - this->Partner[triangle]))
                               : this->ByValue[triangle];
}

inline TriangleId FiltrationPairs::LoopFilled(EdgeId edge) const
{
  const TriangleRank filler = this->Filler[this->F.RankOfEdge[edge]];
  return filler.Exists() ? this->F.TrianglesInOrder[filler] : TriangleId::None();
}

inline EdgeId FiltrationPairs::LoopClosed(TriangleId triangle) const
{
  return EdgeId(std::max(-1, this->Partner[triangle]));
}

}

#endif
