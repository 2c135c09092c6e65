/**
 * @file BeadShapes.h
 * @brief Beads joined by struts with a waist: position and circumference of each neck are known.
 */
#ifndef isthmus_BeadShapes_h
#define isthmus_BeadShapes_h

#include "ChokingSurfaces.h"
#include "Core/Geometry.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace isthmus::testing
{

/// The narrowest place of a strut.
struct Neck
{
  Point3 Place;
  double Radius;
};

/// Balls of one radius and struts between them, round, narrowest half way.
struct BeadShape
{
  double Bead = 1.0;
  std::vector<Point3> Centers;
  std::vector<std::array<std::size_t, 2>> Struts;
  std::vector<double> Radii; ///< of the struts' waists

  void Join(std::size_t a, std::size_t b, double radius)
  {
    this->Struts.push_back({ a, b });
    this->Radii.push_back(radius);
  }

  std::vector<Neck> Necks() const
  {
    std::vector<Neck> necks;
    for (std::size_t s = 0; s < this->Struts.size(); ++s)
    {
      necks.push_back(
        { 0.5 * (this->Centers[this->Struts[s][0]] + this->Centers[this->Struts[s][1]]),
          this->Radii[s] });
    }
    return necks;
  }

  /// Negative inside.
  double operator()(const Point3& p) const
  {
    double value = HUGE_VAL;
    for (const Point3& c : this->Centers)
    {
      value = std::min(value, std::sqrt(Dot(p - c, p - c)) - this->Bead);
    }
    for (std::size_t s = 0; s < this->Struts.size(); ++s)
    {
      const Point3& a = this->Centers[this->Struts[s][0]];
      const Point3 axis = this->Centers[this->Struts[s][1]] - a;
      const double u = Dot(p - a, axis) / Dot(axis, axis);
      if (u > 0.0 && u < 1.0)
      {
        const Point3 d = p - a - u * axis;
        const double waist = 2.0 * u - 1.0;
        const double widens = std::min(0.4, 0.95 * this->Bead - this->Radii[s]);
        value = std::min(value, std::sqrt(Dot(d, d)) - this->Radii[s] - widens * waist * waist);
      }
    }
    return value;
  }

  /// The surface, with cells of side at most `h`, in a box that the shape does not touch.
  TriangleMesh Surface(double h) const
  {
    Bounds3 box{ this->Centers.front(), this->Centers.front() };
    std::for_each(
      this->Centers.begin(), this->Centers.end(), [&box](const Point3& c) { box.Add(c); });
    std::array<int, 3> cells;
    for (std::size_t k = 0; k < 3; ++k)
    {
      box.Min[k] -= this->Bead + 2.37 * h;
      box.Max[k] += this->Bead + 2.37 * h;
      cells[k] = static_cast<int>(std::ceil((box.Max[k] - box.Min[k]) / h));
    }
    return LevelSet(
      [this](double x, double y, double z) {
        return (*this)(Point3{ x, y, z });
      },
      box.Min, box.Max, cells);
  }
};

/// A closed necklace of n beads, the gaps between them 0.6 wide.
inline BeadShape Necklace(int n, double neck)
{
  BeadShape shape;
  const double large = 0.5 * 2.6 / std::sin(M_PI / n);
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2.0 * M_PI * (i + 0.137) / n;
    shape.Centers.push_back({ large * std::cos(angle), large * std::sin(angle), 0.0213 });
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
  {
    shape.Join(i, (i + 1) % static_cast<std::size_t>(n), neck);
  }
  return shape;
}

/// Two necklaces, one above the other, each bead joined to the one above it.
inline BeadShape StackedRings(int n, double neck)
{
  BeadShape shape = Necklace(n, neck);
  const auto beads = static_cast<std::size_t>(n);
  for (std::size_t i = 0; i < beads; ++i)
  {
    shape.Centers[i][2] -= 1.3;
    shape.Centers.push_back(shape.Centers[i] + Point3{ 0.0, 0.0, 2.6 });
  }
  for (std::size_t i = 0; i < beads; ++i)
  {
    shape.Join(beads + i, beads + (i + 1) % beads, neck);
    shape.Join(i, beads + i, neck);
  }
  return shape;
}

/// n x n x n beads.
inline BeadShape Lattice(int n, double neck)
{
  BeadShape shape;
  const auto at = [n](int i, int j, int k)
  { return static_cast<std::size_t>((i * n + j) * n + k); };
  const double middle = 0.5 * (n - 1);
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int k = 0; k < n; ++k)
      {
        shape.Centers.push_back(
          { 2.6 * (i - middle) + 0.011, 2.6 * (j - middle) + 0.017, 2.6 * (k - middle) + 0.023 });
        if (i > 0)
        {
          shape.Join(at(i - 1, j, k), at(i, j, k), neck);
        }
        if (j > 0)
        {
          shape.Join(at(i, j - 1, k), at(i, j, k), neck);
        }
        if (k > 0)
        {
          shape.Join(at(i, j, k - 1), at(i, j, k), neck);
        }
      }
    }
  }
  return shape;
}

/// A row of n beads, each with a protruding tooth.
inline BeadShape Comb(int n, double neck)
{
  BeadShape shape;
  const auto teeth = static_cast<std::size_t>(n);
  for (int i = 0; i < n; ++i)
  {
    shape.Centers.push_back({ 2.6 * (i - 0.5 * (n - 1)) + 0.011, -1.31, 0.017 });
  }
  for (std::size_t i = 0; i < teeth; ++i)
  {
    shape.Centers.push_back(shape.Centers[i] + Point3{ 0.0, 2.6, 0.0 });
    shape.Join(i, teeth + i, neck);
    if (i > 0)
    {
      shape.Join(i - 1, i, neck);
    }
  }
  return shape;
}

/// A plate of hexagons, `rows` by `rows`, a bead at each corner.
inline BeadShape Honeycomb(int rows, double neck)
{
  BeadShape shape;
  const double a = 2.6;
  for (int i = 0; i < 2 * rows + 2; ++i)
  {
    for (int j = 0; j < rows + 1; ++j)
    {
      const double zigzag = (i + j) % 2 == 0 ? 0.25 * a : -0.25 * a;
      shape.Centers.push_back({ (i - rows) * a * std::sqrt(0.75) + 0.011,
        (j - 0.5 * rows) * 1.5 * a + zigzag + 0.017, 0.023 });
    }
  }
  for (std::size_t i = 0; i < shape.Centers.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const Point3 d = shape.Centers[i] - shape.Centers[j];
      if (Dot(d, d) < 1.01 * a * a)
      {
        shape.Join(j, i, neck);
      }
    }
  }
  return shape;
}

/// A closed tube along a curve over [0, 1], of radius `Thick` with a waist of radius `Thin` at
/// `Waist`.
struct Tube
{
  std::function<Point3(double)> Curve;
  double Thick;
  double Thin;
  double Waist;

  double Radius(double u) const
  {
    const double way = std::abs(u - this->Waist);
    const double near = std::min(way, 1.0 - way) / 0.15;
    return this->Thick - (this->Thick - this->Thin) * std::exp(-near * near);
  }
};

/// Point v (of `across`) round point u (of `along`) of a tube: in frames without twist.
inline TriangleMesh TubeSurface(const Tube& tube, int along, int across)
{
  TriangleMesh mesh;
  const auto unit = [](const Point3& v) { return (1.0 / std::sqrt(Dot(v, v))) * v; };
  const auto tangent = [&](double u) { return unit(tube.Curve(u + 1e-5) - tube.Curve(u - 1e-5)); };
  std::vector<Point3> normals{ unit(Cross(tangent(0.0), Point3{ 0.31, 0.53, 0.79 })) };
  for (int i = 1; i <= along; ++i)
  {
    const Point3 t = tangent(static_cast<double>(i) / along);
    normals.push_back(unit(normals.back() - Dot(normals.back(), t) * t));
  }
  // The rotation of the frame after one round is distributed evenly along the curve.
  const Point3 side = Cross(tangent(0.0), normals.front());
  const double twist = std::atan2(Dot(normals.back(), side), Dot(normals.back(), normals.front()));
  for (int i = 0; i < along; ++i)
  {
    const double u = static_cast<double>(i) / along;
    const Point3& n = normals[static_cast<std::size_t>(i)];
    const Point3 b = Cross(tangent(u), n);
    for (int j = 0; j < across; ++j)
    {
      const double angle = 2.0 * M_PI * (j + 0.5 * (i % 2)) / across - twist * u;
      mesh.Points.push_back(
        tube.Curve(u) + tube.Radius(u) * (std::cos(angle) * n + std::sin(angle) * b));
    }
  }
  const auto id = [=](int i, int j) -> std::int64_t
  { return (i + along) % along * across + (j + across) % across; };
  for (int i = 0; i < along; ++i)
  {
    const int s = i % 2;
    for (int j = 0; j < across; ++j)
    {
      mesh.Triangles.push_back({ id(i, j), id(i, j + 1), id(i + 1, j + s) });
      mesh.Triangles.push_back({ id(i, j + 1 - s), id(i + 1, j + 1), id(i + 1, j) });
    }
  }
  return mesh;
}

/// Both surfaces as one.
inline TriangleMesh Together(TriangleMesh a, const TriangleMesh& b)
{
  const auto shift = static_cast<std::int64_t>(a.Points.size());
  a.Points.insert(a.Points.end(), b.Points.begin(), b.Points.end());
  for (const Triangle& t : b.Triangles)
  {
    a.Triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
  return a;
}

}

#endif
