/**
 * @file AreaQuantiles.h
 * @brief Quantiles of values that are each weighted by a part of a surface.
 */
#ifndef isthmus_AreaQuantiles_h
#define isthmus_AreaQuantiles_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

#include <utility>
#include <vector>

namespace isthmus
{

/// A value and its weight.
using WeightedValue = std::pair<double, double>;

/// Of one triangle.
double TriangleArea(const SurfaceView& surface, vtkIdType triangle);

/// The area assigned to each point of `surface`: a third of that of its triangles.
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<double> PointAreas(const SurfaceView& surface);

/// The smallest value such that at least `fraction` of the weight lies at or below it; sorts by
/// value.
/// @throws std::invalid_argument if there is no weight or the fraction is not from 0 to 1.
double WeightedQuantile(const std::vector<WeightedValue>& sorted, double fraction);

}

#endif
