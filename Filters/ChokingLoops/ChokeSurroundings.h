/**
 * @file ChokeSurroundings.h
 * @brief The tetrahedra round a choke triangle, and the triangles that link them.
 */
#ifndef isthmus_ChokeSurroundings_h
#define isthmus_ChokeSurroundings_h

#include "Index.h"
#include "MinimumCut.h"
#include "ShapeFeatures.h"

#include <algorithm>
#include <unordered_map>

namespace isthmus
{

/// Calls visit(triangle) for each face of a tetrahedron. Triangles are sorted by the first of
/// their sides, the tetrahedron with the smaller id (CellFiltration::Connect()).
template <typename Visit>
void ForFaces(const CellFiltration& f, SimplexId cell, Visit&& visit)
{
  const auto& n = f.Neighbours[static_cast<std::size_t>(cell)];
  std::array<SimplexId, 5> firsts{ n[0], n[1], n[2], n[3], cell };
  std::sort(firsts.begin(), firsts.end());
  const auto end = std::unique(firsts.begin(), firsts.end());
  for (auto first = firsts.begin(); first != end && *first <= cell; ++first)
  {
    const auto begin =
      std::lower_bound(f.TriangleFaces.begin(), f.TriangleFaces.end(), 4 * std::max(*first, 0));
    for (auto s = begin; *first >= 0 && s != f.TriangleFaces.end() && *s / 4 == *first; ++s)
    {
      const SimplexId other = f.Neighbours[static_cast<std::size_t>(*first)][At(*s % 4)];
      if (*first == cell || other == cell)
      {
        visit(static_cast<SimplexId>(s - f.TriangleFaces.begin()));
      }
    }
  }
}

/**
 * Cells (tetrahedra, and -1 for what is beyond the complex) round a choke triangle, linked across
 * triangles that are no walls. Costs what lies within reach, times a look-up among all triangles:
 * O(log n).
 */
class ChokeSurroundings
{
public:
  /// @pre `feature.Choke` is a triangle of the complex, `feature.Distance()` is above 0.
  ChokeSurroundings(
    const FeatureContext& context, const ShapeFeature& feature, const Point3& centre)
    : Context(context)
    , F(context.Filtration)
    , Choke(feature.Choke)
    , Centre(centre)
    , Radius(feature.Distance())
  {
  }

  /// Takes in the cells that a walk from the choke meets across triangles with a corner within
  /// `reach` of the centre, `most` and a few at most; false: there are no others. What lies beyond
  /// the complex is met, but not passed: it leads to nothing but dead ends.
  bool Collect(double reach, std::size_t most);

  const std::vector<SimplexId>& Cells() const { return this->Met; }

  /// Their places in Cells(), with areas as capacities: 2^30 for a squared radius.
  const std::vector<FlowLink>& Links() const { return this->All; }

  /// The triangle of each link.
  const std::vector<SimplexId>& Triangles() const { return this->Linking; }

  std::int32_t PlaceOf(SimplexId cell) const { return this->Places.at(cell); }

  /// Calls visit(triangle, cell beyond) for the faces that link a cell.
  template <typename Visit>
  void ForLinks(SimplexId cell, Visit&& visit) const;

  bool IsWithin(const Point3& p, double reach) const
  {
    return Dot(p - this->Centre, p - this->Centre) < reach * reach;
  }

  /// The place of a tetrahedron: where Voronoi vertices of samples are, else its centroid.
  Point3 Middle(SimplexId cell) const;

private:
  std::int32_t Meet(SimplexId cell);
  void Link(SimplexId triangle, std::int32_t from, std::int32_t to);
  double Area(SimplexId triangle) const;

  /// Of a coarse mesh, not even the choke triangle itself need be that near.
  bool IsWithinReach(SimplexId triangle) const
  {
    const auto corners = this->F.TrianglePoints(static_cast<std::size_t>(triangle));
    return triangle == this->Choke ||
      std::any_of(corners.begin(), corners.end(),
        [this](SimplexId p)
        { return this->IsWithin(this->F.Points[static_cast<std::size_t>(p)], this->Reach); });
  }

  SimplexId Beyond(SimplexId triangle, SimplexId cell) const
  {
    const auto sides = this->F.TriangleSides(static_cast<std::size_t>(triangle));
    return sides[0] == cell ? sides[1] : sides[0];
  }

  const FeatureContext& Context;
  const CellFiltration& F;
  SimplexId Choke;
  Point3 Centre;
  double Radius;
  double Reach = 0.0;
  std::unordered_map<SimplexId, std::int32_t> Places;
  std::vector<SimplexId> Met;
  std::vector<SimplexId> Linking;
  std::vector<FlowLink> All;
};

template <typename Visit>
void ChokeSurroundings::ForLinks(SimplexId cell, Visit&& visit) const
{
  const auto report = [&](SimplexId t)
  {
    if (!this->Context.IsWall(t) && this->IsWithinReach(t))
    {
      visit(t, this->Beyond(t, cell));
    }
  };
  if (cell >= 0)
  {
    ForFaces(this->F, cell, report);
    return;
  }
  for (const SimplexId t : this->Linking)
  {
    if (this->F.TriangleSides(static_cast<std::size_t>(t))[1] < 0)
    {
      report(t);
    }
  }
}

}

#endif
