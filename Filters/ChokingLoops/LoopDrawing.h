/**
 * @file LoopDrawing.h
 * @brief From a membrane's loops along edges to tight ones, with the membrane that follows them.
 */
#ifndef isthmus_LoopDrawing_h
#define isthmus_LoopDrawing_h

#include "LoopFeature.h"

namespace isthmus
{

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
