/**
 * @file SimplexIds.h
 * @brief Ids of a filtration's edges, triangles and tetrahedra, and their places in its order.
 */
#ifndef isthmus_SimplexIds_h
#define isthmus_SimplexIds_h

#include "Core/Handles.h"

#include <cstdint>
#include <vector>

namespace isthmus
{

/// The integer of all of these; ids of points are it as it stands. 32 bits: a complex has at most
/// 2^29 tetrahedra, whose faces are numbered, which is about 80 million points;
/// CellFiltration::Connect() refuses more with a sentence.
using SimplexId = std::int32_t;

using EdgeId = Handle<struct FiltrationEdge, SimplexId>;
using TriangleId = Handle<struct FiltrationTriangle, SimplexId>;
/// None: what is beyond the complex.
using TetrahedronId = Handle<struct FiltrationTetrahedron, SimplexId>;

/// Position in the order of entry among the simplices of the same dimension.
using EdgeRank = Handle<struct FiltrationEdgeRank, SimplexId>;
using TriangleRank = Handle<struct FiltrationTriangleRank, SimplexId>;
using TetrahedronRank = Handle<struct FiltrationTetrahedronRank, SimplexId>;

static_assert(sizeof(EdgeId) == sizeof(SimplexId) && sizeof(TriangleRank) == sizeof(SimplexId));

/// A set of edges, or of triangles, over Z/2: ids without repetition.
using EdgeChain = std::vector<EdgeId>;
using TriangleChain = std::vector<TriangleId>;

}

#endif
