/**
 * @file Progress.h
 * @brief Progress reports of long computations, and aborting them.
 */
#ifndef isthmus_Progress_h
#define isthmus_Progress_h

#include <functional>
#include <stdexcept>

namespace isthmus
{

/// Called with the fraction done, in [0, 1], on the thread that started the work; returning false
/// aborts it. An empty callback is allowed.
using ProgressCallback = std::function<bool(double fraction)>;

/// Thrown by an algorithm whose ProgressCallback returned false. This is not reported as an error.
class Cancelled : public std::runtime_error
{
public:
  Cancelled()
    : std::runtime_error("The computation was stopped on request.")
  {
  }
};

/// Reports `fraction` to `progress`, if it is not empty.
/// @throws Cancelled if it returns false.
inline void Report(const ProgressCallback& progress, double fraction)
{
  if (progress && !progress(fraction))
  {
    throw Cancelled();
  }
}

/// The range of `progress` between `from` and `to`, for a step that counts its own work from 0 to
/// 1.
inline ProgressCallback Between(const ProgressCallback& progress, double from, double to)
{
  if (!progress)
  {
    return {};
  }
  return [progress, from, to](double fraction) { return progress(from + fraction * (to - from)); };
}

}

#endif
