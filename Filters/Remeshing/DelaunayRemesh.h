/**
 * @file DelaunayRemesh.h
 * @brief Triangles with a bound on their angles for a surface, by restricted Delaunay refinement.
 *
 * J.-D. Boissonnat, S. Oudot, Graph. Models 67 (2005) 405, doi:10.1016/j.gmod.2005.01.004, with
 * balls that keep features (S.-W. Cheng, T. K. Dey, E. A. Ramos, SODA 2007, 1096), in CGAL's
 * Mesh_3.
 */
#ifndef isthmus_DelaunayRemesh_h
#define isthmus_DelaunayRemesh_h

#include "Core/Progress.h"
#include "Remeshing/SurfaceRemesh.h"

namespace isthmus
{

/**
 * Delaunay remeshing of `mesh`, each connected part separately. New points lie on the old surface;
 * no triangle has a larger circumscribed circle than an equilateral one of EdgeLength. Features and
 * boundaries stay, as chains of edges through their corners, within half of MaximumDistance;
 * triangles that touch them may have smaller angles. In planar parts every boundary point stays.
 *
 * @pre as for RemeshSurface(). @throws as that, and std::runtime_error when refinement does not end
 * below MaximumPoints, as at very sharp features, or loses a part: use a smaller EdgeLength.
 * Time: linear in the points of the result.
 */
RemeshedSurface DelaunayRemesh(const SurfaceView& mesh, const SurfaceRemeshParameters& parameters,
  const ProgressCallback& progress = {});

}

#endif
