/**
 * @file LoopDrawing.h
 * @brief From a feature to the loops and the membrane that are shown: shortened, and held at the
 * choke point.
 */
#ifndef isthmus_LoopDrawing_h
#define isthmus_LoopDrawing_h

#include "ChokingLoops/ChokingLoops.h"
#include "ChokingLoops/FeatureDiagram.h"
#include "ChokingLoops/FeatureMembrane.h"
#include "ChokingLoops/LoopShortening.h"
#include "Core/Geometry.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <functional>
#include <map>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Does a loop belong to its choke point?

/**
 * How far the true radius may lie below Radius(): between sqrt(d^2 - e^2) and d, since
 * d_M^2 <= d_S^2 <= d_M^2 + e^2 for a surface M and its samples S.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double UncertaintyOf(const ShapeFeature& feature);

/**
 * No loop that surrounds a choke point is shorter: 2 pi (Radius() - UncertaintyOf()).
 *
 * M keeps that far away from the choke point c. Drawn from c onto the sphere of that radius, a loop
 * on M gets no longer; if c lies in its convex hull, what is drawn lies in no open half of the
 * sphere, and a closed curve on a unit sphere that lies in none is at least 2 pi long (W. Fenchel,
 * Math. Ann. 101 (1929) 238).
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double ShortestGirth(const ShapeFeature& feature);

/// True when `centre` is within `reach` of the convex hull of `points`. By the points that bound
/// it one after another (E. G. Gilbert, SIAM J. Control 4 (1966) 61); O(points) each.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT bool IsSurrounded(
  const Point3& centre, double reach, const std::vector<Point3>& points);

/// Largest angle, in radians, by which a closed polygon turns at a point; points closer together
/// than `least` count as one.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double SharpestTurn(
  const std::vector<Point3>& polygon, double least);

// ------------------------------------------------------------------------------------------
// From a membrane's loops along edges to geodesic ones, with the membrane adapted to them.

/// Geometry of one feature. Membrane corners are ids: those below the number of samples are points
/// of the sampled surface, the others Extra points.
struct LoopFeature
{
  std::vector<std::vector<SimplexId>> Loops;
  std::vector<double> Lengths;
  std::vector<SimplexId> Anchors; ///< per loop: a point of the samples on the same component
  std::vector<std::array<SimplexId, 3>> Membrane;
  std::vector<Point3> Extra;
  double Area = 0.0;
  bool Collapsed = false;    ///< a loop can be drawn together on M: it stands as it came
  bool Held = false;         ///< nothing on M holds a loop, so it is held where the ball touches M
  bool Converged = true;     ///< the loops are as tight as they get, but where they are held
  double SharpestBend = 0.0; ///< largest turn where it is held, in radians
  bool Encircling = false;   ///< not of the class that the choke closed (FeatureMembrane.h)

  const Point3& Point(SimplexId id, const SurfaceView& samples) const
  {
    const auto i = static_cast<std::size_t>(id);
    return i < samples.Points.size() ? samples.Points[i] : this->Extra[i - samples.Points.size()];
  }
};

/// Radians that a loop held at a point may turn there before its corner is cut.
constexpr double SharpestKept = 0.7853981633974483;

/// The loops of a membrane as tight as M holds them; those that pass some of `pins` keep passing
/// these. None with 0 `rounds`: they stay as they come. @throws Cancelled.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<SurfaceCurve> ShortenedLoops(
  const SurfaceAdjacency& surface, const Membrane& membrane, int rounds,
  const std::vector<SimplexId>& pins = {}, const ProgressCallback& progress = {});

/// The feature with the tight loops of its membrane, if there are any, and strips between the old
/// and the new ones. Corners at pins above SharpestKept are cut `cut` off. Of several loops those
/// that can be drawn together on M are filled instead.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT LoopFeature Drawn(const SurfaceAdjacency& surface,
  const Membrane& membrane, const std::vector<SurfaceCurve>& tight, double cut = 0.0);

// ------------------------------------------------------------------------------------------
// A choking loop as it is shown: curves on the surface and a membrane that they bound.

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
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT bool BelongsToChokePoint(const ChokingLoops& loops,
  std::size_t feature, const LoopFeature& geometry, const LoopTolerances& tolerances = {});

/**
 * Loops and membrane of a feature; with `rounds` above 0 the loops are shortened that often, and a
 * strip of triangles between the old and the new loop keeps the membrane's boundary theirs.
 *
 * A trusted feature's loops belong to its choke point: the longest is at least 0.98 ShortestGirth()
 * long, and the point lies within 0.3 of its radius of their convex hull. Of MembraneOf() and,
 * where those loops do not belong or are long, MinimumCutMembraneOf() the shorter ones that belong
 * are taken. Where neither does, since nothing on M holds them there, the loops are held where the
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

// ------------------------------------------------------------------------------------------
// The loops of many features, and the estimated time to draw them.

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
