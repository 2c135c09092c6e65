/**
 * @file HandleTables.h
 * @brief Bridges, windows and stable levels of a map as VTK's points and tables.
 */
#ifndef isthmus_HandleTables_h
#define isthmus_HandleTables_h

#include "ChokingLoops/MapHandles.h"

#include <vector>

class vtkImageData;
class vtkPolyData;
class vtkTable;

namespace isthmus
{

/// The bridges, or the windows, of `handles` as points at the nodes of `image`: the arrays of
/// vtkMapHandles' first two outputs. `level` is the level chosen (for `IsThere`).
void FillHandles(const std::vector<MapHandle>& handles, bool bridges, const FeatureList& features,
  vtkImageData* image, double level, vtkPolyData* output);

/// A row for each level: Betti numbers of what persists, and Beta1 once more in the row nearest to
/// the stable and to the recommended level (NaN: none).
void FillLevels(const BettiCurves& curves, double stable, double recommended, vtkTable* table);

/// A row for each interval, in their order.
void FillIntervals(const std::vector<StableInterval>& intervals, vtkTable* table);

}

#endif
