/**
 * @file ContourClusters.h
 * @brief Points of a uniform contour put together in an octree.
 *
 * S. Schaefer, T. Ju, J. Warren, IEEE TVCG 13 (2007) 610, doi:10.1109/TVCG.2007.1012: in each cell
 * of the octree, from small to large, the points that the surface joins within the cell become a
 * cluster, with a point of its own where the planes of all are met best. It may stand for them
 * where its planes are met within the tolerance (root of the mean square) and its piece of surface
 * is a disc: points - edges + faces, each inside the cell, is 1.
 */
#ifndef isthmus_ContourClusters_h
#define isthmus_ContourClusters_h

#include "Contouring/UniformContour.h"
#include "Core/Geometry.h"
#include "Core/Index.h"

namespace isthmus
{

class ContourClusters
{
public:
  /// O(points log points), 200 bytes a point. @throws Cancelled
  ContourClusters(const UniformContour& contour, const DualContouringParameters& parameters,
    const ProgressCallback& progress);

  /// For each point of the contour: the largest cluster that may stand for it, or itself.
  const std::vector<std::int64_t>& Tops() const { return this->Top; }
  /// Clusters follow the points of the contour.
  bool IsCluster(std::int64_t id) const { return id >= this->NumberOfPoints; }
  std::int64_t Size() const { return static_cast<std::int64_t>(this->Points.size()); }
  const Point3& PointOf(std::int64_t id) const { return this->Points[At(id)]; }

  /// A point of the contour goes elsewhere.
  void Move(std::int64_t point, const Point3& x) { this->Points[At(point)] = x; }
  /// `id` stands for others no more, from the next Choose() on. False if it never did.
  bool Split(std::int64_t id);
  /// Tops anew. O(points)
  void Choose();

private:
  struct Open ///< a cluster or point without parent, as yet
  {
    std::int64_t Id;
    QuadraticErrors Errors;
  };
  struct Level ///< what is left to put together
  {
    std::vector<Open> Clusters;
    std::vector<std::array<std::int64_t, 2>> Sides; ///< of quadrilaterals, between two clusters
    std::vector<std::array<std::int64_t, 4>> Edges; ///< quadrilaterals among several clusters
    std::vector<UniformContour::Index> Cells;       ///< of each id: any fine cell in it
    std::vector<int> Euler;                         ///< of each id
  };

  Level Fine(const UniformContour& contour) const;
  /// False when no larger cluster can do any more.
  bool AddLevel(Level& level, int depth, const UniformContour& contour,
    const DualContouringParameters& parameters);
  std::vector<std::int64_t> Joined(Level& level, int depth) const;
  bool Place(const Open& open, const Bounds3& box, const DualContouringParameters& parameters);
  void Relabel(Level& level) const;

  std::int64_t NumberOfPoints;
  std::vector<Point3> Points;
  std::vector<std::int64_t> Parent; ///< -1: none
  std::vector<char> MayStand;
  std::vector<std::int64_t> Top; ///< of each id
};

}

#endif
