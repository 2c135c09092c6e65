/**
 * @file CombinatorialHandles.h
 * @brief Typed ids of the cells of a combinatorial map, so that a vertex cannot be used as an edge.
 */
#ifndef isthmus_CombinatorialHandles_h
#define isthmus_CombinatorialHandles_h

#include "Core/Handles.h"

#include <cstddef>

namespace isthmus
{

/// 0-cell; `Id` is unsigned: 0 ... n0 - 1, the numbers of the input.
template <typename Id>
using VertexHandle = Handle<struct VertexKind, Id>;
/// 1-cell: 0 ... n1 - 1, ordered by smaller, then larger end vertex.
template <typename Id>
using EdgeHandle = Handle<struct EdgeKind, Id>;
/// 2-cell: 0 ... n2 - 1, ordered by its three smallest vertices.
template <typename Id>
using FaceHandle = Handle<struct FaceKind, Id>;
/// 3-cell: 0 ... n3 - 1, the numbers of the input.
template <typename Id>
using CellHandle = Handle<struct CellKind, Id>;
/// A face seen from one cell: cell number and local face, packed.
template <typename Id>
using HalfFaceHandle = Handle<struct HalfFaceKind, Id>;
/// A boundary half face: 0 ... n_b - 1, ordered by cell and local face.
template <typename Id>
using BoundaryFaceHandle = Handle<struct BoundaryFaceKind, Id>;
/// (vertex, edge, face, cell): cell number and local dart (from 1), packed; local dart 0 means the
/// outside, with the number of the boundary face instead of a cell.
template <typename Id>
using DartHandle = Handle<struct DartKind, Id>;

/// `Count` values computed on demand, usable in a `for`: `make(0)` ... `make(count - 1)`.
template <typename Make>
class IndexRange
{
public:
  class Iterator
  {
  public:
    Iterator(const Make* make, std::size_t index)
      : Maker(make)
      , Index(index)
    {
    }
    auto operator*() const { return (*this->Maker)(this->Index); }
    Iterator& operator++()
    {
      ++this->Index;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return this->Index != other.Index; }

  private:
    const Make* Maker;
    std::size_t Index;
  };

  IndexRange(std::size_t count, Make make)
    : Count(count)
    , Maker(make)
  {
  }
  Iterator begin() const { return Iterator(&this->Maker, 0); }
  Iterator end() const { return Iterator(&this->Maker, this->Count); }
  auto operator[](std::size_t i) const { return this->Maker(i); }
  std::size_t size() const { return this->Count; }

private:
  std::size_t Count;
  Make Maker;
};

}

#endif
