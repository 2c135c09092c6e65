/**
 * @file AtomDistanceGrid.h
 * @brief The distance from the nearest atom, on a grid round the atoms.
 */
#ifndef isthmus_AtomDistanceGrid_h
#define isthmus_AtomDistanceGrid_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

#include <array>

namespace isthmus
{

/// Parameters for sampling the distance from the atoms on a grid. Lengths are in the unit of the
/// points.
struct GridDistanceParameters
{
  double Spacing = 0.2;      ///< of the nodes
  double Theta = 2.0;        ///< distances beyond are not looked at
  bool FastMarching = false; ///< as in the thesis, first order; else the exact distance
};

/// @throws std::invalid_argument with property, value and range; so does the other function of this
/// name.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT void Check(const GridDistanceParameters& parameters);

/// Values at nodes, x fastest, clamped at the greatest distance requested.
struct AtomDistances
{
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  Point3 Origin{};
  double Spacing = 1.0;
  std::vector<float> Values;
};

/// See GridBars (FullereneStability.h). The grid reaches Theta beyond the outermost atom. Cost:
/// about (Theta / Spacing)^3 steps for each atom with exact distances, O(nodes log nodes) for each
/// type with fast marching; 4 to 13 bytes for each node. The result is the same on any number of
/// threads.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT AtomDistances AtomDistance(const std::vector<Point3>& atoms,
  const std::vector<double>& scales, const GridDistanceParameters& parameters,
  const ProgressCallback& progress = {});

}

#endif
