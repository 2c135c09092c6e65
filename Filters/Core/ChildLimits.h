/**
 * @file ChildLimits.h
 * @brief Limits of a program that is run, and how it ended.
 */
#ifndef isthmus_ChildLimits_h
#define isthmus_ChildLimits_h

#include <cstdint>

namespace isthmus
{

struct ChildLimits
{
  double TimeLimit = 600.0; ///< of wall time, seconds
  std::uint64_t Bytes = 0;  ///< of address space; 0: no limit
};

enum class ChildEnd
{
  Exited,   ///< by itself; Code is its exit status
  Crashed,  ///< by a signal; Code is its number
  TimedOut, ///< killed after ChildLimits::TimeLimit
  NotFound, ///< there is no such program
  NotRun    ///< it exists, but is a folder or not executable
};

}

#endif
