/**
 * @file LoopFeature.h
 * @brief A choking loop as it is shown: curves on the surface and a membrane that they bound.
 */
#ifndef isthmus_LoopFeature_h
#define isthmus_LoopFeature_h

#include "ChokingLoops.h"
#include "LoopShortening.h"

namespace isthmus
{

/// Geometry of one feature. Membrane corners are ids: those below the number of samples are points
/// of the sampled surface, the others Extra points.
struct LoopFeature
{
  std::vector<std::vector<SimplexId>> Loops;
  std::vector<double> Lengths;
  std::vector<std::array<SimplexId, 3>> Membrane;
  std::vector<Point3> Extra;
  double Area = 0.0;

  const Point3& Point(SimplexId id, const TriangleMesh& samples) const
  {
    const auto i = static_cast<std::size_t>(id);
    return i < samples.Points.size() ? samples.Points[i] : this->Extra[i - samples.Points.size()];
  }
};

/**
 * Loops and membrane of a feature; with `rounds` above 0 the loops are shortened that often, and a
 * strip of triangles between the old and the new loop keeps the membrane's boundary theirs.
 * Throws Cancelled.
 */
VTKISTHMUS_EXPORT LoopFeature MakeLoopFeature(
  ChokingLoops& loops, std::size_t feature, int rounds, const ProgressCallback& progress = {});

}

#endif
