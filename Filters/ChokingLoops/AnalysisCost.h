/**
 * @file AnalysisCost.h
 * @brief What an analysis takes: foretold from counts and its first stage, and measured.
 */
#ifndef isthmus_AnalysisCost_h
#define isthmus_AnalysisCost_h

#include "TriangleMesh.h"
#include "vtkIsthmusModule.h" // for the export macro

#include <cstddef>
#include <string>

namespace isthmus
{

/// Times of the stages, in seconds.
struct ChokingLoopTimes
{
  double Check = 0.0;
  double Sampling = 0.0;
  double Filtration = 0.0;
  double Pairing = 0.0;
  double Features = 0.0;
  double LastRound = 0.0; ///< of these, from the last sampling on: what AnalysisCost estimates
};

/**
 * The cost of analysing the samples of a surface: filtration, pairs, features and the loops of
 * handles and tunnels. What is drawn afterwards for a choice of features is not in it.
 *
 * Bytes follow from counts alone. Seconds depend on the machine, on what else runs on it and on the
 * shape, so they are told once the samples are triangulated: that stage, a quarter to a half of the
 * whole, has met all three.
 */
struct AnalysisCost
{
  std::size_t Samples = 0;
  std::size_t Rank = 0;  ///< of H1(M): twice the genus, all components together
  double Bytes = 0.0;    ///< at the peak
  double Seconds = -1.0; ///< of the whole, triangulation included; below 0: not known yet

  /// With the time that the triangulation took.
  VTKISTHMUS_EXPORT AnalysisCost After(double triangulation) const;
};

/// Cost of the samples of a closed surface, without the time. O(n).
VTKISTHMUS_EXPORT AnalysisCost CostOf(const TriangleMesh& samples);

/**
 * Whether that fits into `limit` bytes (0: what is available). If not, `sentence` says what it
 * would take and what to do.
 */
VTKISTHMUS_EXPORT bool FitsMemory(const AnalysisCost& cost, double limit, std::string& sentence);

}

#endif
