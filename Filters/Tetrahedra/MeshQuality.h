/**
 * @file MeshQuality.h
 * @brief Angles and ratios of triangles and tetrahedra, and their distribution.
 */
#ifndef isthmus_MeshQuality_h
#define isthmus_MeshQuality_h

#include "Core/Progress.h"
#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersTetrahedraModule.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace isthmus
{

/// Angles in degrees. Of a cell without area or volume: angles 0, ratio infinite.
struct CellAngles
{
  double Smallest = 0.0; ///< of a triangle; dihedral of a tetrahedron
  double Largest = 0.0;
  double RadiusEdge = std::numeric_limits<double>::infinity(); ///< circumradius / shortest edge
  double Size = 0.0;                                           ///< area or volume
};

/// Counts of all angles (three a triangle, six a tetrahedron) in equal bins over [0, 180] degrees,
/// and what a line about the mesh needs.
struct QualitySummary
{
  std::vector<std::int64_t> Bins;
  double SmallestAngle = 180.0;
  double LargestAngle = 0.0;
  double LargestRadiusEdge = 0.0;
  double TotalSize = 0.0;
  std::int64_t Cells = 0;
  std::int64_t Slivers = 0; ///< tetrahedra with a dihedral angle below 5 degrees
};

/// Radius-edge ratio is at least 1/sqrt(3) = 0.577 (equilateral).
VTKISTHMUSFILTERSTETRAHEDRA_EXPORT CellAngles MeasureTriangle(
  const Point3& a, const Point3& b, const Point3& c);

/// Radius-edge ratio is at least sqrt(6)/4 = 0.612 (regular), and does not see slivers.
VTKISTHMUSFILTERSTETRAHEDRA_EXPORT CellAngles MeasureTetrahedron(
  const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Measures of each cell into `cells` (of the same size) and the summary, in parallel. O(n).
/// `ghosts`: one flag a cell, or none; where it is not 0 the cell is measured, and not in the
/// summary, since another rank has it in its own.
VTKISTHMUSFILTERSTETRAHEDRA_EXPORT QualitySummary MeasureQuality(const SurfaceView& surface,
  int bins, std::vector<CellAngles>& cells, const ProgressCallback& progress = {},
  const View<unsigned char>& ghosts = {});
VTKISTHMUSFILTERSTETRAHEDRA_EXPORT QualitySummary MeasureQuality(const std::vector<Point3>& points,
  const std::vector<Tetrahedron>& tetrahedra, int bins, std::vector<CellAngles>& cells,
  const ProgressCallback& progress = {}, const View<unsigned char>& ghosts = {});

}

#endif
