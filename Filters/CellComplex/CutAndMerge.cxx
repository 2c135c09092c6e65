#include "CellComplex/CutAndMerge.h"

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace isthmus
{
namespace
{

constexpr std::int64_t Unset = -1;

/// Appends cells of maps, their vertices renumbered.
class Editor
{
public:
  template <typename Map>
  void Add(const Map& map, typename Map::Cell cell, const std::vector<std::int64_t>& newVertices)
  {
    const std::size_t type = this->TypeNumber(map.GetType(cell));
    if (this->Cells.Runs.empty() || this->Cells.Runs.back().Type != type)
    {
      this->Cells.Runs.push_back({ type, 0 });
    }
    ++this->Cells.Runs.back().NumberOfCells;
    for (const auto vertex : map.Vertices(cell))
    {
      this->Cells.CellVertices.push_back(newVertices[vertex.Value]);
    }
    this->Cells.OldCells.push_back(static_cast<std::int64_t>(cell.Value));
  }

  /// The number that the next new vertex gets.
  std::int64_t AddVertex(std::size_t oldNumber)
  {
    this->Cells.OldVertices.push_back(static_cast<std::int64_t>(oldNumber));
    return this->Cells.NumberOfVertices++;
  }

  EditedCells Cells;

private:
  std::size_t TypeNumber(const CellType& type)
  {
    if (&type != this->Known) // cells come in runs, so the result is nearly always the last one
    {
      const auto added = this->Numbers.emplace(
        std::make_pair(type.NumberOfVertices(), type.Faces()), this->Cells.Types.size());
      if (added.second)
      {
        this->Cells.Types.push_back(type);
      }
      this->Number = added.first->second;
      this->Known = &type;
    }
    return this->Number;
  }

  std::map<std::pair<int, FaceList>, std::size_t> Numbers;
  const CellType* Known = nullptr;
  std::size_t Number = 0;
};

}

CellList EditedCells::List() const
{
  return { this->NumberOfVertices, this->Types, this->Runs,
    { this->CellVertices.data(), this->CellVertices.size() } };
}

template <typename Id>
EditedCells CutOut(const CompactCombinatorialMap<Id>& map, const std::vector<unsigned char>& keep)
{
  using Cell = typename CompactCombinatorialMap<Id>::Cell;
  if (keep.size() != map.NumberOfCells())
  {
    throw std::invalid_argument("Cutting needs one keep flag for each of the " +
      std::to_string(map.NumberOfCells()) + " cells, but " + std::to_string(keep.size()) +
      " were given.");
  }
  Editor editor;
  std::vector<std::int64_t> newVertices(map.NumberOfVertices(), Unset);
  for (std::size_t c = 0; c < keep.size(); ++c)
  {
    for (const auto vertex : map.Vertices(Cell(static_cast<Id>(c))))
    {
      newVertices[vertex.Value] = keep[c] ? 0 : newVertices[vertex.Value];
    }
  }
  for (std::size_t v = 0; v < newVertices.size(); ++v)
  {
    newVertices[v] = newVertices[v] == Unset ? Unset : editor.AddVertex(v);
  }
  for (std::size_t c = 0; c < keep.size(); ++c)
  {
    if (keep[c])
    {
      editor.Add(map, Cell(static_cast<Id>(c)), newVertices);
    }
  }
  return std::move(editor.Cells);
}

template <typename Id>
EditedCells Merge(const CompactCombinatorialMap<Id>& first,
  const CompactCombinatorialMap<Id>& second,
  const std::vector<std::pair<std::int64_t, std::int64_t>>& sameVertices)
{
  using Cell = typename CompactCombinatorialMap<Id>::Cell;
  Editor editor;
  std::vector<std::int64_t> ofFirst, ofSecond(second.NumberOfVertices(), Unset);
  for (std::size_t v = 0; v < first.NumberOfVertices(); ++v)
  {
    ofFirst.push_back(editor.AddVertex(v));
  }
  std::vector<bool> paired(first.NumberOfVertices(), false);
  for (const auto& [a, b] : sameVertices)
  {
    const bool exist = a >= 0 && b >= 0 && a < static_cast<std::int64_t>(ofFirst.size()) &&
      b < static_cast<std::int64_t>(ofSecond.size());
    if (!exist || paired[static_cast<std::size_t>(a)] ||
      ofSecond[static_cast<std::size_t>(b)] != Unset)
    {
      throw std::invalid_argument("The vertices " + std::to_string(a) + " and " +
        std::to_string(b) + " can't be merged: " +
        (exist ? "one of them is paired already." : "one of them does not exist."));
    }
    paired[static_cast<std::size_t>(a)] = true;
    ofSecond[static_cast<std::size_t>(b)] = a;
  }
  for (std::size_t v = 0; v < ofSecond.size(); ++v)
  {
    ofSecond[v] = ofSecond[v] == Unset ? editor.AddVertex(v) : ofSecond[v];
  }
  for (std::size_t c = 0; c < first.NumberOfCells(); ++c)
  {
    editor.Add(first, Cell(static_cast<Id>(c)), ofFirst);
  }
  for (std::size_t c = 0; c < second.NumberOfCells(); ++c)
  {
    editor.Add(second, Cell(static_cast<Id>(c)), ofSecond);
  }
  return std::move(editor.Cells);
}

template EditedCells CutOut(
  const CompactCombinatorialMap<std::uint32_t>&, const std::vector<unsigned char>&);
template EditedCells CutOut(
  const CompactCombinatorialMap<std::uint64_t>&, const std::vector<unsigned char>&);
template EditedCells Merge(const CompactCombinatorialMap<std::uint32_t>&,
  const CompactCombinatorialMap<std::uint32_t>&,
  const std::vector<std::pair<std::int64_t, std::int64_t>>&);
template EditedCells Merge(const CompactCombinatorialMap<std::uint64_t>&,
  const CompactCombinatorialMap<std::uint64_t>&,
  const std::vector<std::pair<std::int64_t, std::int64_t>>&);

}
