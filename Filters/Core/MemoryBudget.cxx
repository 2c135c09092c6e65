#include "Core/MemoryBudget.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

namespace isthmus
{
namespace
{

constexpr double Unknown = std::numeric_limits<double>::infinity();

/// The number after `key` in a file of lines "key number", or of a file that is one number.
double NumberIn(const char* file, const std::string& key)
{
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line))
  {
    std::istringstream words(line);
    std::string word;
    double number = 0.0;
    if ((key.empty() || (words >> word && word == key)) && words >> number)
    {
      return number;
    }
  }
  return Unknown;
}

double LeftByGroup()
{
  const double most = NumberIn("/sys/fs/cgroup/memory.max", "");
  const double used = NumberIn("/sys/fs/cgroup/memory.current", "");
  const double cached = NumberIn("/sys/fs/cgroup/memory.stat", "inactive_file");
  const double known = most - used; // infinite or not a number where one is missing
  return known < Unknown ? known + (cached < Unknown ? cached : 0.0) : Unknown;
}

double LeftByLimit()
{
#if defined(__unix__) || defined(__APPLE__)
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
  {
    const double used = NumberIn("/proc/self/status", "VmSize:") * 1024.0;
    return static_cast<double>(limit.rlim_cur) - (used < Unknown ? used : 0.0);
  }
#endif
  return Unknown;
}

}

double AvailableMemory()
{
  const double machine = NumberIn("/proc/meminfo", "MemAvailable:") * 1024.0;
  return std::max(0.0, std::min({ machine, LeftByGroup(), LeftByLimit() }));
}

std::string MemoryText(double bytes)
{
  const char* units[] = { "KB", "MB", "GB", "TB", "PB", "EB" };
  std::size_t unit = 0;
  double amount = bytes / 1e3;
  while (amount >= 999.5 && unit + 1 < std::size(units))
  {
    amount /= 1e3;
    ++unit;
  }
  char text[40];
  std::snprintf(text, sizeof(text), "%.3g %s", amount, units[unit]);
  return text;
}

}
