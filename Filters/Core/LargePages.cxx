#include "Core/LargePages.h"

#ifdef __linux__
#include <sys/mman.h>

#include <cstdint>
#endif

namespace isthmus
{

// The first access to a page is a fault; with pages of 4 KiB, faults take up to a third of the time
// of a computation that memory bandwidth limits (curvature at nodes).
void AdviseLargePages(void* data, std::size_t bytes)
{
#ifdef __linux__
  constexpr std::uintptr_t page = std::uintptr_t{ 2 } << 20;
  if (bytes < 4 * page)
  {
    return;
  }
  const auto begin = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t first = (begin + page - 1) / page * page;
  const std::uintptr_t end = (begin + bytes) / page * page;
  madvise(static_cast<char*>(data) + (first - begin), end - first, MADV_HUGEPAGE);
#else
  (void)data;
  (void)bytes;
#endif
}

}
