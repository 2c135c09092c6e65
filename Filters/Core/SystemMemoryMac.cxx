#include "Core/SystemMemory.h"

#include <cstdint>
#include <limits>

#include <mach/mach.h>
#include <sys/sysctl.h>

namespace isthmus
{

double TotalMemory()
{
  std::uint64_t bytes = 0;
  std::size_t size = sizeof(bytes);
  return sysctlbyname("hw.memsize", &bytes, &size, nullptr, 0) == 0
    ? static_cast<double>(bytes)
    : std::numeric_limits<double>::infinity();
}

double FreeMemory()
{
  vm_statistics64_data_t pages{};
  mach_msg_type_number_t count = HOST_VM_INFO64_COUNT;
  vm_size_t pageSize = 0;
  const host_t host = mach_host_self();
  if (host_page_size(host, &pageSize) != KERN_SUCCESS ||
    host_statistics64(host, HOST_VM_INFO64, reinterpret_cast<host_info64_t>(&pages), &count) !=
      KERN_SUCCESS)
  {
    return std::numeric_limits<double>::infinity();
  }
  // Inactive pages and those of files are reused before anything is swapped.
  const double number = static_cast<double>(pages.free_count) +
    static_cast<double>(pages.inactive_count) + static_cast<double>(pages.purgeable_count);
  return number * static_cast<double>(pageSize);
}

// The system accepts a limit of the address space, but does not enforce it.
double AddressSpaceLeft()
{
  return std::numeric_limits<double>::infinity();
}

}
