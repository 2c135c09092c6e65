/**
 * @file ContourRings.h
 * @brief Do the polygons around each point of a contour form one ring?
 */
#ifndef isthmus_ContourRings_h
#define isthmus_ContourRings_h

#include "Contouring/ContourPolygons.h"

namespace isthmus
{

struct BadRings
{
  std::vector<std::int64_t> Edges; ///< crossed edges of the polygons in them, and folded ones
  std::vector<char> IsThere;       ///< of each point and cluster: it has polygons
};

/**
 * Points whose polygons are not one ring of three or more, each beside the next one with the same
 * side out; a chain will do for those of `mayBeOpen` and for points of polygons.More.
 * O(n log n), 130 bytes a polygon.
 */
BadRings FindBadRings(const ContourPolygons& polygons, const std::vector<char>& mayBeOpen);

}

#endif
