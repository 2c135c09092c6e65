/**
 * @file MinimumCutMembrane.h
 * @brief The membrane of least area through a choke triangle: a minimum cut of the tetrahedra
 * around it, which does not depend on the cycles of the filtration.
 */
#ifndef isthmus_MinimumCutMembrane_h
#define isthmus_MinimumCutMembrane_h

#include "ChokingLoops/FeatureDiagram.h"
#include "Core/Progress.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// The minimum cut of a network: the cheapest set of links that separates sources from sinks.

/// A link between two nodes; flow may pass in both directions.
struct FlowLink
{
  std::array<std::int32_t, 2> Nodes;
  std::int64_t Capacity; ///< not negative
};

/**
 * One char per node: 1 for nodes that the sources still reach after a maximum flow has saturated
 * the links. The links from 1 to 0 are a minimum cut, the one nearest to the sources. Capacities
 * are integers, so the result depends on the input only.
 *
 * Source: Y. Boykov, V. Kolmogorov, IEEE Trans. PAMI 26 (2004) 1124, in the implementation of
 * Boost.Graph. It cannot be cancelled while it runs, which takes 0.1 s on the largest graphs of
 * tetrahedra here.
 *
 * @pre nodes of links, sources and sinks lie in [0, nodes); no node is source and sink.
 * @throws Cancelled before it begins.
 */
std::vector<char> MinimumCut(std::int32_t nodes, const std::vector<FlowLink>& links,
  const std::vector<std::int32_t>& sources, const std::vector<std::int32_t>& sinks,
  const ProgressCallback& progress = {});

// ------------------------------------------------------------------------------------------
// The tetrahedra around a choke triangle, and the triangles between them.

/// Index of a cell in the surroundings of a choke.
using CellPlace = Handle<struct SurroundingCell, std::int32_t>;

/// A triangle between two cells.
struct CellLink
{
  std::array<CellPlace, 2> Cells;
  std::int64_t Capacity; ///< its area, scaled so that a squared radius has 2^30
  TriangleId Triangle;
};

/**
 * Cells (tetrahedra, and None for the space beyond the complex) around a choke triangle, linked
 * across triangles that are not walls. Time: number of cells within reach times O(log n), for
 * finding a triangle among all triangles.
 */
class ChokeSurroundings
{
public:
  /// @pre `feature.Choke` is a triangle of the complex, `feature.Radius()` is above 0.
  ChokeSurroundings(
    const FeatureContext& context, const ShapeFeature& feature, const Point3& center)
    : Context(context)
    , F(context.Filtration)
    , Choke(feature.Choke)
    , Center(center)
    , Radius(feature.Radius())
  {
  }

  /// Collects the cells that a search from the choke reaches across triangles with a corner within
  /// `reach` of the center, and stops after slightly more than `most`; returns false if there are
  /// no more cells. The space beyond the complex is recorded but not crossed, since it leads only
  /// to dead ends. Another call continues the search. @pre `reach` is not less than before.
  bool Collect(double reach, std::size_t most);

  const HandleVector<CellPlace, TetrahedronId>& Cells() const { return this->Met; }

  const std::vector<CellLink>& Links() const { return this->All; }

  /// @pre The cell is one of Cells().
  CellPlace GetPlace(TetrahedronId cell) const { return this->Places[cell]; }

  /// Calls visit(triangle, cell beyond) for the faces that link a cell.
  template <typename Visit>
  void ForLinks(TetrahedronId cell, Visit&& visit) const;

  bool IsWithin(const Point3& p, double reach) const
  {
    return Dot(p - this->Center, p - this->Center) < reach * reach;
  }

  /// The position of a tetrahedron: its Voronoi vertex on a complex of samples, otherwise its
  /// centroid.
  Point3 Middle(TetrahedronId cell) const;

private:
  CellPlace Meet(TetrahedronId cell);
  void Pass(CellPlace own);
  void Cross(TriangleId triangle, CellPlace from);
  void Link(TriangleId triangle, CellPlace from, CellPlace to);
  double Area(TriangleId triangle) const;

  /// On a coarse mesh, even the choke triangle itself may be farther away.
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
  Point3 Center;
  double Radius;
  double Reach = 0.0;
  IdMap<TetrahedronId, CellPlace> Places{ CellPlace::None() };
  HandleVector<CellPlace, TetrahedronId> Met;
  std::size_t Passed = 0; ///< number of cells whose faces have been examined
  std::vector<std::pair<TriangleId, CellPlace>>
    Beyond; ///< faces of these cells that were out of reach
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
      report(this->F.GetTriangle(cell, corner));
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
// The membrane of least area through a choke triangle.

struct ShapeFeature;

/**
 * The set of triangles of least area that separates the spaces on the two sides of a feature's
 * choke triangle, restricted to its part connected with the choke triangle. The wider space on
 * either side (deeper than the radius of the choke and within 1.5 radii of `center`) is not cut, so
 * the membrane runs through the choke point instead of wrapping around the passage.
 *
 * It replaces the cycle that an edge closed in the filtration, which may run around the whole
 * shape. The search begins within 3 radii of `center` and is extended to 6 if the membrane requires
 * it. The boundary lies on M, except for edges as short as the sampling error. The result is empty
 * if nothing separates the sides there, or if there are more than 50,000 tetrahedra within reach.
 * Cost: that of MinimumCut() on the tetrahedra within reach.
 *
 * With `chords`, the boundary may run along edges that join two points of M through the space,
 * which occur in a mesh that contains M. The paths on M that replace them change the area little.
 *
 * The result is also empty if the choke triangle lies on M. @pre `feature.Choke` is a triangle of
 * the complex.
 * @throws Cancelled.
 */
TriangleChain MinimumCutTriangles(const FeatureContext& context, const ShapeFeature& feature,
  const Point3& center, const ProgressCallback& progress = {}, bool chords = false);

}

#endif
