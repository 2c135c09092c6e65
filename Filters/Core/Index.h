/**
 * @file Index.h
 * @brief Ids, which are signed as VTK's are, as places in the library's vectors.
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
