/**
 * @file ChargeTree.h
 * @brief Many charges seen from afar: a tree of boxes with a few stand-in charges each.
 *
 * A box of the tree holds 5^3 charges at its Chebyshev points that interpolate those in it (the
 * Lagrange treecode of L. Wang, R. Krasny and S. Tlupova, Commun. Comput. Phys. 28 (2020) 1415).
 * Targets are points or balls: boxes whose radius is less than half their distance are seen by
 * their stand-ins, relative error about 1e-5; all others are opened down to the charges.
 */
#ifndef isthmus_ChargeTree_h
#define isthmus_ChargeTree_h

#include "Electrostatics/ChargeSums.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

namespace isthmus
{

/// Building: O(n log n), most of it parallel; memory about 8 numbers for each charge.
class VTKISTHMUSFILTERSELECTROSTATICS_EXPORT ChargeTree
{
public:
  explicit ChargeTree(const ChargeList& charges);

  /// `seen` = what targets within `radius` of `centre` may sum over instead of all charges.
  void Gather(const Point3& centre, double radius, ChargeList& seen) const;

  /// sum q exp(-kappa |x - r|) / |x - r| at a point; some microseconds.
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
  /// Whether a box is seen from afar.
  static bool Far(const Box& box, const Point3& centre, double radius);
  void Gather(std::int64_t box, const Point3& centre, double radius, ChargeList& seen) const;
  double ScreenedSum(std::int64_t box, const Point3& x, double kappa) const;

  ChargeList Sorted; ///< the charges of a box in a row
  std::vector<Box> Boxes;
};

/// Below this number of charges sums are made directly.
constexpr std::size_t FewestForTree = 5000;

}

#endif
