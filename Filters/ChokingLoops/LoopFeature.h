/**
 * @file LoopFeature.h
 * @brief A choking loop as it is shown: curves on the surface and a membrane that they bound.
 */
#ifndef isthmus_LoopFeature_h
#define isthmus_LoopFeature_h

#include "ChokingLoops/ChokingLoops.h"
#include "ChokingLoops/LoopDrawing.h"
#include "Core/Pi.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/// What tells a loop that belongs to its choke from one that does not, and within what bounds each
/// may be chosen: TestLoopTolerances holds lengths to 3 % at the ends of 0.25 to 0.32, 47 to 60
/// degrees, 80 to 100 degrees, { 0.25, 0.4 } to { 0.35, 0.52 }; most loops stay as they are.
struct LoopTolerances
{
  /// In radii: how far the choke point may lie outside of the hull of its loops. A round loop that
  /// touches the ball is as long as 0.98 of its girth only within sqrt(1 - 0.98^2) = 0.2 of it; a
  /// wider one, of a neck that is not round, is still to be within 0.35 of its place (there one
  /// loop of skull_low_resolution.obj is another, 6 % shorter).
  double Nearness = 0.3;
  /// Radians that a loop may turn where it is held: above SharpestKept (45 degrees), at which
  /// corners are cut no more, and no more than the 60 degrees that loops may turn by at all: 54.
  double SharpestHeld = 0.3 * Pi;
  /// From this turn on a loop goes back rather than round: its ways in and out have an angle below
  /// 90 degrees.
  double SharpestLoop = 0.5 * Pi;
  /// In radii: how far off corners are cut, one try after the other; loops that get shorter than
  /// their girth so are not taken. Cut again by halves, a cut reaches up to twice as far; contacts
  /// spread evenly round the ball are 2 pi / 3 apart, so that cuts of up to pi / 6 = 0.52 from both
  /// ends leave some of the loop between them.
  std::array<double, 2> CornerCuts{ 0.3, 0.5 };
};

/// True when loops belong to the choke point of a feature, see MakeLoopFeature().
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT bool Belongs(const ChokingLoops& loops, std::size_t feature,
  const LoopFeature& geometry, const LoopTolerances& tolerances = {});

/**
 * Loops and membrane of a feature; with `rounds` above 0 the loops are shortened that often, and a
 * strip of triangles between the old and the new loop keeps the membrane's boundary theirs.
 *
 * A trusted feature's loops belong to its choke point: the longest is at least 0.98 ShortestGirth()
 * long, and the point lies within 0.3 of its radius of their convex hull. Of MembraneOf() and,
 * where those loops do not belong or are long, TightMembraneOf() the shorter ones that belong are
 * taken. Where neither does, since nothing on M holds them there, the loops are held where the
 * choking ball touches M, geodesic between these points, corners cut off. Where they turn sharply
 * even so (above 54 degrees), or a loop of another class that bounds there is no longer
 * (EncirclingMembranesOf()), that one is taken; where all are hairpins, a tight loop of the class
 * elsewhere, which then does not surround the choke point.
 *
 * @throws Cancelled.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT LoopFeature MakeLoopFeature(ChokingLoops& loops,
  std::size_t feature, int rounds, const ProgressCallback& progress = {},
  const LoopTolerances& tolerances = {});

}

#endif
