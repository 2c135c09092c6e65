/**
 * @file SideClasses.h
 * @brief Which classes of loops on a surface bound inside, and which outside; handles and tunnels
 * that the samples do not resolve.
 */
#ifndef isthmus_SideClasses_h
#define isthmus_SideClasses_h

#include "ChokingLoops/FeatureMembrane.h"

#include <array>
#include <vector>

namespace isthmus
{

/**
 * Splits the classes of H1(M; Z/2) into those that bound inside and those that bound outside, from
 * M alone, however close its sheets are.
 *
 * A loop x bounds inside exactly if no loop y of M, pushed off to the outside, is linked with it,
 * and the linking numbers of x with y pushed to either side differ by the intersection number of x
 * and y (D. Rolfsen, Knots and Links, section 5D). With the basis loops of SurfaceHomology for x
 * and their dual loops for y, the matrix of linking numbers modulo 2 is therefore the projection
 * onto the classes that bound outside, along those that bound inside.
 *
 * Linking numbers are crossings in one projection, counted exactly on coordinates rounded to 2^-45
 * of the size.
 */
class SideClasses
{
public:
  /// Time: O(c (1 + g / 64)), with c crossings between projected edges.
  /// @pre M does not cross itself.
  /// @throws std::runtime_error if the numbers contradict each other, as where M crosses itself.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT SideClasses(
    const SurfaceAdjacency& surface, const SurfaceHomology& homology);

  /// The part of a class that bounds on a side. The class is the sum of both parts.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT HomologyClass Part(
    const HomologyClass& c, SpaceSide side) const;

  /// True for a class that bounds on a side; so does zero, on both.
  bool Bounds(const HomologyClass& c, SpaceSide side) const
  {
    return IsZero(
      this->Part(c, side == SpaceSide::Inside ? SpaceSide::Outside : SpaceSide::Inside));
  }

private:
  std::vector<HomologyClass> Outside; ///< the outer part of each basis loop
};

/**
 * Completes handles and tunnels to g each, with loops; false if they are already. Generators that
 * the samples resolve are kept if their class bounds on their side. The classes of the others,
 * split into their parts, give as many more, narrowest first, that are independent of those kept.
 * They are not trusted: M does not fill their class later than the samples do, so their true radius
 * lies between 0 and Radius().
 *
 * @throws what SideClasses() throws; `features` is then as before.
 */
bool CompleteGenerators(const FeatureContext& context, LocatedFeatures& features);

}

#endif
