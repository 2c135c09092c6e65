#include "Core/NumberText.h"
#include "Core/SystemMemory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

#include <sys/resource.h>
#include <unistd.h>

namespace isthmus
{
namespace
{

constexpr double UnknownMemory = std::numeric_limits<double>::infinity();

/// The number after `key` in a file of lines "key number", or of a file that is one number.
double NumberIn(const char* file, const std::string& key)
{
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line))
  {
    std::string_view words = line;
    double number = 0.0;
    if ((key.empty() || ExtractWord(words) == key) && ExtractNumber(words, number))
    {
      return number;
    }
  }
  return UnknownMemory;
}

double ControlGroupMemory()
{
  const double most = NumberIn("/sys/fs/cgroup/memory.max", "");
  const double used = NumberIn("/sys/fs/cgroup/memory.current", "");
  const double cached = NumberIn("/sys/fs/cgroup/memory.stat", "inactive_file");
  const double known = most - used; // infinite or NaN if one is missing
  return known < UnknownMemory ? known + (cached < UnknownMemory ? cached : 0.0) : UnknownMemory;
}

}

double TotalMemory()
{
  return NumberIn("/proc/meminfo", "MemTotal:") * 1024.0;
}

double FreeMemory()
{
  return std::min(NumberIn("/proc/meminfo", "MemAvailable:") * 1024.0, ControlGroupMemory());
}

double AddressSpaceLeft()
{
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
  {
    return UnknownMemory;
  }
  double pages = 0.0;
  std::ifstream("/proc/self/statm") >> pages;
  return static_cast<double>(limit.rlim_cur) - pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}
