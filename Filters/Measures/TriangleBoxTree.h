/**
 * @file TriangleBoxTree.h
 * @brief Pairs of triangles whose boxes overlap, by a tree of boxes along a space-filling curve.
 */
#ifndef isthmus_TriangleBoxTree_h
#define isthmus_TriangleBoxTree_h

#include "TriangleMesh.h"
#include "vtkIsthmusModule.h" // for the export macro

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/**
 * Boxes along the axes round four triangles each, in the order of Morton's curve (G. M. Morton,
 * 1966), under a complete binary tree. Boxes are floats relative to the middle of the surface,
 * rounded so that boxes which overlap still do. O(n log n), some 50 bytes a triangle. Queries may
 * run in parallel.
 */
class TriangleBoxTree
{
public:
  /// @pre corners exist, points are finite, and the box of all is no wider than 1e37.
  VTKISTHMUS_EXPORT explicit TriangleBoxTree(const TriangleMesh& mesh);

  std::int64_t Leaves() const { return this->NumberOfLeaves; }

  /**
   * Calls visit(a, b), triangles a and b, for all pairs with overlapping boxes of which one is in
   * leaf `leaf` and the other in it or a later one. Over all leaves, each pair comes once.
   */
  template <typename Visit>
  void ForPairs(std::int64_t leaf, Visit&& visit) const;

private:
  struct Box
  {
    std::array<float, 3> Min, Max;

    bool Overlaps(const Box& other) const
    {
      return this->Min[0] <= other.Max[0] && other.Min[0] <= this->Max[0] &&
        this->Min[1] <= other.Max[1] && other.Min[1] <= this->Max[1] &&
        this->Min[2] <= other.Max[2] && other.Min[2] <= this->Max[2];
    }
  };

  static constexpr std::size_t TrianglesOfLeaf = 4;

  void MakeBoxes(const TriangleMesh& mesh);
  void MakeNodes();

  template <typename Visit>
  void ForPairsOfLeaves(std::size_t a, std::size_t b, Visit&& visit) const;

  std::vector<std::int64_t> Order; ///< triangles along the curve
  std::vector<Box> Boxes;          ///< theirs, in that order
  std::vector<Box> Nodes;          ///< children of k are 2k and 2k + 1; the root is 1
  std::int64_t NumberOfLeaves = 0;
  std::size_t FirstLeaf = 1; ///< node of leaf 0, a power of two
  unsigned int Height = 0;   ///< of the root above the leaves
};

template <typename Visit>
void TriangleBoxTree::ForPairsOfLeaves(std::size_t a, std::size_t b, Visit&& visit) const
{
  const std::size_t endOfA = std::min((a + 1) * TrianglesOfLeaf, this->Boxes.size());
  const std::size_t endOfB = std::min((b + 1) * TrianglesOfLeaf, this->Boxes.size());
  for (std::size_t i = a * TrianglesOfLeaf; i < endOfA; ++i)
  {
    for (std::size_t j = a == b ? i + 1 : b * TrianglesOfLeaf; j < endOfB; ++j)
    {
      if (this->Boxes[i].Overlaps(this->Boxes[j]))
      {
        visit(this->Order[i], this->Order[j]);
      }
    }
  }
}

template <typename Visit>
void TriangleBoxTree::ForPairs(std::int64_t leaf, Visit&& visit) const
{
  const auto own = static_cast<std::size_t>(leaf);
  const Box& box = this->Nodes[this->FirstLeaf + own];
  struct Waiting
  {
    std::size_t Node;
    unsigned int Height;
  };
  std::array<Waiting, 128> stack; // one more than the height at most
  std::size_t waiting = 0;
  stack[waiting++] = { 1, this->Height };
  while (waiting > 0)
  {
    const Waiting next = stack[--waiting];
    const std::size_t last = ((next.Node + 1) << next.Height) - 1 - this->FirstLeaf;
    if (last < own || !this->Nodes[next.Node].Overlaps(box))
    {
      continue;
    }
    if (next.Height == 0)
    {
      this->ForPairsOfLeaves(own, next.Node - this->FirstLeaf, visit);
      continue;
    }
    stack[waiting++] = { 2 * next.Node + 1, next.Height - 1 };
    stack[waiting++] = { 2 * next.Node, next.Height - 1 };
  }
}

}

#endif
