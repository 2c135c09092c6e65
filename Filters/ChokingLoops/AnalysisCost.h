/**
 * @file AnalysisCost.h
 * @brief What an analysis takes, from the number of its samples.
 */
#ifndef isthmus_AnalysisCost_h
#define isthmus_AnalysisCost_h

#include "vtkIsthmusModule.h" // for the export macro

#include <cstddef>
#include <string>

namespace isthmus
{

/// Bytes that the filtration of `samples` points takes at its peak, with pairs and features: 2.0 KB
/// a sample, between 1.8 (split armadillo, 232,000) and 2.0 (the same, 1.01 million).
inline double AnalysisBytes(std::size_t samples)
{
  return 2000.0 * static_cast<double>(samples);
}

/// Seconds on two threads of 2.6 GHz: 23 to 33 us a sample for tori of 17,000 to 999,000.
inline double AnalysisSeconds(std::size_t samples)
{
  return 30e-6 * static_cast<double>(samples);
}

/**
 * Whether `samples` fit into `limit` bytes (0: what is available). If not, `sentence` says what it
 * would take and what to do.
 */
VTKISTHMUS_EXPORT bool FitsMemory(std::size_t samples, double limit, std::string& sentence);

}

#endif
