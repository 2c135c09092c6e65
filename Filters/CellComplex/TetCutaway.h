/**
 * @file TetCutaway.h
 * @brief Removes a connected piece of a volume mesh, to show what is inside.
 *
 * Source: X. Feng, "Geometric and topological modeling techniques for large and complex shapes",
 * 4.3.2 and Figure 4.14: breadth-first search from a seed face.
 */
#ifndef isthmus_TetCutaway_h
#define isthmus_TetCutaway_h

#include "CellComplex/CompactCombinatorialMap.h"
#include "vtkIsthmusFiltersCellComplexModule.h"

#include <array>
#include <functional>
#include <vector>

namespace isthmus
{

using Position = std::array<double, 3>;

/// Which cells may be removed, among those reached from the seed through faces of removed cells.
struct CutawayRule
{
  enum class StopRules
  {
    ByNumber,   ///< the first NumberOfCells in breadth-first order
    ByDistance, ///< those whose centers are at most Distance from the seed cell's center
    ByPlane     ///< those whose centers lie on the side of the plane to which PlaneNormal points
  };
  StopRules StopRule = StopRules::ByNumber;
  std::int64_t NumberOfCells = 1000;
  double Distance = 1.0; ///< in the units of the mesh
  Position PlaneOrigin{ 0, 0, 0 };
  Position PlaneNormal{ 0, 0, 1 };
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT void Check(const CutawayRule& rule);

/**
 * Returns 1 for each removed cell and 0 for the others. `centerOf(cell)` returns the center of a
 * cell by its number. Time: proportional to the removed cells and their neighbours; memory: one
 * byte per cell.
 */
template <typename Id>
VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT std::vector<unsigned char> CutAway(
  const CompactCombinatorialMap<Id>& map, typename CompactCombinatorialMap<Id>::Cell seed,
  const CutawayRule& rule, const std::function<Position(std::size_t)>& centerOf,
  const ProgressCallback& progress = {});

}

#endif
