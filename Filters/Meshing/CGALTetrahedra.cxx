#include "CGALSurface.h"
#include "TetrahedralMesher.h"

#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/make_mesh_3.h>

#include <memory>
#include <unordered_map>

namespace isthmus
{
namespace
{

using cgal::Kernel;
using cgal::SurfaceMesh;
using Point = Kernel::Point_3;

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

  void Add(const TriangleMesh& shell)
  {
    this->Owned.push_back(std::make_unique<SurfaceMesh>(cgal::ToSurfaceMesh(shell)));
    this->Sides.push_back(
      std::make_unique<CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel>>(*this->Owned.back()));
    this->Volumes.push_back(std::abs(SixVolume(shell)));
  }

  static double SixVolume(const TriangleMesh& shell)
  {
    double sum = 0.0;
    for (const Triangle& t : shell.Triangles)
    {
      const auto at = [&](std::size_t c) { return shell.Points[static_cast<std::size_t>(t[c])]; };
      sum += Dot(at(0), Cross(at(1), at(2)));
    }
    return sum;
  }

  /// CGAL can't tell how far it is; questions asked against those expected can, roughly.
  void Count() const
  {
    if (++this->Queries % 256 == 0)
    {
      const auto asked = static_cast<double>(this->Queries);
      Report(this->Progress, asked / (asked + this->ExpectedQueries));
    }
  }

  const TetrahedralTask& Task;
  const ProgressCallback& Progress;
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

private:
  const Solids* Regions;
};

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
    return this->Size + growth * std::sqrt(Dot(away, away));
  }
};

/// The twelve edges of the box, so that they come out straight.
void AddBoxEdges(const TriangleMesh& box, DomainWithBox& domain)
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
  constexpr std::size_t count = 20;
  for (const SurfaceMesh* shell : shells)
  {
    const std::size_t n = shell->number_of_faces();
    const std::size_t step = std::max<std::size_t>(1, n / count);
    for (std::size_t i = 0; i < n; i += step)
    {
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

Complex Refine(const DomainWithBox& domain, const std::vector<const SurfaceMesh*>& shells,
  const Bounds3& bounds, const CGALCriteria& c)
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
  // No optimisation stage that stops by the clock, since its result would not be repeatable.
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
  CGAL::exude_mesh_3(complex, params::sliver_bound = 8.0);
  return complex;
}

}

TetrahedralMesh CGALTetrahedra(const TetrahedralTask& task, const ProgressCallback& progress)
{
  return cgal::WithSentence("filling the surface with tetrahedra",
    [&]
    {
      const Bounds3 bounds = BoundsOf(task.Surface);
      const CGALCriteria criteria = Sizes(task.Parameters.CGAL, bounds);
      const Solids solids(task, criteria.CellSize, progress);
      DomainWithBox domain(&solids, solids.Meshes());
      if (!task.Box.Triangles.empty())
      {
        AddBoxEdges(task.Box, domain);
      }
      return Extract(Refine(domain, solids.Meshes(), bounds, criteria));
    });
}

}
