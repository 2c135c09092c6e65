/**
 * @file PeakMemory.h
 * @brief The most memory that the process has held since it was last reset (Linux).
 */
#ifndef isthmus_PeakMemory_h
#define isthmus_PeakMemory_h

#include <fstream>
#include <string>

namespace isthmus::testing
{

/// Resets the kernel's peak of the resident memory: proc(5), clear_refs.
inline void ResetPeakMemory()
{
  std::ofstream("/proc/self/clear_refs") << "5";
}

/// Peak in bytes; 0 where the kernel does not report it.
inline double PeakMemory()
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.rfind("VmHWM:", 0) == 0)
    {
      return 1024.0 * std::stod(line.substr(6));
    }
  }
  return 0.0;
}

}

#endif
