/**
 * @file MeshRefinement.h
 * @brief Delaunay refinement by CGAL's Mesh_3. Private: only for files that use CGAL, to be
 * included before any header of Mesh_3.
 */
#ifndef isthmus_MeshRefinement_h
#define isthmus_MeshRefinement_h

#include "Remeshing/CGALVersions.h"

#include <CGAL/Mesh_3/Dump_c3t3.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL
{

template <typename Complex>
void DiscardDump(const Complex&, const std::string&)
{
}

}

// Steps that fail write dump-bug.mesh and dump-bug.binary.cgal into the current folder and a line
// to the terminal before they throw (CGAL 5.5).
#define dump_c3t3 DiscardDump

#include <CGAL/Mesh_3/C3T3_helpers.h>
#include <CGAL/Mesh_3/Mesher_3.h>
#include <CGAL/Mesh_3/Protect_edges_sizing_field.h>
#include <CGAL/Mesh_error_code.h>
#include <CGAL/Mesh_facet_topology.h>

namespace isthmus::cgal
{

/// An edge criterion of Mesh_3 as the sizing field required by the protection of edges.
template <typename EdgeCriteria>
struct EdgeSize
{
  using Index = typename EdgeCriteria::Index;
  using FT = typename EdgeCriteria::FT;
  using Point_3 = typename EdgeCriteria::Point_3;

  const EdgeCriteria& Criteria;

  FT operator()(const Point_3& point, int dimension, const Index& index) const
  {
    return this->Criteria.sizing_field(point, dimension, index);
  }
};

/// Inserts the balls that protect the edges and corners of `domain`.
/// @returns false if that takes more than `maximumPoints`.
// make_mesh_3 of CGAL does this first, but including its header takes a gigabyte (CGAL 5.5).
template <typename Complex, typename Domain, typename Criteria>
bool ProtectEdges(
  Complex& complex, const Domain& domain, const Criteria& criteria, std::size_t maximumPoints)
{
  using Size = EdgeSize<typename Criteria::Edge_criteria>;
  CGAL::Mesh_error_code error{};
  CGAL::Mesh_3::Protect_edges_sizing_field<Complex, Domain, Size> protect(complex, domain,
    Size{ criteria.edge_criteria_object() }, {},
#if ISTHMUS_CGAL_6
    {}, // a distance
#endif
    maximumPoints, &error);
  protect(true);
  return error != CGAL::CGAL_MESH_3_MAXIMAL_NUMBER_OF_VERTICES_REACHED;
}

/// Inserts points of the surface of `domain` to refine from, unless facets of `complex` lie on it
/// already.
template <typename Complex, typename Domain>
void AddInitialPoints(Complex& complex, const Domain& domain)
{
  auto& triangulation = complex.triangulation();
  if (triangulation.dimension() == 3)
  {
    CGAL::Mesh_3::C3T3_helpers<Complex, Domain>(complex, domain).update_restricted_facets();
    if (complex.number_of_facets() > 0)
    {
      return;
    }
  }
  std::vector<std::pair<typename Domain::Point_3, typename Domain::Index>> points;
  domain.construct_initial_points_object()(std::back_inserter(points));
  for (const auto& [point, index] : points)
  {
    const auto v = triangulation.insert(typename Complex::Triangulation::Weighted_point(point));
    if (v != typename Complex::Vertex_handle()) // else hidden by a ball
    {
      complex.set_dimension(v, 2);
      complex.set_index(v, index);
    }
  }
}

/// Refines `complex` until it meets `criteria`; `topology` is required of its facets.
/// @returns false if `maximumPoints` is reached first.
// The same as refine_mesh_3 of CGAL, without the four optimizers that this function instantiates
// even if none of them is wanted: half of its compile time and memory.
template <typename Complex, typename Domain, typename Criteria>
bool RefineMesh(Complex& complex, const Domain& domain, const Criteria& criteria,
  std::size_t maximumPoints, int topology = 0)
{
  CGAL::Mesh_error_code error{};
  CGAL::Mesh_3::Mesher_3<Complex, Criteria, Domain> mesher(
    complex, domain, criteria, topology, maximumPoints, &error, nullptr);
  mesher.refine_mesh();
  complex.clear_manifold_info();
  return error != CGAL::CGAL_MESH_3_MAXIMAL_NUMBER_OF_VERTICES_REACHED;
}

}

#endif
