/**
 * @file MeshQuality.h
 * @brief Angles and ratios of triangles and tetrahedra, and their distribution.
 */
#ifndef isthmus_MeshQuality_h
#define isthmus_MeshQuality_h

#include "Core/Progress.h"
#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace isthmus
{

/// Angles in degrees. For a cell without area or volume, angles are 0 and
/// the ratio is infinite.
struct CellAngles
{
  double Smallest = 0.0; ///< of a triangle; dihedral of a tetrahedron
  double Largest = 0.0;
  double RadiusEdge = std::numeric_limits<double>::infinity(); ///< circumradius / shortest edge
  double Size = 0.0; ///< area, or signed volume, positive in VTK's order of the corners
};

/// Counts of all angles (three for a triangle, six for a tetrahedron) in equal bins over [0, 180]
/// degrees, and the data for a one-line summary of the mesh.
struct QualitySummary
{
  std::vector<std::int64_t> Bins;
  double SmallestAngle = 180.0;
  double LargestAngle = 0.0;
  double LargestRadiusEdge = 0.0;
  double TotalSize = 0.0; ///< inverted tetrahedra counted as negative
  std::int64_t Cells = 0;
  std::int64_t Slivers = 0;         ///< tetrahedra with a dihedral angle below 5 degrees
  std::int64_t Inverted = 0;        ///< tetrahedra whose corners are ordered opposite to the others
  std::string InvertedCellsMessage; ///< a warning that names them, or empty
};

/// Radius-edge ratio is at least 1/sqrt(3) = 0.577 (equilateral).
CellAngles MeasureTriangle(const Point3& a, const Point3& b, const Point3& c);

/// Radius-edge ratio is at least sqrt(6)/4 = 0.612 (regular), and does not detect slivers.
CellAngles MeasureTetrahedron(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Writes the measures of each cell to `measures` and returns the summary, in parallel. O(n).
/// `ghosts` is empty or has one flag for each cell; a cell whose flag is not 0 is measured but not
/// included in the summary, since another rank includes it.
QualitySummary MeasureQuality(const SurfaceView& surface, int bins, std::vector<CellAngles>& cells,
  const ProgressCallback& progress = {}, const View<unsigned char>& ghosts = {});
QualitySummary MeasureQuality(const std::vector<Point3>& points,
  const std::vector<Tetrahedron>& tetrahedra, int bins, std::vector<CellAngles>& cells,
  const ProgressCallback& progress = {}, const View<unsigned char>& ghosts = {});

}

#endif
