/**
 * @file MachineMemory.h
 * @brief How much memory a filter may plan with when its user sets no limit.
 */
#ifndef isthmus_MachineMemory_h
#define isthmus_MachineMemory_h

#include <cstdint>

#include <unistd.h>

namespace isthmus
{

/// Bytes.
inline std::uint64_t ThreeQuartersOfMemory()
{
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) / 4 * 3 *
    static_cast<std::uint64_t>(sysconf(_SC_PAGE_SIZE));
}

}

#endif
