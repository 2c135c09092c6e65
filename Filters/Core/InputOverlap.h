/**
 * @file InputOverlap.h
 * @brief Checks whether the inputs of a filter lie in the same place and have the same unit of
 * length.
 *
 * A surface of another molecule, a map whose origin was lost, or atoms in nanometres would give
 * wrong numbers that look plausible. Each further input is compared with the first one: the overlap
 * is the share of points of the smaller one (by the diagonals of their boxes) that lie in the box
 * of the larger one, enlarged by a tenth of its diagonal on all sides. RunGuarded
 * (AlgorithmGuard.h) checks it for every filter with several inputs. Filters that need other limits
 * set a rule of their own and state it in their header.
 *
 * The points are those of the polygons if there are any, otherwise all points; the atoms of a
 * vtkMolecule; 16 nodes along each axis of an image. Positions that are not finite are not counted.
 * Tables and empty data have no position.
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

/// Requirements on the position of an input relative to the first one.
struct OverlapRule
{
  double Refused = 0.0; ///< a share up to this is an error; negative: never an error
  double Warned = 0.5;  ///< a smaller share is a warning
  bool Units =
    true; ///< whether a ratio of sizes of 10 (angstrom and nanometre) also causes a warning
};

struct InputOverlap
{
  Bounds3 First, Second; ///< boxes of the two
  double Share = 1.0;    ///< of the smaller one's points
  double Ratio = 1.0;    ///< diagonal of the second over that of the first; 0 where it has no size

  /// Whether the ratio is within 5 % of 10 or 1/10.
  bool IsOfOtherUnit() const;
};

/// Empty if one of the two has no position. O(points).
std::optional<InputOverlap> MeasureOverlap(vtkDataObject* first, vtkDataObject* second);

/// Sets the rule for the inputs of `port`, which is 1 or higher. Call it in a constructor.
VTKISTHMUSFILTERSCORE_EXPORT void SetOverlapRule(
  vtkAlgorithm* self, int port, const OverlapRule& rule);

/**
 * Compares each further input of `self` with the first one by its rule. It issues one warning for
 * each input, once for the same pipeline. It does nothing if pieces are requested, on several ranks
 * or in streaming, because each piece has only a part of the inputs.
 * @throws std::invalid_argument naming the inputs and their boxes if the rule refuses them.
 */
void CheckOverlap(vtkAlgorithm* self);

}

#endif
