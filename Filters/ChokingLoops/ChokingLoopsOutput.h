/**
 * @file ChokingLoopsOutput.h
 * @brief Features that share a loop, limits on loops, and the conversion to VTK data, for
 * vtkChokingLoops.
 */
#ifndef isthmus_ChokingLoopsOutput_h
#define isthmus_ChokingLoopsOutput_h

#include "ChokingLoops/LoopDrawing.h"

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Adjacent narrowings that share one loop.

/// A feature and its geometry.
struct ShownFeature
{
  std::size_t Index; ///< in ChokingLoops::Diagram().Features
  const LoopFeature* Geometry;
  std::ptrdiff_t SharedWith = -1; ///< Index of the feature that has the same loops; -1: none
};

/**
 * Sets SharedWith and the shared Geometry of features that have the same loop.
 *
 * Example: if a wall between two chambers has two windows, the membrane of each window includes the
 * other window, and both have the same loop. A feature is linked to the first feature, in the given
 * order, on the same side whose loops coincide with its own: the same number of loops, lengths that
 * differ by less than 2 %, and no point of one farther than a tenth of the smaller radius from the
 * other. A feature without a geodesic loop of its own uses the shortest loop of another feature
 * that also belongs to its choke point (BelongsToChokePoint()) and whose membrane passes within 0.3
 * radii of that point.
 *
 * Cost: pairs of similar loops times their points squared.
 */
void FindShared(const ChokingLoops& loops, std::vector<ShownFeature>& features);

// ------------------------------------------------------------------------------------------
// Drops loops that are too long or too far from the point where the ball gets stuck.
//
// Source: X. Feng, PhD thesis, 6.5: a ball gets stuck in a slot at a smaller radius than in a round
// passage of the same girth. To find the round passages, loops are sorted by length, and those
// around a choke face that do not reach the surface within a given distance are discarded.

/// Distance of the farthest point of a feature's loops from its choke point, in radii: slightly
/// above 1 for a round neck, sqrt(1 + (a/b)^2) for a slot with sides a and b < a.
double ComputeReach(const ChokingLoops& loops, const ShownFeature& feature);

/// Drops the features beyond the limits and sorts the others. If the first of several features that
/// share a loop is dropped, the next one takes its place in SharedWith. O(points of all loops).
void ApplyLimits(
  const ChokingLoops& loops, const LoopLimits& limits, std::vector<ShownFeature>& features);

}

class vtkPolyData;
class vtkTable;

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Choking loops as VTK data, for vtkChokingLoops.

/// The outputs as documented in vtkChokingLoops.h; `method`: how the membranes are computed.
void FillLoops(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output);
void FillMembranes(const ChokingLoops& loops, const std::vector<ShownFeature>& features,
  MembraneMethod method, vtkPolyData* output);
void FillChokePoints(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output);
void FillDiagram(const ChokingLoops& loops, vtkTable* output);

/// Facts about the analysis, as field data of the loops.
void AddAnalysisFieldData(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output);

}

#endif
