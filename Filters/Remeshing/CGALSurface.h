/**
 * @file CGALSurface.h
 * @brief Between TriangleMesh and CGAL's Surface_mesh. Private: only for files that use CGAL.
 */
#ifndef isthmus_CGALSurface_h
#define isthmus_CGALSurface_h

#include "Core/TriangleMesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>
#include <string>

namespace isthmus::cgal
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

inline Point ToCGAL(const Point3& p)
{
  return { p[0], p[1], p[2] };
}

inline Point3 FromCGAL(const Point& p)
{
  return { p.x(), p.y(), p.z() };
}

/// Triangles and points keep their order, so that face i is triangle i; unused points are included.
/// @pre the mesh is manifold and oriented (SurfaceDefects.h).
/// @throws std::invalid_argument where it is not.
inline SurfaceMesh ToSurfaceMesh(const SurfaceView& mesh)
{
  SurfaceMesh result;
  for (const Point3& p : mesh.Points)
  {
    result.add_vertex(ToCGAL(p));
  }
  for (const Triangle& t : mesh.Triangles)
  {
    const auto corner = [&t](std::size_t c)
    { return SurfaceMesh::Vertex_index(static_cast<SurfaceMesh::size_type>(t[c])); };
    if (result.add_face(corner(0), corner(1), corner(2)) == SurfaceMesh::null_face())
    {
      throw std::invalid_argument("The surface is not manifold: repair it first.");
    }
  }
  return result;
}

inline TriangleMesh FromSurfaceMesh(SurfaceMesh& mesh)
{
  mesh.collect_garbage();
  TriangleMesh result;
  result.Points.reserve(mesh.number_of_vertices());
  for (const auto v : mesh.vertices())
  {
    result.Points.push_back(FromCGAL(mesh.point(v)));
  }
  result.Triangles.reserve(mesh.number_of_faces());
  for (const auto f : mesh.faces())
  {
    Triangle t{};
    std::size_t c = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
    {
      t[c++ % 3] = static_cast<std::int64_t>(v.idx());
    }
    result.Triangles.push_back(t);
  }
  return result;
}

/// Runs `body()`.
/// @throws std::runtime_error with a message about `doing` if the checks of CGAL throw.
template <typename Body>
auto RethrowWithContext(const char* doing, Body&& body)
{
  try
  {
    return body();
  }
  catch (const CGAL::Failure_exception& failure)
  {
    throw std::runtime_error(std::string("CGAL failed while ") + doing + " (" +
      failure.expression() + ", " + failure.filename().substr(failure.filename().rfind('/') + 1) +
      ":" + std::to_string(failure.line_number()) +
      "): remesh or repair the surface, or change the requested sizes.");
  }
}

}

#endif
