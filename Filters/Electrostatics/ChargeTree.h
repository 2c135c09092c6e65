/**
 * @file ChargeTree.h
 * @brief Sums over many distant charges by a tree of boxes, each with a few equivalent charges.
 *
 * A box of the tree holds 5^3 charges at its Chebyshev points that interpolate those in it (the
 * Lagrange treecode of L. Wang, R. Krasny and S. Tlupova, Commun. Comput. Phys. 28 (2020) 1415).
 * Targets are points or balls. Boxes whose radius is less than half their distance are replaced by
 * their equivalent charges, with a relative error of about 1e-5; all others are opened down to the
 * charges.
 */
#ifndef isthmus_ChargeTree_h
#define isthmus_ChargeTree_h

#include "Electrostatics/ChargeSums.h"

namespace isthmus
{

/// Building the tree takes O(n log n), mostly in parallel, and memory for about 8 numbers for each
/// charge.
class ChargeTree
{
public:
  explicit ChargeTree(const ChargeList& charges);

  /// Sets `seen` to the charges over which targets within `radius` of `center` may sum instead of
  /// all charges.
  void Gather(const Point3& center, double radius, ChargeList& seen) const;

  /// sum q exp(-kappa |x - r|) / |x - r| at a point.
  double ScreenedSum(const Point3& x, double kappa) const;

private:
  struct Box
  {
    Point3 Low, High;
    std::size_t First, Last; ///< of Sorted
    std::int64_t Children[2] = { -1, -1 };
    ChargeList StandIns;
  };

  std::int64_t Build(const ChargeList& charges, std::vector<std::size_t>& order, std::size_t first,
    std::size_t last);
  static void AddStandIns(
    const ChargeList& charges, const std::vector<std::size_t>& order, Box& box);
  /// Whether a box is far enough away to be replaced by its equivalent charges.
  static bool IsFar(const Box& box, const Point3& center, double radius);
  void Gather(std::int64_t box, const Point3& center, double radius, ChargeList& seen) const;
  double ScreenedSum(std::int64_t box, const Point3& x, double kappa) const;

  ChargeList Sorted; ///< the charges of a box are consecutive
  std::vector<Box> Boxes;
};

/// Below this number of charges sums are made directly.
constexpr std::size_t FewestForTree = 5000;

}

#endif
