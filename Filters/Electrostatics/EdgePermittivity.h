/**
 * @file EdgePermittivity.h
 * @brief The permittivity of each edge of a grid, in a byte.
 */
#ifndef isthmus_EdgePermittivity_h
#define isthmus_EdgePermittivity_h

#include <array>
#include <vector>

namespace isthmus
{

/**
 * Permittivities by code, so that the finest grid takes three bytes a node: `Code[a][node]` names
 * the permittivity `Table[Code]` of the edge from the node to the next along axis a.
 */
struct EdgePermittivity
{
  std::array<std::vector<unsigned char>, 3> Code;
  std::array<float, 256> Table{};
};

}

#endif
