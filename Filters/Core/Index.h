/**
 * @file Index.h
 * @brief Signed ids, like VTK's, as indices of standard library vectors.
 */
#ifndef isthmus_Index_h
#define isthmus_Index_h

#include <cstddef>
#include <cstdint>

namespace isthmus
{

/// @pre `id` is not negative.
inline std::size_t At(std::int64_t id)
{
  return static_cast<std::size_t>(id);
}

}

#endif
