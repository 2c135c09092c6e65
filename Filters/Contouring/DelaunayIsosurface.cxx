#include "Contouring/DelaunayIsosurface.h"

#include "Contouring/SeedPoints.h"
#include "Core/NumberText.h"
#include "Core/RangeChecks.h"
#include "Remeshing/CGALSurface.h"
#include "Remeshing/MeshRefinement.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"

#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>

#include <unordered_map>

namespace isthmus
{
namespace
{

using cgal::Kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
using Vertex = Triangulation::Vertex_handle;

/// Refuses sizes that the search for points does not resolve, or that need more points than
/// allowed, before refinement begins.
void RequireBudget(
  const DelaunayIsosurfaceParameters& p, const Bounds3& bounds, const SurfaceView& guide)
{
  const double finest = 1e-6 * bounds.Diagonal();
  if (p.Radius < finest || p.Distance < finest)
  {
    throw std::runtime_error("Radius is " + FormatNumber(p.Radius) + " and Distance " +
      FormatNumber(p.Distance) + ", but the surface is located to about " + FormatNumber(finest) +
      " (a millionth of the diagonal of the volume): choose larger ones.");
  }
  const double area = SurfaceArea(guide);
  // No triangle of circumradius r is larger than (3 sqrt(3) / 4) r^2, and there are two per point.
  const double least = area / (2.6 * p.Radius * p.Radius);
  if (least > static_cast<double>(p.MaximumNumberOfPoints))
  {
    throw std::runtime_error("A Radius of " + FormatNumber(p.Radius) + " needs at least " +
      FormatNumber(least) + " points, more than the limit of " +
      FormatNumber(static_cast<double>(p.MaximumNumberOfPoints)) +
      ": choose a larger one, or make the spacings of the volume more alike (Resample To Image).");
  }
}

/// Negative inside, as CGAL expects; counts the evaluations, the only measure of CGAL's progress.
class Side
{
public:
  Side(const ScalarField& field, const DelaunayIsosurfaceParameters& parameters, double expected,
    const ProgressCallback& progress)
    : Field(field)
    , Parameters(parameters)
    , Expected(expected)
    , Progress(progress)
  {
  }

  double operator()(const cgal::Point& p) const
  {
    if (++this->Evaluations % 4096 == 0)
    {
      const auto asked = static_cast<double>(this->Evaluations);
      Report(this->Progress, asked / (asked + this->Expected));
    }
    const double value = this->Field(cgal::FromCGAL(p));
    const bool inside = this->Parameters.InsideIsHigher ? value > this->Parameters.Level
                                                        : value < this->Parameters.Level;
    return inside ? -1.0 : 1.0;
  }

private:
  const ScalarField& Field;
  const DelaunayIsosurfaceParameters& Parameters;
  double Expected;
  const ProgressCallback& Progress;
  mutable std::int64_t Evaluations = 0;
};

/// Refinement of one surface, in rounds with more and more initial points.
class Refinement
{
public:
  Refinement(const Domain& domain, const DelaunayIsosurfaceParameters& parameters)
    : TheDomain(domain)
    , Parameters(parameters)
  {
  }

  std::vector<Vertex> Insert(const SurfaceView& guide, const std::vector<std::int64_t>& ids)
  {
    std::vector<Vertex> inserted;
    for (const std::int64_t id : ids)
    {
      const Point3& p = guide.Points[static_cast<std::size_t>(id)];
      const Vertex v =
        this->Result.triangulation().insert(Triangulation::Weighted_point(cgal::ToCGAL(p)));
      this->Result.set_dimension(v, 2);
      this->Result.set_index(
        v, this->TheDomain.index_from_surface_patch_index(Domain::Surface_patch_index(0, 1)));
      inserted.push_back(v);
    }
    return inserted;
  }

  void Run()
  {
    namespace params = CGAL::parameters;
    const Criteria criteria(params::facet_angle = this->Parameters.Angle,
      params::facet_size = this->Parameters.Radius,
      params::facet_distance = this->Parameters.Distance);
    if (!cgal::RefineMesh(this->Result, this->TheDomain, criteria,
          static_cast<std::size_t>(this->Parameters.MaximumNumberOfPoints), CGAL::MANIFOLD))
    {
      throw std::runtime_error("Refinement passed " +
        std::to_string(this->Parameters.MaximumNumberOfPoints) +
        " points: choose a larger radius or distance, or move the level a little: refinement does "
        "not terminate at a level where two parts just touch.");
    }
  }

  /// Whether one of these vertices is part of the surface.
  bool IsCaptured(const std::vector<Vertex>& vertices) const
  {
    return std::any_of(vertices.begin(), vertices.end(),
      [this](const Vertex& v) { return this->Result.face_status(v) != Complex::NOT_IN_COMPLEX; });
  }

  TriangleMesh Surface() const
  {
    TriangleMesh mesh;
    std::unordered_map<const void*, std::int64_t> ids;
    for (auto f = this->Result.facets_in_complex_begin(); f != this->Result.facets_in_complex_end();
         ++f)
    {
      // The corners opposite to vertex i, counter-clockwise seen from outside its cell.
      constexpr int corners[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
      auto cell = f->first;
      int i = f->second;
      if (!this->Result.is_in_complex(cell))
      {
        const auto inner = cell->neighbor(i);
        i = inner->index(cell);
        cell = inner;
      }
      Triangle t{};
      for (std::size_t c = 0; c < 3; ++c)
      {
        const auto vertex = cell->vertex(corners[i][c]);
        const auto [known, isNew] =
          ids.emplace(&*vertex, static_cast<std::int64_t>(mesh.Points.size()));
        if (isNew)
        {
          mesh.Points.push_back(cgal::FromCGAL(vertex->point().point()));
        }
        t[c] = known->second;
      }
      mesh.Triangles.push_back(t);
    }
    return mesh;
  }

private:
  const Domain& TheDomain;
  const DelaunayIsosurfaceParameters& Parameters;
  Complex Result;
};

std::string Place(const SeededComponent& component)
{
  const Point3 middle = 0.5 * (component.Bounds.Min + component.Bounds.Max);
  return "(" + FormatNumber(middle[0]) + ", " + FormatNumber(middle[1]) + ", " +
    FormatNumber(middle[2]) + "), " + FormatNumber(component.Bounds.Diagonal()) + " across";
}

/// Refines from the seeds of every component, and from all points of those that were missed;
/// returns the positions of those that are still missing.
std::vector<std::string> CaptureComponents(
  Refinement& refinement, const SurfaceView& guide, const std::vector<SeededComponent>& components)
{
  std::vector<std::vector<Vertex>> seeds;
  seeds.reserve(components.size());
  for (const SeededComponent& component : components)
  {
    seeds.push_back(refinement.Insert(guide, component.Seeds));
  }
  refinement.Run();
  bool again = false;
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    if (!refinement.IsCaptured(seeds[c]))
    {
      seeds[c] = refinement.Insert(guide, components[c].Points);
      again = true;
    }
  }
  if (again)
  {
    refinement.Run();
  }
  std::vector<std::string> lost;
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    if (!refinement.IsCaptured(seeds[c]))
    {
      lost.push_back(Place(components[c]));
    }
  }
  return lost;
}

/// The differences between the surface and its guide.
std::string Differences(
  const SurfaceView& surface, const SurfaceView& guide, const std::vector<std::string>& lost)
{
  if (!lost.empty())
  {
    return "Dropped, since they are too small for the requested sizes (reduce Radius and Distance "
           "to "
           "keep them): " +
      std::to_string(lost.size()) + " of the level set's components, the first at " + lost.front() +
      ".";
  }
  const SurfaceDefects defects = FindDefects(surface);
  if (!defects.None())
  {
    return defects.Message();
  }
  const auto count = [](const SurfaceView& mesh)
  {
    const std::vector<int> labels = Components(mesh);
    return labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end()) + 1;
  };
  const int mine = count(surface);
  const int theirs = count(guide);
  const auto genus = [](const SurfaceView& mesh, int components)
  { return components - EulerCharacteristic(mesh) / 2; };
  if (mine != theirs || genus(surface, mine) != genus(guide, theirs))
  {
    return "Topology differs from that of marching cubes: " + std::to_string(mine) +
      " components and genus " + std::to_string(genus(surface, mine)) + ", there " +
      std::to_string(theirs) + " and " + std::to_string(genus(guide, theirs)) +
      ": choose a smaller radius.";
  }
  return {};
}

}

void Check(const DelaunayIsosurfaceParameters& p)
{
  RequireRange(
    "Angle", p.Angle, 0.0, 30.0, "It is in degrees; above, refinement may not terminate.");
  RequireRange("Radius", p.Radius, 0.0, LargestLength, "It is a length.");
  RequireRange("Distance", p.Distance, 0.0, LargestLength, "It is a length.");
  RequireRange("Level", p.Level, -Unlimited, Unlimited);
  RequireRange("MaximumNumberOfPoints", static_cast<double>(p.MaximumNumberOfPoints), 4, 1e9,
    "It limits the number of points of the result.");
}

void SetAutomaticSizes(double spacing, DelaunayIsosurfaceParameters& parameters)
{
  if (parameters.Radius == 0.0)
  {
    parameters.Radius = 1.5 * spacing;
  }
  if (parameters.Distance == 0.0)
  {
    parameters.Distance = 0.25 * spacing;
  }
}

// Mesh_3 and not Surface_mesher: it accepts initial points on every component, has an option for
// manifold output, can be stopped, and is maintained (the other is deprecated in CGAL 6).
DelaunayIsosurfaceResult DelaunayIsosurface(const ScalarField& field, const Bounds3& bounds,
  const SurfaceView& guide, const DelaunayIsosurfaceParameters& parameters,
  const ProgressCallback& progress)
{
  Check(parameters);
  RequireAbove("Radius", parameters.Radius, 0.0, LargestLength, "It is a length.");
  RequireAbove("Distance", parameters.Distance, 0.0, LargestLength, "It is a length.");
  if (guide.Triangles.empty())
  {
    return {};
  }
  return cgal::RethrowWithContext("refining the isosurface",
    [&]
    {
      Report(progress, 0.0);
      RequireBudget(parameters, bounds, guide);
      const auto components = SpreadSeeds(guide, 2.0 * parameters.Radius);
      const double expected = 400.0 * static_cast<double>(guide.Points.size());
      const Side side(field, parameters, expected, progress);
      const CGAL::Bbox_3 box(
        bounds.Min[0], bounds.Min[1], bounds.Min[2], bounds.Max[0], bounds.Max[1], bounds.Max[2]);
      const Domain domain =
        Domain::create_implicit_mesh_domain(CGAL::parameters::function = std::cref(side),
          CGAL::parameters::bounding_object = box, CGAL::parameters::relative_error_bound = 1e-7);
      Refinement refinement(domain, parameters);
      const std::vector<std::string> lost = CaptureComponents(refinement, guide, components);
      DelaunayIsosurfaceResult result;
      result.Surface = refinement.Surface();
      result.Warning = Differences(result.Surface, guide, lost);
      return result;
    });
}

}
