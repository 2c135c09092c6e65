/**
 * @file SurfaceHomology.h
 * @brief First homology of a closed surface: 2g loops, and the class of any other loop.
 */
#ifndef isthmus_SurfaceHomology_h
#define isthmus_SurfaceHomology_h

#include "ChokingLoops/SurfaceAdjacency.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <algorithm>

namespace isthmus
{

/// Coordinates of a class in H1(M; Z/2), 64 to a word.
using HomologyClass = std::vector<std::uint64_t>;

/**
 * Basis of H1(M; Z/2) by tree and cotree (D. Eppstein, "Dynamic generators of topologically
 * embedded graphs", SODA 2003): edges that are neither in a spanning tree of the points nor in one
 * of the triangles, 2g of them in all, each closed through the tree. The dual loops, closed through
 * the cotree, read off the class of any loop of edges.
 */
class SurfaceHomology
{
public:
  /// O(n (1 + g / 64)) in time; with handles, g / 4 bytes an edge.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT explicit SurfaceHomology(const SurfaceAdjacency& surface);

  /// 2g, g being the sum over all components.
  std::size_t Rank() const { return this->Generators.size(); }

  /// Connected components, and the component of each point (-1 for a point no triangle uses).
  int Components() const { return this->ComponentCount; }
  int ComponentOf(SimplexId point) const
  {
    return this->Component[static_cast<std::size_t>(point)];
  }

  /// Basis loop i as edges.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT SurfaceChain Loop(std::size_t i) const;

  /// The class of a cycle of edges. Its coordinates are with respect to the loops above.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT HomologyClass ClassOf(const SurfaceChain& edges) const;

  /// Adds an edge to the class of a chain, which is that of no edges at first, and ClassOf() the
  /// chain where it is a cycle.
  void AddTo(HomologyClass& c, SurfaceEdgeId edge) const
  {
    for (std::size_t w = 0; w < this->Words && !this->Crossings.empty(); ++w)
    {
      c[w] ^= this->Crossings[this->Words * edge.Index() + w];
    }
  }

private:
  void GrowTree();
  struct Cotree;
  Cotree GrowCotree();
  void MarkDualLoops(const Cotree& cotree);

  const SurfaceAdjacency& Surface;
  std::vector<HalfEdgeId> Parent; ///< per point: half edge to its parent in the tree; None: root
  std::vector<int> Component;
  HandleVector<SurfaceEdgeId, char> InTree;
  SurfaceChain Generators;
  std::vector<std::uint64_t> Crossings; ///< per edge, Words words: the dual loops that cross it
  std::size_t Words = 0;
  int ComponentCount = 0;
};

/// True for the class of a loop that bounds on M.
inline bool IsZero(const HomologyClass& c)
{
  return std::all_of(c.begin(), c.end(), [](std::uint64_t word) { return word == 0; });
}

/// A growing subspace of H1(M; Z/2).
class HomologySpan
{
public:
  /// Adds a class; true when it was not in the subspace before.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT bool Add(HomologyClass c);

  bool Contains(HomologyClass c) const
  {
    this->Reduce(c);
    return IsZero(c);
  }

  std::size_t Rank() const { return this->Rows.size(); }

private:
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void Reduce(HomologyClass& c) const;

  std::vector<std::pair<std::size_t, HomologyClass>> Rows; ///< leading bit, reduced class
};

}

#endif
