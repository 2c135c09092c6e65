/**
 * @file CGALVersions.h
 * @brief The only file that depends on CGAL's version, for functions without a common call in all
 * versions from 5.5 to the newest. Private: only for files that use CGAL.
 */
#ifndef isthmus_CGALVersions_h
#define isthmus_CGALVersions_h

#include "Remeshing/CGALSurface.h"

#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/version.h>

namespace isthmus::cgal
{

/// Collapses needles among `faces` (longest over shortest edge above `needleRatio`) where that
/// moves a point by at most `collapseLength`, and flips caps (cosine of the largest angle below
/// `capCosine`). From CGAL 6.0 on the function takes named parameters and is no longer in
/// `experimental`.
template <typename Faces>
void RemoveNeedlesAndCaps(const Faces& faces, SurfaceMesh& mesh, double capCosine,
  double needleRatio, double collapseLength)
{
#if CGAL_VERSION_NR >= 1060000000 // 6.0
  CGAL::Polygon_mesh_processing::remove_almost_degenerate_faces(faces, mesh,
    CGAL::parameters::cap_threshold(capCosine)
      .needle_threshold(needleRatio)
      .collapse_length_threshold(collapseLength));
#else
  CGAL::Polygon_mesh_processing::experimental::remove_almost_degenerate_faces(
    faces, mesh, capCosine, needleRatio, collapseLength);
#endif
}

}

#endif
