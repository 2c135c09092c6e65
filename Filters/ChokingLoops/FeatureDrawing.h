/**
 * @file FeatureDrawing.h
 * @brief The loops of many features, and how long drawing them is going to take.
 */
#ifndef isthmus_FeatureDrawing_h
#define isthmus_FeatureDrawing_h

#include "ChokingLoops/LoopFeature.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <functional>
#include <map>

namespace isthmus
{

/// What is left to draw, and how long that is going to take.
struct DrawingCost
{
  std::size_t Loops = 0;
  double Seconds = 0.0;

  /// When `done` of `count` features, SampledFirst() ones, took so long.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT static DrawingCost After(
    std::size_t done, std::size_t count, double seconds);
};

/**
 * Places of `count` features in the order to draw them: at first a sample spread evenly over them,
 * then the others. `sample` becomes its size: a quarter, 24 at least; all, where they are no more.
 *
 * What a loop takes is not to be seen before (a neck that holds it: milliseconds; one that slides
 * off, a thousand times as much), but the mean of a fair sample is. The deviation of the times is
 * 1.4 to 3 times their mean (twelve surfaces and noisy contours), that of the mean of 24 of them so
 * 0.3 to 0.6 of it. A factor of two is not assured: a skew sample tells too little more often than
 * too much, on noisy contours 0.36 to 0.93 of what it took.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<std::size_t> SampledFirst(
  std::size_t count, std::size_t& sample);

/// By feature and rounds of shortening.
using DrawnFeatures = std::map<std::pair<std::size_t, int>, LoopFeature>;

/**
 * Draws the loops of `features` (MakeLoopFeature()) that are not among `drawn` already. Where there
 * are more than 24 of them, `estimated` is told once what is left and how long it is going to take,
 * after a quarter of them or 24. The result does not depend on the order.
 *
 * @throws Cancelled.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void DrawFeatures(ChokingLoops& loops,
  const std::vector<std::size_t>& features, int rounds, DrawnFeatures& drawn,
  const std::function<void(const DrawingCost&)>& estimated = {},
  const ProgressCallback& progress = {});

}

#endif
