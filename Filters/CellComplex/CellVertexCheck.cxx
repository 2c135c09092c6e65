#include "CellComplex/CellVertexCheck.h"

#include "CellComplex/MeshError.h"

#include <algorithm>
#include <string>

namespace isthmus
{
namespace
{

constexpr std::size_t NamedCells = 5;

/// The cells of one error message, in any order, as the subject of the message.
std::string FormatCells(std::vector<std::size_t> cells)
{
  std::sort(cells.begin(), cells.end());
  std::string text = cells.size() == 1 ? "Cell " : "Cells ";
  for (std::size_t i = 0; i < std::min(cells.size(), NamedCells); ++i)
  {
    text += (i ? ", " : "") + std::to_string(cells[i]);
  }
  return cells.size() > NamedCells
    ? text + " and " + std::to_string(cells.size() - NamedCells) + " more"
    : text;
}

bool AreDistinct(const View<std::int64_t>& vertices)
{
  constexpr std::size_t few = 8; // for which comparing all pairs is quicker than sorting a copy
  if (vertices.size() <= few)
  {
    bool distinct = true;
    for (std::size_t i = 1; i < vertices.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        distinct = distinct && vertices[i] != vertices[j];
      }
    }
    return distinct;
  }
  std::vector<std::int64_t> sorted(vertices.begin(), vertices.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

}

void CellVertexCheck::Add(std::size_t cell, View<std::int64_t> vertices)
{
  bool inRange = true;
  for (const std::int64_t vertex : vertices)
  {
    inRange = inRange && vertex >= 0 && vertex < this->NumberOfVertices;
  }
  if (!inRange || !AreDistinct(vertices))
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    (inRange ? this->Degenerate : this->OutOfRange).push_back(cell);
  }
}

void CellVertexCheck::ThrowIfBad() const
{
  if (!this->OutOfRange.empty())
  {
    throw MeshError(MeshError::Reason::OutOfRange,
      FormatCells(this->OutOfRange) + ": a vertex number is not in 0 ... " +
        std::to_string(this->NumberOfVertices - 1) + ". Correct the list of cells.");
  }
  if (!this->Degenerate.empty())
  {
    throw MeshError(MeshError::Reason::Degenerate,
      FormatCells(this->Degenerate) + ": the same vertex occurs twice. Remove degenerate cells.");
  }
}

}
