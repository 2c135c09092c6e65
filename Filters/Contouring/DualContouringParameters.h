/**
 * @file DualContouringParameters.h
 * @brief What dual contouring is given and asked for.
 */
#ifndef isthmus_DualContouringParameters_h
#define isthmus_DualContouringParameters_h

#include "Contouring/SharpEdges.h"
#include "Core/Geometry.h"
#include "Surfaces/SurfaceCrossings.h"

#include <functional>

namespace isthmus
{

/// Where a surface crosses the lines of a grid, with its normals there ("Hermite data").
struct HermiteGrid
{
  GridShape Shape;
  std::vector<unsigned char> Inside;   ///< of each node: 1 inside, else 0
  std::vector<GridCrossing> Crossings; ///< ordered by node and axis; normals outward
  SharpEdges Sharp;                    ///< where known: points of their cells go there
};

struct DualContouringParameters
{
  /// Directions in which the normals of a cell vary less than this part of how they vary most are
  /// left to the mean of its crossings: 0 (all noise is a feature) to 1 (none is). 0.07: an edge of
  /// 30 degrees, tan^2 of half the angle (SharpEdges.h).
  double FeatureThreshold = 0.07;
  /// Spacings by which a vertex may leave its cell, 0 to 1, whatever is there (at 0: only into
  /// empty cells and to known edges, ContourPlaces.h); polygons cross more easily above 0.
  double Reach = 0.0;
  bool Triangles = true; ///< quadrilaterals cut in two, else as they are
  /// How far the surface may be from that of the whole grid, a length: above 0, cells are put
  /// together (octree) where that allows it. 0: none are.
  double Tolerance = 0.0;
  /// No two triangles cross: quadrilaterals around which they do are cut into triangles that each
  /// stay in a cell. Triangles only.
  bool FreeOfCrossings = false;
  /// Moves points of the grid's frame to where they are wanted; empty: they stay. Point by point.
  std::function<void(std::vector<Point3>& points)> ToWorld;
};

/// Polygons of three or four corners (the fourth then differs from -1).
struct DualContour
{
  std::vector<Point3> Points;
  std::vector<std::array<std::int64_t, 4>> Polygons; ///< counter-clockwise seen from outside
  std::int64_t Crossing = 0; ///< of FreeOfCrossings: triangles that still cross (at the border)
};

}

#endif
