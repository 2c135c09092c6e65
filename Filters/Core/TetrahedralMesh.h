/**
 * @file TetrahedralMesh.h
 * @brief A class that owns a mesh of tetrahedra.
 */
#ifndef isthmus_TetrahedralMesh_h
#define isthmus_TetrahedralMesh_h

#include "Core/Geometry.h"

#include <vtkType.h>

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// A tetrahedron, given by the ids of its corners.
using Tetrahedron = std::array<vtkIdType, 4>;

/// Indexed tetrahedra of positive volume, (p1-p0)x(p2-p0).(p3-p0) > 0, with a region for each.
struct TetrahedralMesh
{
  std::vector<Point3> Points;
  std::vector<Tetrahedron> Tetrahedra;
  std::vector<int> Regions;                 ///< one for each tetrahedron
  std::vector<std::int64_t> OriginalPoints; ///< for each point: its id in the input, or -1
};

}

#endif
