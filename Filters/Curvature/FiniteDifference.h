/**
 * @file FiniteDifference.h
 * @brief First and second derivatives of grid data by central differences, at its nodes.
 *
 * Central differences of second order (radius R = 1; thesis F5.36, mixed derivatives by the
 * four-point cross) or fourth order (R = 2, mixed ones by the product of two first differences).
 * They are the derivatives at the node of the polynomial of degree 2R through the 2R + 1 nodes
 * around it. Derivatives between the nodes are in PointDerivative.h.
 *
 * Derivatives are along the grid's axes, in units of the data per length of the spacing.
 */
#ifndef isthmus_FiniteDifference_h
#define isthmus_FiniteDifference_h

#include "Core/GridView.h"
#include "vtkIsthmusFiltersCurvatureModule.h" // for the export macro

#include <array>
#include <cstdint>
#include <type_traits>

/// Expands `instantiate(type)` for each type.
#define ISTHMUS_FOR_EACH_SCALAR_TYPE(instantiate)                                                  \
  instantiate(char);                                                                               \
  instantiate(signed char);                                                                        \
  instantiate(unsigned char);                                                                      \
  instantiate(short);                                                                              \
  instantiate(unsigned short);                                                                     \
  instantiate(int);                                                                                \
  instantiate(unsigned int);                                                                       \
  instantiate(long);                                                                               \
  instantiate(unsigned long);                                                                      \
  instantiate(long long);                                                                          \
  instantiate(unsigned long long);                                                                 \
  instantiate(float);                                                                              \
  instantiate(double)

namespace isthmus
{

/// Type in which results on a grid of `T` are stored: double for double, float for all others.
template <typename T>
using ResultType = std::conditional_t<std::is_same_v<T, double>, double, float>;

/// Value, first and second derivatives at up to Capacity places; one array for each, so that loops
/// over places vectorise. At 10 KB it fits on the stack and into the first-level cache.
struct DerivativeRows
{
  static constexpr std::int64_t Capacity = 128;
  using Row = std::array<double, Capacity>;

  alignas(64) Row Value;
  alignas(64) Row X, Y, Z;
  alignas(64) Row XX, YY, ZZ, XY, XZ, YZ;
};

/// Number of nodes that a difference needs on each side: 1 for accuracy 2, 2 for accuracy 4.
/// @throws std::invalid_argument for any other accuracy.
VTKISTHMUSFILTERSCURVATURE_EXPORT int StencilRadius(int accuracy);

/**
 * Derivatives at the `count` nodes (first[0] ... first[0] + count - 1, first[1], first[2]), into
 * places 0 ... count - 1 of `rows`.
 *
 * @pre 0 < count <= Capacity, and all nodes lie at least StencilRadius(accuracy) nodes inside
 * `grid`. O(count): reads 19 values per node with accuracy 2, and 61 with accuracy 4.
 */
template <typename T>
VTKISTHMUSFILTERSCURVATURE_EXPORT void DifferentiateAtNodes(const GridView<const T>& grid,
  const std::array<std::int64_t, 3>& first, std::int64_t count, int accuracy, DerivativeRows& rows);

}

#endif
