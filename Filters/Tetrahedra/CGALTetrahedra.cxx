#include "Tetrahedra/CGALComplex.h"

#include <unordered_map>

namespace isthmus
{
namespace
{

using cgal::Complex;
using cgal::DomainWithBox;
using cgal::Kernel;
using cgal::Solids;
using cgal::SurfaceMesh;
using cgal::Triangulation;
using Point = Kernel::Point_3;
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

/// The twelve edges of the box, which keeps them straight.
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
    mesh.Regions.push_back(Solids::GetRegion(complex.subdomain_index(cell)));
  }
  mesh.OriginalPoints.assign(mesh.Points.size(), -1);
  return mesh;
}

/// The criteria with their defaults resolved.
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
  // Steps by the golden ratio, since equal steps can all fall on one ring of a regular mesh.
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

Complex Refine(const DomainWithBox& domain, const std::vector<const SurfaceMesh*>& shells,
  const Bounds3& bounds, const CGALCriteria& c, const ProgressCallback& progress)
{
  namespace params = CGAL::parameters;
  const GrowingSize facets{ bounds, c.FacetSize };
  const GrowingSize cells{ bounds, c.CellSize };
  const Criteria criteria(params::edge_size = facets, params::facet_angle = c.FacetAngle,
    params::facet_size = facets, params::facet_distance = c.FacetDistance,
    params::cell_radius_edge_ratio = c.CellRadiusEdgeRatio, params::cell_size = cells);
  Complex complex;
  const auto maximumPoints = static_cast<std::size_t>(c.MaximumPoints);
  bool isWithinLimit = cgal::ProtectEdges(complex, domain, criteria, maximumPoints);
  if (isWithinLimit)
  {
    AddSeeds(shells, domain, complex);
    isWithinLimit = cgal::RefineMesh(complex, domain, criteria, maximumPoints);
  }
  if (!isWithinLimit)
  {
    throw std::runtime_error("CGAL's refinement passed " + std::to_string(c.MaximumPoints) +
      " points: choose larger sizes, a smaller facet angle, or raise the limit.");
  }
  cgal::Optimize(domain, c, complex, progress);
  return complex;
}

}

TetrahedralMesh CGALTetrahedra(const TetrahedralTask& task, const ProgressCallback& progress)
{
  return cgal::RethrowWithContext("filling the surface with tetrahedra",
    [&]
    {
      const Bounds3 bounds = ComputeBounds(task.Surface);
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
