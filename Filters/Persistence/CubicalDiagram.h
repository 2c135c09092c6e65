/**
 * @file CubicalDiagram.h
 * @brief Parameters and results of the persistence of a volume.
 */
#ifndef isthmus_CubicalDiagram_h
#define isthmus_CubicalDiagram_h

#include <cstdint>
#include <vector>

namespace isthmus
{

/**
 * A cell of the cubical complex on the nodes of a grid, given by the node with which it enters (the
 * last of its corners) and the direction from there to the opposite corner.
 */
class CubicalCell
{
public:
  CubicalCell() = default; ///< no cell: of a class that never ends
  CubicalCell(std::int64_t node, int direction)
    : Code(27 * node + direction)
  {
  }

  /// -1: no cell.
  std::int64_t Node() const { return this->Code < 0 ? -1 : this->Code / 27; }

  /// The direction from the node to the opposite corner, (dx + 1) + 3 (dy + 1) + 9 (dz + 1) with
  /// components -1, 0 or 1; 13 is the node itself.
  int Direction() const { return static_cast<int>(this->Code % 27); }

  /// Step along an axis from the node to the opposite corner: -1, 0 or 1.
  int Step(int axis) const
  {
    const int power = axis == 0 ? 1 : axis == 1 ? 3 : 9;
    return this->Direction() / power % 3 - 1;
  }

  /// Node and direction in one number, in the order of nodes.
  std::int64_t Name() const { return this->Code; }

  bool operator==(const CubicalCell& other) const { return this->Code == other.Code; }

private:
  std::int64_t Code = -1; ///< 8 bytes, since noise has millions of pairs
};

/// A homology class: the cell that creates it, and the cell one dimension higher that ends it.
struct CubicalPair
{
  CubicalCell Birth;
  CubicalCell Death;
  std::int8_t Dimension = 0; ///< 0: component, 1: loop, 2: void
  /// The class that it merges with when it ends: the node where the elder component began, or the
  /// cube where the void on the other side will end; none for loops, or if it merges with the
  /// exterior.
  CubicalCell Elder;

  bool operator==(const CubicalPair& other) const
  {
    return this->Birth == other.Birth && this->Death == other.Death &&
      this->Dimension == other.Dimension && this->Elder == other.Elder;
  }
};

/// The classes of a volume, and its Euler numbers.
struct CubicalDiagram
{
  /// The classes whose birth and death have different values, and the one that never ends. They are
  /// sorted by dimension, then in the order of the cells that end them (for voids, the cells that
  /// create them).
  std::vector<CubicalPair> Pairs;
  /// Euler number of the sublevel (superlevel) set at each of the requested levels, counted from
  /// cells, not from pairs.
  std::vector<std::int64_t> EulerNumbers;
};

struct CubicalParameters
{
  /// Let the set grow from the highest value down instead of from the lowest value up.
  bool Superlevel = false;
  /// Levels at which the Euler number is computed, ascending and finite.
  std::vector<double> Levels;
};

}

#endif
