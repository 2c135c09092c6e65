/**
 * @file ChokingSamples.h
 * @brief How finely a surface is sampled for its choking loops, and where more finely.
 */
#ifndef isthmus_ChokingSamples_h
#define isthmus_ChokingSamples_h

#include "ChokingLoops/SurfacePreparation.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/// Where the samples should lie closer, and how close.
struct Refinement
{
  Point3 Centre;
  double Radius;
  double EdgeLength;
};

/// More places than this to be refined mean that the sampling is too coarse everywhere.
constexpr std::size_t ManyPlaces = 64;

/**
 * The surface split until no edge is longer than `spacing`; where that is 0, it becomes the spacing
 * of some 20,000 samples spread evenly, longer where needles would take many more.
 *
 * @throws std::invalid_argument for a spacing that is no length, or takes more than 20 million
 * points along the edges alone; std::runtime_error when it takes more; Cancelled.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleMesh FirstSamples(
  const SurfaceView& surface, double& spacing, const ProgressCallback& progress = {});

/// `mesh` split again near the places wanted, or everywhere to 0.6 of `spacing` where these are
/// more than ManyPlaces. An empty mesh when that takes too many points, or when less than half of
/// many places would be settled by `finest`, to which rounds like this one come: a flat surface, a
/// needle.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleMesh Refined(const SurfaceView& mesh,
  const std::vector<Refinement>& wanted, double spacing, double finest,
  const ProgressCallback& progress = {});

}

#endif
