/**
 * @file ContourPolygons.h
 * @brief The polygons of a contour whose points are put together, and finer ones where they cross.
 *
 * A quadrilateral whose points are put together becomes a triangle or nothing. A *cut* one becomes
 * triangles around its crossing; where it borders on another one (a "side": a face of the grid
 * between two cells), they get a point on that face, halfway between both crossings. Each of these
 * triangles stays in one cell (T. Ju, T. Udeshi, Intersection-free contouring on an octree grid,
 * Pacific Graphics 2006).
 */
#ifndef isthmus_ContourPolygons_h
#define isthmus_ContourPolygons_h

#include "Contouring/ContourClusters.h"

#include <map>

namespace isthmus
{

/// Corners: ids of points and clusters, then of More; the fourth is -1 in triangles.
struct ContourPolygons
{
  std::vector<std::array<std::int64_t, 4>> Corners;
  std::vector<std::int64_t> Edge;   ///< of each: the crossed edge it is around
  std::vector<std::int64_t> Folded; ///< crossed edges two of whose opposite points are the same
  std::vector<Point3> More;         ///< crossings, and points on faces
};

/// Which quadrilaterals are cut. @pre only those none of whose points stand in a cluster.
class ContourCuts
{
public:
  /// O(edges log edges), 100 bytes an edge.
  explicit ContourCuts(const UniformContour& contour);

  bool Has(std::int64_t edge) const { return this->IsCut[static_cast<std::size_t>(edge)] != 0; }
  void Cut(std::int64_t edge) { this->IsCut[static_cast<std::size_t>(edge)] = 1; }
  /// The other edge around which two points are neighbours; -1 at the border of the grid.
  std::int64_t Beyond(std::int64_t edge, std::int64_t a, std::int64_t b) const;

private:
  struct Side
  {
    std::array<std::int64_t, 2> Points; ///< ascending
    std::int64_t Edge;
  };

  std::vector<Side> Sides; ///< ascending
  std::vector<char> IsCut;
};

/// O(edges). @param cuts none, or what is to be cut.
ContourPolygons PolygonsOf(const UniformContour& contour, const ContourClusters& clusters,
  bool triangles, const ContourCuts* cuts);

}

#endif
