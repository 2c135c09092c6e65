#include "Remeshing/SurfaceRemesh.h"

#include "Core/MemoryBudget.h"
#include "Core/RangeChecks.h"
#include "Core/UnitScale.h"
#include "Remeshing/CGALSurface.h"
#include "Remeshing/CGALVersions.h"
#include "Remeshing/LineCorners.h"
#include "Surfaces/SurfaceDefects.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/tangential_relaxation.h>
#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <array>

namespace isthmus
{
namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMS = CGAL::Surface_mesh_simplification;
using cgal::Kernel;
using cgal::SurfaceMesh;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<SurfaceMesh>;
using Tree = CGAL::AABB_tree<cgal::TreeTraits<Primitive>>;

constexpr double MostTriangles = 5e7;

void RequireManifold(const SurfaceView& mesh)
{
  SurfaceDefects defects = FindDefects(mesh);
  defects.BoundaryTriangles.clear();
  if (!defects.None())
  {
    throw std::invalid_argument(defects.Message() + " Repair the surface before remeshing it.");
  }
}

/// Which edges are features, as a property map for CGAL.
struct Features
{
  using key_type = SurfaceMesh::Edge_index;
  using value_type = bool;
  using reference = bool;
  using category = boost::read_write_property_map_tag;

  SurfaceMesh::Property_map<key_type, bool> Map;
  const SurfaceMesh* Mesh = nullptr;

  /// Where all triangles around a point are flat, CGAL 5.5's tangential relaxation requests the
  /// edge of a null half edge; a feature is skipped.
  friend bool get(const Features& features, key_type e)
  {
    return e.idx() >= features.Mesh->num_edges() || features.Map[e];
  }
  friend void put(const Features& features, key_type e, bool is) { features.Map[e] = is; }
};

/// Number of triangles with edges of `length`, or more; refuses an invalid length, or too many
/// triangles.
double ExpectedTriangles(const SurfaceView& mesh, double length)
{
  double edges = 0.0; // of needles: they have no area, but are split as well
  double longest = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const Point3 edge = mesh.Points[static_cast<std::size_t>(t[(c + 1) % 3])] -
        mesh.Points[static_cast<std::size_t>(t[c])];
      const double size = Length(edge);
      edges += 0.5 * std::max(0.0, size / length - 1.0);
      longest = std::max(longest, size);
    }
  }
  const double expected = std::max(SurfaceArea(mesh) / (0.433 * length * length), edges);
  if (!(expected < MostTriangles) || length < 1e-9 * longest)
  {
    throw std::invalid_argument("An edge length of " + FormatNumber(length) +
      " is so small that more than 50 million triangles would result: choose a larger one.");
  }
  constexpr double bytesPerTriangle = 450.0;
  MemoryBudget().Require(bytesPerTriangle * expected,
    "A surface of about " + FormatNumber(expected, 2) + " triangles",
    "choose a larger edge length");
  return expected;
}

/// Applies `remesh` to the mesh scaled to about 1, and scales the result back.
template <typename Remesh>
RemeshedSurface RemeshAtUnitScale(TriangleMesh mesh, const UnitScale& scale, Remesh&& remesh)
{
  scale.Apply(mesh.Points);
  RemeshedSurface result = remesh(mesh);
  scale.Undo(result.Mesh.Points);
  return result;
}

/// Weights of the corners of a needle for a point on it: along its longest edge, by the corner that
/// lies between, which has its own data.
std::array<double, 3> WeightsOnNeedle(const std::array<Point3, 3>& corners, const Point3& point)
{
  std::size_t first = 0;
  const auto edge = [&](std::size_t c) { return corners[(c + 1) % 3] - corners[c]; };
  for (std::size_t c = 1; c < 3; ++c)
  {
    first = Dot(edge(c), edge(c)) > Dot(edge(first), edge(first)) ? c : first;
  }
  const std::size_t last = (first + 1) % 3, middle = (first + 2) % 3;
  const auto along = [&](const Point3& p) { return Dot(p - corners[first], edge(first)); };
  const double to = along(corners[last]), by = along(corners[middle]), at = along(point);
  std::array<double, 3> weights{ 0.0, 0.0, 0.0 };
  const std::size_t end = at < by ? first : last;
  const double whole = at < by ? by : to - by; // from this end to the middle
  weights[middle] = whole > 0.0 ? std::clamp((at < by ? at : to - at) / whole, 0.0, 1.0) : 0.0;
  weights[end] = 1.0 - weights[middle];
  return weights;
}

/// The nearest points on the old surface.
class OldSurface
{
public:
  OldSurface(const SurfaceView& triangles, const SurfaceMesh& mesh)
    : Triangles(triangles)
    , Faces(faces(mesh).first, faces(mesh).second, mesh)
  {
    this->Faces.accelerate_distance_queries();
  }

  cgal::Point Nearest(const cgal::Point& p) const { return this->Faces.closest_point(p); }

  SurfaceLocation Locate(const cgal::Point& p) const
  {
    const auto [nearest, face] = this->Faces.closest_point_and_primitive(p);
    const Triangle& t = this->Triangles.Triangles[face.idx()];
    const auto at = [&](std::size_t c) { return this->Triangles.Point(t[c]); };
    const Point3 point = cgal::FromCGAL(nearest);
    const Point3 x = point - at(0);
    const Point3 u = at(1) - at(0);
    const Point3 v = at(2) - at(0);
    const double uu = Dot(u, u), uv = Dot(u, v), vv = Dot(v, v), xu = Dot(x, u), xv = Dot(x, v);
    const double det = uu * vv - uv * uv;
    constexpr double flat = 1e-10; // below, rounding moves points by more than the height does
    if (!(det > flat * uu * vv))   // a needle, whose area is lost in rounding
    {
      return { static_cast<std::int64_t>(face.idx()),
        WeightsOnNeedle({ at(0), at(1), at(2) }, point) };
    }
    const double b = std::clamp((xu * vv - xv * uv) / det, 0.0, 1.0);
    const double c = std::clamp((xv * uu - xu * uv) / det, 0.0, 1.0 - b);
    return { static_cast<std::int64_t>(face.idx()), { 1.0 - b - c, b, c } };
  }

private:
  SurfaceView Triangles;
  Tree Faces;
};

/// Every point of the new surface on the old one.
RemeshedSurface LocatePoints(SurfaceMesh& remeshed, const OldSurface& old)
{
  RemeshedSurface result;
  result.Mesh = cgal::FromSurfaceMesh(remeshed);
  result.Locations.reserve(result.Mesh.Points.size());
  for (const Point3& p : result.Mesh.Points)
  {
    result.Locations.push_back(old.Locate(cgal::ToCGAL(p)));
  }
  return result;
}

/// Ratio of visits of points to the expected number beyond which remeshing does not terminate.
constexpr double ManyTimes = 100.0;

/// Projects points that are on no feature or border onto the old surface.
class Projection
{
public:
  Projection(const OldSurface& old, double expected, const ProgressCallback& progress)
    : Old(old)
    , Expected(expected)
    , Progress(progress)
  {
  }

  void Project(const Features& features, SurfaceMesh& mesh)
  {
    const auto holds = [&](SurfaceMesh::Halfedge_index h)
    { return mesh.is_border(mesh.edge(h)) || get(features, mesh.edge(h)); };
    for (const auto v : mesh.vertices())
    {
      this->Count();
      const auto edges = mesh.halfedges_around_target(mesh.halfedge(v));
      if (!mesh.is_isolated(v) && std::none_of(edges.begin(), edges.end(), holds))
      {
        mesh.point(v) = this->Old.Nearest(mesh.point(v));
      }
    }
  }

private:
  void Count()
  {
    if (static_cast<double>(++this->Done) > ManyTimes * this->Expected + 1e5)
    {
      throw std::runtime_error("Remeshing does not end: the surface has needles or folds that "
                               "splitting does not improve. Repair it, or choose a longer edge.");
    }
    if (this->Done % 256 == 0)
    {
      Report(this->Progress, std::min(1.0, static_cast<double>(this->Done) / this->Expected));
    }
  }

  const OldSurface& Old;
  double Expected;
  const ProgressCallback& Progress;
  std::int64_t Done = 0;
};

/// Points of boundaries and feature lines, for simplification.
enum class PlaceOnLine : char
{
  None,
  Along, ///< may be moved along the line, or removed
  Corner
};
using PlacesOnLines = SurfaceMesh::Property_map<SurfaceMesh::Vertex_index, PlaceOnLine>;

/// The distance from a straight line below which points of a boundary are on it, when edges become
/// `length` long. Small also where all of a boundary is shorter than that.
double StraightLineTolerance(const SurfaceView& mesh, double length)
{
  constexpr double share = 1e-3;
  return share * std::min(length, MeanEdgeLength(mesh));
}

/// Where the points of `mesh` are on the lines of the edges for which `isLine[edge]`.
PlacesOnLines FindPlacesOnLines(
  SurfaceMesh& mesh, const std::vector<bool>& isLine, double tolerance)
{
  PlacesOnLines places =
    mesh.add_property_map<SurfaceMesh::Vertex_index, PlaceOnLine>("v:place", PlaceOnLine::None)
      .first;
  for (const cgal::LineBetweenCorners& line : cgal::CutLinesAtCorners(mesh, isLine, tolerance))
  {
    for (const auto v : line.Points)
    {
      places[v] = std::max(places[v], PlaceOnLine::Along);
    }
    places[line.Points.front()] = places[line.Points.back()] = PlaceOnLine::Corner;
  }
  return places;
}

/// Corners, as a property map for CGAL.
struct Corners
{
  using key_type = SurfaceMesh::Vertex_index;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  PlacesOnLines Places;

  friend bool get(const Corners& corners, key_type v)
  {
    return corners.Places[v] == PlaceOnLine::Corner;
  }
};

template <typename Profile>
bool IsBoundary(const Profile& profile)
{
  return profile.is_v0_v1_a_border() || profile.is_v1_v0_a_border();
}

/// Placement by Lindstrom and Turk for points inside; none that would change a boundary.
struct PlacementKeepingBoundaries
{
  PlacesOnLines Places;

  template <typename Profile>
  cgal::Optional<cgal::Point> operator()(const Profile& profile) const
  {
    const PlaceOnLine place0 = this->Places[profile.v0()], place1 = this->Places[profile.v1()];
    const PlaceOnLine last = std::max(place0, place1);
    if (last == PlaceOnLine::None)
    {
      return SMS::LindstromTurk_placement<SurfaceMesh>()(profile);
    }
    if (place0 != place1)
    {
      const bool isFree = std::min(place0, place1) == PlaceOnLine::None || IsBoundary(profile);
      return isFree ? Place(place0 == last ? profile.p0() : profile.p1()) : Place();
    }
    return last == PlaceOnLine::Along && IsBoundary(profile)
      ? Place(CGAL::midpoint(profile.p0(), profile.p1()))
      : Place();
  }

private:
  using Place = cgal::Optional<cgal::Point>;
};

/// A point that two are merged into is where the one of them that stayed is. Counts the edges of
/// boundaries.
struct MergePlacesOnLines : SMS::Edge_collapse_visitor_base<SurfaceMesh>
{
  using Base = SMS::Edge_collapse_visitor_base<SurfaceMesh>;

  MergePlacesOnLines(const PlacesOnLines& places, std::size_t* boundaryEdges)
    : Places(places)
    , BoundaryEdges(boundaryEdges)
  {
  }

  void OnCollapsing(const Base::Profile& profile, const cgal::Optional<cgal::Point>&)
  {
    this->Merged = std::max(this->Places[profile.v0()], this->Places[profile.v1()]);
    *this->BoundaryEdges -= IsBoundary(profile) ? 1 : 0;
  }
  void OnCollapsed(const Base::Profile&, const Base::vertex_descriptor& v)
  {
    this->Places[v] = this->Merged;
  }

  PlacesOnLines Places;
  std::size_t* BoundaryEdges;
  PlaceOnLine Merged = PlaceOnLine::None;
};

/// Stops at a number of triangles; also reports progress, since CGAL calls it for each collapse.
struct StopAtTriangles
{
  std::size_t Triangles;
  const std::size_t* BoundaryEdges;
  const ProgressCallback* Progress;

  template <typename Cost, typename Profile>
  bool operator()(const Cost&, const Profile&, std::size_t initial, std::size_t current) const
  {
    const std::size_t edges = (3 * this->Triangles + *this->BoundaryEdges) / 2;
    if (current % 16 == 0) // around a point of a thousand triangles, each takes milliseconds
    {
      const double all = static_cast<double>(initial) - static_cast<double>(edges) + 1.0;
      Report(*this->Progress, std::min(1.0, static_cast<double>(initial - current) / all));
    }
    return current <= edges;
  }
};

}

void Check(const SurfaceRemeshParameters& parameters)
{
  RequireAbove("EdgeLength", parameters.EdgeLength, 0.0, LargestLength, "It is a length.");
  RequireRange("FeatureAngle", parameters.FeatureAngle, 0.0, 180.0, "It is an angle in degrees.");
  RequireRange(
    "NumberOfIterations", parameters.NumberOfIterations, 1, 100, "It is a number of rounds.");
  RequireRange("MinimumAngle", parameters.MinimumAngle, 0.0, 30.0,
    "It is an angle in degrees; above 30, refinement may not terminate.");
  RequireRange("MaximumDistance", parameters.MaximumDistance, 0.0, LargestLength,
    "It is a length; 0 stands for a tenth of the edge length.");
}

RemeshedSurface RemeshSurface(const SurfaceView& mesh, const SurfaceRemeshParameters& parameters,
  const ProgressCallback& progress)
{
  RequireManifold(mesh); // before the edge length, which may be derived from it
  Check(parameters);
  if (mesh.Triangles.empty())
  {
    return {};
  }
  RequireResolved(mesh); // by its own coordinates
  const UnitScale scale(mesh);
  if (!scale.IsOne())
  {
    SurfaceRemeshParameters scaled = parameters;
    scaled.EdgeLength *= scale.Factor();
    return RemeshAtUnitScale(CopyMesh(mesh), scale,
      [&](const SurfaceView& small) { return RemeshSurface(small, scaled, progress); });
  }
  const double length = parameters.EdgeLength;
  const double expected = ExpectedTriangles(mesh, length);
  return cgal::RethrowWithContext("remeshing the surface",
    [&]
    {
      const SurfaceMesh before = cgal::ToSurfaceMesh(mesh);
      const OldSurface old(mesh, before);
      SurfaceMesh after = before;
      const Features isFeature{
        after.add_property_map<SurfaceMesh::Edge_index, bool>("e:is_feature", false).first, &after
      };
      PMP::detect_sharp_edges(after, parameters.FeatureAngle, isFeature);
      std::vector<bool> isLine(after.num_edges());
      for (const auto e : after.edges())
      {
        isLine[e] = after.is_border(e) || get(isFeature, e);
      }
      const Corners corners{ FindPlacesOnLines(
        after, isLine, StraightLineTolerance(mesh, length)) };
      const auto cornerCount = std::count_if(
        after.vertices().begin(), after.vertices().end(), [&](auto v) { return get(corners, v); });
      const auto rest = Between(progress, 0.05, 0.95);
      Projection projection(old,
        (0.5 * expected + static_cast<double>(cornerCount)) * parameters.NumberOfIterations, rest);
      for (int i = 0; i < parameters.NumberOfIterations; ++i)
      {
        // CGAL's own relaxation requests null edges: see Features.
        PMP::isotropic_remeshing(faces(after), length, after,
          CGAL::parameters::edge_is_constrained_map(isFeature)
            .vertex_is_constrained_map(corners)
            .number_of_relaxation_steps(0)
            .do_project(false));
        PMP::tangential_relaxation(
          vertices(after), after, CGAL::parameters::edge_is_constrained_map(isFeature));
        projection.Project(isFeature, after);
      }
      return LocatePoints(after, old);
    });
}

RemeshedSurface SimplifySurface(
  const SurfaceView& mesh, std::int64_t triangles, const ProgressCallback& progress)
{
  RequireRange("NumberOfTriangles", static_cast<double>(triangles), 1.0, Unlimited);
  if (mesh.Triangles.empty())
  {
    return {};
  }
  RequireManifold(mesh);
  const UnitScale scale(mesh);
  if (!scale.IsOne())
  {
    return RemeshAtUnitScale(CopyMesh(mesh), scale,
      [&](const SurfaceView& small) { return SimplifySurface(small, triangles, progress); });
  }
  return cgal::RethrowWithContext("simplifying the surface",
    [&]
    {
      const SurfaceMesh before = cgal::ToSurfaceMesh(mesh);
      const OldSurface old(mesh, before);
      SurfaceMesh after = before;
      std::size_t border = 0;
      std::vector<bool> isLine(after.num_edges());
      for (const auto e : after.edges())
      {
        isLine[e] = after.is_border(e);
        border += isLine[e] ? 1 : 0;
      }
      const double length = std::sqrt(SurfaceArea(mesh) / static_cast<double>(triangles));
      const PlacesOnLines places =
        FindPlacesOnLines(after, isLine, StraightLineTolerance(mesh, length));
      const auto rest = Between(progress, 0.05, 0.95);
      const StopAtTriangles stop{ static_cast<std::size_t>(triangles), &border, &rest };
      SMS::edge_collapse(after, stop,
        CGAL::parameters::get_cost(SMS::LindstromTurk_cost<SurfaceMesh>())
          .get_placement(PlacementKeepingBoundaries{ places })
          .filter(SMS::Bounded_normal_change_filter<>())
          .visitor(MergePlacesOnLines(places, &border)));
      return LocatePoints(after, old);
    });
}

std::vector<SurfaceLocation> LocateOn(const SurfaceView& old, const std::vector<Point3>& points)
{
  const SurfaceMesh mesh = cgal::ToSurfaceMesh(old);
  const OldSurface surface(old, mesh);
  std::vector<SurfaceLocation> locations;
  locations.reserve(points.size());
  std::transform(points.begin(), points.end(), std::back_inserter(locations),
    [&](const Point3& p) { return surface.Locate(cgal::ToCGAL(p)); });
  return locations;
}

double MeanEdgeLength(const SurfaceView& mesh)
{
  double sum = 0.0;
  const auto points = static_cast<std::int64_t>(mesh.Points.size());
  for (const Triangle& t : mesh.Triangles)
  {
    // Corners that are not points are reported later, by the check of the mesh.
    if (std::any_of(t.begin(), t.end(), [points](auto id) { return id < 0 || id >= points; }))
    {
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      const Point3 edge = mesh.Points[static_cast<std::size_t>(t[(c + 1) % 3])] -
        mesh.Points[static_cast<std::size_t>(t[c])];
      sum += Length(edge);
    }
  }
  return mesh.Triangles.empty() ? 0.0 : sum / (3.0 * static_cast<double>(mesh.Triangles.size()));
}

}
