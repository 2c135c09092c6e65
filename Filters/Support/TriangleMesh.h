/**
 * @file TriangleMesh.h
 * @brief A triangle surface and a tetrahedral mesh as the meshing algorithms see them.
 */
#ifndef isthmus_TriangleMesh_h
#define isthmus_TriangleMesh_h

#include "Point3.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isthmus
{

using Triangle = std::array<std::int64_t, 3>;
using Tetrahedron = std::array<std::int64_t, 4>;

/// Indexed triangles, counter-clockwise seen from outside. Lengths are in the units of the data
/// (angstrom for molecular surfaces).
struct TriangleMesh
{
  std::vector<Point3> Points;
  std::vector<Triangle> Triangles;
};

inline double SurfaceArea(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    const auto at = [&](std::size_t k) { return mesh.Points[static_cast<std::size_t>(t[k])]; };
    sum += TriangleArea(at(0), at(1), at(2));
  }
  return sum;
}

/// Indexed tetrahedra of positive volume, (p1-p0)x(p2-p0).(p3-p0) > 0, with a region for each.
struct TetrahedralMesh
{
  std::vector<Point3> Points;
  std::vector<Tetrahedron> Tetrahedra;
  std::vector<int> Regions;                 ///< one for each tetrahedron
  std::vector<std::int64_t> OriginalPoints; ///< for each point: its id in the input, or -1
};

/// Axis-aligned box.
struct Bounds3
{
  Point3 Min{ 0, 0, 0 };
  Point3 Max{ 0, 0, 0 };

  double Diagonal() const { return Distance(this->Min, this->Max); }

  bool Contains(const Bounds3& other) const
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      if (other.Min[a] < this->Min[a] || other.Max[a] > this->Max[a])
      {
        return false;
      }
    }
    return true;
  }

  void Add(const Point3& p)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Min[a] = std::min(this->Min[a], p[a]);
      this->Max[a] = std::max(this->Max[a], p[a]);
    }
  }
};

}

#endif
