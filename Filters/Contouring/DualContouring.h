/**
 * @file DualContouring.h
 * @brief Computes a surface with sharp edges from crossings and normals on a grid.
 *
 * T. Ju, F. Losasso, S. Schaefer, J. Warren, ACM Trans. Graph. 21 (2002) 339,
 * doi:10.1145/566654.566586: each cell gets the point nearest to the planes of its crossings
 * (QuadricError.h), and each crossed edge a quadrilateral of four such points. A cell has a point
 * for each piece of surface in it (UniformContour.h), so that the surface is manifold; it is open
 * only where it leaves the grid. Points are kept in their cells, except those of edges that pass
 * close to a cell (UniformContour.h). That makes crossing polygons rare but does not prevent them;
 * FreeOfCrossings does.
 *
 * With a tolerance, the points of the cells of an octree are merged (S. Schaefer, T. Ju, J. Warren,
 * doi:10.1109/TVCG.2007.1012; ContourClusters.h) and clusters are split again until the surface is
 * manifold and within the tolerance.
 */
#ifndef isthmus_DualContouring_h
#define isthmus_DualContouring_h

#include "Contouring/UniformContour.h"
#include "Core/Progress.h"

namespace isthmus
{

/// Polygons with three or four corners; for three, the fourth is -1.
struct DualContour
{
  std::vector<Point3> Points;
  std::vector<std::array<std::int64_t, 4>> Polygons; ///< counter-clockwise seen from outside
  std::int64_t Crossing = 0; ///< of FreeOfCrossings: triangles that still cross (at the border)
  /// Share of the crossings that are those of a wall between two nodes, which is lost there.
  double ThinWalls = 0.0;
};

/**
 * The contour of `grid`, in its frame (first node at the origin) or moved by ToWorld. If an edge is
 * crossed several times, the middle crossing is used.
 *
 * Second order on smooth surfaces; edges and corners between planes are exact if the normals are.
 * O(cells + crossings log crossings), points in parallel that are bitwise the same on any number of
 * threads; 400 bytes for each point, and with a tolerance three times that and a few searches for
 * the nearest triangle for each point.
 * @throws std::invalid_argument for parameters out of range, std::runtime_error if inside and
 * crossings contradict each other, and Cancelled.
 */
DualContour DualContouring(const HermiteGrid& grid, const DualContouringParameters& parameters,
  const ProgressCallback& progress = {});

}

#endif
