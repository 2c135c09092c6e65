/**
 * @file CompactCombinatorialMap.h
 * @brief All incidence of a volume mesh in constant time and little memory.
 *
 * A dart is a vertex, an edge, a face and a cell that meet: (v, e, f, c). beta_i leads to the dart
 * that differs in the vertex and the i-cell. beta1 and beta2 stay in a cell and follow from its
 * type; beta3 is stored for the first dart of each half face only, since
 * beta3 = beta1 o beta3 o beta1. Source: X. Feng, "Geometric and topological modeling techniques
 * for large and complex shapes", chapter 3, with the corrections named where they apply.
 *
 * Tables (names of the thesis; n0 vertices, n3 cells, n_b boundary faces; one id each):
 * Cv2V the vertices of each cell, H2D beta3 of the first dart of each half face (the number of the
 * boundary face where there is no other cell), V2D a dart of each vertex, on a boundary face where
 * there is one, B2D the dart of each boundary face. For tetrahedra 4 (4 n3 + 4 n3 + n0 + n_b)
 * bytes. Edges() and Faces() add E2D, V2E and F2D, V2F when first asked for; Stars() lists the
 * cells around each vertex for those who sweep over all of them (the thesis walks each star
 * instead).
 */
#ifndef isthmus_CompactCombinatorialMap_h
#define isthmus_CompactCombinatorialMap_h

#include "CellList.h"
#include "CombinatorialHandles.h"
#include "MeshError.h"
#include "Progress.h"

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

/// Bytes of one table of the map.
struct TableMemory
{
  const char* Name;
  std::size_t Bytes;
};

/**
 * The map of one mesh; `Id` is std::uint32_t, or std::uint64_t for meshes that need it
 * (see FitsIn). An id of a dart holds the cell's number and, in the low DartBits() bits, the local
 * dart: 4 bits for tetrahedra, 5 for the other built-in types, so 2^28 tetrahedra fit in 32 bits.
 *
 * Cells and vertices keep the numbers of the input. Cells may come in any order of types; each run
 * of cells of one type costs 72 bytes, and a mesh of more than one run one integer a cell.
 *
 * Two cells may touch in a vertex or an edge alone (a pinched mesh): their stars and fans are then
 * complete, not only one umbrella. What is refused, by MeshError naming the first cells: a vertex
 * number out of range, a vertex twice in a cell, a face with three cells, two cells that see their
 * common face in the same direction, and more cells or vertices than `Id` can number.
 *
 * The constructor works in parallel, in O(n3), with at most 2.5 times the tables' memory; its
 * result does not depend on the number of threads. Queries allocate nothing and may be made from
 * any number of threads. Their cost depends on the valence only, never on the size of the mesh.
 */
template <typename Id = std::uint32_t>
class VTKISTHMUS_EXPORT CompactCombinatorialMap
{
public:
  using IdType = Id;
  using Vertex = VertexHandle<Id>;
  using Edge = EdgeHandle<Id>;
  using Face = FaceHandle<Id>;
  using Cell = CellHandle<Id>;
  using HalfFace = HalfFaceHandle<Id>;
  using BoundaryFace = BoundaryFaceHandle<Id>;
  using Dart = DartHandle<Id>;

  explicit CompactCombinatorialMap(CellList mesh, const ProgressCallback& progress = {});
  ~CompactCombinatorialMap();
  CompactCombinatorialMap(const CompactCombinatorialMap&) = delete;
  CompactCombinatorialMap& operator=(const CompactCombinatorialMap&) = delete;

  /// Whether the darts, half faces and vertices of `mesh` can be numbered by `Id`.
  static bool FitsIn(const CellList& mesh);

  std::size_t NumberOfVertices() const { return this->V2D.size(); }
  std::size_t NumberOfCells() const { return this->CellCount; }
  std::size_t NumberOfHalfFaces() const { return this->H2D.size(); }
  std::size_t NumberOfBoundaryFaces() const { return this->B2D.size(); }
  std::size_t NumberOfFaces() const { return (this->H2D.size() + this->B2D.size()) / 2; }
  std::size_t NumberOfDarts() const { return this->DartCount; }
  unsigned DartBits() const { return this->Bits; }

  /// @name Darts and their maps
  ///@{
  Dart MakeDart(Cell cell, unsigned local) const
  {
    return Dart(static_cast<Id>(cell.Value << this->Bits) | static_cast<Id>(local));
  }
  unsigned LocalDart(Dart dart) const { return static_cast<unsigned>(dart.Value & this->Mask()); }
  /// True for what lies beyond a boundary face (and for the dart of a vertex without cells).
  bool IsOutside(Dart dart) const { return this->LocalDart(dart) == 0; }
  /// The boundary face that an outside dart stands for.
  BoundaryFace BoundaryFaceOf(Dart outside) const
  {
    return BoundaryFace(outside.Value >> this->Bits);
  }

  Dart Beta1(Dart dart) const { return this->Sibling(dart, this->At(dart).Next); }
  /// The inverse of beta1.
  Dart Beta1Inverse(Dart dart) const { return this->Sibling(dart, this->At(dart).Previous); }
  Dart Beta2(Dart dart) const { return Dart(((dart.Value - 1) ^ Id(1)) + 1); }
  /// Outside for a dart of a boundary face.
  Dart Beta3(Dart dart) const
  {
    const Block& block = this->BlockOf(this->CellOf(dart));
    const CellType::Dart& local = block.Darts[this->LocalDart(dart)];
    return this->StepBack(
      this->H2D[block.HalfFaceIndex(dart.Value >> this->Bits, local.Face)], local.Position);
  }

  Cell CellOf(Dart dart) const { return Cell(dart.Value >> this->Bits); }
  Vertex StartVertex(Dart dart) const
  {
    const Block& block = this->BlockOf(this->CellOf(dart));
    return this
      ->Cv2V[block.VertexIndex(dart.Value >> this->Bits, block.Darts[this->LocalDart(dart)].Start)];
  }
  Vertex EndVertex(Dart dart) const { return this->StartVertex(this->Beta2(dart)); }
  /// Both, a little faster.
  std::pair<Vertex, Vertex> EndVertices(Dart dart) const
  {
    const Block& block = this->BlockOf(this->CellOf(dart));
    const Vertex* vertices = this->Cv2V.data() + block.VertexIndex(dart.Value >> this->Bits, 0);
    const unsigned local = this->LocalDart(dart);
    return { vertices[block.Darts[local].Start],
      vertices[block.Darts[CellType::Beta2(local)].Start] };
  }
  HalfFace HalfFaceOf(Dart dart) const
  {
    return this->MakeHalfFace(this->CellOf(dart), this->At(dart).Face);
  }
  ///@}

  /// @name Half faces
  ///@{
  HalfFace MakeHalfFace(Cell cell, unsigned localFace) const
  {
    return HalfFace(static_cast<Id>(cell.Value << this->Bits) | static_cast<Id>(localFace));
  }
  Cell CellOf(HalfFace half) const { return Cell(half.Value >> this->Bits); }
  unsigned LocalFace(HalfFace half) const
  {
    return static_cast<unsigned>(half.Value & this->Mask());
  }
  Dart FirstDart(HalfFace half) const
  {
    return this->MakeDart(
      this->CellOf(half), this->TypeOf(this->CellOf(half)).FaceDart(this->LocalFace(half), 0));
  }
  /// beta3 of the first dart, from the table: a dart of the cell beyond, or outside.
  Dart Across(HalfFace half) const { return this->H2D[this->IndexOf(half)]; }
  bool IsBoundary(HalfFace half) const { return this->IsOutside(this->Across(half)); }
  /// The darts around a half face, counter-clockwise seen from outside its cell.
  auto Darts(HalfFace half) const
  {
    const CellType& type = this->TypeOf(this->CellOf(half));
    const Cell cell = this->CellOf(half);
    const unsigned face = this->LocalFace(half);
    return IndexRange(type.FaceSize(face),
      [this, &type, cell, face](std::size_t i)
      { return this->MakeDart(cell, type.FaceDart(face, static_cast<unsigned>(i))); });
  }
  /// The first dart of a boundary half face.
  Dart DartOf(BoundaryFace face) const { return this->B2D[face.Value]; }
  ///@}

  /// @name Cells
  ///@{
  const CellType& TypeOf(Cell cell) const { return *this->BlockOf(cell).Type; }
  View<Vertex> Vertices(Cell cell) const
  {
    const Block& block = this->BlockOf(cell);
    return { this->Cv2V.data() + block.VertexIndex(cell.Value, 0), block.VertexCount };
  }
  auto HalfFaces(Cell cell) const
  {
    return IndexRange(this->BlockOf(cell).FaceCount,
      [this, cell](std::size_t f) { return this->MakeHalfFace(cell, static_cast<unsigned>(f)); });
  }
  auto Darts(Cell cell) const
  {
    return IndexRange(this->BlockOf(cell).DartCount,
      [this, cell](std::size_t d) { return this->MakeDart(cell, static_cast<unsigned>(d + 1)); });
  }
  /// One dart for each edge of the cell.
  auto EdgeDarts(Cell cell) const
  {
    return IndexRange(this->BlockOf(cell).DartCount / 2,
      [this, cell](std::size_t e)
      { return this->MakeDart(cell, static_cast<unsigned>(2 * e + 1)); });
  }
  /// What lies beyond each face of a cell, in their order: a dart there, or outside.
  View<Dart> Neighbours(Cell cell) const
  {
    const Block& block = this->BlockOf(cell);
    return { this->H2D.data() + block.HalfFaceIndex(cell.Value, 0), block.FaceCount };
  }
  ///@}

  /// @name Vertices; their stars are walked by VertexStar
  ///@{
  /// A dart that starts there, on a boundary face if the vertex has one; outside if it has no cell.
  Dart DartOf(Vertex vertex) const { return this->V2D[vertex.Value]; }
  bool IsBoundary(Vertex vertex) const
  {
    const Dart dart = this->DartOf(vertex);
    return !this->IsOutside(dart) && this->IsOutside(this->Beta3(dart));
  }
  /// A dart for each further umbrella of cells at a vertex where the mesh is pinched.
  View<std::pair<Vertex, Dart>> FurtherUmbrellas(Vertex vertex) const;
  ///@}

  /// @name Optional tables, built at the first call: numbered edges and faces, lists for sweeps
  ///@{
  const EdgeTable<Id>& Edges(const ProgressCallback& progress = {}) const;
  const FaceTable<Id>& Faces(const ProgressCallback& progress = {}) const;
  const StarTable<Id>& Stars() const;
  const CellEdgeTable<Id>& CellEdges() const;
  ///@}

  /// @name Places of cells of each kind in an array of attributes
  ///@{
  std::size_t IndexOf(Vertex vertex) const { return vertex.Value; }
  std::size_t IndexOf(Edge edge) const { return edge.Value; }
  std::size_t IndexOf(Face face) const { return face.Value; }
  std::size_t IndexOf(Cell cell) const { return cell.Value; }
  std::size_t IndexOf(HalfFace half) const
  {
    return this->BlockOf(this->CellOf(half))
      .HalfFaceIndex(half.Value >> this->Bits, this->LocalFace(half));
  }
  std::size_t IndexOf(Dart dart) const
  {
    const Block& block = this->BlockOf(this->CellOf(dart));
    return block.DartBase + (dart.Value >> this->Bits) * block.DartCount + this->LocalDart(dart) -
      1;
  }
  ///@}

  /// Bytes of each table in use: Cv2V, H2D, V2D, B2D, then what runs, types, edges and faces add.
  std::vector<TableMemory> MemoryReport() const;
  /// The thesis' estimate for tetrahedra with coordinates (Table 3.8): 4 (8.7 n3 + n_b) bytes.
  static double EstimatedBytes(double numberOfTetrahedra, double numberOfBoundaryFaces)
  {
    return 4.0 * (8.7 * numberOfTetrahedra + numberOfBoundaryFaces);
  }

private:
  template <typename>
  friend class HalfFaceMatching;

  /// A run of cells of one type; the bases are such that cell numbers need no subtraction.
  struct Block
  {
    const CellType* Type;
    const CellType::Dart* Darts; // of the type
    std::size_t FirstCell, EndCell;
    std::size_t VertexBase, HalfFaceBase, DartBase;
    unsigned VertexCount, FaceCount, DartCount;

    std::size_t VertexIndex(std::size_t cell, std::size_t v) const
    {
      return this->VertexBase + cell * this->VertexCount + v;
    }
    std::size_t HalfFaceIndex(std::size_t cell, std::size_t f) const
    {
      return this->HalfFaceBase + cell * this->FaceCount + f;
    }
  };

  Id Mask() const { return static_cast<Id>((Id(1) << this->Bits) - 1); }
  const Block& BlockOf(Cell cell) const
  {
    return this->Blocks[this->C2B.empty() ? 0 : this->C2B[cell.Value]];
  }
  const CellType::Dart& At(Dart dart) const
  {
    return this->BlockOf(this->CellOf(dart)).Darts[this->LocalDart(dart)];
  }
  Dart Sibling(Dart dart, unsigned local) const
  {
    return Dart(static_cast<Id>(dart.Value & ~this->Mask()) | static_cast<Id>(local));
  }
  Dart StepBack(Dart across, unsigned steps) const
  {
    const unsigned local = this->LocalDart(across);
    return local == 0 || steps == 0
      ? across
      : this->Sibling(across, this->TypeOf(this->CellOf(across)).Back(local, steps));
  }

  void LayOutBlocks(const std::vector<CellRun>& runs);
  void CopyVertices(View<std::int64_t> cellVertices, std::size_t numberOfVertices);
  void NumberBoundaryFaces();
  void ChooseVertexDarts();
  void FindUmbrellas(const ProgressCallback& progress);
  std::vector<std::pair<Vertex, Dart>> CornersOfPinchedVertices() const;

  std::vector<CellType> Types;
  std::vector<Block> Blocks;
  std::vector<std::uint32_t> C2B; // empty for one block
  unsigned Bits = 0;
  std::size_t CellCount = 0, DartCount = 0;
  std::vector<Vertex> Cv2V;
  std::vector<Dart> H2D, V2D, B2D;
  std::vector<std::pair<Vertex, Dart>> Umbrellas; // sorted; empty unless the mesh is pinched

  mutable std::once_flag EdgesOnce, FacesOnce, StarsOnce, CellEdgesOnce;
  mutable std::unique_ptr<EdgeTable<Id>> EdgesBuilt;
  mutable std::unique_ptr<FaceTable<Id>> FacesBuilt;
  mutable std::unique_ptr<StarTable<Id>> StarsBuilt;
  mutable std::unique_ptr<CellEdgeTable<Id>> CellEdgesBuilt;
};

}

#endif
