/**
 * @file CellVertexCheck.h
 * @brief Whether the vertices of each cell exist, and are there once; else a sentence that names
 * the cells.
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

/// Looks at cells, in any order and from any number of threads, then tells what was wrong.
class CellVertexCheck
{
public:
  explicit CellVertexCheck(std::int64_t numberOfVertices)
    : NumberOfVertices(numberOfVertices)
  {
  }

  void Look(std::size_t cell, View<std::int64_t> vertices);

  /// @throws MeshError (OutOfRange, else Degenerate) with the first cells that were found wanting.
  void Demand() const;

private:
  std::int64_t NumberOfVertices;
  std::mutex Mutex;
  std::vector<std::size_t> OutOfRange, Degenerate;
};

}

#endif
