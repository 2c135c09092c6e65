/**
 * @file CubicalGradient.h
 * @brief Cells of a volume by key, with their boundaries and cofaces, based on the lower stars.
 */
#ifndef isthmus_CubicalGradient_h
#define isthmus_CubicalGradient_h

#include "Persistence/CubicalDiagram.h"
#include "Persistence/LowerStars.h"
#include "Persistence/OrderedValues.h"

#include <array>
#include <cstdint>

namespace isthmus
{

template <typename Stored, typename KeyType>
class CubicalGradient
{
public:
  using Key = KeyType;

  CubicalGradient(const OrderedValues<Stored>& values, const LowerStars& stars)
    : Values(values)
    , Stars(stars)
  {
  }

  const LowerStars& Lower() const { return this->Stars; }

  /// `cell` of the lower star of `node`; the place in the key counts within its dimension.
  Key EdgeKey(std::int64_t node, StarCell cell) const
  {
    return Key(this->Values[node], node, cell.Value);
  }
  Key FaceKey(std::int64_t node, StarCell cell) const
  {
    return Key(this->Values[node], node, cell.Value - Star::FirstFace);
  }
  Key CubeKey(std::int64_t node, StarCell cell) const
  {
    return Key(this->Values[node], node, cell.Value - Star::FirstCube);
  }
  /// The cell of the node's star that is denoted by the key of an edge or of a face.
  static StarCell GetEdge(const Key& key) { return StarCell(key.Place()); }
  static StarCell GetFace(const Key& key) { return StarCell(key.Place() + Star::FirstFace); }

  static CubicalCell MakeCell(std::int64_t node, StarCell cell)
  {
    return CubicalCell(node, Star::DirectionOf[cell.Index()]);
  }
  static CubicalCell MakeNodeCell(std::int64_t node)
  {
    return MakeCell(node, StarCell(Star::Node));
  }

  bool IsLater(std::int64_t a, std::int64_t b) const
  {
    const auto first = this->Values[a];
    const auto second = this->Values[b];
    return first != second ? first > second : a > b;
  }

  /// The two nodes of an edge.
  std::array<std::int64_t, 2> GetEnds(const Key& edge) const
  {
    return { edge.Node(), edge.Node() + this->Stars.Offset(GetEdge(edge)) };
  }

  /// The edge from a node one step along an axis, forwards or back.
  Key EdgeAlong(std::int64_t node, std::size_t axis, bool forwards) const
  {
    const StarCell cell(forwards ? 3 + static_cast<int>(axis) : 2 - static_cast<int>(axis));
    return this->EdgeBetween(node, node + this->Stars.Offset(cell), cell);
  }

  /// The four edges of a face of the star of `node`; the first two are of the same star.
  std::array<Key, 4> GetBoundary(std::int64_t node, StarCell face) const
  {
    const auto& edges = Star::FaceEdges[face.Index() - Star::FirstFace];
    const StarCell first(edges[0]), second(edges[1]);
    const std::int64_t far = node + this->Stars.Offset(face);
    return { this->EdgeKey(node, first), this->EdgeKey(node, second),
      this->EdgeBetween(node + this->Stars.Offset(first), far, second),
      this->EdgeBetween(node + this->Stars.Offset(second), far, first) };
  }

  /// The cubes on both sides of a face, given by their lowest corners; NodeCount() stands for the
  /// exterior of the grid.
  std::array<std::int64_t, 2> GetCofaces(std::int64_t node, StarCell face) const
  {
    const auto& step = Star::Steps[face.Index()];
    const std::size_t normal = step[0] == 0 ? 0 : step[1] == 0 ? 1 : 2;
    std::int64_t low = node;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low -= step[axis] < 0 ? this->Stars.Stride(axis) : 0;
    }
    const std::int64_t length = this->Stars.Dimensions()[normal];
    const std::int64_t at = node / this->Stars.Stride(normal) % length;
    const std::int64_t outside = this->Stars.NodeCount();
    return { at + 1 < length ? low : outside, at > 0 ? low - this->Stars.Stride(normal) : outside };
  }

  /// The cube with this lowest corner, given by its last corner and its number in the star of that
  /// corner.
  std::pair<std::int64_t, StarCell> StarCube(std::int64_t low) const
  {
    std::int64_t last = low;
    std::size_t corner = 0;
    for (std::size_t c = 1; c < 8; ++c)
    {
      const std::int64_t node = low + (c & 1U ? 1 : 0) + (c & 2U ? this->Stars.Stride(1) : 0) +
        (c & 4U ? this->Stars.Stride(2) : 0);
      if (this->IsLater(node, last))
      {
        last = node;
        corner = c;
      }
    }
    // Cubes are numbered by direction, with x varying fastest, so the direction back from the last
    // corner has the opposite number.
    return { last, StarCell(Star::FirstCube + 7 - static_cast<int>(corner)) };
  }

  std::int64_t NodeOutside() const { return this->Stars.NodeCount(); }

private:
  Key EdgeBetween(std::int64_t near, std::int64_t far, StarCell cell) const
  {
    // Edges are numbered so that 5 - cell is the opposite direction.
    const auto a = this->Values[near];
    const auto b = this->Values[far];
    return b > a || (b == a && far > near) ? Key(b, far, 5 - cell.Value) : Key(a, near, cell.Value);
  }

  const OrderedValues<Stored>& Values;
  const LowerStars& Stars;
};

}

#endif
