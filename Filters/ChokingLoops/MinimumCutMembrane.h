/**
 * @file MinimumCutMembrane.h
 * @brief Membranes through a choke triangle whatever cycles the filtration closed: that of least
 * area, a minimum cut of the tetrahedra around it, and one that grows greedily.
 */
#ifndef isthmus_MinimumCutMembrane_h
#define isthmus_MinimumCutMembrane_h

#include "ChokingLoops/FeatureDiagram.h"
#include "Core/Progress.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// The minimum cut of a network: the cheapest set of links that separates sources from sinks.

/// A link of two nodes that flow may pass either way.
struct FlowLink
{
  std::array<std::int32_t, 2> Nodes;
  std::int64_t Capacity; ///< not negative
};

/**
 * One char a node: 1 for those that the sources still reach when a largest flow has filled the
 * links. The links from 1 to 0 are a minimum cut, the one nearest to the sources. Whole numbers,
 * so that the answer depends on nothing but the input.
 *
 * Source: Y. Boykov, V. Kolmogorov, IEEE Trans. PAMI 26 (2004) 1124, by Boost.Graph. It runs to its
 * end once begun: 0.1 s on the largest graphs of tetrahedra here.
 *
 * @pre nodes of links, sources and sinks lie in [0, nodes); no node is source and sink.
 * @throws Cancelled before it begins.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<char> MinimumCut(std::int32_t nodes,
  const std::vector<FlowLink>& links, const std::vector<std::int32_t>& sources,
  const std::vector<std::int32_t>& sinks, const ProgressCallback& progress = {});

// ------------------------------------------------------------------------------------------
// The tetrahedra around a choke triangle, and the triangles between them.

/// Place of a cell among the surroundings of a choke.
using CellPlace = Handle<struct SurroundingCell, std::int32_t>;

/// A triangle between two cells.
struct CellLink
{
  std::array<CellPlace, 2> Cells;
  std::int64_t Capacity; ///< its area: 2^30 for a squared radius
  TriangleId Triangle;
};

/**
 * Cells (tetrahedra, and None for what is beyond the complex) round a choke triangle, linked across
 * triangles that are no walls. Costs what lies within reach, times a look-up among all triangles:
 * O(log n).
 */
class ChokeSurroundings
{
public:
  /// @pre `feature.Choke` is a triangle of the complex, `feature.Radius()` is above 0.
  ChokeSurroundings(
    const FeatureContext& context, const ShapeFeature& feature, const Point3& centre)
    : Context(context)
    , F(context.Filtration)
    , Choke(feature.Choke)
    , Centre(centre)
    , Radius(feature.Radius())
  {
  }

  /// Takes in the cells that a walk from the choke meets across triangles with a corner within
  /// `reach` of the centre, `most` and a few at most; false: there are no others. What lies beyond
  /// the complex is met, but not passed: it leads to nothing but dead ends. Asked again, it goes on
  /// from there. @pre `reach` is no less than before.
  bool Collect(double reach, std::size_t most);

  const HandleVector<CellPlace, TetrahedronId>& Cells() const { return this->Met; }

  const std::vector<CellLink>& Links() const { return this->All; }

  /// @pre The cell is one of Cells().
  CellPlace PlaceOf(TetrahedronId cell) const { return this->Places[cell]; }

  /// Calls visit(triangle, cell beyond) for the faces that link a cell.
  template <typename Visit>
  void ForLinks(TetrahedronId cell, Visit&& visit) const;

  bool IsWithin(const Point3& p, double reach) const
  {
    return Dot(p - this->Centre, p - this->Centre) < reach * reach;
  }

  /// The place of a tetrahedron: where Voronoi vertices of samples are, else its centroid.
  Point3 Middle(TetrahedronId cell) const;

private:
  CellPlace Meet(TetrahedronId cell);
  void Pass(CellPlace own);
  void Cross(TriangleId triangle, CellPlace from);
  void Link(TriangleId triangle, CellPlace from, CellPlace to);
  double Area(TriangleId triangle) const;

  /// Of a coarse mesh, not even the choke triangle itself need be that near.
  bool IsWithinReach(TriangleId triangle) const
  {
    const auto corners = this->F.TrianglePoints(triangle);
    return triangle == this->Choke ||
      std::any_of(corners.begin(), corners.end(),
        [this](SimplexId p)
        { return this->IsWithin(this->F.Points[static_cast<std::size_t>(p)], this->Reach); });
  }

  const FeatureContext& Context;
  const CellFiltration& F;
  TriangleId Choke;
  Point3 Centre;
  double Radius;
  double Reach = 0.0;
  IdMap<TetrahedronId, CellPlace> Places{ CellPlace::None() };
  HandleVector<CellPlace, TetrahedronId> Met;
  std::size_t Passed = 0; ///< of the cells met: those whose faces were looked at
  std::vector<std::pair<TriangleId, CellPlace>> Beyond; ///< faces of these out of reach
  std::vector<CellLink> All;
};

template <typename Visit>
void ChokeSurroundings::ForLinks(TetrahedronId cell, Visit&& visit) const
{
  const auto report = [&](TriangleId t)
  {
    if (!this->Context.IsWall(t) && this->IsWithinReach(t))
    {
      visit(t, this->F.Across(t, cell));
    }
  };
  if (cell.Exists())
  {
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      report(this->F.TriangleOf(cell, corner));
    }
    return;
  }
  for (const CellLink& link : this->All)
  {
    if (!this->F.TriangleSides(link.Triangle)[1].Exists())
    {
      report(link.Triangle);
    }
  }
}

// ------------------------------------------------------------------------------------------
// The smallest membrane through a choke triangle, whatever cycles the filtration closed.

struct ShapeFeature;

/**
 * Triangles of the complex that part the space on one side of a feature's choke triangle from that
 * on the other: of all such sets the one of least area, as far as it hangs together with the choke
 * triangle. What is wider than the choke on either side (deeper than its radius and within 1.5
 * radii of `centre`) stays whole, so that the membrane runs through the choke point and does not
 * wrap the way through it.
 *
 * It stands in for the cycle that an edge closed, which may run round the whole shape. The search
 * begins within 3 radii of `centre` and goes on to 6 where the membrane needs it. The boundary lies
 * on M, up to edges as short as the sampling error. Empty when nothing parts the sides there, or
 * beyond 50,000 tetrahedra within reach. Cost: that of MinimumCut on the tetrahedra within
 * reach, which a walk from the choke triangle finds.
 *
 * With `chords`, the boundary may run along edges that join two points of M through the space, as a
 * mesh that M is part of has them: the paths on M that replace them bound little more.
 *
 * Empty, too, where the choke triangle lies on M. @pre `feature.Choke` is a triangle of the
 * complex.
 * @throws Cancelled.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleChain MinimumCutTriangles(
  const FeatureContext& context, const ShapeFeature& feature, const Point3& centre,
  const ProgressCallback& progress = {}, bool chords = false);

// ------------------------------------------------------------------------------------------
// A membrane through a choke triangle that grows step by step.

/// Triangles grown from a choke triangle, and what they cost.
struct GreedyPatches
{
  TriangleChain Triangles; ///< the choke triangle among them
  double Cost = 0.0;       ///< sum over the paths, in the unit of the points
  std::size_t Steps = 0;   ///< vertices whose one-ring was filled
};

/**
 * Grows a membrane as X. Feng's thesis does (6.3.2).
 *
 * The membrane is the choke triangle f at first, with its two tetrahedra in the left and the right
 * cluster. At each step the vertex v of the boundary with the largest value d is taken. In the
 * one-ring of v, a path replaces v between its two neighbours on the boundary; the triangles of the
 * path with v join the membrane, and the tetrahedra around v join the clusters, those on either
 * side of the triangles. The path is the cheapest (Dijkstra) along edges of the ring whose triangle
 * with v is in the filtration before f and has not two tetrahedra of the same cluster. A step from
 * p to q costs (|p - q| + d(q)) / 2: the length keeps the area small, the distance leads down to M.
 * Vertices of the boundary are avoided where that is possible, those passed always, so it ends.
 *
 * It is greedy: nothing is ever taken back, and the area is not minimal (MinimumCutTriangles()).
 * The boundary ends with all of its vertices on M. O(s log s) per step in the s tetrahedra around a
 * vertex.
 *
 * Nothing where the growth has no way on, where v has no whole ring, and where M is not part of the
 * complex: all points of samples lie on M, where d is 0. @pre `feature.Choke` is a triangle of the
 * complex.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::optional<GreedyPatches> GrowGreedily(
  const FeatureContext& context, const ShapeFeature& feature);

}

#endif
