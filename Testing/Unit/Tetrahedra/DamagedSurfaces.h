/**
 * @file DamagedSurfaces.h
 * @brief Closed surfaces of many kinds, and typical damage to them.
 */
#ifndef isthmus_DamagedSurfaces_h
#define isthmus_DamagedSurfaces_h

#include "MeshedSpheres.h"
#include "Surfaces/ShellNesting.h"
#include "Surfaces/SurfaceTopology.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace isthmus::testing
{

/// A surface, and the volume that it encloses in common sense; -1: not known.
struct DamagedSurface
{
  TriangleMesh Mesh;
  double Volume = -1.0;
};

class Chance
{
public:
  explicit Chance(std::uint64_t seed)
    : Generator(seed)
  {
  }

  std::size_t Below(std::size_t count)
  {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(this->Generator);
  }
  double Between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Generator);
  }

private:
  std::mt19937_64 Generator;
};

/// A torus of n x n quadrilaterals, halved.
inline TriangleMesh SmallTorus(double large, double small, std::int64_t n)
{
  TriangleMesh mesh;
  const double step = 8.0 * std::atan(1.0) / static_cast<double>(n);
  for (std::int64_t i = 0; i < n * n; ++i)
  {
    const double u = step * static_cast<double>(i / n), v = step * static_cast<double>(i % n);
    const double r = large + small * std::cos(v);
    mesh.Points.push_back({ r * std::cos(u), r * std::sin(u), small * std::sin(v) });
    const std::int64_t below = i / n * n, above = (below + n) % (n * n), next = (i % n + 1) % n;
    mesh.Triangles.push_back({ i, above + i % n, above + next });
    mesh.Triangles.push_back({ i, above + next, below + next });
  }
  return mesh;
}

/// A prism over a regular polygon: n triangles at both ends.
inline TriangleMesh Prism(double radius, double height, std::int64_t n)
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 0, 0, height } };
  for (std::int64_t i = 0; i < n; ++i)
  {
    const double t = 8.0 * std::atan(1.0) * static_cast<double>(i) / static_cast<double>(n);
    mesh.Points.push_back({ radius * std::cos(t), radius * std::sin(t), 0.0 });
    mesh.Points.push_back({ radius * std::cos(t), radius * std::sin(t), height });
    const std::int64_t a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % n);
    mesh.Triangles.push_back({ 0, b, a });
    mesh.Triangles.push_back({ 1, a + 1, b + 1 });
    mesh.Triangles.push_back({ a, b, b + 1 });
    mesh.Triangles.push_back({ a, b + 1, a + 1 });
  }
  return mesh;
}

/// Closed and without crossings, about 2 wide, of 12 to 900 triangles.
inline TriangleMesh SoundSurface(Chance& chance)
{
  switch (chance.Below(5))
  {
    case 0:
      return Sphere({ 0, 0, 0 }, 1.0, 6 + static_cast<int>(chance.Below(14)));
    case 1:
      return SmallTorus(
        1.0, chance.Between(0.2, 0.6), 8 + static_cast<std::int64_t>(chance.Below(12)));
    case 2:
      return Prism(chance.Between(0.3, 1.0), chance.Between(0.5, 2.0),
        4 + static_cast<std::int64_t>(chance.Below(20)));
    case 3:
    {
      TriangleMesh star = Sphere({ 0, 0, 0 }, 1.0, 8 + static_cast<int>(chance.Below(8)));
      for (Point3& p : star.Points)
      {
        p = chance.Between(0.6, 1.0) * p;
      }
      return star;
    }
    default:
    {
      TriangleMesh box = Prism(1.0, 1.4, 4);
      for (Point3& p : box.Points)
      {
        p = { p[0], chance.Between(0.999, 1.001) * 0.5 * p[1], p[2] };
      }
      return box;
    }
  }
}

/// `mesh` and `other`, side by side.
inline void Append(TriangleMesh& mesh, const TriangleMesh& other, bool inverted = false)
{
  const auto first = static_cast<std::int64_t>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), other.Points.begin(), other.Points.end());
  for (const Triangle& t : other.Triangles)
  {
    mesh.Triangles.push_back(inverted ? Triangle{ first + t[0], first + t[2], first + t[1] }
                                      : Triangle{ first + t[0], first + t[1], first + t[2] });
  }
}

inline TriangleMesh Moved(TriangleMesh mesh, const Point3& by, double scale = 1.0)
{
  for (Point3& p : mesh.Points)
  {
    p = scale * p + by;
  }
  return mesh;
}

struct DamageKind
{
  const char* Name;
  std::function<void(DamagedSurface&, Chance&)> Do;
};

inline Point3& AnyPoint(TriangleMesh& mesh, Chance& chance)
{
  return mesh.Points[chance.Below(mesh.Points.size())];
}

inline Triangle& AnyTriangle(TriangleMesh& mesh, Chance& chance)
{
  return mesh.Triangles[chance.Below(mesh.Triangles.size())];
}

/// A triangle cut in two at a point of its first side, at a given distance from its first corner;
/// with `both` the neighbour as well.
inline void CutSide(TriangleMesh& mesh, Chance& chance, double at, bool both)
{
  const Triangle t = AnyTriangle(mesh, chance);
  const auto point = [&](std::int64_t id) { return mesh.Points[static_cast<std::size_t>(id)]; };
  const Point3 middle = point(t[0]) + at * (point(t[1]) - point(t[0]));
  const auto id = static_cast<std::int64_t>(mesh.Points.size());
  mesh.Points.push_back(middle);
  const std::size_t count = mesh.Triangles.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    Triangle& cut = mesh.Triangles[i];
    for (std::size_t c = 0; c < 3; ++c)
    {
      const std::int64_t a = cut[c], b = cut[(c + 1) % 3], other = cut[(c + 2) % 3];
      const bool isOwn = a == t[0] && b == t[1];
      if (isOwn || (both && a == t[1] && b == t[0]))
      {
        cut = { a, id, other };
        mesh.Triangles.push_back({ id, b, other });
        break;
      }
    }
  }
}

/// Those that change what is enclosed leave the volume unknown.
inline const std::vector<DamageKind>& DamageKinds()
{
  static const std::vector<DamageKind> kinds{ { "needles",
                                                [](DamagedSurface& s, Chance& chance)
                                                {
                                                  for (std::size_t i = 0; i < 1 + chance.Below(4);
                                                       ++i)
                                                  {
                                                    CutSide(s.Mesh, chance,
                                                      std::pow(10.0, -chance.Between(10.0, 20.0)),
                                                      true);
                                                  }
                                                } },
    { "points on edges",
      [](DamagedSurface& s, Chance& chance)
      {
        for (std::size_t i = 0; i < 1 + chance.Below(4); ++i)
        {
          CutSide(s.Mesh, chance, chance.Between(0.1, 0.9), false);
        }
      } },
    { "double points",
      [](DamagedSurface& s, Chance&)
      {
        TriangleMesh soup;
        for (const Triangle& t : s.Mesh.Triangles)
        {
          const auto first = static_cast<std::int64_t>(soup.Points.size());
          for (const std::int64_t id : t)
          {
            soup.Points.push_back(s.Mesh.Points[static_cast<std::size_t>(id)]);
          }
          soup.Triangles.push_back({ first, first + 1, first + 2 });
        }
        s.Mesh = soup;
      } },
    { "double triangles",
      [](DamagedSurface& s, Chance& chance)
      {
        for (std::size_t i = 0; i < 1 + chance.Below(4); ++i)
        {
          s.Mesh.Triangles.push_back(Triangle(AnyTriangle(s.Mesh, chance)));
        }
      } },
    { "flat triangles",
      [](DamagedSurface& s, Chance& chance)
      {
        const Triangle t = AnyTriangle(s.Mesh, chance);
        s.Mesh.Triangles.push_back({ t[0], t[0], t[1] });
        s.Mesh.Triangles.push_back({ t[2], t[2], t[2] });
      } },
    { "flipped triangles",
      [](DamagedSurface& s, Chance& chance)
      {
        for (std::size_t i = 0; i < 1 + s.Mesh.Triangles.size() / 20; ++i)
        {
          Triangle& t = AnyTriangle(s.Mesh, chance);
          std::swap(t[0], t[1]);
        }
      } },
    { "all flipped",
      [](DamagedSurface& s, Chance&)
      {
        for (Triangle& t : s.Mesh.Triangles)
        {
          std::swap(t[0], t[1]);
        }
      } },
    { "touching sheets",
      [](DamagedSurface& s, Chance&)
      {
        const Bounds3 box = ComputeBounds(s.Mesh);
        const TriangleMesh one = s.Mesh;
        Append(s.Mesh, Moved(one, { box.Max[0] - box.Min[0], 0, 0 }));
        s.Volume *= 2.0;
      } },
    { "crossing copies",
      [](DamagedSurface& s, Chance& chance)
      {
        const TriangleMesh one = s.Mesh;
        Append(s.Mesh,
          Moved(
            one, { chance.Between(0.1, 0.7), chance.Between(0.1, 0.7), chance.Between(0.1, 0.7) }));
        s.Volume = -1.0;
      } },
    { "crossing parts",
      [](DamagedSurface& s, Chance& chance)
      {
        Point3& p = AnyPoint(s.Mesh, chance);
        p = -chance.Between(0.2, 1.2) * p;
        s.Volume = -1.0;
      } },
    { "holes",
      [](DamagedSurface& s, Chance& chance)
      {
        for (std::size_t i = 0; i < 1 + s.Mesh.Triangles.size() / 50; ++i)
        {
          s.Mesh.Triangles.erase(s.Mesh.Triangles.begin() +
            static_cast<std::ptrdiff_t>(chance.Below(s.Mesh.Triangles.size())));
        }
        s.Volume = -1.0;
      } },
    { "wrong corners",
      [](DamagedSurface& s, Chance& chance)
      {
        AnyTriangle(s.Mesh, chance)[chance.Below(3)] =
          static_cast<std::int64_t>(chance.Below(s.Mesh.Points.size()));
        s.Volume = -1.0;
      } },
    { "no number",
      [](DamagedSurface& s, Chance& chance)
      {
        AnyPoint(s.Mesh, chance)[chance.Below(3)] = std::numeric_limits<double>::quiet_NaN();
        s.Volume = -1.0;
      } },
    { "rounded points",
      [](DamagedSurface& s, Chance& chance)
      {
        const double to = std::pow(2.0, -3.0 - static_cast<double>(chance.Below(6)));
        for (Point3& p : s.Mesh.Points)
        {
          p = { to * std::round(p[0] / to), to * std::round(p[1] / to),
            to * std::round(p[2] / to) };
        }
        s.Volume = -1.0;
      } },
    { "cavity",
      [](DamagedSurface& s, Chance&)
      {
        const TriangleMesh inner = Sphere({ 5, 0, 0 }, 0.5, 8);
        Append(s.Mesh, Sphere({ 5, 0, 0 }, 1.0, 10));
        Append(s.Mesh, inner, true);
        s.Volume = s.Volume < 0.0
          ? -1.0
          : s.Volume + SignedVolume(Sphere({ 0, 0, 0 }, 1.0, 10)) - SignedVolume(inner);
      } },
    { "huge or tiny",
      [](DamagedSurface& s, Chance& chance)
      {
        const double scale = std::pow(10.0, chance.Between(-30.0, 30.0));
        s.Mesh = Moved(s.Mesh, { 0, 0, 0 }, scale);
        s.Volume *= s.Volume < 0.0 ? 1.0 : scale * scale * scale;
      } },
    { "far away", [](DamagedSurface& s, Chance& chance) {
       s.Mesh = Moved(s.Mesh, { std::pow(10.0, chance.Between(0.0, 6.0)), 0, 0 });
     } } };
  return kinds;
}

}

#endif
