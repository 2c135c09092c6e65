/**
 * @file MeshAttribute.h
 * @brief One array on the vertices or on the cells of a mesh file.
 */
#ifndef isthmus_MeshAttribute_h
#define isthmus_MeshAttribute_h

#include "Files/NumberTypes.h"

#include <cstdint>
#include <string>

namespace isthmus
{

struct MeshAttribute
{
  enum class Place
  {
    Vertices,
    Cells
  };
  Place On = Place::Vertices;
  std::string Name;
  std::int64_t Components = 1;
  NumberList Values; ///< components run fastest
};

}

#endif
