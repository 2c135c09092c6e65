/**
 * @file SurfaceCorrection.h
 * @brief Corrects small defects of surfaces from files: cracks between facets, flipped patches, and
 * cavities that face the wrong way.
 *
 * Points are not moved; only the corners of triangles change.
 */
#ifndef isthmus_SurfaceMending_h
#define isthmus_SurfaceMending_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

#include <cstdint>
#include <string>
#include <vector>

namespace isthmus
{

/// What was done.
struct SurfaceCorrection
{
  std::int64_t Joined = 0; ///< points merged with others, within Tolerance
  double Tolerance = 0.0;  ///< distance up to which points were merged
  double Share = 0.0;      ///< the same as a share of the diagonal of the surface's box
  std::int64_t Turned = 0; ///< triangles turned to face as their neighbours do
  std::int64_t Shells = 0; ///< closed shells flipped as a whole

  /// One message, empty if nothing was changed.
  VTKISTHMUSFILTERSSURFACES_EXPORT std::string Message() const;
};

/**
 * `surface` with points at its open edges merged that are nearly at one place, as rounding leaves
 * them between the facets of STL files. The tolerance is one of 1e-7, 1e-6, 1e-5 and 1e-4 of the
 * diagonal, and at most a tenth of the median open edge: the smallest one with which the fewest
 * triangles are at a hole, provided that no edge gets more than two triangles. Triangles that lose
 * an edge are dropped. O(n).
 * @pre coinciding points are merged (MergedCorners), corners exist and are finite.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<Triangle> JoinCracks(
  const SurfaceView& surface, SurfaceCorrection& done);

/**
 * `surface` with neighbours oriented consistently: in each component, triangles that cover the
 * smaller area are turned. Components that cannot be oriented consistently (e.g. a Moebius strip)
 * are not changed. The orientation is not propagated across edges of more than two triangles. O(n
 * log n).
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<Triangle> OrientAlike(
  const SurfaceView& surface, SurfaceCorrection& done);

/**
 * `surface` with closed shells facing as they must, given the outermost ones: a shell directly in
 * another faces the other way, so that cavities are subtracted and bodies in cavities added.
 * Outermost shells are oriented outward if any of them faces outward; if all face inward, so does
 * the result. Shells that cross are not nested; shells around others are searched for among the
 * thousand largest. O(n log n), with winding numbers computed by a tree.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<Triangle> OrientShells(
  const SurfaceView& surface, SurfaceCorrection& done);

/// The same with the outermost shells facing outward, whichever way they faced. Open components are
/// not changed.
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<Triangle> OrientOutward(const SurfaceView& surface);

}

#endif
