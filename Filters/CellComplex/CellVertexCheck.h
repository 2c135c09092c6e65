/**
 * @file CellVertexCheck.h
 * @brief Checks that the vertices of each cell exist and are different.
 */
#ifndef isthmus_CellVertexCheck_h
#define isthmus_CellVertexCheck_h

#include "Core/View.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace isthmus
{

/// Checks cells, in any order and from any number of threads, and collects the invalid ones.
class CellVertexCheck
{
public:
  explicit CellVertexCheck(std::int64_t numberOfVertices)
    : NumberOfVertices(numberOfVertices)
  {
  }

  void Add(std::size_t cell, View<std::int64_t> vertices);

  /// @throws MeshError (OutOfRange, else Degenerate) with the first invalid cells.
  void ThrowIfBad() const;

private:
  std::int64_t NumberOfVertices;
  std::mutex Mutex;
  std::vector<std::size_t> OutOfRange, Degenerate;
};

}

#endif
