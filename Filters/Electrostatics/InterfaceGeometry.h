/**
 * @file InterfaceGeometry.h
 * @brief Crossings of a level set with the edges of a grid, with normal and curvature tensor.
 *
 * Along the edge the level function is the polynomial through six nodes, across it derivatives are
 * central ones of fourth order, so that crossings, normals and curvatures converge faster than the
 * second order that the solver needs of them. (Those of the thesis, 5.21 to 5.23, are linear.)
 */
#ifndef isthmus_InterfaceGeometry_h
#define isthmus_InterfaceGeometry_h

#include "Core/Progress.h"
#include "Electrostatics/LevelFunction.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

#include <vector>

namespace isthmus
{

/// The surface at a point: outward unit normal, and W = P (grad grad S) P / |grad S| with
/// P = 1 - n n^T (xx, yy, zz, xy, xz, yz), P / R for a sphere.
struct SurfaceFrame
{
  Point3 Normal{ 0.0, 0.0, 1.0 };
  std::array<double, 6> Curvature{ 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
};

/// Crossing of the surface with the edge from `Node` to the next node along `Axis`.
struct InterfaceCrossing
{
  std::int64_t Node = 0;
  int Axis = 0;
  double Fraction = 0.0; ///< of the edge, from Node
  SurfaceFrame Frame;
};

/// 1 for the nodes of the box inside the level, else 0. Parallel.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::vector<unsigned char> ClassifyNodes(
  const LevelFunction& level, const SolverBox& box);

/**
 * All crossings, ordered by node, then axis. Throws std::invalid_argument if one is less than three
 * nodes away from the border of the box. O(nodes + 200 crossings), parallel, the same on any number
 * of threads; Cancelled.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::vector<InterfaceCrossing> FindCrossings(
  const LevelFunction& level, const SolverBox& box, const std::vector<unsigned char>& inside,
  const ProgressCallback& progress = {});

/// The point of the level set nearest to x, which must be within about a spacing of it; computed by
/// Newton steps along the gradient of the polynomial through 6^3 nodes.
Point3 OnLevel(const LevelFunction& level, const SolverBox& box, Point3 x);

/// The frame of the level set through the point `x` (frame of the volume).
SurfaceFrame FrameAt(const LevelFunction& level, const SolverBox& box, const Point3& x);

}

#endif
