/**
 * @file CGALVersions.h
 * @brief Differences between versions of CGAL from 5.5 to the newest: functions without a common
 * call, and macros of the versions. Private: only for files that use CGAL.
 *
 * The functions are not inline: each instantiates much of CGAL, which is compiled once, in
 * CGALVersions.cxx.
 */
#ifndef isthmus_CGALVersions_h
#define isthmus_CGALVersions_h

#include "Remeshing/CGALSurface.h"

#include <CGAL/version.h>

#define ISTHMUS_CGAL_6 (CGAL_VERSION_NR >= 1060000000)
#define ISTHMUS_CGAL_6_2 (CGAL_VERSION_NR >= 1060200000)

#if ISTHMUS_CGAL_6
#include <CGAL/AABB_traits_3.h>

#include <optional>
#else
#include <CGAL/AABB_traits.h>

#include <boost/optional.hpp>
#endif

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

/// The type that CGAL's functions use as an optional: that of the standard library from CGAL 6.0
/// on.
#if ISTHMUS_CGAL_6
template <typename Value>
using Optional = std::optional<Value>;
#else
template <typename Value>
using Optional = boost::optional<Value>;
#endif

/// Collapses needles in `faces` (longest over shortest edge above `needleRatio`) if that moves a
/// point by at most `collapseLength`, and flips caps (cosine of the largest angle below
/// `capCosine`).
void RemoveNeedlesAndCaps(const std::vector<SurfaceMesh::Face_index>& faces, SurfaceMesh& mesh,
  double capCosine, double needleRatio, double collapseLength);

/// One halfedge of each border.
std::vector<SurfaceMesh::Halfedge_index> BorderCycles(const SurfaceMesh& mesh);

/// Fills the hole at `border` with triangles and returns them; returns none if that fails.
std::vector<SurfaceMesh::Face_index> FillHole(
  SurfaceMesh& mesh, SurfaceMesh::Halfedge_index border);

}

#endif
