/**
 * @file CGALVersions.h
 * @brief The only file that depends on CGAL's version, for functions without a common call in all
 * versions from 5.5 to the newest. Private: only for files that use CGAL.
 */
#ifndef isthmus_CGALVersions_h
#define isthmus_CGALVersions_h

#include "Remeshing/CGALSurface.h"
#include "Remeshing/OrderedTraits.h"

#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/version.h>

#define ISTHMUS_CGAL_6 (CGAL_VERSION_NR >= 1060000000)
#define ISTHMUS_CGAL_6_2 (CGAL_VERSION_NR >= 1060200000)

#if ISTHMUS_CGAL_6_2
#include <CGAL/boost/graph/border.h>
#else
#include <CGAL/Polygon_mesh_processing/border.h>
#endif
#if ISTHMUS_CGAL_6
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <iterator>
#include <vector>

namespace isthmus::cgal
{

/// Traits of an AABB tree in space: named AABB_traits_3 from CGAL 6.0 on.
#if ISTHMUS_CGAL_6
template <typename Primitive>
using TreeTraits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
template <typename Primitive>
using TreeTraits = CGAL::AABB_traits<Kernel, Primitive>;
#endif

/// Collapses needles in `faces` (longest over shortest edge above `needleRatio`) if that moves a
/// point by at most `collapseLength`, and flips caps (cosine of the largest angle below
/// `capCosine`). From CGAL 6.0 on the function takes named parameters and is no longer in
/// `experimental`.
template <typename Faces>
void RemoveNeedlesAndCaps(const Faces& faces, SurfaceMesh& mesh, double capCosine,
  double needleRatio, double collapseLength)
{
#if ISTHMUS_CGAL_6
  CGAL::Polygon_mesh_processing::remove_almost_degenerate_faces(faces, mesh,
    CGAL::parameters::cap_threshold(capCosine)
      .needle_threshold(needleRatio)
      .collapse_length_threshold(collapseLength));
#else
  CGAL::Polygon_mesh_processing::experimental::remove_almost_degenerate_faces(
    faces, mesh, capCosine, needleRatio, collapseLength);
#endif
}

/// One halfedge of each border. From CGAL 6.2 on the function is part of CGAL and has its own
/// header.
inline std::vector<SurfaceMesh::Halfedge_index> BorderCycles(const SurfaceMesh& mesh)
{
  std::vector<SurfaceMesh::Halfedge_index> borders;
#if ISTHMUS_CGAL_6_2
  CGAL::extract_boundary_cycles(mesh, std::back_inserter(borders));
#else
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
#endif
  return borders;
}

/// Fills the hole at `border` with triangles and returns them; returns none if that fails. From
/// CGAL 6.0 on the output iterator is a named parameter.
inline std::vector<SurfaceMesh::Face_index> FillHole(
  SurfaceMesh& mesh, SurfaceMesh::Halfedge_index border)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<SurfaceMesh::Face_index> patch;
#if ISTHMUS_CGAL_6
  PMP::triangulate_hole(mesh, border,
    CGAL::parameters::face_output_iterator(std::back_inserter(patch)).geom_traits(OrderedTraits()));
#else
  PMP::triangulate_hole(
    mesh, border, std::back_inserter(patch), CGAL::parameters::geom_traits(OrderedTraits()));
#endif
  return patch;
}

}

#endif
