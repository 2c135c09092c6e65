/**
 * @file CompactCombinatorialMap.h
 * @brief All incidence relations of a volume mesh in constant time and little memory.
 *
 * A dart is a tuple (v, e, f, c) of an incident vertex, edge, face and cell. beta_i leads to the
 * dart that differs in the vertex and the i-cell. beta1 and beta2 stay within a cell and follow
 * from its type; beta3 is stored for the first dart of each half face only, since beta3 = beta1 o
 * beta3 o beta1. Source: X. Feng, "Geometric and topological modeling techniques for large and
 * complex shapes", chapter 3; corrections are noted where they apply.
 *
 * Tables (names of the thesis; n0 vertices, n3 cells, n_b boundary faces; one id each): Cv2V the
 * vertices of each cell, H2D beta3 of the first dart of each half face (the number of the boundary
 * face if there is no other cell), V2D a dart of each vertex, on a boundary face if there is one,
 * B2D the dart of each boundary face. For tetrahedra this takes 4 (4 n3 + 4 n3 + n0 + n_b) bytes.
 * Edges() and Faces() add E2D, V2E and F2D, V2F on first use; Stars() lists the cells around each
 * vertex, for algorithms that visit all stars (the thesis walks each star instead).
 */
#ifndef isthmus_CompactCombinatorialMap_h
#define isthmus_CompactCombinatorialMap_h

#include "CellComplex/CellType.h"
#include "CellComplex/DartMap.h"
#include "CellComplex/MeshError.h"
#include "Core/Progress.h"
#include "vtkIsthmusFiltersCellComplexModule.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace isthmus
{

template <typename Id>
class CellEdgeTable;
template <typename Id>
class EdgeTable;
template <typename Id>
class FaceTable;
template <typename Id>
class StarTable;

/**
 * The map of one mesh; `Id` is std::uint32_t, or std::uint64_t for meshes that need it
 * (see FitsIn). An id of a dart holds the cell's number and, in the low DartBits() bits, the local
 * dart: 4 bits for tetrahedra, 5 for the other built-in types, so 2^28 tetrahedra fit in 32 bits.
 *
 * Cells and vertices keep the numbers of the input. Cells may be in any order of types; each run of
 * cells of one type costs 72 bytes, and a mesh with more than one run needs one more integer per
 * cell.
 *
 * Two cells may touch only in a vertex or an edge (a pinched mesh). Stars and fans are complete in
 * this case and not limited to one umbrella.
 *
 * The constructor works in parallel, in O(n3), with at most 2.5 times the tables' memory; its
 * result does not depend on the number of threads. Queries allocate no memory and may be made from
 * any number of threads. Their cost depends only on the valence, not on the size of the mesh.
 */
template <typename Id = std::uint32_t>
class VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT CompactCombinatorialMap : public DartMap<Id>
{
public:
  using typename DartMap<Id>::Vertex;
  using typename DartMap<Id>::Cell;
  using typename DartMap<Id>::Dart;

  /// @throws MeshError, naming the first cells, for a vertex number out of range, a repeated vertex
  /// in a cell, a face with three cells, two cells that see their common face in the same
  /// direction, and more cells or vertices than `Id` can number; Cancelled.
  explicit CompactCombinatorialMap(CellList mesh, const ProgressCallback& progress = {});
  ~CompactCombinatorialMap();

  /// Whether the darts, half faces and vertices of `mesh` can be numbered by `Id`.
  static bool FitsIn(const CellList& mesh);

  /// @name Optional tables, built at the first call: numbered edges and faces, lists for sweeps
  ///@{
  const EdgeTable<Id>& Edges(const ProgressCallback& progress = {}) const;
  const FaceTable<Id>& Faces(const ProgressCallback& progress = {}) const;
  const StarTable<Id>& Stars() const;
  const CellEdgeTable<Id>& CellEdges() const;
  ///@}

  /// Bytes of each table in use: Cv2V, H2D, V2D, B2D, then those of runs, types, edges and faces.
  std::vector<TableMemory> MemoryReport() const;
  /// The thesis' estimate for tetrahedra with coordinates (Table 3.8): 4 (8.7 n3 + n_b) bytes.
  static double EstimatedBytes(double numberOfTetrahedra, double numberOfBoundaryFaces)
  {
    return 4.0 * (8.7 * numberOfTetrahedra + numberOfBoundaryFaces);
  }

private:
  using typename DartMap<Id>::Block;

  void LayOutBlocks(const std::vector<CellRun>& runs);
  void CopyVertices(View<std::int64_t> cellVertices, std::size_t numberOfVertices);
  void NumberBoundaryFaces();
  void ChooseVertexDarts();
  void FindUmbrellas(const ProgressCallback& progress);
  std::vector<std::pair<Vertex, Dart>> CornersOfPinchedVertices() const;

  mutable std::once_flag EdgesOnce, FacesOnce, StarsOnce, CellEdgesOnce;
  mutable std::unique_ptr<EdgeTable<Id>> EdgesBuilt;
  mutable std::unique_ptr<FaceTable<Id>> FacesBuilt;
  mutable std::unique_ptr<StarTable<Id>> StarsBuilt;
  mutable std::unique_ptr<CellEdgeTable<Id>> CellEdgesBuilt;
};

}

#endif
