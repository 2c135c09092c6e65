/**
 * @file InputOverlap.h
 * @brief Whether the inputs of a filter lie in one place and in one unit of length.
 *
 * A surface of another molecule, a map whose origin was lost, or atoms in nanometres give numbers
 * that look like any others. Of each further input with the first one: the share of points of the
 * smaller one (by the diagonals of their boxes) that lie in the box of the larger one, grown by a
 * tenth of its diagonal on all sides. Guarded (AlgorithmGuard.h) checks it for every filter with
 * several inputs; those in which other numbers are right set a rule of their own and state it in
 * their header.
 *
 * Points are those of the polygons where there are any, else all; atoms of a vtkMolecule; 16 nodes
 * along each axis of an image. Positions that are not finite do not count. Tables and empty data
 * have no place.
 */
#ifndef isthmus_InputOverlap_h
#define isthmus_InputOverlap_h

#include "Core/Geometry.h"
#include "vtkIsthmusFiltersCoreModule.h"

#include <optional>

class vtkAlgorithm;
class vtkDataObject;

namespace isthmus
{

/// What is asked of the place of an input, beside the first one.
struct OverlapRule
{
  double Refused = 0.0; ///< a share of this or less is an error; negative: none is
  double Warned = 0.5;  ///< a smaller share is a warning
  bool Units = true; ///< whether a ratio of sizes of 10 (angstrom and nanometre) is a warning, too
};

struct InputOverlap
{
  Bounds3 First, Second; ///< boxes of the two
  double Share = 1.0;    ///< of the smaller one's points
  double Ratio = 1.0;    ///< diagonal of the second over that of the first; 0 where it has no size

  /// The ratio is within 5 % of 10 or 1/10.
  VTKISTHMUSFILTERSCORE_EXPORT bool IsOfOtherUnit() const;
};

/// Nothing where one of the two has no place. O(points).
VTKISTHMUSFILTERSCORE_EXPORT std::optional<InputOverlap> OverlapOf(
  vtkDataObject* first, vtkDataObject* second);

/// Sets the rule for the inputs of `port`, 1 or higher; to be called in a constructor.
VTKISTHMUSFILTERSCORE_EXPORT void SetOverlapRule(
  vtkAlgorithm* self, int port, const OverlapRule& rule);

/**
 * Compares each further input of `self` with the first one by its rule. One warning for each input,
 * once for the same pipeline. It does nothing where pieces are requested, on several ranks or in
 * streaming: each has a part of the inputs only.
 * @throws std::invalid_argument naming the inputs and their boxes where the rule refuses them.
 */
VTKISTHMUSFILTERSCORE_EXPORT void CheckOverlap(vtkAlgorithm* self);

}

#endif
