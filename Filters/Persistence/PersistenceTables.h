/**
 * @file PersistenceTables.h
 * @brief Converts the features of a volume to VTK tables and points.
 */
#ifndef isthmus_PersistenceTables_h
#define isthmus_PersistenceTables_h

#include "Persistence/CubicalCycles.h"
#include "Persistence/ScalarFeatures.h"

class vtkImageData;
class vtkPolyData;
class vtkTable;

namespace isthmus
{

/// Betti curves: see vtkScalarPersistence.
void FillCurves(
  const BettiCurves& curves, const std::vector<std::int64_t>& eulerNumbers, vtkTable* table);

/// One row for each feature that is kept. `end` is the value at which infinite deaths are drawn.
void FillDiagram(const FeatureList& features, double end, vtkTable* table);

/// The saddle of each feature that is kept, then the other ends, at the nodes of `image`.
void FillSaddles(const FeatureList& features, double end, vtkImageData* image,
  const VolumeView& volume, vtkPolyData* points);

/// A closed polyline for each cycle.
void FillCycles(const FeatureList& features, const std::vector<CubicalCycle>& cycles,
  vtkImageData* image, vtkPolyData* lines);

}

#endif
