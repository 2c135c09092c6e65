/**
 * @file ChargeTree.h
 * @brief Many charges seen from afar: a tree of boxes with a few stand-in charges each.
 *
 * A box of the tree holds 5^3 charges at its Chebyshev points that interpolate those in it (the
 * Lagrange treecode of L. Wang, R. Krasny and S. Tlupova, Commun. Comput. Phys. 28 (2020) 1415).
 * Targets come in balls: boxes whose radius is less than half their distance from the ball are seen
 * by their stand-ins, relative error about 1e-5; all others are opened down to the charges.
 */
#ifndef isthmus_ChargeTree_h
#define isthmus_ChargeTree_h

#include "ChargeSums.h"
#include "vtkIsthmusModule.h"

namespace isthmus
{

/// Refers to the charges. Building: O(n log n); memory about 4 numbers for each charge.
class VTKISTHMUS_EXPORT ChargeTree
{
public:
  explicit ChargeTree(const ChargeList& charges);

  /// `seen` = what targets within `radius` of `centre` may sum over instead of all charges.
  void Gather(const Vector3& centre, double radius, ChargeList& seen) const;

private:
  struct Box
  {
    Vector3 Low, High;
    std::size_t First, Last; ///< of Order
    std::int64_t Children[2] = { -1, -1 };
    ChargeList StandIns;
  };

  std::int64_t Build(std::size_t first, std::size_t last);
  void AddStandIns(Box& box) const;
  void Gather(std::int64_t box, const Vector3& centre, double radius, ChargeList& seen) const;

  const ChargeList& Charges;
  std::vector<std::size_t> Order;
  std::vector<Box> Boxes;
};

/// Below this number of charges sums are made directly.
constexpr std::size_t FewestForTree = 5000;

}

#endif
