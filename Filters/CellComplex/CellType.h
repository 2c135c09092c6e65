/**
 * @file CellType.h
 * @brief A kind of volume cell, defined by its oriented faces alone, from which darts and their
 * maps are derived.
 *
 * Source: X. Feng, "Geometric and topological modeling techniques for large and complex shapes",
 * 3.3.2.1 and Tables 3.1, 3.2, 3.4.
 */
#ifndef isthmus_CellType_h
#define isthmus_CellType_h

#include "Core/View.h"
#include "vtkIsthmusFiltersCellComplexModule.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace isthmus
{

/// Faces of a cell as cycles of local vertices (from 0), counter-clockwise seen from outside.
using FaceList = std::vector<std::vector<int>>;

/**
 * The same faces, reversed where needed so that any two that share an edge run along it in opposite
 * directions; the first face keeps its direction. If this is not possible, the faces are returned
 * unchanged, and CellType will reject them.
 */
VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT FaceList OrientFaces(FaceList faces);

/**
 * Local combinatorial map of one kind of cell.
 *
 * Local darts are numbered from 1: the e-th edge (a, b), a < b, in lexicographic order has the
 * darts 2e+1 = (a, b) and 2e+2 = (b, a). beta1 leads to the next dart of a face, beta2 to the other
 * dart of the edge. The first dart of a face is the edge with which its vertex list begins.
 *
 * Memory: about 20 bytes per dart and 300 per type. A mesh has few types, except that a mesh of
 * general polyhedra has up to one per cell.
 */
class VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT CellType
{
public:
  /// The number of a local vertex, face or dart.
  using Local = std::uint16_t;

  /// The data of one dart.
  struct Dart
  {
    Local Next = 0;     ///< beta1
    Local Previous = 0; ///< inverse of beta1
    Local Start = 0;    ///< vertex at which it starts
    Local Face = 0;     ///< face around which it runs
    Local Position = 0; ///< its position in that face, 0 for the first dart
  };

  /// @throws std::invalid_argument with a message unless the faces form a sphere (each edge in two
  /// faces that run along it in opposite directions, one fan of faces at each vertex, a single
  /// piece, and V - E + F = 2), and for more than 65,534 darts.
  CellType(std::string name, int numberOfVertices, FaceList faces);

  /// @name The built-in types, with VTK's vertex numbering except for Prism. Prism is defined as in
  /// the thesis, with triangle (0, 1, 2) facing (3, 4, 5), so a VTK_WEDGE, as documented by VTK,
  /// has its vertices in the order (0, 2, 1, 3, 5, 4).
  ///@{
  static const CellType& Tetrahedron();
  static const CellType& Pyramid();
  static const CellType& Prism();
  static const CellType& Hexahedron();
  ///@}

  const std::string& Name() const { return this->TypeName; }
  const FaceList& Faces() const { return this->FaceVertices; }
  int NumberOfVertices() const { return this->VertexCount; }
  int NumberOfEdges() const { return this->NumberOfDarts() / 2; }
  int NumberOfFaces() const { return static_cast<int>(this->FaceVertices.size()); }
  int NumberOfDarts() const { return static_cast<int>(this->Darts.size()) - 1; }

  const Dart& At(unsigned dart) const { return this->Darts[dart]; }
  static constexpr unsigned Beta2(unsigned dart) { return ((dart - 1) ^ 1u) + 1; }
  unsigned FaceSize(unsigned face) const
  {
    return static_cast<unsigned>(this->FaceOffsets[face + 1] - this->FaceOffsets[face]);
  }
  /// The `i`-th dart of a face, 0 <= i < FaceSize(face).
  Local FaceDart(unsigned face, unsigned i) const
  {
    return this->FaceDarts[this->FaceOffsets[face] + i];
  }
  /// The dart `steps` before `dart` in its face; 0 <= steps < the size of that face.
  unsigned Back(unsigned dart, unsigned steps) const
  {
    const Dart& known = this->Darts[dart];
    const unsigned first = this->FaceOffsets[known.Face];
    const unsigned size = this->FaceOffsets[known.Face + 1] - first;
    const unsigned position = known.Position + size - steps;
    return this->FaceDarts[first + (position >= size ? position - size : position)];
  }
  unsigned VertexDegree(unsigned vertex) const
  {
    return static_cast<unsigned>(this->VertexOffsets[vertex + 1] - this->VertexOffsets[vertex]);
  }
  /// The `i`-th dart that starts at a vertex, 0 <= i < VertexDegree(vertex).
  Local VertexDart(unsigned vertex, unsigned i) const
  {
    return this->VertexDarts[this->VertexOffsets[vertex] + i];
  }

  /// Bytes of this type's tables.
  std::size_t MemoryBytes() const;

  /// The mirror image of the type: the direction of every face is reversed.
  CellType MakeMirrorImage() const;

  friend bool operator==(const CellType& a, const CellType& b)
  {
    return a.VertexCount == b.VertexCount && a.FaceVertices == b.FaceVertices;
  }

private:
  using LocalDarts = std::map<std::pair<int, int>, unsigned>; // edge a < b: dart from a to b
  LocalDarts NumberEdges() const;
  void NumberDarts();
  void LinkFace(std::size_t first);
  void GatherVertexDarts();
  void CheckSphere() const;
  int DartsReachedFromFirst() const;
  [[noreturn]] void Reject(const std::string& reason) const;

  std::string TypeName;
  int VertexCount;
  FaceList FaceVertices;
  std::vector<Dart> Darts; // [0] is unused
  std::vector<Local> FaceOffsets, FaceDarts;
  std::vector<Local> VertexOffsets, VertexDarts;
};

//--------------------------------------------------------------------------------------------------
// A volume mesh as a list of cells of a few types.

/// `NumberOfCells` consecutive cells of one type.
struct CellRun
{
  std::size_t Type = 0; ///< index in the list of types
  std::int64_t NumberOfCells = 0;
};

/// Runs of cells, numbered in this order, and the vertices of all cells one after the other.
struct CellList
{
  std::int64_t NumberOfVertices = 0;
  std::vector<CellType> Types;
  std::vector<CellRun> Runs;
  View<std::int64_t> CellVertices; ///< not owned
};

}

#endif
