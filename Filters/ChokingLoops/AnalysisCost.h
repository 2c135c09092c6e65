/**
 * @file AnalysisCost.h
 * @brief What an analysis takes: foretold from counts and its first stage, and measured.
 */
#ifndef isthmus_AnalysisCost_h
#define isthmus_AnalysisCost_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h" // for the export macro

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
 * handles and tunnels. What is drawn afterwards for a choice of features: LoopDrawing.h.
 *
 * Bytes follow from counts alone. Seconds depend on the machine, on what else runs on it and on the
 * shape, so they are told once the samples are triangulated, in units of that stage, which has met
 * all three:
 * - all stages but the next take 3.2 and 0.006 for each class of loops. Those are medians of 25
 *   surfaces and contours; how hard the classes are to reduce (0 to 2.5 units, most on noisy
 *   contours) and whether radii need exact arithmetic (3 units more on flat pieces) is the shape's,
 *   and hardly changes as it is sampled more finely: from the second round on, the units that the
 *   round before took are taken instead;
 * - where the samples do not settle all handles and tunnels, the surface's own points are
 *   tetrahedralized and analysed as well (GeneratorCompletion.h): 11.4 times as long a point. That
 *   is expected in the last round, and where more than 64 were not settled by the round before;
 * else it is told once the features are known.
 *
 * Each of the 25 told by constants from the other 24: 0.53 to 1.28 of what it took (CPU seconds).
 */
struct AnalysisCost
{
  std::size_t Samples = 0;
  std::size_t Rank = 0;       ///< of H1(M): twice the genus, all components together
  std::size_t Own = 0;        ///< the surface's own points, where handles are to be found on them
  double Bytes = 0.0;         ///< at the peak
  double Triangulation = 0.0; ///< seconds that it took
  double Units = 0.0;         ///< all stages but GeneratorCompletion.h, in triangulations
  double Seconds = -1.0;      ///< of the whole, triangulation included; below 0: not known yet

  /// With the time that the triangulation took.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT AnalysisCost After(double triangulation) const;

  /// Takes over Units from the same surface on fewer samples, which took so long without
  /// GeneratorCompletion.h.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void LearnFrom(const AnalysisCost& before, double seconds);

  /// Handles or tunnels are to be found on the surface's own points.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void ExpectCompletion(std::size_t points);

  /// Seconds that this takes.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double Completion() const;
};

/// Cost of the samples of a closed surface, without the time. O(n).
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT AnalysisCost CostOf(const SurfaceView& samples);

/**
 * Whether that fits into `limit` bytes (0: what is available). If not, `sentence` says what it
 * would take and what to do.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT bool FitsMemory(
  const AnalysisCost& cost, double limit, std::string& sentence);

}

#endif
