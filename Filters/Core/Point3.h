/**
 * @file Point3.h
 * @brief Points and vectors of space, and what is done with them all the time.
 */
#ifndef isthmus_Point3_h
#define isthmus_Point3_h

#include <array>
#include <cmath>

namespace isthmus
{

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

}

#endif
