/**
 * @file DualContouringParameters.h
 * @brief The parameters of all steps of dual contouring (DualContouring.h).
 */
#ifndef isthmus_DualContouringParameters_h
#define isthmus_DualContouringParameters_h

#include "Core/Geometry.h"
#include "vtkIsthmusFiltersContouringModule.h"

#include <functional>
#include <vector>

namespace isthmus
{

struct DualContouringParameters
{
  /// In directions in which the normals of a cell vary less than this fraction of their largest
  /// variation, the mean of its crossings is used. From 0 (all noise is a feature) to 1 (nothing
  /// is); 0.07 corresponds to an edge of 30 degrees, tan^2 of half the angle (HermiteGrid.h).
  double FeatureThreshold = 0.07;
  /// How far, in spacings from 0 to 1, a vertex may leave its cell even if the other cell has a
  /// vertex (at 0, only into empty cells and to known edges); polygons cross more easily above 0.
  double Reach = 0.0;
  bool Quadrilaterals = false; ///< as they are, else cut in two triangles
  /// Allowed distance from the surface of the whole grid, a length. Above 0, cells are merged
  /// (octree) where this is possible; 0: no cells are merged.
  double Tolerance = 0.0;
  /// Ensures that no two triangles cross: quadrilaterals with crossing triangles are cut into
  /// triangles that each stay in one cell. Only for triangles.
  bool FreeOfCrossings = false;
  /// Transforms points from the frame of the grid, each independently of the others; empty: no
  /// transformation.
  std::function<void(std::vector<Point3>& points)> ToWorld;
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSCONTOURING_EXPORT void Check(const DualContouringParameters& parameters);

}

#endif
