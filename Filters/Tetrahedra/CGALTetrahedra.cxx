#include "Remeshing/SuppressCGALDumps.h"

#include "Core/Geometry.h"
#include "Core/TetrahedralMesh.h"
#include "Remeshing/CGALSurface.h"
#include "Tetrahedra/TetrahedralMesher.h"

#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/lloyd_optimize_mesh_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>

#include <limits>
#include <memory>
#include <unordered_map>

namespace isthmus::cgal
{

/// The shells (and the box, last) as CGAL meshes, and who is inside whom.
class Solids
{
public:
  Solids(const TetrahedralTask& task, double cellSize, const ProgressCallback& progress)
    : Task(task)
    , Progress(progress)
  {
    for (const TriangleMesh& shell : task.Nesting.Shells)
    {
      this->Add(shell);
    }
    if (!task.Box.Triangles.empty())
    {
      this->Add(task.Box);
    }
    double volume = 0.0;
    for (const SpaceRegion& region : task.Nesting.InnerRegions)
    {
      volume += region.Volume;
    }
    this->ExpectedQueries = 1e4 + 60.0 * volume / (cellSize * cellSize * cellSize);
  }

  /// 1 + place of the region in Regions, or 0 where no tetrahedra are wanted.
  int Label(const Point& p) const
  {
    this->Count();
    const std::size_t shells = this->Task.Nesting.Shells.size();
    int region = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < shells; ++s)
    {
      // Of all shells around p the smallest is the innermost.
      const double volume = this->Volumes[s];
      if (volume < smallest && (*this->Sides[s])(p) == CGAL::ON_BOUNDED_SIDE)
      {
        smallest = volume;
        region = this->Task.Nesting.InnerRegions[s].Id;
      }
    }
    const bool outside = region == 0 &&
      (this->Sides.size() == shells || (*this->Sides.back())(p) != CGAL::ON_BOUNDED_SIDE);
    return outside || !this->Task.IsWanted(region) ? 0 : region + Shift;
  }

  static int RegionOf(int label) { return label - Shift; }

  /// CGAL can't tell how far it is; questions asked against those expected can, roughly.
  /// @throws Cancelled on request.
  void Count() const
  {
    if (++this->Queries % 256 == 0)
    {
      const auto asked = static_cast<double>(this->Queries);
      Report(this->Progress, asked / (asked + this->ExpectedQueries));
    }
  }

  std::vector<const SurfaceMesh*> Meshes() const
  {
    std::vector<const SurfaceMesh*> result;
    for (const auto& mesh : this->Owned)
    {
      result.push_back(mesh.get());
    }
    return result;
  }

private:
  static constexpr int Shift = 1 << 24; ///< makes labels of cavities positive

  void Add(const SurfaceView& shell)
  {
    this->Owned.push_back(std::make_unique<SurfaceMesh>(ToSurfaceMesh(shell)));
    this->Sides.push_back(
      std::make_unique<CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel>>(*this->Owned.back()));
    this->Volumes.push_back(std::abs(SixVolume(shell)));
  }

  static double SixVolume(const SurfaceView& shell)
  {
    double sum = 0.0;
    for (const Triangle& t : shell.Triangles)
    {
      const auto at = [&](std::size_t c) { return shell.Points[static_cast<std::size_t>(t[c])]; };
      sum += Dot(at(0), Cross(at(1), at(2)));
    }
    return sum;
  }

  const TetrahedralTask& Task;
  ProgressCallback Progress;
  std::vector<std::unique_ptr<SurfaceMesh>> Owned;
  std::vector<std::unique_ptr<CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel>>> Sides;
  std::vector<double> Volumes;
  double ExpectedQueries = 1.0;
  mutable std::int64_t Queries = 0;
};

/// CGAL's domain of triangulated surfaces, with our regions.
class Domain : public CGAL::Polyhedral_mesh_domain_3<SurfaceMesh, Kernel>
{
  using Base = CGAL::Polyhedral_mesh_domain_3<SurfaceMesh, Kernel>;

public:
  Domain(const Solids* solids, const std::vector<const SurfaceMesh*>& meshes)
    : Base(meshes.begin(), meshes.end())
    , Regions(solids)
  {
  }

  struct Is_in_domain
  {
    const Solids* Regions;

    Subdomain operator()(const Point& p) const
    {
      const int label = this->Regions->Label(p);
      return label == 0 ? Subdomain() : Subdomain(label);
    }
  };
  Is_in_domain is_in_domain_object() const { return { this->Regions }; }

  /// Refinement of facets asks for intersections only, and a stop must be heard there, too.
  struct Construct_intersection : Base::Construct_intersection
  {
    explicit Construct_intersection(const Domain& domain)
      : Base::Construct_intersection(domain)
      , Regions(domain.Regions)
    {
    }

    template <typename Query>
    auto operator()(const Query& query) const
    {
      this->Regions->Count();
      return Base::Construct_intersection::operator()(query);
    }

    const Solids* Regions;
  };
  Construct_intersection construct_intersection_object() const
  {
    return Construct_intersection(*this);
  }

private:
  const Solids* Regions;
};

}

namespace isthmus
{
namespace
{

using cgal::Domain;
using cgal::Kernel;
using cgal::Solids;
using cgal::SurfaceMesh;
using Point = Kernel::Point_3;

using DomainWithBox = CGAL::Mesh_domain_with_polyline_features_3<Domain>;
using Triangulation = CGAL::Mesh_triangulation_3<DomainWithBox>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, DomainWithBox::Corner_index,
  DomainWithBox::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

/// `Size` around the surface, growing with the distance from its box.
struct GrowingSize
{
  using FT = Kernel::FT;
  using Point_3 = Point;
  using Index = DomainWithBox::Index;

  Bounds3 Around;
  double Size;

  FT operator()(const Point& p, int, const Index&) const
  {
    constexpr double growth = 0.3;
    Point3 away{};
    for (int a = 0; a < 3; ++a)
    {
      const auto i = static_cast<std::size_t>(a);
      away[i] = std::max({ 0.0, this->Around.Min[i] - p[a], p[a] - this->Around.Max[i] });
    }
    return this->Size + growth * Length(away);
  }
};

/// The twelve edges of the box, so that they come out straight.
void AddBoxEdges(const SurfaceView& box, DomainWithBox& domain)
{
  std::vector<std::vector<Point>> edges;
  for (std::size_t corner = 0; corner < box.Points.size(); ++corner)
  {
    for (const std::size_t bit : { 1u, 2u, 4u })
    {
      if ((corner & bit) == 0)
      {
        edges.push_back(
          { cgal::ToCGAL(box.Points[corner]), cgal::ToCGAL(box.Points[corner | bit]) });
      }
    }
  }
  domain.add_features(edges.begin(), edges.end());
}

TetrahedralMesh Extract(const Complex& complex)
{
  TetrahedralMesh mesh;
  std::unordered_map<const void*, std::int64_t> ids;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell)
  {
    Tetrahedron t{};
    for (int c = 0; c < 4; ++c)
    {
      const auto vertex = cell->vertex(c);
      const auto [known, isNew] =
        ids.emplace(&*vertex, static_cast<std::int64_t>(mesh.Points.size()));
      if (isNew)
      {
        mesh.Points.push_back(cgal::FromCGAL(vertex->point().point()));
      }
      t[static_cast<std::size_t>(c)] = known->second;
    }
    mesh.Tetrahedra.push_back(t);
    mesh.Regions.push_back(Solids::RegionOf(complex.subdomain_index(cell)));
  }
  mesh.OriginalPoints.assign(mesh.Points.size(), -1);
  return mesh;
}

/// The criteria with their defaults worked out.
CGALCriteria Sizes(CGALCriteria criteria, const Bounds3& bounds)
{
  const auto fallBack = [](double& size, double value) { size = size > 0.0 ? size : value; };
  fallBack(criteria.FacetSize, bounds.Diagonal() / 40.0);
  fallBack(criteria.CellSize, bounds.Diagonal() / 40.0);
  fallBack(criteria.FacetDistance, criteria.FacetSize / 10.0);
  return criteria;
}

/// Points of each shell to start from, since CGAL's own choice (rays from the middle) misses small
/// ones: middles of triangles, since a point on a sharp edge can keep refinement from ending.
void AddSeeds(
  const std::vector<const SurfaceMesh*>& shells, const DomainWithBox& domain, Complex& complex)
{
  constexpr std::size_t count = 40;
  // Steps of the golden ratio, since equal ones can all hit one ring of a regular mesh.
  constexpr double golden = 0.6180339887498949;
  for (const SurfaceMesh* shell : shells)
  {
    const auto n = static_cast<double>(shell->number_of_faces());
    for (std::size_t k = 0; k < count; ++k)
    {
      const auto i = static_cast<std::size_t>(n * std::fmod(golden * static_cast<double>(k), 1.0));
      const auto h =
        shell->halfedge(SurfaceMesh::Face_index(static_cast<SurfaceMesh::size_type>(i)));
      const Point middle = CGAL::centroid(shell->point(shell->source(h)),
        shell->point(shell->target(h)), shell->point(shell->target(shell->next(h))));
      const auto vertex = complex.triangulation().insert(Triangulation::Weighted_point(middle));
      if (vertex != Triangulation::Vertex_handle()) // else hidden by the ball of a box edge
      {
        complex.set_dimension(vertex, 2);
        complex.set_index(
          vertex, domain.index_from_surface_patch_index(DomainWithBox::Surface_patch_index()));
      }
    }
  }
}

/// The criterion of CGAL's exuder, which asks for nothing else of ours: where a stop is heard.
class ReportingCriterion : public CGAL::Mesh_3::Min_dihedral_angle_criterion<Triangulation>
{
  using Base = CGAL::Mesh_3::Min_dihedral_angle_criterion<Triangulation>;

public:
  ReportingCriterion(double bound, const Triangulation& triangulation, double usual,
    const ProgressCallback& progress, std::uint64_t& count)
    : Base(bound, triangulation)
    , Usual(usual)
    , Progress(&progress)
    , Calls(&count)
  {
  }

  using Base::operator();
  double operator()(const Tetrahedron_3& t) const override
  {
    if (++*this->Calls % 1024 == 0)
    {
      Report(*this->Progress, 1.0 - std::exp(-static_cast<double>(*this->Calls) / this->Usual));
    }
    return Base::operator()(t);
  }

private:
  double Usual; ///< calls after which some two thirds of the bar are full
  const ProgressCallback* Progress;
  std::uint64_t* Calls;
};

void Exude(Complex& complex, const ProgressCallback& progress)
{
  constexpr double slivers = 8.0; // degrees
  std::uint64_t count = 0;
  const double usual = 100.0 * static_cast<double>(complex.number_of_cells_in_complex() + 1);
  const ReportingCriterion criterion(slivers, complex.triangulation(), usual, progress, count);
  CGAL::Mesh_3::Slivers_exuder<Complex, ReportingCriterion> exuder(complex, criterion);
  exuder.set_time_limit(0.0);
  exuder();
}

void Optimise(const DomainWithBox& domain, const CGALCriteria& c, Complex& complex,
  const ProgressCallback& progress)
{
  namespace params = CGAL::parameters;
  if (c.LloydIterations > 0)
  {
    CGAL::lloyd_optimize_mesh_3(complex, domain, params::time_limit = c.OptimisationSeconds,
      params::max_iteration_number = static_cast<std::size_t>(c.LloydIterations));
  }
  if (c.ODTIterations > 0)
  {
    CGAL::odt_optimize_mesh_3(complex, domain, params::time_limit = c.OptimisationSeconds,
      params::max_iteration_number = static_cast<std::size_t>(c.ODTIterations));
  }
  if (c.PerturbSeconds > 0.0)
  {
    CGAL::perturb_mesh_3(
      complex, domain, params::time_limit = c.PerturbSeconds, params::sliver_bound = 15.0);
  }
  if (c.Exude)
  {
    Exude(complex, progress);
  }
}

Complex Refine(const DomainWithBox& domain, const std::vector<const SurfaceMesh*>& shells,
  const Bounds3& bounds, const CGALCriteria& c, const ProgressCallback& progress)
{
  namespace params = CGAL::parameters;
  const GrowingSize facets{ bounds, c.FacetSize };
  const GrowingSize cells{ bounds, c.CellSize };
  const Criteria criteria(params::edge_size = facets, params::facet_angle = c.FacetAngle,
    params::facet_size = facets, params::facet_distance = c.FacetDistance,
    params::cell_radius_edge_ratio = c.CellRadiusEdgeRatio, params::cell_size = cells);
  CGAL::Mesh_error_code error{};
  Complex complex;
  CGAL::Mesh_3::internal::init_c3t3_with_features(complex, domain, criteria);
  AddSeeds(shells, domain, complex);
  // Optimisation comes by itself, below: the stages that stop by the clock only where asked for.
  CGAL::refine_mesh_3(complex, domain, criteria, params::no_reset_c3t3(), params::no_perturb(),
    params::no_exude(),
    params::mesh_3_options(
      params::maximal_number_of_vertices = static_cast<std::size_t>(c.MaximumPoints),
      params::pointer_to_error_code = &error));
  if (error == CGAL::CGAL_MESH_3_MAXIMAL_NUMBER_OF_VERTICES_REACHED)
  {
    throw std::runtime_error("CGAL's refinement passed " + std::to_string(c.MaximumPoints) +
      " points: ask for larger sizes, a smaller facet angle, or raise the limit.");
  }
  Optimise(domain, c, complex, progress);
  return complex;
}

}

TetrahedralMesh CGALTetrahedra(const TetrahedralTask& task, const ProgressCallback& progress)
{
  return cgal::RethrowWithContext("filling the surface with tetrahedra",
    [&]
    {
      const Bounds3 bounds = BoundsOf(task.Surface);
      const CGALCriteria criteria = Sizes(task.Parameters.CGAL, bounds);
      const Solids solids(task, criteria.CellSize, Between(progress, 0.0, 0.9));
      DomainWithBox domain(&solids, solids.Meshes());
      if (!task.Box.Triangles.empty())
      {
        AddBoxEdges(task.Box, domain);
      }
      return Extract(
        Refine(domain, solids.Meshes(), bounds, criteria, Between(progress, 0.9, 1.0)));
    });
}

}
