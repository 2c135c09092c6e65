#include "Remeshing/CGALVersions.h"

#include "Remeshing/OrderedTraits.h"

#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#if ISTHMUS_CGAL_6_2
#include <CGAL/boost/graph/border.h>
#else
#include <CGAL/Polygon_mesh_processing/border.h>
#endif

#include <iterator>

namespace isthmus::cgal
{

namespace PMP = CGAL::Polygon_mesh_processing;

// From CGAL 6.0 on, the function takes named parameters and is no longer in `experimental`.
void RemoveNeedlesAndCaps(const std::vector<SurfaceMesh::Face_index>& faces, SurfaceMesh& mesh,
  double capCosine, double needleRatio, double collapseLength)
{
#if ISTHMUS_CGAL_6
  PMP::remove_almost_degenerate_faces(faces, mesh,
    CGAL::parameters::cap_threshold(capCosine)
      .needle_threshold(needleRatio)
      .collapse_length_threshold(collapseLength));
#else
  PMP::experimental::remove_almost_degenerate_faces(
    faces, mesh, capCosine, needleRatio, collapseLength);
#endif
}

// From CGAL 6.2 on, the function is in another namespace and header.
std::vector<SurfaceMesh::Halfedge_index> BorderCycles(const SurfaceMesh& mesh)
{
  std::vector<SurfaceMesh::Halfedge_index> borders;
#if ISTHMUS_CGAL_6_2
  CGAL::extract_boundary_cycles(mesh, std::back_inserter(borders));
#else
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
#endif
  return borders;
}

// From CGAL 6.0 on, the output iterator is a named parameter.
std::vector<SurfaceMesh::Face_index> FillHole(SurfaceMesh& mesh, SurfaceMesh::Halfedge_index border)
{
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
