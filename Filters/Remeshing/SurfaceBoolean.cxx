#include "Remeshing/SurfaceBoolean.h"

#include "Remeshing/CGALSurface.h"
#include "Remeshing/CGALVersions.h"
#include "Remeshing/OrderedTraits.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <array>

namespace isthmus
{
namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;
using cgal::SurfaceMesh;
using Face = SurfaceMesh::Face_index;

/// The origin of a triangle, and whether it existed before.
struct Origin
{
  int Tag = 0;
  bool IsNew = false;
};
using Origins = SurfaceMesh::Property_map<Face, Origin>;

/// Triangles along the curve: longest over shortest edge of a needle, cosine of a cap's angle.
constexpr double NeedleRatio = 50.0;
constexpr double CapCosine = -0.9998;

/// Passes tags on to the parts of triangles, and to those copied into the result.
class OriginVisitor : public PMP::Corefinement::Default_visitor<SurfaceMesh>
{
public:
  OriginVisitor(const SurfaceMesh& first, const Origins& ofFirst, const Origins& ofSecond)
    : First(&first)
    , OfFirst(ofFirst)
    , OfSecond(ofSecond)
  {
  }

  void before_subface_creations(Face whole, SurfaceMesh& mesh)
  {
    this->Current = this->GetOrigins(mesh)[whole].Tag;
  }
  void after_subface_created(Face part, SurfaceMesh& mesh)
  {
    this->GetOrigins(mesh)[part] = { this->Current, true };
  }
  void after_face_copy(Face from, const SurfaceMesh& source, Face to, SurfaceMesh& target)
  {
    this->GetOrigins(target)[to] = { this->GetOrigins(source)[from].Tag, true };
  }

private:
  Origins& GetOrigins(const SurfaceMesh& mesh)
  {
    return &mesh == this->First ? this->OfFirst : this->OfSecond;
  }

  const SurfaceMesh* First;
  Origins OfFirst;
  Origins OfSecond;
  int Current = 0;
};

/// The origins of the faces of `mesh`, added if it has none. CGAL's search for a property
/// returns a pair before CGAL 6 and an optional since; adding an existing one returns it in all
/// versions.
Origins GetOrigins(SurfaceMesh& mesh)
{
  return mesh.add_property_map<Face, Origin>("f:origin").first;
}

Origins SetOrigins(SurfaceMesh& mesh, const std::vector<int>& tags)
{
  Origins map = GetOrigins(mesh);
  std::size_t i = 0;
  for (const Face f : mesh.faces())
  {
    map[f] = { tags[i++], false };
  }
  return map;
}

/// The same surface, with edges numbered by its triangles. CGAL numbers the edges that it makes in
/// an order that depends on addresses, and removes slivers in the order of edges.
SurfaceMesh RenumberFaces(SurfaceMesh& mesh, const Origins& origins)
{
  const TriangleMesh triangles = cgal::FromSurfaceMesh(mesh);
  SurfaceMesh same = cgal::ToSurfaceMesh(triangles);
  Origins copy = GetOrigins(same);
  auto to = same.faces().begin();
  for (const Face from : mesh.faces())
  {
    copy[*to++] = origins[from];
  }
  return same;
}

void RemoveSlivers(SurfaceMesh& mesh, const Origins& origins, double finest)
{
  std::vector<Face> made;
  for (const Face f : mesh.faces())
  {
    if (origins[f].IsNew)
    {
      made.push_back(f);
    }
  }
  cgal::RemoveNeedlesAndCaps(made, mesh, CapCosine, NeedleRatio, finest);
}

}

TaggedSurface CombineSurfaces(
  const TaggedSurface& a, const TaggedSurface& b, BooleanOperation operation, double finest)
{
  return cgal::RethrowWithContext("joining two surfaces",
    [&]
    {
      SurfaceMesh first = cgal::ToSurfaceMesh(a.Mesh);
      SurfaceMesh second = cgal::ToSurfaceMesh(b.Mesh);
      const Origins origins = SetOrigins(first, a.Tags);
      const OriginVisitor visitor(first, origins, SetOrigins(second, b.Tags));
      // One call for both: CGAL's functions for a union and a difference instantiate it once each.
      std::array<cgal::Optional<SurfaceMesh*>, 4> results;
      const std::size_t wanted = operation == BooleanOperation::Union
        ? PMP::Corefinement::UNION
        : PMP::Corefinement::TM1_MINUS_TM2;
      results[wanted] = &first;
      const bool isManifold = PMP::corefine_and_compute_boolean_operations(
        first, second, results, CGAL::parameters::visitor(visitor))[wanted];
      if (!isManifold)
      {
        throw std::runtime_error(
          "Two surfaces touch in such a way that their union is not a closed surface.");
      }
      SurfaceMesh joined = RenumberFaces(first, origins);
      const Origins ofJoined = GetOrigins(joined);
      RemoveSlivers(joined, ofJoined, finest);
      TaggedSurface result;
      result.Mesh = cgal::FromSurfaceMesh(joined);
      for (const Face f : joined.faces())
      {
        result.Tags.push_back(ofJoined[f].Tag);
      }
      return result;
    });
}

TriangleMesh OutwardSurface(const SurfaceView& mesh)
{
  if (mesh.Triangles.empty())
  {
    return {}; // CGAL reads a component that is not there
  }
  return cgal::RethrowWithContext("turning the surface",
    [&]
    {
      SurfaceMesh surface = cgal::ToSurfaceMesh(mesh);
      PMP::orient_to_bound_a_volume(surface);
      return cgal::FromSurfaceMesh(surface);
    });
}

std::vector<Triangle> PolygonFilling(const std::vector<Point3>& polygon)
{
  std::vector<cgal::Point> points;
  points.reserve(polygon.size());
  for (const Point3& p : polygon)
  {
    points.push_back(cgal::ToCGAL(p));
  }
  std::vector<CGAL::Triple<int, int, int>> filling;
  cgal::RethrowWithContext("filling a loop",
    [&]
    {
      PMP::triangulate_hole_polyline(
        points, std::back_inserter(filling), CGAL::parameters::geom_traits(cgal::OrderedTraits()));
    });
  std::vector<Triangle> triangles;
  triangles.reserve(filling.size());
  for (const auto& t : filling)
  {
    triangles.push_back({ t.first, t.second, t.third });
  }
  return triangles;
}

}
