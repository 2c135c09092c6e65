/**
 * @file SeedPoints.h
 * @brief Points spread over each component of a surface.
 */
#ifndef isthmus_SeedPoints_h
#define isthmus_SeedPoints_h

#include "Core/Geometry.h"
#include "Core/TriangleMesh.h"

namespace isthmus
{

/// One component of a surface: its point ids, box and the ids of its seeds.
struct SeededComponent
{
  std::vector<std::int64_t> Points;
  std::vector<std::int64_t> Seeds;
  Bounds3 Bounds;
};

/**
 * Components of `surface` in order, each with seeds: points of the surface that are at least
 * `spacing` apart, and at least four of them (or all, if there are fewer), chosen greedily to be
 * far apart. O(n), and O(4 n) for components with few seeds.
 */
std::vector<SeededComponent> SpreadSeeds(const SurfaceView& surface, double spacing);

}

#endif
