/**
 * @file CpuEstimate.h
 * @brief The predicted cost of an analysis of choking loops, measured in CPU time, which other load
 * does not affect.
 */
#ifndef isthmus_CpuEstimate_h
#define isthmus_CpuEstimate_h

#include "ChokingLoops/ChokingLoops.h"

#include <sys/resource.h>

namespace isthmus::testing
{

/// CPU time of this process, all its threads and its children (TetGen); other processes do not
/// count.
inline double CpuSeconds()
{
  double seconds = 0.0;
  for (const auto who : { RUSAGE_SELF, RUSAGE_CHILDREN })
  {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& t : { usage.ru_utime, usage.ru_stime })
    {
      seconds += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    }
  }
  return seconds;
}

/// The estimates of an analysis, converted from wall time to CPU time.
class CpuEstimate
{
public:
  void operator()(const AnalysisCost& cost)
  {
    const double now = CpuSeconds();
    if (cost.Seconds < 0.0) // a round begins
    {
      AnalysisCost next = cost;
      next.LearnFrom(this->Last, now - this->Began);
      this->Last = next;
      this->Began = now;
      this->Corrected = 0.0;
    }
    else if (this->Last.Seconds < 0.0) // its samples are triangulated
    {
      this->Last = this->Last.After(now - this->Began);
    }
    else // handles or tunnels are to be found on the surface itself
    {
      this->Last.ExpectCompletion(cost.Own);
      this->Corrected = now - this->Began + this->Last.Completion();
    }
  }

  AnalysisCost Last;
  double Began = 0.0;     ///< the last round
  double Corrected = 0.0; ///< the last estimate, instead of Last.Seconds; 0: none
};

}

#endif
