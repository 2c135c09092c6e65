/**
 * @file Geometry.h
 * @brief Points, vectors and axis-aligned boxes in space.
 */
#ifndef isthmus_Geometry_h
#define isthmus_Geometry_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace isthmus
{

constexpr double Pi = 3.14159265358979323846;

using Point3 = std::array<double, 3>;

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

inline double Length(const Point3& v)
{
  return std::sqrt(Dot(v, v));
}

inline double Distance(const Point3& a, const Point3& b)
{
  return Length(b - a);
}

inline double TriangleArea(const Point3& a, const Point3& b, const Point3& c)
{
  return 0.5 * Length(Cross(b - a, c - a));
}

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
