/**
 * @file TriangleBoxTree.h
 * @brief Pairs of triangles whose boxes overlap, by a tree of boxes along a space-filling curve.
 */
#ifndef isthmus_TriangleBoxTree_h
#define isthmus_TriangleBoxTree_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h" // for the export macro

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/**
 * Axis-aligned boxes around four triangles each, in the order of Morton's curve (G. M. Morton,
 * 1966), under a complete binary tree. The coordinates of boxes are floats relative to the middle
 * of the surface, rounded so that overlapping boxes still overlap. O(n log n), about 50 bytes for
 * each triangle. Queries may run in parallel.
 */
class TriangleBoxTree
{
public:
  /// @pre corners exist, points are finite, and the box of all is no wider than 1e37.
  VTKISTHMUSFILTERSSURFACES_EXPORT explicit TriangleBoxTree(const SurfaceView& mesh);

  /// Runs of up to 256 triangles along the curve.
  std::int64_t Groups() const { return this->NumberOfGroups; }

  /**
   * Calls visit(a, b) for all pairs of triangles with overlapping boxes of which one is in this
   * group and the other in the same or a later group. Over all groups, each pair is visited once.
   * The part of the tree for the group and the whole tree are traversed together, so that paths
   * from the root are shared.
   */
  template <typename Visit>
  void ForEachPair(std::int64_t group, Visit&& visit) const;

private:
  struct Box
  {
    std::array<float, 3> Min, Max;

    bool Overlaps(const Box& other) const
    {
      bool overlaps = true;
      for (std::size_t a = 0; a < 3;
           ++a) // for everything: which allocation fails cannot be predicted
      {
        overlaps &= this->Min[a] <= other.Max[a];
        overlaps &= other.Min[a] <= this->Max[a];
      }
      return overlaps;
    }
  };

  static constexpr std::size_t TrianglesOfLeaf = 4;
  static constexpr unsigned int HeightOfGroup = 6;

  void MakeBoxes(const SurfaceView& mesh);
  void MakeNodes();

  template <typename Visit>
  void ForEachPairOfLeaves(std::size_t a, std::size_t b, Visit&& visit) const;

  std::vector<std::int64_t> Order; ///< triangles along the curve
  std::vector<Box> Boxes;          ///< theirs, in that order
  std::vector<Box> Nodes;          ///< children of k are 2k and 2k + 1; the root is 1
  std::int64_t NumberOfGroups = 0;
  std::size_t FirstLeaf = 1;          ///< node of leaf 0, a power of two
  unsigned int Height = 0;            ///< of the root above the leaves
  unsigned int HeightAboveGroups = 0; ///< of the root above the nodes of groups
};

template <typename Visit>
void TriangleBoxTree::ForEachPairOfLeaves(std::size_t a, std::size_t b, Visit&& visit) const
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
void TriangleBoxTree::ForEachPair(std::int64_t group, Visit&& visit) const
{
  struct Waiting
  {
    std::size_t Own, Other;     // nodes; Other is Own, or all its leaves follow those of Own
    unsigned int Height, Above; // of Own; of Other above that
  };
  std::array<Waiting, 256> stack; // three more for each of at most 63 levels
  std::size_t waiting = 0;
  const auto wait = [&](std::size_t own, std::size_t other, unsigned int height, unsigned int above)
  {
    const std::size_t last = ((other + 1) << above) - 1;
    if (last >= own && this->Nodes[own].Overlaps(this->Nodes[other]))
    {
      stack[waiting++] = { own, other, height, above };
    }
  };
  const unsigned int height = this->Height - this->HeightAboveGroups;
  wait((std::size_t{ 1 } << this->HeightAboveGroups) + static_cast<std::size_t>(group), 1, height,
    this->HeightAboveGroups);
  while (waiting > 0)
  {
    const Waiting next = stack[--waiting];
    if (next.Above > 0)
    {
      wait(next.Own, 2 * next.Other, next.Height, next.Above - 1);
      wait(next.Own, 2 * next.Other + 1, next.Height, next.Above - 1);
    }
    else if (next.Height == 0)
    {
      this->ForEachPairOfLeaves(next.Own - this->FirstLeaf, next.Other - this->FirstLeaf, visit);
    }
    else
    {
      const std::size_t own = 2 * next.Own, other = 2 * next.Other;
      wait(own, other, next.Height - 1, 0);
      wait(own, other + 1, next.Height - 1, 0);
      wait(own + 1, other, next.Height - 1, 0); // of a node with itself it comes later: skipped
      wait(own + 1, other + 1, next.Height - 1, 0);
    }
  }
}

}

#endif
