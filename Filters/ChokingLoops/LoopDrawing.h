/**
 * @file LoopDrawing.h
 * @brief From a feature to the displayed loops and membrane: shortened, and kept at the choke
 * point.
 */
#ifndef isthmus_LoopDrawing_h
#define isthmus_LoopDrawing_h

#include "ChokingLoops/ChokingLoops.h"
#include "ChokingLoops/FeatureDiagram.h"
#include "ChokingLoops/FeatureMembrane.h"
#include "ChokingLoops/LoopShortening.h"
#include "Core/Geometry.h"

#include <functional>
#include <map>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Does a loop belong to its choke point?

/**
 * Lower bound for the length of a loop that surrounds a choke point: 2 pi (Radius() -
 * ComputeUncertainty()).
 *
 * M is at least r = Radius() - ComputeUncertainty() away from the choke point c. Projected from c
 * onto the sphere of radius r, a loop on M does not get longer. If c lies in the convex hull of the
 * loop, the projection lies in no open hemisphere, and a closed curve on a unit sphere that lies in
 * no open hemisphere is at least 2 pi long (W. Fenchel, Math. Ann. 101 (1929) 238).
 */
double ShortestGirth(const ShapeFeature& feature);

/// True when `center` is within `reach` of the convex hull of `points`. By Gilbert's algorithm (E.
/// G. Gilbert, SIAM J. Control 4 (1966) 61); O(points) per iteration.
bool IsSurrounded(const Point3& center, double reach, const std::vector<Point3>& points);

/// Largest angle, in radians, by which a closed polygon turns at a point; points closer together
/// than `least` count as one.
double SharpestTurn(const std::vector<Point3>& polygon, double least);

// ------------------------------------------------------------------------------------------
// From the loops of a membrane along edges to geodesic loops, with an adapted membrane.

/// Geometry of one feature. Membrane corners are ids: those below the number of samples are points
/// of the sampled surface, the others Extra points.
struct LoopFeature
{
  std::vector<std::vector<SimplexId>> Loops;
  std::vector<double> Lengths;
  std::vector<SimplexId> Anchors; ///< per loop: a point of the samples on the same component
  /// Per loop: the samples that it passes, the nearer end of each edge crossed.
  std::vector<std::vector<SimplexId>> Walks;
  std::vector<std::array<SimplexId, 3>> Membrane;
  std::vector<Point3> Extra;
  double Area = 0.0;
  bool Collapsed = false;    ///< a loop is contractible on M: it is returned unchanged
  bool Held = false;         ///< no geodesic loop there: fixed where the ball touches M
  bool Converged = true;     ///< the loops are geodesic, except where they are fixed
  double SharpestBend = 0.0; ///< largest turning angle at fixed points, in radians
  bool Encircling = false;   ///< belongs to another class than the choke closed (FeatureMembrane.h)
  MembraneMethod Method = MembraneMethod::Automatic; ///< how the membrane was computed
  double GrowthCost = 0.0;                           ///< Membrane::GrowthCost

  /// Length of its longest loop; 0 without loops.
  double LongestLength() const;

  const Point3& Point(SimplexId id, const SurfaceView& samples) const
  {
    const auto i = static_cast<std::size_t>(id);
    return i < samples.Points.size() ? samples.Points[i] : this->Extra[i - samples.Points.size()];
  }
};

/// Largest turning angle, in radians, of a loop at a fixed point; sharper corners are cut.
constexpr double SharpestUncut = 0.7853981633974483;

/// The loops of a membrane, shortened on M; loops through some of the `pins` stay fixed there.
/// Empty with 0 `rounds`: the loops are not changed. @throws Cancelled.
std::vector<SurfaceCurve> ShortenedLoops(const SurfaceAdjacency& surface, const Membrane& membrane,
  int rounds, const std::vector<SimplexId>& pins = {}, const ProgressCallback& progress = {});

/// The feature with the shortened loops of its membrane, if there are any, and strips of triangles
/// between the old and the new loops. Corners at pins that turn by more than SharpestUncut are cut
/// at a distance of `cut`. If there are several loops, those that are contractible on M are filled
/// instead.
LoopFeature Drawn(const SurfaceAdjacency& surface, const Membrane& membrane,
  const std::vector<SurfaceCurve>& tight, double cut = 0.0);

// ------------------------------------------------------------------------------------------
// A choking loop as displayed: curves on the surface and a membrane that they bound.

/// Tolerances that decide whether a loop belongs to its choke. TestLoopTolerances checks that
/// lengths change by at most 3 % when the parameters, in the order below, are moved to either end
/// of the ranges 0.25 to 0.32, 47 to 60 degrees, 80 to 100 degrees, and { 0.25, 0.4 } to { 0.35,
/// 0.52 }; most loops do not change.
struct LoopTolerances
{
  /// Largest distance of the choke point from the convex hull of its loops, in radii. A round loop
  /// that touches the ball is as long as 0.98 of its girth only within sqrt(1 - 0.98^2) = 0.2 of
  /// it; a wider one, around a neck that is not round, should still be within 0.35 of its position
  /// (with 0.35, one loop of skull_low_resolution.obj is replaced by another that is 6 % shorter).
  double Nearness = 0.3;
  /// Largest turning angle of a loop where it is fixed, in radians: 54 degrees. It must be above
  /// SharpestUncut (45 degrees), below which corners are not cut, and at most the 60 degrees that
  /// are allowed anywhere on a loop.
  double SharpestHeld = 0.3 * Pi;
  /// Above this turning angle, in radians, a loop reverses its direction instead of surrounding the
  /// choke (a hairpin): its two branches at the point form an angle below 90 degrees.
  double SharpestLoop = 0.5 * Pi;
  /// Distances at which corners are cut, in radii, tried one after the other; loops that become
  /// shorter than the lower bound are rejected. With repeated cuts at half the distance, a cut
  /// reaches up to twice as far. Contacts spread evenly around the ball are 2 pi / 3 apart, so cuts
  /// of up to pi / 6 = 0.52 from both ends leave part of the loop between them.
  std::array<double, 2> CornerCuts{ 0.3, 0.5 };
};

/// True when loops belong to the choke point of a feature, see MakeLoopFeature().
bool BelongsToChokePoint(const ChokingLoops& loops, std::size_t feature,
  const LoopFeature& geometry, const LoopTolerances& tolerances = {});

/**
 * Loops and membrane of a feature; with `rounds` above 0 the loops are shortened by that many
 * rounds, and a strip of triangles between the old and the new loop extends the membrane to them.
 *
 * A trusted feature's loops belong to its choke point: the longest is at least 0.98 ShortestGirth()
 * long, and the point lies within 0.3 of its radius of their convex hull. Of the loops of
 * GetMembrane() and, where those do not belong or are long, of GetMinimumCutMembrane(), the shorter
 * ones that belong are used. If neither loops belong, because there is no geodesic loop there, the
 * loops are fixed where the choking ball touches M, are geodesic between these points, and have
 * their corners cut. If they still turn sharply (by more than 54 degrees), or if a loop of another
 * class that bounds there (ComputeEncirclingMembranes()) is not longer, that loop is used. If all
 * of these are hairpins, a geodesic loop of the class elsewhere is used, which does not surround
 * the choke point.
 *
 * Loops are found on the samples. If these are coarser than the surface (ChokingLoops::Fine()),
 * they are moved to the surface and shortened there, and the membrane is extended to them; all
 * points of the loops are then Extra points.
 *
 * With a `method` other than Automatic, its membrane is used and the loops are shortened, without
 * any of these choices. If the method finds no membrane, the automatic one is used and Method is
 * set to Automatic.
 *
 * @throws Cancelled.
 */
LoopFeature MakeLoopFeature(ChokingLoops& loops, std::size_t feature, int rounds,
  const ProgressCallback& progress = {}, const LoopTolerances& tolerances = {},
  MembraneMethod method = MembraneMethod::Automatic);

// ------------------------------------------------------------------------------------------
// Loops of many features.

/// Key: feature and rounds of shortening.
using DrawnFeatures = std::map<std::pair<std::size_t, int>, LoopFeature>;

/**
 * Draws the loops of those `features` (MakeLoopFeature()) that are not in `drawn` yet, on as many
 * threads as ParallelFor() uses, each by the first one that is free; the result is bitwise the same
 * on any number. `progress` is called on the calling thread.
 *
 * @throws Cancelled. What is drawn by then is kept in `drawn`.
 */
void DrawFeatures(ChokingLoops& loops, const std::vector<std::size_t>& features, int rounds,
  DrawnFeatures& drawn, const ProgressCallback& progress = {},
  MembraneMethod method = MembraneMethod::Automatic);

}

#endif
