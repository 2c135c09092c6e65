/**
 * @file CGALComplex.h
 * @brief The domain and the mesh of CGAL's tetrahedra. Private: only for files that use CGAL.
 */
#ifndef isthmus_CGALComplex_h
#define isthmus_CGALComplex_h

#include "Core/Geometry.h"
#include "Core/TetrahedralMesh.h"
#include "Remeshing/CGALSurface.h"
#include "Remeshing/MeshRefinement.h"
#include "Tetrahedra/TetrahedralMesher.h"

#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <limits>
#include <memory>

namespace isthmus::cgal
{

/// The shells (and the box, last) as CGAL meshes, and their nesting.
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

  /// A positive label of the region at `p` (its id + Shift), or 0 where no tetrahedra are wanted.
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

  static int GetRegion(int label) { return label - Shift; }

  /// Estimates the progress, which CGAL does not report, from the number of queries.
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

  /// Refinement of facets computes intersections only: cancellation must be checked here as well.
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

using DomainWithBox = CGAL::Mesh_domain_with_polyline_features_3<Domain>;
using Triangulation = CGAL::Mesh_triangulation_3<DomainWithBox>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, DomainWithBox::Corner_index,
  DomainWithBox::Curve_index>;

/// Lloyd, ODT, perturbation and exudation, as requested by the criteria.
void Optimize(const DomainWithBox& domain, const CGALCriteria& criteria, Complex& complex,
  const ProgressCallback& progress);

}

#endif
