#include "Remeshing/ThinTriangles.h"

#include "Core/Geometry.h"
#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/UnitScale.h"
#include "Remeshing/CGALSurface.h"
#include "Remeshing/CGALVersions.h"

namespace isthmus
{
namespace
{

/// Height over longest edge; a triangle below this is thin.
constexpr double Thin = 1e-6;

/// For CGAL, a little beyond: longest over shortest edge of a needle, cosine of a cap's angle (of
/// 180 degrees less 1e-5 rad), and the longest edge to collapse, relative to the diagonal.
constexpr double ThinnestNeedle = 2e5;
constexpr double FlattestCap = -1.0 + 5e-11;
constexpr double CollapseLength = 1e-5;

bool IsThin(const Point3& p, const Point3& q, const Point3& r)
{
  const Point3 u = q - p, v = r - p, w = r - q;
  double largest = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    largest = std::max({ largest, std::abs(u[a]), std::abs(v[a]), std::abs(w[a]) });
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double scale = std::ldexp(1.0, -exponent); // its square does not underflow
  const Point3 a = scale * u, b = scale * v, c = scale * w;
  const Point3 normal = Cross(a, b);
  const double longest2 = std::max({ Dot(a, a), Dot(b, b), Dot(c, c) });
  return Dot(normal, normal) < Thin * Thin * longest2 * longest2;
}

}

std::vector<std::int64_t> ThinTriangles(const SurfaceView& mesh)
{
  const auto point = [&mesh](std::int64_t p) -> const Point3& { return mesh.Points[At(p)]; };
  const auto count = static_cast<std::int64_t>(mesh.Triangles.size());
  std::vector<char> isThin(At(count));
  ParallelFor(0, count, 1 << 14,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t t = begin; t < end; ++t)
      {
        const auto& [a, b, c] = mesh.Triangles[At(t)];
        isThin[At(t)] = IsThin(point(a), point(b), point(c)) ? 1 : 0;
      }
    });
  std::vector<std::int64_t> thin;
  for (std::int64_t t = 0; t < count; ++t)
  {
    if (isThin[At(t)])
    {
      thin.push_back(t);
    }
  }
  return thin;
}

TriangleMesh RemoveThinTriangles(const SurfaceView& mesh)
{
  const UnitScale scale(mesh.Points);
  if (!scale.IsOne())
  {
    TriangleMesh scaled = CopyMesh(mesh);
    scale.Apply(scaled.Points);
    TriangleMesh result = RemoveThinTriangles(scaled);
    scale.Undo(result.Points);
    return result;
  }
  return cgal::RethrowWithContext("removing thin triangles",
    [&]
    {
      Bounds3 box{ mesh.Points.front(), mesh.Points.front() };
      for (const Point3& p : mesh.Points)
      {
        box.Add(p);
      }
      cgal::SurfaceMesh surface = cgal::ToSurfaceMesh(mesh);
      cgal::RemoveNeedlesAndCaps({ surface.faces().begin(), surface.faces().end() }, surface,
        FlattestCap, ThinnestNeedle, CollapseLength * box.Diagonal());
      return cgal::FromSurfaceMesh(surface);
    });
}

}
