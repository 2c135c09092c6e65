/**
 * @file SurfaceHomology.h
 * @brief First homology of a closed surface: a basis, the class of a loop, and where classes die in
 * a complex.
 */
#ifndef isthmus_SurfaceHomology_h
#define isthmus_SurfaceHomology_h

#include "ChokingLoops/SurfacePaths.h"
#include "Persistence/FiltrationPairs.h"

#include <algorithm>
#include <set>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// First homology of a closed surface: 2g loops, and the class of any other loop.

/// Coordinates of a class in H1(M; Z/2), 64 per word.
using HomologyClass = std::vector<std::uint64_t>;

/**
 * Basis of H1(M; Z/2) by tree and cotree (D. Eppstein, "Dynamic generators of topologically
 * embedded graphs", SODA 2003): the 2g edges that are neither in a spanning tree of the points nor
 * in one of the triangles, each closed through the tree. The dual loops, closed through the cotree,
 * give the class of any loop of edges.
 */
class SurfaceHomology
{
public:
  /// Time: O(n (1 + g / 64)). Memory, if there are handles: g / 4 bytes per edge.
  explicit SurfaceHomology(const SurfaceAdjacency& surface);

  /// 2g, where g is summed over all components.
  std::size_t Rank() const { return this->Generators.size(); }

  /// Connected components, and the component of each point (-1 for a point no triangle uses).
  int Components() const { return this->ComponentCount; }
  int GetComponent(SimplexId point) const
  {
    return this->Component[static_cast<std::size_t>(point)];
  }

  /// Basis loop i as edges.
  SurfaceChain Loop(std::size_t i) const;

  /// The class of a cycle of edges. Its coordinates are with respect to the loops above.
  HomologyClass GetClass(const SurfaceChain& edges) const;

  /// Adds an edge to the class of a chain. The class starts at zero and equals GetClass() once the
  /// chain is a cycle.
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

/// True if the class is zero, i.e. if the loop bounds on M.
inline bool IsZero(const HomologyClass& c)
{
  return std::all_of(c.begin(), c.end(), [](std::uint64_t word) { return word == 0; });
}

/// A growing subspace of H1(M; Z/2).
class HomologySpan
{
public:
  /// Adds a class; returns true if it was not in the subspace before.
  bool Add(HomologyClass c);

  bool Contains(HomologyClass c) const
  {
    this->Reduce(c);
    return IsZero(c);
  }

  std::size_t Rank() const { return this->Rows.size(); }

private:
  void Reduce(HomologyClass& c) const;

  std::vector<std::pair<std::size_t, HomologyClass>> Rows; ///< leading bit, reduced class
};

// ------------------------------------------------------------------------------------------
// Correspondence between edges of a surface and edges of the complex of its points.

/// The surface's points are points of the complex, with the same ids; its edges and triangles need
/// not be simplices of it.
class SurfaceInComplex
{
public:
  /// O(n). Keeps references to both.
  SurfaceInComplex(const SurfaceAdjacency& surface, const CellFiltration& f,
    const ProgressCallback& progress = {});

  /// The surface's edge that an edge of the complex is, or None.
  SurfaceEdgeId SurfaceEdge(EdgeId edge) const { return this->OnSurface[edge]; }

  /**
   * Edges of the complex that replace an edge of the surface: itself, or the Delaunay edges between
   * the Voronoi cells that it passes. Each of these enters the complex before half the length of
   * the edge, and the path can be deformed into the edge within the balls of that radius.
   */
  EdgeChain Image(SurfaceEdgeId surfaceEdge) const;

  /// Shortest path of surface edges between two points of the surface, at most `reach` long; empty
  /// when there is none.
  std::vector<SurfaceEdgeId> ShortestPath(SimplexId from, SimplexId to, double reach) const;

private:
  const SurfaceAdjacency& Surface;
  const CellFiltration& F;
  HandleVector<EdgeId, SurfaceEdgeId> OnSurface;
  HandleVector<SurfaceEdgeId, EdgeId> InComplex;
  std::vector<SimplexId> FirstSmaller; ///< edges whose larger point is p, in SmallerEdges
  std::vector<EdgeId> SmallerEdges;
};

// ------------------------------------------------------------------------------------------
// Chains of triangles of a complex: their boundary and their connected pieces.

/// Adds an element over Z/2.
template <typename Id>
void Toggle(std::set<Id>& chain, Id e)
{
  if (!chain.erase(e))
  {
    chain.insert(e);
  }
}

/// Boundary of a set of triangles, over Z/2, ascending.
EdgeChain ComputeBoundary(const CellFiltration& f, const TriangleChain& triangles);

/// Those of the `triangles` that are connected with `seed` across edges that are not on M.
TriangleChain ConnectedPiece(const CellFiltration& f, const SurfaceInComplex& surface,
  const std::set<TriangleId>& triangles, TriangleId seed);

// ------------------------------------------------------------------------------------------
// The triangle, and so the radius, at which each class of loops on a surface dies.

/// A class of H1(M) that dies in the complex.
struct SurfaceGenerator
{
  TriangleId Filler;            ///< the triangle that fills it
  std::vector<std::size_t> Sum; ///< the basis loops of SurfaceHomology whose sum it is
};

/**
 * The persistent kernel of H1(M) -> H1(K_d), with Z/2 coefficients: one filler for each class of M
 * that dies in the complex, at the value where the kernel grows.
 *
 * If the complex fills space, all 2g classes die. Where inside and outside are separated (above the
 * sampling error), g of them die inside and g outside ("half lives, half dies"), and a filler
 * closes a class of its side, possibly plus one that died before on the other side. Ascending by
 * value. Time: 2g cycle reductions and an elimination of 2g columns.
 */
std::vector<SurfaceGenerator> SurfaceGenerators(const SurfaceHomology& homology,
  const SurfaceInComplex& surface, const CellFiltration& f, const FiltrationPairs& pairs,
  const ProgressCallback& progress = {});

}

#endif
