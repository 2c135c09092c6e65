/**
 * @file LoopDrawing.h
 * @brief From a membrane's loops along edges to tight ones, with the membrane that follows them.
 */
#ifndef isthmus_LoopDrawing_h
#define isthmus_LoopDrawing_h

#include "ChokingLoops/FeatureMembrane.h"
#include "ChokingLoops/LoopShortening.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

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
  bool Encircling = false;   ///< not of the class that the choke closed (EncirclingLoops.h)

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
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<SurfaceCurve> TightLoops(
  const SurfaceAdjacency& surface, const Membrane& membrane, int rounds,
  const std::vector<SimplexId>& pins = {}, const ProgressCallback& progress = {});

/// The feature with the tight loops of its membrane, if there are any, and strips between the old
/// and the new ones. Corners at pins above SharpestKept are cut `cut` off. Of several loops those
/// that can be drawn together on M are filled instead.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT LoopFeature Drawn(const SurfaceAdjacency& surface,
  const Membrane& membrane, const std::vector<SurfaceCurve>& tight, double cut = 0.0);

}

#endif
