/**
 * @file Stopwatch.h
 * @brief Measures the time that a stage of a computation takes.
 */
#ifndef isthmus_Stopwatch_h
#define isthmus_Stopwatch_h

#include <chrono>

namespace isthmus
{

/// Wall-clock time in seconds since the construction or the last call of Lap().
class Stopwatch
{
public:
  double Lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - this->Last;
    this->Last = now;
    return passed.count();
  }

private:
  std::chrono::steady_clock::time_point Last = std::chrono::steady_clock::now();
};

}

#endif
