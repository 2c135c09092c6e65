/**
 * @file CartesianMeasures.h
 * @brief Area and volume of the region described by a volume, without a mesh.
 *
 *     area           = sum over crossings with grid lines along axis a of |n_a| h_b h_c     (sharp)
 *     volume         = number of nodes inside x h_a h_b h_c                                 (sharp)
 *     smeared area   = sum over nodes of |grad u| h_a h_b h_c
 *     smeared volume = sum over nodes of u h_a h_b h_c
 *
 * with b and c the axes that a is not, n the normals of LevelCrossings.h and
 * u = (S - outside value) / (inside value - outside value). Source: X. Feng's thesis, 5.26 to 5.29;
 * each crossing contributes only the component of n along its line (all three components together,
 * as 5.26 can be read, do not give the area). The sharp area is second order in h, the sharp volume
 * first. The smeared area is the mean of the areas of all levels between the two values, so it is
 * close to the area of one level only where S changes within a thin layer.
 *
 * Errors of the sharp measures are estimated from the same sums on the up to eight grids of every
 * second node, with mean M and standard deviation D, from the lengths of the grid lines inside, and
 * from the part P of the area across which S jumps within one spacing, as in masks, whose area by
 * central differences is 7 to 12 % too large:
 *
 *     area error   = 5/4 |M - area| + D/2 + 12/100 P
 *     volume error = max(3/5 D, |sum over axes (length of lines inside x h_b h_c - volume)|,
 *                        h^2 sqrt(area) / 2, h P / 8)
 *
 * h^2 sqrt(area) / 2 is about twice the standard deviation of the number of nodes in a sphere at a
 * random place, in case all of these grids are alike.
 */
#ifndef isthmus_CartesianMeasures_h
#define isthmus_CartesianMeasures_h

#include "Core/Progress.h"
#include "Surfaces/LevelCrossings.h"

namespace isthmus
{

struct CartesianMeasures
{
  double Area = 0.0;          ///< length^2
  double Volume = 0.0;        ///< length^3
  double SmearedArea = 0.0;   ///< length^2
  double SmearedVolume = 0.0; ///< length^3
  double LineExcess = 0.0; ///< length^3: by how much lines inside exceed Volume, summed over axes
  double StepArea = 0.0;   ///< length^2: the area across which S jumps within one spacing

  CartesianMeasures& operator+=(const CartesianMeasures& other);
};

/// Measures at `level`, in parallel; T is float or double, and all values must be finite. O(nodes),
/// no additional memory.
/// @throws std::invalid_argument if the two values are equal, and Cancelled.
template <typename T>
CartesianMeasures MeasureOnGrid(const LevelView<T>& level, double insideValue, double outsideValue,
  const ProgressCallback& progress = {});

/// Estimated errors of the sharp measures, both positive.
struct CartesianErrors
{
  double Area = 0.0;   ///< length^2
  double Volume = 0.0; ///< length^3
};

/// Of `measures` at the same `level`. Covers smooth surfaces of three nodes or more for each radius
/// of curvature. Time as MeasureOnGrid, memory for an eighth of the values.
template <typename T>
CartesianErrors EstimateErrors(const LevelView<T>& level, const CartesianMeasures& measures,
  const ProgressCallback& progress = {});

}

#endif
