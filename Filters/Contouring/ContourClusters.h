/**
 * @file ContourClusters.h
 * @brief Vertex clustering of a uniform contour in an octree, and the resulting polygons.
 */
#ifndef isthmus_ContourClusters_h
#define isthmus_ContourClusters_h

#include "Contouring/UniformContour.h"
#include "Core/Geometry.h"
#include "Core/Index.h"

#include <map>

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// Points of a uniform contour, merged in an octree.
//
// S. Schaefer, T. Ju, J. Warren, IEEE TVCG 13 (2007) 610, doi:10.1109/TVCG.2007.1012: in each cell
// of the octree, from small to large, the points that the surface joins within the cell become a
// cluster with a new point that best fits the planes of all. The cluster may replace them if its
// point is within the tolerance of the planes (root mean square) and its piece of surface is a
// disc, i.e. points - edges + faces inside the cell is 1.

class ContourClusters
{
public:
  /// O(points log points), 200 bytes per point. @throws Cancelled
  ContourClusters(const UniformContour& contour, const DualContouringParameters& parameters,
    const ProgressCallback& progress);

  /// For each point of the contour: the largest cluster that may replace it, or itself.
  const std::vector<std::int64_t>& Tops() const { return this->Top; }
  /// The clusters are stored after the points of the contour.
  bool IsCluster(std::int64_t id) const { return id >= this->NumberOfPoints; }
  std::int64_t Size() const { return static_cast<std::int64_t>(this->Points.size()); }
  const Point3& GetPoint(std::int64_t id) const { return this->Points[At(id)]; }

  /// Moves a point of the contour.
  void Move(std::int64_t point, const Point3& x) { this->Points[At(point)] = x; }
  /// From the next Choose() on, `id` no longer represents others. False if it never did.
  bool Split(std::int64_t id);
  /// Tops again. O(points)
  void Choose();

private:
  struct Open ///< a cluster or point without parent, as yet
  {
    std::int64_t Id;
    QuadricError Errors;
  };
  struct Level ///< the parts that remain to be merged
  {
    std::vector<Open> Clusters;
    std::vector<std::array<std::int64_t, 2>> Sides; ///< of quadrilaterals, between two clusters
    std::vector<std::array<std::int64_t, 4>> Edges; ///< quadrilaterals among several clusters
    std::vector<UniformContour::Index> Cells;       ///< of each id: any fine cell in it
    std::vector<int> Euler;                         ///< of each id
  };

  Level Fine(const UniformContour& contour) const;
  /// False if no larger cluster is possible.
  bool AddLevel(Level& level, int depth, const UniformContour& contour,
    const DualContouringParameters& parameters);
  std::vector<std::int64_t> JoinRoots(Level& level, int depth) const;
  bool Place(const Open& open, const Bounds3& box, const DualContouringParameters& parameters);
  void Relabel(Level& level) const;

  std::int64_t NumberOfPoints;
  std::vector<Point3> Points;
  std::vector<std::int64_t> Parent; ///< -1: none
  std::vector<char> MayStand;
  std::vector<std::int64_t> Top; ///< of each id
};

//--------------------------------------------------------------------------------------------------
// The polygons of a contour whose points are merged, and finer ones where they cross.
//
// A quadrilateral whose points are merged becomes a triangle or vanishes. A cut one becomes
// triangles around its crossing. Where it borders on another one (a "side": a face of the grid
// between two cells), these get a point on that face, halfway between both crossings. Each of these
// triangles stays in one cell (T. Ju, T. Udeshi, Intersection-free contouring on an octree grid,
// Pacific Graphics 2006).

/// Corners: ids of points and clusters, then of More; the fourth is -1 in triangles.
struct ContourPolygons
{
  std::vector<std::array<std::int64_t, 4>> Corners;
  std::vector<std::int64_t> Edge;   ///< of each: the crossed edge it is around
  std::vector<std::int64_t> Folded; ///< crossed edges two of whose opposite points are the same
  std::vector<Point3> More;         ///< crossings, and points on faces
};

/// The quadrilaterals that are cut.
/// @pre none of their points is in a cluster.
class ContourCuts
{
public:
  /// O(edges log edges), 100 bytes for each edge.
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

/// O(edges). @param cuts null, or the quadrilaterals to be cut.
ContourPolygons BuildPolygons(const UniformContour& contour, const ContourClusters& clusters,
  bool triangles, const ContourCuts* cuts);

//--------------------------------------------------------------------------------------------------
// Whether the polygons around each point of a contour form one ring.

struct NonManifoldPoints
{
  std::vector<std::int64_t> Edges; ///< crossed edges of the polygons in them, and folded ones
  std::vector<char> IsThere;       ///< of each point and cluster: it has polygons
};

/**
 * Points whose polygons do not form one ring of at least three consistently oriented polygons; for
 * points in `mayBeOpen` and for points of polygons.More, a chain is sufficient. O(n log n), 130
 * bytes for each polygon.
 */
NonManifoldPoints FindNonManifoldPoints(
  const ContourPolygons& polygons, const std::vector<char>& mayBeOpen);

}

#endif
