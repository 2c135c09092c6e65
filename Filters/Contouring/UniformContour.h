/**
 * @file UniformContour.h
 * @brief Dual contouring on every cell of a grid: what cells are put together from, or the result.
 */
#ifndef isthmus_UniformContour_h
#define isthmus_UniformContour_h

#include "Contouring/DualContouringParameters.h"
#include "Contouring/QuadricError.h"
#include "Core/Progress.h"

namespace isthmus
{

/// One point for each piece of surface in a cell, one quadrilateral for each crossed edge.
struct UniformContour
{
  using Index = std::array<std::int64_t, 3>;

  /// An edge of the grid that the surface crosses, with cells all around.
  struct Edge
  {
    std::array<std::int64_t, 4> Around; ///< its points, counter-clockwise seen from outside
    Point3 Crossing;                    ///< a thousandth of the edge away from its ends at least
    Point3 Normal;
  };

  GridShape Shape;
  std::vector<Index> Cells;            ///< of each point: its cell's lowest node
  std::vector<QuadraticErrors> Errors; ///< of each point: the tangent planes of its crossings
  std::vector<Point3> Points;          ///< where these are least in the cell
  std::vector<char> IsSharp;           ///< of each point: on a known sharp edge or corner
  std::vector<Edge> Edges;
};

/**
 * O(cells + crossings log crossings), points in parallel with the same bits on any number of
 * threads; 400 bytes a point.
 * @throws std::runtime_error where inside and crossings contradict each other, and Cancelled.
 */
UniformContour MakeUniformContour(const HermiteGrid& grid,
  const DualContouringParameters& parameters, const ProgressCallback& progress);

}

#endif
