/**
 * @file CutAndMerge.h
 * @brief Parts of a combinatorial map, and two maps made one, with every cell left intact.
 *
 * To cut a mesh along faces, cut out the cells on each side; to glue two meshes along faces, merge
 * them with the vertices of those faces paired. The result is a list of cells, of which a new map
 * is made: that checks it, and costs what reading the mesh again would.
 */
#ifndef isthmus_CutAndMerge_h
#define isthmus_CutAndMerge_h

#include "CellComplex/CompactCombinatorialMap.h"
#include "vtkIsthmusFiltersCellComplexModule.h"

#include <utility>
#include <vector>

namespace isthmus
{

/// Cells with new numbers, and where they come from.
struct EditedCells
{
  std::int64_t NumberOfVertices = 0;
  std::vector<CellType> Types;
  std::vector<CellRun> Runs;
  std::vector<std::int64_t> CellVertices;
  std::vector<std::int64_t> OldCells;    ///< of the first map, then of the second
  std::vector<std::int64_t> OldVertices; ///< likewise; a merged vertex has its number in the first

  /// Views this object's lists, which must outlive what is made of it.
  CellList List() const;
};

/// The cells for which `keep` is not 0, in their order, and the vertices they use, in theirs.
/// O(n3 + n0).
/// @throws std::invalid_argument unless `keep` has one entry a cell.
template <typename Id>
VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT EditedCells CutOut(
  const CompactCombinatorialMap<Id>& map, const std::vector<unsigned char>& keep);

/// All cells of `first`, then those of `second`, whose vertices follow but for those paired as
/// (vertex of first, vertex of second). O(n3 + n0).
/// @throws std::invalid_argument for a vertex that does not exist or is paired twice.
template <typename Id>
VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT EditedCells Merge(const CompactCombinatorialMap<Id>& first,
  const CompactCombinatorialMap<Id>& second,
  const std::vector<std::pair<std::int64_t, std::int64_t>>& sameVertices);

}

#endif
