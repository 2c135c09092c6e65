/**
 * @file CutAndMerge.h
 * @brief Extracts parts of a combinatorial map and merges two maps; cells are not changed.
 *
 * To cut a mesh along faces, cut out the cells on each side; to glue two meshes along faces, merge
 * them with the vertices of those faces paired. The result is a list of cells from which a new map
 * is built. Building checks it, and costs as much as for a mesh that was just read.
 */
#ifndef isthmus_CutAndMerge_h
#define isthmus_CutAndMerge_h

#include "CellComplex/CompactCombinatorialMap.h"
#include "vtkIsthmusFiltersCellComplexModule.h"

#include <utility>
#include <vector>

namespace isthmus
{

/// Renumbered cells with their original numbers.
struct EditedCells
{
  std::int64_t NumberOfVertices = 0;
  std::vector<CellType> Types;
  std::vector<CellRun> Runs;
  std::vector<std::int64_t> CellVertices;
  std::vector<std::int64_t> OldCells; ///< numbers in the first map, then in the second
  std::vector<std::int64_t>
    OldVertices; ///< likewise; for a merged vertex, its number in the first map

  /// A view of this object's lists; the object must outlive everything that uses the view.
  CellList List() const;
};

/// The cells for which `keep` is not 0, and the vertices that they use, both in their original
/// order. O(n3 + n0).
/// @throws std::invalid_argument unless `keep` has one entry per cell.
template <typename Id>
VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT EditedCells CutOut(
  const CompactCombinatorialMap<Id>& map, const std::vector<unsigned char>& keep);

/// All cells of `first`, then those of `second`. The vertices of `second` follow those of `first`,
/// except for those paired as (vertex of first, vertex of second). O(n3 + n0).
/// @throws std::invalid_argument for a vertex that does not exist or is paired twice.
template <typename Id>
VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT EditedCells Merge(const CompactCombinatorialMap<Id>& first,
  const CompactCombinatorialMap<Id>& second,
  const std::vector<std::pair<std::int64_t, std::int64_t>>& sameVertices);

}

#endif
