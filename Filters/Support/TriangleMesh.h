/**
 * @file TriangleMesh.h
 * @brief A triangle surface and a tetrahedral mesh as the meshing algorithms see them.
 */
#ifndef isthmus_TriangleMesh_h
#define isthmus_TriangleMesh_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isthmus
{

using Point3 = std::array<double, 3>;
using Triangle = std::array<std::int64_t, 3>;
using Tetrahedron = std::array<std::int64_t, 4>;

/// Indexed triangles, counter-clockwise seen from outside. Lengths are in the units of the data
/// (angstrom for molecular surfaces).
struct TriangleMesh
{
  std::vector<Point3> Points;
  std::vector<Triangle> Triangles;
};

/// Indexed tetrahedra of positive volume, (p1-p0)x(p2-p0).(p3-p0) > 0, with a region for each.
struct TetrahedralMesh
{
  std::vector<Point3> Points;
  std::vector<Tetrahedron> Tetrahedra;
  std::vector<int> Regions;                 ///< one for each tetrahedron
  std::vector<std::int64_t> OriginalPoints; ///< for each point: its id in the input, or -1
};

inline Point3 operator+(const Point3& a, const Point3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Point3 operator-(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Point3 operator*(double s, const Point3& a)
{
  return { s * a[0], s * a[1], s * a[2] };
}

inline double Dot(const Point3& a, const Point3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point3 Cross(const Point3& a, const Point3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/// Axis-aligned box.
struct Bounds3
{
  Point3 Min{ 0, 0, 0 };
  Point3 Max{ 0, 0, 0 };

  double Diagonal() const
  {
    const Point3 d = this->Max - this->Min;
    return std::sqrt(Dot(d, d));
  }

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
