/**
 * @file TriangleMesh.h
 * @brief The owner of a triangle surface. What only reads one takes a SurfaceView.
 */
#ifndef isthmus_TriangleMesh_h
#define isthmus_TriangleMesh_h

#include "Core/Corners.h"
#include "Core/Point3.h"

#include <vector>

namespace isthmus
{

/// Indexed triangles, counter-clockwise seen from outside. Lengths are in the units of the data
/// (angstrom for molecular surfaces).
struct TriangleMesh
{
  std::vector<Point3> Points;
  std::vector<Triangle> Triangles;
};

}

#endif
