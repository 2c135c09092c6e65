/**
 * @file EdgedSolids.h
 * @brief Solids with straight and round sharp edges as functions, turned at random, and those
 * edges.
 */
#ifndef isthmus_EdgedSolids_h
#define isthmus_EdgedSolids_h

#include "DualContours.h"
#include "EdgeSamples.h"

#include <cmath>
#include <functional>
#include <random>

namespace isthmus::testing
{

using Value = std::function<double(const Point3&)>;

constexpr double Half = 0.5;   // of the box's side
constexpr double Radius = 0.4; // of the ball
inline const Point3 Center{ 0.02, 0.01, 0.5 };

inline double Box(const Point3& q)
{
  return std::max({ std::abs(q[0]), std::abs(q[1]), std::abs(q[2]) }) - Half;
}

/// The Euclidean distance, with rounded level sets outside of edges.
inline double BoxDistance(const Point3& q)
{
  Point3 out;
  for (std::size_t a = 0; a < 3; ++a)
  {
    out[a] = std::max(0.0, std::abs(q[a]) - Half);
  }
  return Length(out) + std::min(0.0, Box(q));
}

inline double OctahedronValue(const Point3& q)
{
  return (std::abs(q[0]) + std::abs(q[1]) + std::abs(q[2]) - 0.8) / std::sqrt(3.0);
}

inline double BoxWithoutBall(const Point3& q)
{
  return std::max(Box(q), Radius - Length(q - Center));
}

inline double BoxAndBall(const Point3& q)
{
  return std::min(BoxDistance(q), Length(q - Center) - Radius);
}

/// A uniformly distributed random rotation.
class Rotation
{
public:
  explicit Rotation(unsigned seed)
  {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Point3 a{ normal(random), normal(random), normal(random) };
    const Point3 b{ normal(random), normal(random), normal(random) };
    a = (1.0 / Length(a)) * a;
    const Point3 c = (1.0 / Length(Cross(a, b))) * Cross(a, b);
    this->Rows = { a, Cross(c, a), c };
    this->Shift = { 0.3 * normal(random), 0.3 * normal(random), 0.3 * normal(random) };
  }

  Point3 operator()(const Point3& p) const
  {
    const Point3 q = p - 0.03 * this->Shift;
    return { Dot(this->Rows[0], q), Dot(this->Rows[1], q), Dot(this->Rows[2], q) };
  }
  Point3 Back(const Point3& q) const
  {
    return q[0] * this->Rows[0] + q[1] * this->Rows[1] + q[2] * this->Rows[2] + 0.03 * this->Shift;
  }

private:
  std::array<Point3, 3> Rows;
  Point3 Shift;
};

/// Points on lines, those nearer to an end than `corner` left out, and on the ball's circle.
inline TriangleMesh SampleEdges(
  const std::vector<Point3>& corners, double length, double corner, bool hasBall)
{
  std::vector<Point3> points;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    for (std::size_t j = i + 1; j < corners.size(); ++j)
    {
      const Point3 along = corners[j] - corners[i];
      for (double s = 0.002; s < length && Length(along) < 1.001 * length; s += 0.004)
      {
        const Point3 p = corners[i] + (s / length) * along;
        if (std::min(s, length - s) > corner && !(hasBall && Length(p - Center) < Radius + corner))
        {
          points.push_back(p);
        }
      }
    }
  }
  for (int i = 0; hasBall && i < 1000; ++i)
  {
    const double t = 8.0 * std::atan(1.0) * i / 1000.0;
    points.push_back(
      { Center[0] + Radius * std::cos(t), Center[1] + Radius * std::sin(t), Center[2] });
  }
  return AsMesh(points);
}

inline TriangleMesh BoxEdges(double corner, bool hasBall)
{
  std::vector<Point3> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.push_back({ (i & 1) - Half, (i >> 1 & 1) - Half, (i >> 2) - Half });
  }
  return SampleEdges(corners, 1.0, corner, hasBall);
}

inline TriangleMesh OctahedronEdges(double corner)
{
  return SampleEdges(Octahedron(0.8).Points, 0.8 * std::sqrt(2.0), corner, false);
}

}

#endif
