/**
 * @file StarDefects.h
 * @brief What is wrong with the edges and fans of a surface, found star by star. Private.
 */
#ifndef isthmus_StarDefects_h
#define isthmus_StarDefects_h

#include "Core/TriangleMesh.h"
#include "Surfaces/SurfaceDefects.h"

namespace isthmus
{

/**
 * Adds to `found` duplicate triangles, those at edges that do not have two of opposite direction,
 * and points whose triangles form more than one fan; each list in ascending order, without
 * repetition.
 *
 * All of that shows in the star of one point, the lowest of what is concerned, whose triangles are
 * sorted by their other corners: O(n) for stars of bounded size, in parallel over points, 32 bytes
 * a triangle. The same on any number of threads.
 *
 * @param skip Triangles to leave out, one flag each.
 * @pre The corners of all others are points, and differ.
 */
void FindStarDefects(const SurfaceView& mesh, const std::vector<char>& skip, SurfaceDefects& found);

}

#endif
