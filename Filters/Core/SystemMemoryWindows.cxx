#include "Core/SystemMemory.h"

#include <limits>

#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

namespace isthmus
{
namespace
{

MEMORYSTATUSEX MemoryStatus()
{
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof(status);
  if (!GlobalMemoryStatusEx(&status))
  {
    status.ullTotalPhys = 0;
  }
  return status;
}

}

double TotalMemory()
{
  const MEMORYSTATUSEX status = MemoryStatus();
  return status.ullTotalPhys > 0 ? static_cast<double>(status.ullTotalPhys)
                                 : std::numeric_limits<double>::infinity();
}

double FreeMemory()
{
  const MEMORYSTATUSEX status = MemoryStatus();
  return status.ullTotalPhys > 0 ? static_cast<double>(status.ullAvailPhys)
                                 : std::numeric_limits<double>::infinity();
}

// What a process commits is limited by the machine and its page file.
double AddressSpaceLeft()
{
  const MEMORYSTATUSEX status = MemoryStatus();
  return status.ullTotalPhys > 0 ? static_cast<double>(status.ullAvailPageFile)
                                 : std::numeric_limits<double>::infinity();
}

}
