/**
 * @file ChokingLoopsOutput.h
 * @brief Features that share a loop, limits on loops, and both as VTK data, for vtkChokingLoops.
 */
#ifndef isthmus_ChokingLoopsOutput_h
#define isthmus_ChokingLoopsOutput_h

#include "ChokingLoops/LoopDrawing.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Narrowings beside each other that have one loop between them.

/// A feature and its geometry.
struct ShownFeature
{
  std::size_t Index; ///< in ChokingLoops::Diagram().Features
  const LoopFeature* Geometry;
  std::ptrdiff_t SharedWith = -1; ///< Index of the feature that has the same loops; -1: none
};

/**
 * Sets SharedWith, and Geometry to that of the feature named.
 *
 * As where a wall between two chambers has two windows, the membrane of either takes in the other,
 * and both have one loop. To the first feature, in the order given, of the same side whose loops
 * coincide: as many of them, of lengths that differ by less than 2 %, and no point of either
 * farther than a tenth of the smaller radius from the other. And a feature that nothing on M holds
 * a loop of takes the shortest one of another feature that belongs to its choke point, too
 * (BelongsToChokePoint()), with a membrane within 0.3 of its radius of that.
 *
 * Cost: pairs of similar loops times their points squared.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void FindShared(
  const ChokingLoops& loops, std::vector<ShownFeature>& features);

// ------------------------------------------------------------------------------------------
// Loops that are too long, or too far from where the ball gets stuck, left out.
//
// Source: X. Feng, PhD thesis, 6.5: a ball is stuck in a slot long before it is in a round passage
// of the same girth. Where round ones are sought, loops are sorted by length, and those round a
// choke face that do not reach the surface within a given distance are discarded.

struct LoopLimits
{
  double MaximumLength = 0.0; ///< of a feature's longest loop, in the unit of the points; 0: any
  double MaximumReach = 0.0;  ///< ReachOf() a feature; 0: any
  bool ByLength = false;      ///< ascending by the longest loop instead of by radius
};

/// Distance of the farthest point of a feature's loops from its choke point, in radii: 1 and little
/// more for a round neck, sqrt(1 + (a/b)^2) for a slot with sides a and b < a.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double ReachOf(
  const ChokingLoops& loops, const ShownFeature& feature);

/// Leaves out what is beyond the limits, and sorts. Where the first of several features that share
/// a loop goes, the next takes its place in SharedWith. O(points of all loops).
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void ApplyLimits(
  const ChokingLoops& loops, const LoopLimits& limits, std::vector<ShownFeature>& features);

}

class vtkPolyData;
class vtkTable;

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Choking loops as VTK data, for vtkChokingLoops.

/// The outputs as documented in vtkChokingLoops.h; `method`: that of the membranes.
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
