#include "Surfaces/TriangleTree.h"

#include "Core/VectorClones.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t DeepestStack = 128; // 7 pending nodes on each of 12 levels, and one more

}

double SquaredDistanceToSegment(const Point3& x, const Point3& a, const Point3& b)
{
  const Point3 d = b - a;
  const double dd = Dot(d, d);
  const double t = dd > 0.0 ? std::clamp(Dot(x - a, d) / dd, 0.0, 1.0) : 0.0;
  const Point3 rest = x - a - t * d;
  return Dot(rest, rest);
}

double SquaredDistanceToTriangle(const Point3& x, const std::array<Point3, 3>& corners)
{
  const auto& [a, b, c] = corners;
  const Point3 normal = Cross(b - a, c - a);
  const double nn = Dot(normal, normal);
  const double border = std::min({ SquaredDistanceToSegment(x, a, b),
    SquaredDistanceToSegment(x, b, c), SquaredDistanceToSegment(x, c, a) });
  const bool over = nn > 0.0 && Dot(Cross(b - a, x - a), normal) >= 0.0 &&
    Dot(Cross(c - b, x - b), normal) >= 0.0 && Dot(Cross(a - c, x - c), normal) >= 0.0;
  if (!over)
  {
    return border;
  }
  // No point of the triangle is farther from its border than |n| / perimeter, so the distance stays
  // within that of the border's even if rounding has turned a needle's normal.
  const double longest = std::max({ Dot(b - a, b - a), Dot(c - b, c - b), Dot(a - c, a - c) });
  const double height = Dot(normal, x - a);
  return std::min(std::max(height * height / nn, border - 0.25 * nn / longest), border);
}

TriangleTree::TriangleTree(const SurfaceView& mesh)
  : Tree(MakeTriangleNodes(mesh))
{
}

/// One query. Its loops over lanes have no branches, so that they become vector instructions.
class TriangleTree::Search
{
  using Node = TriangleTreeNodes::Node;
  using Leaf = TriangleTreeNodes::Leaf;
  using Lanes = TriangleTreeNodes::Lanes;
  static constexpr std::size_t Width = TriangleTreeNodes::Width;

public:
  Search(const TriangleTreeNodes& tree, const Point3& x)
    : Tree(tree)
    , X(x)
  {
    double size = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double place = (x[axis] - tree.Origin[axis]) / tree.Scale;
      size += std::abs(place);
      this->Place[axis] = static_cast<float>(place);
    }
    // From so far away that squares leave the range of floats, all cylinders count as near.
    constexpr double farthest = 1e15;
    this->Margin = size < farthest ? Rounding * static_cast<float>(size + 1.0)
                                   : std::numeric_limits<float>::infinity();
    this->Place = size < farthest ? this->Place : std::array<float, 3>{ 0.0F, 0.0F, 0.0F };
  }

  /// A leaf that is probably near comes first, so that most cylinders are beyond its distance.
  Nearest Run(std::int64_t guess)
  {
    if (guess >= 0)
    {
      this->VisitLeaf(guess);
    }
    if (this->Tree.Nodes.empty() && !this->Tree.Leaves.empty())
    {
      this->VisitLeaf(0);
    }
    else if (!this->Tree.Nodes.empty())
    {
      this->Stack[this->Waiting++] = { 0, 0.0F };
    }
    while (this->Waiting > 0)
    {
      const Entry next = this->Stack[--this->Waiting];
      if (next.Squared >= this->Reach)
      {
        continue;
      }
      if (next.Child < 0)
      {
        this->VisitLeaf(~next.Child);
      }
      else
      {
        this->OpenNode(this->Tree.Nodes[static_cast<std::size_t>(next.Child)]);
      }
    }
    return this->Found;
  }

private:
  struct Entry
  {
    std::int32_t Child;
    float Squared; ///< in the tree's scale, not more than any triangle's there
  };

  /// Children that may be nearer than the best result so far are pushed, the nearest on top.
  ///
  /// With u = 2^-24 and all lengths in the tree's scale: x and a center are rounded by u of their
  /// sizes, |x| + 1 together, so r is by less than 2^-22 (|x| + 1), height by 8u |r| more; r^2 -
  /// height^2 by (4 + 16) u r^2 < 2^-19 r^2, which is taken off it before the root; the last sums
  /// and roots by u each. Rounding (|x| + 1) = 2^-20 (|x| + 1), taken off heights and radii, is
  /// more than all the rest.
  void OpenNode(const Node& node)
  {
    // Cylinders: where the surface is smooth they are flat discs, and far from it few are as near
    // as the nearest triangle. Boxes extend away from the surface: inside a sphere, a hundred times
    // as many of them have to be opened.
    alignas(64) TriangleTreeNodes::FloatLanes squared;
    for (std::size_t n = 0; n < Width; ++n)
    {
      const float rx = this->Place[0] - node.Center[0][n], ry = this->Place[1] - node.Center[1][n],
                  rz = this->Place[2] - node.Center[2][n];
      const float height = rx * node.Axis[0][n] + ry * node.Axis[1][n] + rz * node.Axis[2][n];
      const float all = rx * rx + ry * ry + rz * rz;
      const float across = std::sqrt(std::max(all - height * height - 2.0F * Rounding * all, 0.0F));
      const float above = std::max(std::abs(height) - node.HalfHeight[n] - this->Margin, 0.0F);
      const float beside = std::max(across - node.Radius[n] - this->Margin, 0.0F);
      squared[n] = above * above + beside * beside;
    }
    const std::size_t first = this->Waiting;
    for (std::size_t n = 0; n < Width; ++n)
    {
      if (squared[n] < this->Reach)
      {
        std::size_t place = this->Waiting++;
        for (; place > first && this->Stack[place - 1].Squared < squared[n]; --place)
        {
          this->Stack[place] = this->Stack[place - 1];
        }
        this->Stack[place] = { node.Child[n], squared[n] };
      }
    }
  }

  /// The position of x relative to an edge of lane n's triangle.
  struct LaneEdges
  {
    double Squared; ///< distance from it
    double Side;    ///< negative where x is beyond it, seen along the normal
    double Length;  ///< squared
  };

  LaneEdges Edge(const Leaf& leaf, std::size_t corner, std::size_t n, const Point3& normal) const
  {
    const auto& a = leaf.Corner[corner];
    const auto& b = leaf.Corner[(corner + 1) % 3];
    const Point3 d{ b[0][n] - a[0][n], b[1][n] - a[1][n], b[2][n] - a[2][n] };
    const Point3 r{ this->X[0] - a[0][n], this->X[1] - a[1][n], this->X[2] - a[2][n] };
    const double length = Dot(d, d);
    const double t = std::min(std::max(Dot(r, d) / std::max(length, Smallest), 0.0), 1.0);
    const Point3 rest{ r[0] - t * d[0], r[1] - t * d[1], r[2] - t * d[2] };
    return { Dot(rest, rest), Dot(Cross(d, r), normal), length };
  }

  /// SquaredDistanceToTriangle, eight at once.
  void VisitLeaf(std::int64_t index)
  {
    const Leaf& leaf = this->Tree.Leaves[static_cast<std::size_t>(index)];
    const auto& [a, b, c] = leaf.Corner;
    alignas(64) Lanes squared;
    for (std::size_t n = 0; n < Width; ++n)
    {
      const Point3 normal = Cross({ b[0][n] - a[0][n], b[1][n] - a[1][n], b[2][n] - a[2][n] },
        { c[0][n] - a[0][n], c[1][n] - a[1][n], c[2][n] - a[2][n] });
      const double nn = Dot(normal, normal);
      const LaneEdges ab = this->Edge(leaf, 0, n, normal);
      const LaneEdges bc = this->Edge(leaf, 1, n, normal);
      const LaneEdges ca = this->Edge(leaf, 2, n, normal);
      const double border = std::min(std::min(ab.Squared, bc.Squared), ca.Squared);
      const double side = std::min(std::min(ab.Side, bc.Side), ca.Side);
      const double longest = std::max(std::max(ab.Length, bc.Length), ca.Length);
      const double height =
        Dot(normal, { this->X[0] - a[0][n], this->X[1] - a[1][n], this->X[2] - a[2][n] });
      const double plane = height * height / std::max(nn, Smallest);
      const double least = border - 0.25 * nn / std::max(longest, Smallest);
      const double over = std::min(std::max(plane, least), border);
      squared[n] = side >= 0.0 && nn > 0.0 ? over : border;
    }
    const double least = *std::min_element(squared.begin(), squared.end());
    if (least < this->Found.Squared)
    {
      this->Found = { least, index };
      // Slightly larger, to allow for the rounding of squares.
      this->Reach = static_cast<float>(
        least / (this->Tree.Scale * this->Tree.Scale) * (1.0 + 2.0 * double(Rounding)) +
        std::numeric_limits<float>::min());
    }
  }

  static constexpr double Smallest = std::numeric_limits<double>::min();

  const TriangleTreeNodes& Tree;
  const Point3 X;
  static constexpr float Rounding = 0x1p-20F;
  std::array<float, 3> Place; ///< X in the tree's scale
  float Margin = 0.0F;
  Nearest Found{ Infinity, -1 };
  float Reach = std::numeric_limits<float>::infinity(); ///< of the result, in the tree's scale
  std::array<Entry, DeepestStack> Stack;
  std::size_t Waiting = 0;
};

/// Flattened, since only what is inlined is compiled for the vectors of each machine.
ISTHMUS_VECTOR_CLONES [[gnu::flatten]] TriangleTree::Nearest TriangleTree::Find(
  const Point3& x, std::int64_t guess) const
{
  return Search(this->Tree, x).Run(guess);
}

}
