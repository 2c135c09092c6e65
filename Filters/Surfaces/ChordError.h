/**
 * @file ChordError.h
 * @brief How far area and volume of a surface are from those of the smooth surface that its
 * triangles approximate.
 *
 * Triangles lie beside a smooth surface like chords beside a circle. Over a triangle, the surface
 * is taken as the quadratic height g with the normals that the triangles around its corners have on
 * average. With a_k = e_k . (n_end - n_begin) for the edges e_k of a triangle of area A, the exact
 * integrals are
 *
 *     volume between = A / 24 (a_1 + a_2 + a_3)        area beyond = 1/2 integral of |grad g|^2
 *
 * Linear interpolation of a volume moves the points of an isosurface, too, to the same side as
 * chords: by 0.6 of the mean height above the triangles for a signed distance, and by more for
 * other functions. The area changes by as much as that of the surface with its points moved back.
 * The estimates are 2.5 times the sums, signs included, plus 0.3 and 0.5 of the sums without signs,
 * so that they do not vanish where curvatures of both signs cancel.
 *
 * Triangles whose normals differ by more than 60 degrees belong to different sides of a sharp edge,
 * which adds no error: a cube has none.
 */
#ifndef isthmus_ChordError_h
#define isthmus_ChordError_h

#include "Core/TriangleMesh.h"
#include "Surfaces/TriangleStars.h"

#include <vector>

namespace isthmus
{

/// Estimates of one component, both positive.
struct ChordError
{
  double Area = 0.0;   ///< length^2
  double Volume = 0.0; ///< length^3
};

/// For each of `count` components; `componentOf` has the component of each point. O(triangles).
std::vector<ChordError> EstimateChordErrors(const SurfaceView& mesh, const TriangleStars& stars,
  const std::vector<vtkIdType>& componentOf, vtkIdType count);

}

#endif
