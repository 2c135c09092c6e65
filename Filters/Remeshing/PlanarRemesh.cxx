#include "Remeshing/PlanarRemesh.h"

#include "Remeshing/CGALSurface.h"
#include "Surfaces/SurfaceTopology.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace isthmus
{
namespace
{

using cgal::Kernel;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel,
  CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
    CGAL::Delaunay_mesh_face_base_2<Kernel>>,
  CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// A triangle is too large if its circumscribed circle is; CGAL's own criterion is its longest
/// edge.
class Criteria : public CGAL::Delaunay_mesh_size_criteria_2<Triangulation>
{
  using Base = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;

public:
  Criteria(double squaredSine, double largestRadius)
    : Base(squaredSine, largestRadius)
  {
    this->set_bound(squaredSine); // a virtual base, in CGAL 5
  }

  struct Is_bad : Base::Is_bad
  {
    using Base::Is_bad::Is_bad;
    using Base::Is_bad::operator();

    CGAL::Mesh_2::Face_badness operator()(
      const Triangulation::Face_handle& face, typename Base::Quality& quality) const
    {
      const auto side = [&](int k)
      {
        return CGAL::squared_distance(
          face->vertex((k + 1) % 3)->point(), face->vertex((k + 2) % 3)->point());
      };
      std::array<double, 3> sides{ side(0), side(1), side(2) };
      std::sort(sides.begin(), sides.end());
      const double twice =
        CGAL::area(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point()) *
        2.0;
      const double radius = sides[0] * sides[1] * sides[2] / (4.0 * twice * twice);
      quality.first = twice * twice / (sides[1] * sides[2]);
      quality.second = radius / this->squared_size_bound;
      return (*this)(quality);
    }
  };
  Is_bad is_bad_object() const { return Is_bad(this->bound(), this->size_bound(), this->traits); }
};

/// Coordinates in the plane of the largest triangle.
class PlaneAxes
{
public:
  explicit PlaneAxes(const SurfaceView& part)
  {
    double largest = 0.0;
    for (const Triangle& t : part.Triangles)
    {
      const Point3 along = part.Point(t[1]) - part.Point(t[0]);
      const Point3 normal = Cross(along, part.Point(t[2]) - part.Point(t[0]));
      if (Length(normal) > largest)
      {
        largest = Length(normal);
        this->Origin = part.Point(t[0]);
        this->X = (1.0 / Length(along)) * along;
        this->Normal = (1.0 / largest) * normal;
      }
    }
    this->Y = Cross(this->Normal, this->X);
  }

  double Height(const Point3& p) const { return Dot(p - this->Origin, this->Normal); }
  Kernel::Point_2 Project(const Point3& p) const
  {
    return { Dot(p - this->Origin, this->X), Dot(p - this->Origin, this->Y) };
  }
  Point3 Unproject(const Kernel::Point_2& p) const
  {
    return this->Origin + p.x() * this->X + p.y() * this->Y;
  }
  const Point3& Start() const { return this->Origin; }

private:
  Point3 Origin{}, X{}, Y{}, Normal{};
};

[[noreturn]] void RejectFolded(const SurfaceView& part)
{
  throw std::invalid_argument("A part of the surface with " +
    std::to_string(part.Triangles.size()) +
    " triangles lies in one plane, where it covers itself or its boundaries cross. Repair or "
    "remove it.");
}

/// The edges that only one triangle has.
std::vector<std::array<std::int64_t, 2>> BoundaryEdges(const SurfaceView& part)
{
  std::set<std::pair<std::int64_t, std::int64_t>> once;
  for (const Triangle& t : part.Triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto edge = std::minmax(t[c], t[(c + 1) % 3]);
      if (const auto [at, isNew] = once.insert(edge); !isNew)
      {
        once.erase(at);
      }
    }
  }
  std::vector<std::array<std::int64_t, 2>> edges;
  edges.reserve(once.size());
  for (const auto& [a, b] : once)
  {
    edges.push_back({ a, b });
  }
  return edges;
}

/// Between the boundaries: an odd number of them away from the unbounded face.
void MarkInside(Triangulation& triangulation)
{
  using Face = Triangulation::Face_handle;
  for (const Face face : triangulation.all_face_handles())
  {
    face->set_in_domain(false);
  }
  std::set<Face> seen{ triangulation.infinite_face() };
  std::vector<Face> next{ triangulation.infinite_face() };
  while (!next.empty())
  {
    const Face face = next.back();
    next.pop_back();
    for (int k = 0; k < 3; ++k)
    {
      const Face other = face->neighbor(k);
      if (seen.insert(other).second)
      {
        const bool isBoundary = triangulation.is_constrained({ face, k });
        other->set_in_domain(face->is_in_domain() != isBoundary);
        next.push_back(other);
      }
    }
  }
}

TriangleMesh ExtractInside(const Triangulation& triangulation, const PlaneAxes& axes)
{
  TriangleMesh mesh;
  std::map<Triangulation::Vertex_handle, std::int64_t> ids;
  for (const auto vertex : triangulation.finite_vertex_handles())
  {
    ids.emplace(vertex, static_cast<std::int64_t>(mesh.Points.size()));
    mesh.Points.push_back(axes.Unproject(vertex->point()));
  }
  for (const auto face : triangulation.finite_face_handles())
  {
    if (face->is_in_domain())
    {
      mesh.Triangles.push_back(
        { ids.at(face->vertex(0)), ids.at(face->vertex(1)), ids.at(face->vertex(2)) });
    }
  }
  return mesh;
}

}

void RejectManyPoints(std::int64_t most)
{
  throw std::runtime_error("Refinement passed " + std::to_string(most) +
    " points: choose longer edges, a larger distance or a smaller angle.");
}

bool IsPlanar(const SurfaceView& part)
{
  const PlaneAxes axes(part);
  double size = 0.0, height = 0.0;
  for (const Point3& p : part.Points)
  {
    size = std::max(size, Length(p - axes.Start()));
    height = std::max(height, std::fabs(axes.Height(p)));
  }
  return height <= 1e-11 * size;
}

TriangleMesh PlanarRemesh(const SurfaceView& part, const PlanarRemeshParameters& parameters,
  const ProgressCallback& progress)
{
  const PlaneAxes axes(part);
  Triangulation triangulation;
  try
  {
    for (const auto& [a, b] : BoundaryEdges(part))
    {
      triangulation.insert_constraint(axes.Project(part.Point(a)), axes.Project(part.Point(b)));
    }
  }
  catch (const Triangulation::Intersection_of_constraints_exception&)
  {
    RejectFolded(part);
  }
  if (triangulation.dimension() < 2)
  {
    RejectFolded(part); // a closed part has no boundary
  }
  MarkInside(triangulation);
  const double sine = std::sin(parameters.Angle * Pi / 180.0);
  CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(
    triangulation, Criteria(sine * sine, parameters.EdgeLength / std::sqrt(3.0)));
  mesher.init(true);
  const double expected =
    SurfaceArea(part) / (2.0 * parameters.EdgeLength * parameters.EdgeLength) + 256.0;
  for (std::int64_t step = 0; mesher.try_one_step_refine_mesh(); ++step)
  {
    if (step % 256 == 0)
    {
      const auto made = static_cast<double>(step);
      Report(progress, made / (made + expected));
    }
    if (static_cast<std::int64_t>(triangulation.number_of_vertices()) > parameters.MaximumPoints)
    {
      RejectManyPoints(parameters.MaximumPoints);
    }
  }
  TriangleMesh refined = ExtractInside(triangulation, axes);
  if (!(std::fabs(SurfaceArea(refined) - SurfaceArea(part)) <= 1e-6 * SurfaceArea(part)))
  {
    RejectFolded(part);
  }
  return refined;
}

}
