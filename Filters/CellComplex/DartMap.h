/**
 * @file DartMap.h
 * @brief The darts of a volume mesh, the maps between them, and the incident cells of each dart.
 *
 * CompactCombinatorialMap builds this map, and all mesh traversals read it; formulas, tables and
 * source are described there.
 */
#ifndef isthmus_DartMap_h
#define isthmus_DartMap_h

#include "CellComplex/CellType.h"
#include "CellComplex/CombinatorialHandles.h"
#include "Core/View.h"

#include "vtkIsthmusFiltersCellComplexModule.h" // for the export macro

#include <cstdint>
#include <utility>
#include <vector>

namespace isthmus
{

/// Bytes of one table of the map.
struct TableMemory
{
  const char* Name;
  std::size_t Bytes;
};

/**
 * The tables Cv2V, H2D, V2D and B2D, and all queries that need no other tables. `Id` is
 * std::uint32_t or std::uint64_t. Queries allocate no memory and may be made from any number of
 * threads; their cost does not depend on the size of the mesh.
 */
template <typename Id = std::uint32_t>
class VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT DartMap
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

  DartMap(const DartMap&) = delete;
  DartMap& operator=(const DartMap&) = delete;

  std::size_t NumberOfVertices() const { return this->V2D.size(); }
  std::size_t NumberOfCells() const { return this->CellCount; }
  std::size_t NumberOfHalfFaces() const { return this->H2D.size(); }
  std::size_t NumberOfBoundaryFaces() const { return this->B2D.size(); }
  std::size_t NumberOfFaces() const { return (this->H2D.size() + this->B2D.size()) / 2; }
  std::size_t NumberOfDarts() const { return this->DartCount; }
  unsigned DartBits() const { return this->Bits; }
  /// True if the mesh is a single run of built-in tetrahedra, with four integers per cell in Cv2V
  /// and H2D.
  bool HasOnlyTetrahedra() const
  {
    return this->Blocks.size() == 1 && *this->Blocks[0].Type == CellType::Tetrahedron();
  }

  /// @name Darts and their maps
  ///@{
  Dart MakeDart(Cell cell, unsigned local) const
  {
    return Dart(static_cast<Id>(cell.Value << this->Bits) | static_cast<Id>(local));
  }
  unsigned LocalDart(Dart dart) const { return static_cast<unsigned>(dart.Value & this->Mask()); }
  /// True for the outside of a boundary face (and for the dart of a vertex without cells).
  bool IsOutside(Dart dart) const { return this->LocalDart(dart) == 0; }
  /// The boundary face that an outside dart represents.
  BoundaryFace GetBoundaryFace(Dart outside) const
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
    const Block& block = this->GetBlock(this->GetCell(dart));
    const CellType::Dart& local = block.Darts[this->LocalDart(dart)];
    return this->StepBack(
      this->H2D[block.HalfFaceIndex(this->GetCell(dart), local.Face)], local.Position);
  }

  Cell GetCell(Dart dart) const { return Cell(dart.Value >> this->Bits); }
  Vertex StartVertex(Dart dart) const
  {
    const Block& block = this->GetBlock(this->GetCell(dart));
    return this
      ->Cv2V[block.VertexIndex(this->GetCell(dart), block.Darts[this->LocalDart(dart)].Start)];
  }
  Vertex EndVertex(Dart dart) const { return this->StartVertex(this->Beta2(dart)); }
  /// Both at once, slightly faster.
  std::pair<Vertex, Vertex> EndVertices(Dart dart) const
  {
    const Block& block = this->GetBlock(this->GetCell(dart));
    const Vertex* vertices = this->Cv2V.data() + block.VertexIndex(this->GetCell(dart), 0);
    const unsigned local = this->LocalDart(dart);
    return { vertices[block.Darts[local].Start],
      vertices[block.Darts[CellType::Beta2(local)].Start] };
  }
  HalfFace GetHalfFace(Dart dart) const
  {
    return this->MakeHalfFace(this->GetCell(dart), this->At(dart).Face);
  }
  ///@}

  /// @name Half faces
  ///@{
  HalfFace MakeHalfFace(Cell cell, unsigned localFace) const
  {
    return HalfFace(static_cast<Id>(cell.Value << this->Bits) | static_cast<Id>(localFace));
  }
  Cell GetCell(HalfFace half) const { return Cell(half.Value >> this->Bits); }
  unsigned LocalFace(HalfFace half) const
  {
    return static_cast<unsigned>(half.Value & this->Mask());
  }
  Dart FirstDart(HalfFace half) const
  {
    return this->MakeDart(
      this->GetCell(half), this->GetType(this->GetCell(half)).FaceDart(this->LocalFace(half), 0));
  }
  /// beta3 of the first dart, from the table: a dart of the cell beyond, or outside.
  Dart Across(HalfFace half) const { return this->H2D[this->GetIndex(half)]; }
  bool IsBoundary(HalfFace half) const { return this->IsOutside(this->Across(half)); }
  /// The darts around a half face, counter-clockwise seen from outside its cell.
  auto Darts(HalfFace half) const
  {
    const CellType& type = this->GetType(this->GetCell(half));
    const Cell cell = this->GetCell(half);
    const unsigned face = this->LocalFace(half);
    return IndexRange(type.FaceSize(face),
      [this, &type, cell, face](std::size_t i)
      { return this->MakeDart(cell, type.FaceDart(face, static_cast<unsigned>(i))); });
  }
  /// The first dart of a boundary half face.
  Dart GetDart(BoundaryFace face) const { return this->B2D[face.Value]; }
  ///@}

  /// @name Cells
  ///@{
  const CellType& GetType(Cell cell) const { return *this->GetBlock(cell).Type; }
  View<Vertex> Vertices(Cell cell) const
  {
    const Block& block = this->GetBlock(cell);
    return { this->Cv2V.data() + block.VertexIndex(cell, 0), block.VertexCount };
  }
  auto HalfFaces(Cell cell) const
  {
    return IndexRange(this->GetBlock(cell).FaceCount,
      [this, cell](std::size_t f) { return this->MakeHalfFace(cell, static_cast<unsigned>(f)); });
  }
  auto Darts(Cell cell) const
  {
    return IndexRange(this->GetBlock(cell).DartCount,
      [this, cell](std::size_t d) { return this->MakeDart(cell, static_cast<unsigned>(d + 1)); });
  }
  /// One dart for each edge of the cell.
  auto EdgeDarts(Cell cell) const
  {
    return IndexRange(this->GetBlock(cell).DartCount / 2,
      [this, cell](std::size_t e)
      { return this->MakeDart(cell, static_cast<unsigned>(2 * e + 1)); });
  }
  /// For each face of a cell, in their order, a dart in the cell beyond it, or outside.
  View<Dart> Neighbours(Cell cell) const
  {
    const Block& block = this->GetBlock(cell);
    return { this->H2D.data() + block.HalfFaceIndex(cell, 0), block.FaceCount };
  }
  ///@}

  /// @name Vertices; their stars are traversed by StarWalk
  ///@{
  /// A dart that starts there, on a boundary face if the vertex has one; outside if it has no cell.
  Dart GetDart(Vertex vertex) const { return this->V2D[vertex.Value]; }
  bool IsBoundary(Vertex vertex) const
  {
    const Dart dart = this->GetDart(vertex);
    return !this->IsOutside(dart) && this->IsOutside(this->Beta3(dart));
  }
  /// A dart for each further umbrella of cells at a vertex where the mesh is pinched.
  View<std::pair<Vertex, Dart>> FurtherUmbrellas(Vertex vertex) const;
  ///@}

  /// @name Indices of cells of each kind in an array of attributes
  ///@{
  std::size_t GetIndex(Vertex vertex) const { return vertex.Value; }
  std::size_t GetIndex(Edge edge) const { return edge.Value; }
  std::size_t GetIndex(Face face) const { return face.Value; }
  std::size_t GetIndex(Cell cell) const { return cell.Value; }
  std::size_t GetIndex(HalfFace half) const
  {
    return this->GetBlock(this->GetCell(half))
      .HalfFaceIndex(this->GetCell(half), this->LocalFace(half));
  }
  std::size_t GetIndex(Dart dart) const
  {
    const Block& block = this->GetBlock(this->GetCell(dart));
    return block.DartBase + (dart.Value >> this->Bits) * block.DartCount + this->LocalDart(dart) -
      1;
  }
  ///@}

protected:
  DartMap() = default;
  ~DartMap() = default;

  template <typename>
  friend class HalfFaceMatching;

  /// A run of cells of one type; the base offsets are chosen so that cell numbers need no
  /// subtraction.
  struct Block
  {
    const CellType* Type;
    const CellType::Dart* Darts; // of the type
    std::size_t FirstCell, EndCell;
    std::size_t VertexBase, HalfFaceBase, DartBase;
    unsigned VertexCount, FaceCount, DartCount;

    std::size_t VertexIndex(Cell cell, std::size_t v) const
    {
      return this->VertexBase + cell.Index() * this->VertexCount + v;
    }
    std::size_t HalfFaceIndex(Cell cell, std::size_t f) const
    {
      return this->HalfFaceBase + cell.Index() * this->FaceCount + f;
    }
  };

  Id Mask() const { return static_cast<Id>((Id(1) << this->Bits) - 1); }
  const Block& GetBlock(Cell cell) const
  {
    return this->Blocks[this->C2B.empty() ? 0 : this->C2B[cell.Value]];
  }
  const CellType::Dart& At(Dart dart) const
  {
    return this->GetBlock(this->GetCell(dart)).Darts[this->LocalDart(dart)];
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
      : this->Sibling(across, this->GetType(this->GetCell(across)).Back(local, steps));
  }

  std::vector<CellType> Types;
  std::vector<Block> Blocks;
  std::vector<std::uint32_t> C2B; // empty for one block
  unsigned Bits = 0;
  std::size_t CellCount = 0, DartCount = 0;
  std::vector<Vertex> Cv2V;
  std::vector<Dart> H2D, V2D, B2D;
  std::vector<std::pair<Vertex, Dart>> Umbrellas; // sorted; empty unless the mesh is pinched
};

}

#endif
