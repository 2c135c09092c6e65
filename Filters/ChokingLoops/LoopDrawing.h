/**
 * @file LoopDrawing.h
 * @brief From a membrane's loops along edges to tight ones, with the membrane that follows them.
 */
#ifndef isthmus_LoopDrawing_h
#define isthmus_LoopDrawing_h

#include "FeatureMembrane.h"
#include "LoopShortening.h"

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

/// How loops are drawn tight.
struct LoopDrawing
{
  int Rounds = 0;              ///< of shortening; 0: as they come
  std::vector<SimplexId> Pins; ///< points that a loop keeps passing if it passes them
  double Cut = 0.0;            ///< corners at pins above SharpestKept are cut so far off
};

/// The loops of a membrane, drawn tight, and strips between the old and the new ones. Of several,
/// those that can be drawn together on M are filled instead. @throws Cancelled.
VTKISTHMUS_EXPORT LoopFeature Drawn(const SurfaceAdjacency& surface, const Membrane& membrane,
  const LoopDrawing& drawing, const ProgressCallback& progress = {});

}

#endif
