#include "Remeshing/MeshRefinement.h"

#include "Core/NumberText.h"
#include "Core/RangeChecks.h"
#include "Core/UnitScale.h"
#include "Remeshing/CGALSurface.h"
#include "Remeshing/DelaunayRemesh.h"
#include "Remeshing/LineCorners.h"
#include "Remeshing/PlanarRemesh.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"

#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/facets_in_complex_3_to_triangle_mesh.h>

#include <algorithm>
#include <cmath>

namespace isthmus::cgal
{

/// CGAL's domain of a surface, which counts the queries, the only measure of CGAL's progress.
class SurfaceDomain : public CGAL::Polyhedral_mesh_domain_with_features_3<Kernel, SurfaceMesh>
{
  using Base = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel, SurfaceMesh>;

public:
  SurfaceDomain(
    const std::vector<SurfaceMesh*>& meshes, double expected, const ProgressCallback& progress)
    : Base(meshes.begin(), meshes.end())
    , Expected(expected)
    , Progress(progress)
  {
  }

  struct Construct_intersection : Base::Construct_intersection
  {
    explicit Construct_intersection(const SurfaceDomain& domain)
      : Base::Construct_intersection(domain)
      , Counted(&domain)
    {
    }

    template <typename Query>
    auto operator()(const Query& query) const
    {
      this->Counted->Count();
      return Base::Construct_intersection::operator()(query);
    }

    const SurfaceDomain* Counted;
  };
  Construct_intersection construct_intersection_object() const
  {
    return Construct_intersection(*this);
  }

private:
  void Count() const
  {
    if (++this->Queries % 256 == 0)
    {
      const auto asked = static_cast<double>(this->Queries);
      Report(this->Progress, asked / (asked + this->Expected));
    }
  }

  double Expected;
  ProgressCallback Progress;
  mutable std::int64_t Queries = 0;
};

}

namespace isthmus
{
namespace
{

using cgal::SurfaceDomain;
using cgal::SurfaceMesh;
using DelaunayTriangulation = CGAL::Mesh_triangulation_3<SurfaceDomain>::type;
using DelaunayComplex = CGAL::Mesh_complex_3_in_triangulation_3<DelaunayTriangulation,
  SurfaceDomain::Corner_index, SurfaceDomain::Curve_index>;
using DelaunayCriteria = CGAL::Mesh_criteria_3<DelaunayTriangulation>;

/// The triangles of one label, with their own points.
TriangleMesh ExtractPart(const SurfaceView& mesh, const std::vector<int>& labels, int label)
{
  TriangleMesh part;
  std::vector<std::int64_t> ids(mesh.Points.size(), -1);
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    if (labels[i] != label)
    {
      continue;
    }
    Triangle t = mesh.Triangles[i];
    for (auto& corner : t)
    {
      auto& id = ids[static_cast<std::size_t>(corner)];
      if (id < 0)
      {
        id = static_cast<std::int64_t>(part.Points.size());
        part.Points.push_back(mesh.Points[static_cast<std::size_t>(corner)]);
      }
      corner = id;
    }
    part.Triangles.push_back(t);
  }
  return part;
}

/// Boundaries and features of `surface`, which get balls that keep them, cut at their corners;
/// CGAL's detect_features() cuts them at acute angles only. Sets the patches of `surface`.
std::vector<SurfaceDomain::Polyline_with_context> FindLines(
  SurfaceMesh& surface, double featureAngle, double tolerance)
{
  const auto patch = get(CGAL::face_patch_id_t<int>(), surface);
  const auto isFeature = get(CGAL::edge_is_feature, surface);
  CGAL::Polygon_mesh_processing::sharp_edges_segmentation(
    surface, featureAngle, isFeature, patch, CGAL::parameters::first_index(1));
  std::vector<bool> isLine(surface.num_edges());
  for (const auto e : surface.edges())
  {
    isLine[e] = surface.is_border(e) || get(isFeature, e);
  }
  std::vector<SurfaceDomain::Polyline_with_context> lines;
  for (const auto& line : cgal::CutLinesAtCorners(surface, isLine, tolerance))
  {
    auto& polyline = lines.emplace_back();
    for (const auto v : line.Points)
    {
      polyline.polyline_content.push_back(surface.point(v));
    }
    for (const auto e : line.Edges)
    {
      for (const auto h : { surface.halfedge(e, 0), surface.halfedge(e, 1) })
      {
        if (!surface.is_border(h))
        {
          polyline.context.adjacent_patches_ids.insert(get(patch, surface.face(h)));
        }
      }
    }
  }
  return lines;
}

/// Orients one connected part like the old surface where `made` lies on it.
TriangleMesh RefinePart(const SurfaceView& part, const SurfaceRemeshParameters& parameters,
  const ProgressCallback& progress)
{
  if (IsPlanar(part))
  {
    return PlanarRemesh(
      part, { parameters.EdgeLength, parameters.MinimumAngle, parameters.MaximumPoints }, progress);
  }
  namespace params = CGAL::parameters;
  SurfaceMesh surface = cgal::ToSurfaceMesh(part);
  const double length = parameters.EdgeLength;
  const double triangles = SurfaceArea(part) / (0.433 * length * length);
  const double distance =
    parameters.MaximumDistance > 0.0 ? parameters.MaximumDistance : length / 10.0;
  const auto lines = FindLines(surface, parameters.FeatureAngle, 0.5 * distance);
  SurfaceDomain domain(std::vector<SurfaceMesh*>{ &surface }, 60.0 * triangles + 1e4, progress);
  domain.add_features_with_context(lines.begin(), lines.end());
  const DelaunayCriteria criteria(params::edge_size = length,
    params::facet_angle = parameters.MinimumAngle, params::facet_size = length / std::sqrt(3.0),
    params::facet_distance = distance);
  const bool isClosed = FindDefects(part).BoundaryTriangles.empty();
  DelaunayComplex complex;
  const auto maximumPoints = static_cast<std::size_t>(parameters.MaximumPoints);
  bool isWithinLimit = cgal::ProtectEdges(complex, domain, criteria, maximumPoints);
  if (isWithinLimit)
  {
    cgal::AddInitialPoints(complex, domain);
    isWithinLimit = cgal::RefineMesh(complex, domain, criteria, maximumPoints,
      isClosed ? CGAL::MANIFOLD : CGAL::MANIFOLD_WITH_BOUNDARY);
  }
  if (!isWithinLimit)
  {
    RejectManyPoints(parameters.MaximumPoints);
  }
  SurfaceMesh made;
  CGAL::facets_in_complex_3_to_triangle_mesh(complex, made);
  return cgal::FromSurfaceMesh(made);
}

Point3 ComputeNormal(const SurfaceView& mesh, const Triangle& t)
{
  const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
  return Cross(at(1) - at(0), at(2) - at(0));
}

void Append(const RemeshedSurface& part, RemeshedSurface& whole)
{
  const auto shift = static_cast<std::int64_t>(whole.Mesh.Points.size());
  whole.Mesh.Points.insert(
    whole.Mesh.Points.end(), part.Mesh.Points.begin(), part.Mesh.Points.end());
  whole.Locations.insert(whole.Locations.end(), part.Locations.begin(), part.Locations.end());
  for (const Triangle& t : part.Mesh.Triangles)
  {
    whole.Mesh.Triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
}

/// Flips a part that is oriented against the old surface.
void AlignOrientation(const SurfaceView& old, RemeshedSurface& part)
{
  double alike = 0.0;
  for (const Triangle& t : part.Mesh.Triangles)
  {
    const auto& under = old.Triangles[static_cast<std::size_t>(
      part.Locations[static_cast<std::size_t>(t[0])].Triangle)];
    alike += Dot(ComputeNormal(part.Mesh, t), ComputeNormal(old, under));
  }
  for (Triangle& t : part.Mesh.Triangles)
  {
    if (alike < 0.0)
    {
      std::swap(t[1], t[2]);
    }
  }
}

}

RemeshedSurface DelaunayRemesh(const SurfaceView& mesh, const SurfaceRemeshParameters& parameters,
  const ProgressCallback& progress)
{
  SurfaceDefects defects = FindDefects(mesh);
  defects.BoundaryTriangles.clear();
  if (!defects.None())
  {
    throw std::invalid_argument(defects.Message() + " Repair the surface before remeshing it.");
  }
  Check(parameters); // after the mesh, from which the edge length may be derived
  if (mesh.Triangles.empty())
  {
    return {};
  }
  const double points =
    0.5 * SurfaceArea(mesh) / (0.433 * parameters.EdgeLength * parameters.EdgeLength);
  if (points > static_cast<double>(parameters.MaximumPoints))
  {
    throw std::invalid_argument("An edge length of " + FormatNumber(parameters.EdgeLength) +
      " needs about " + FormatNumber(points) + " points, more than the limit of " +
      std::to_string(parameters.MaximumPoints) + ": choose longer edges.");
  }
  const UnitScale scale(mesh);
  if (!scale.IsOne())
  {
    SurfaceRemeshParameters scaled = parameters;
    scaled.EdgeLength *= scale.Factor();
    scaled.MaximumDistance *= scale.Factor();
    TriangleMesh small = CopyMesh(mesh);
    scale.Apply(small.Points);
    RemeshedSurface result = DelaunayRemesh(small, scaled, progress);
    scale.Undo(result.Mesh.Points);
    return result;
  }
  return cgal::RethrowWithContext("remeshing the surface",
    [&]
    {
      const std::vector<int> labels = Components(mesh);
      const int count = *std::max_element(labels.begin(), labels.end()) + 1;
      RemeshedSurface result;
      for (int label = 0; label < count; ++label)
      {
        const TriangleMesh old = ExtractPart(mesh, labels, label);
        RemeshedSurface part;
        part.Mesh = RefinePart(
          old, parameters, Between(progress, 1.0 * label / count, 1.0 * (label + 1) / count));
        if (part.Mesh.Triangles.empty() ||
          EulerCharacteristic(part.Mesh) != EulerCharacteristic(old))
        {
          throw std::runtime_error("A part of the surface with " +
            std::to_string(old.Triangles.size()) +
            " triangles loses its topology at this edge length: choose a smaller one.");
        }
        part.Locations = LocateOn(mesh, part.Mesh.Points);
        AlignOrientation(mesh, part);
        Append(part, result);
      }
      return result;
    });
}

}
