/**
 * @file SpaceRegions.h
 * @brief Inside or outside: the regions into which a surface parts the tetrahedra round it.
 */
#ifndef isthmus_SpaceRegions_h
#define isthmus_SpaceRegions_h

#include "ChokingLoops/EnclosureTest.h"
#include "ChokingLoops/SurfaceInComplex.h"
#include "Core/DisjointSets.h"
#include "Persistence/FiltrationPairs.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <algorithm>
#include <map>

namespace isthmus
{

enum class SpaceSide
{
  Inside = 0,
  Outside = 1
};

/// A filtration of a surface's surroundings, with what belongs to it.
struct FeatureContext
{
  const CellFiltration& Filtration;
  const FiltrationPairs& Pairs;
  const SurfaceHomology& Homology;
  const SurfaceInComplex& Embedding;
  const SurfaceAdjacency& Surface;
  std::vector<double>
    PointError; ///< SamplingErrors() (SurfacePreparation.h); empty: M is part of the complex

  /// Square of the largest sampling error at the corners of a simplex, with a margin for rounding.
  template <std::size_t N>
  double SquaredError(const std::array<SimplexId, N>& corners) const
  {
    double e = 0.0;
    for (const SimplexId p : corners)
    {
      e =
        std::max(e, this->PointError.empty() ? 0.0 : this->PointError[static_cast<std::size_t>(p)]);
    }
    return (1.0 + 1e-7) * e * e;
  }

  /// True for a triangle of the complex that may cross M or be part of it.
  bool IsWall(TriangleId triangle) const;
};

/**
 * Tetrahedra grouped across triangles that are no walls; a group lies in one region, that of the
 * circumcentre of its latest tetrahedron (of its middle, where M is part of the complex).
 *
 * The dual edge of a triangle that enters above the sampling error keeps away from M, so that the
 * circumcentres at its ends lie on the same side.
 */
class SpaceRegions
{
public:
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT explicit SpaceRegions(
    const FeatureContext& context, const ProgressCallback& progress = {});

  /// The components of M that enclose a tetrahedron, ascending; none for the exterior (None).
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const std::vector<int>& Of(TetrahedronId cell);

  /// The same for a triangle that is no wall.
  const std::vector<int>& OfTriangle(TriangleId triangle);

  static SpaceSide SideOf(const std::vector<int>& enclosing)
  {
    return enclosing.size() % 2 == 1 ? SpaceSide::Inside : SpaceSide::Outside;
  }

private:
  Point3 Inner(TetrahedronId deepest) const;

  const FeatureContext& Context;
  DisjointSets<TetrahedronId> Groups; ///< the root of each is its latest tetrahedron
  EnclosureTest Test;
  std::map<TetrahedronId, std::vector<int>> Known;
};

/// Centre of the smallest sphere through the corners of a triangle or tetrahedron.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT Point3 Circumcentre(
  const Point3& p, const Point3& q, const Point3& r);
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT Point3 Circumcentre(
  const Point3& p, const Point3& q, const Point3& r, const Point3& s);

inline bool FeatureContext::IsWall(TriangleId t) const
{
  return this->PointError.empty()
    ? this->Filtration.TriangleFirst[t] != 0
    : this->Filtration.TriangleValue[t] <= this->SquaredError(this->Filtration.TrianglePoints(t));
}

inline const std::vector<int>& SpaceRegions::OfTriangle(TriangleId triangle)
{
  return this->Of(this->Context.Filtration.TriangleSides(triangle)[0]);
}

}

#endif
