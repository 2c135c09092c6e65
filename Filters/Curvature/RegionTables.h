/**
 * @file RegionTables.h
 * @brief The tables of vtkScalarRegions: regions, threshold sweep, histogram.
 */
#ifndef isthmus_RegionTables_h
#define isthmus_RegionTables_h

#include "Curvature/ScalarRegions.h"

#include <string>

class vtkTable;

namespace isthmus
{

/// Rows for the regions of `first`; columns for those of `second`, called `secondName`, if it has
/// more than one. `areas` as RegionAreas gives them.
void FillRegionTable(vtkTable* table, const ThresholdedScalar& first,
  const ThresholdedScalar& second, const std::string& secondName, const std::vector<double>& areas);

/// The lowest threshold moves to `target` in `steps` steps, then the highest does.
/// @throws std::invalid_argument unless `target` is between them.
void FillSweepTable(vtkTable* table, const SurfaceView& mesh, const ThresholdedScalar& scalar,
  double target, int steps, AreaRule rule);

/// Areas between `bins` + 1 values, equally spaced from the lowest to the highest on the surface.
void FillHistogram(vtkTable* table, const SurfaceView& mesh, const ThresholdedScalar& scalar,
  int bins, AreaRule rule);

}

#endif
