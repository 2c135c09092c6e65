/**
 * @file HalfMapAgreement.h
 * @brief Whether two half maps belong together: their correlation, and a factor, an offset or a
 * shift between them; their mean and their noise.
 */
#ifndef isthmus_HalfMapAgreement_h
#define isthmus_HalfMapAgreement_h

#include "vtkIsthmusFiltersImagingModule.h" // for the export macro

#include <vtkSmartPointer.h>

#include <array>
#include <limits>
#include <string>

class vtkDataArray;

namespace isthmus
{

/// How the second of two half maps differs from the first, apart from noise.
struct HalfMapAgreement
{
  /// Pearson's correlation of means over blocks of 4^3 nodes; NaN: not known.
  double Correlation = std::numeric_limits<double>::quiet_NaN();
  double Factor = 1.0; ///< of the second half's values, negative: the contrast is inverted
  double Offset = 0.0; ///< added to the second half's values, in the unit of the data
  std::array<int, 3> Shift{ 0, 0, 0 }; ///< nodes by which the second half is displaced
  double ShiftedCorrelation = 0.0;     ///< of single nodes, once the shift is undone
  double NodeCorrelation = 0.0;        ///< of single nodes without undoing the shift

  bool IsLinear() const { return this->Factor != 1.0 || this->Offset != 0.0; }
  bool IsShifted() const { return this->Shift != std::array<int, 3>{ 0, 0, 0 }; }
  /// A warning that says what was found; empty if the halves belong together.
  std::string Message() const;
};

/**
 * Compares two half maps, arrays of one number at each node of a grid of `dimensions`.
 *
 * Blocks of 4^3 nodes average the noise away, so that halves correlate there even where the noise
 * of single nodes is higher. Nodes where the halves are equal (outside of a mask) or not finite do
 * not count, nor blocks with fewer than half of their nodes. Factor and offset are those of the
 * line through the blocks' values, reported where they differ from 1 and 0 by more than a tenth (of
 * a standard deviation). A shift of up to 16 nodes is found by the correlation, and reported where
 * it is significantly higher there. O(nodes).
 */
VTKISTHMUSFILTERSIMAGING_EXPORT HalfMapAgreement CompareHalfMaps(
  const std::array<int, 3>& dimensions, vtkDataArray* one, vtkDataArray* other);

/// `other` without the linear difference that was found: (value - Offset) / Factor, as double;
/// `other` itself if there is none.
VTKISTHMUSFILTERSIMAGING_EXPORT vtkSmartPointer<vtkDataArray> RemoveLinearDifference(
  const HalfMapAgreement& agreement, vtkDataArray* other);

/// What two half maps have in common, and their noise: float if both fit into it, else double.
struct HalfMapMean
{
  vtkSmartPointer<vtkDataArray> Mean;           ///< with the name of the first half's array
  vtkSmartPointer<vtkDataArray> HalfDifference; ///< noise like that of the mean; 0 where not finite
};

/// @pre both arrays have one number at each of the same nodes.
/// @throws std::invalid_argument if the halves are equal, or one has a single value.
VTKISTHMUSFILTERSIMAGING_EXPORT HalfMapMean AverageHalfMaps(vtkDataArray* one, vtkDataArray* other);

}

#endif
