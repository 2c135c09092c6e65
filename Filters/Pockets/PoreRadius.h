/**
 * @file PoreRadius.h
 * @brief The radius of a pore: the largest ball between atoms with its center in a plane across the
 * pore.
 */
#ifndef isthmus_PoreRadius_h
#define isthmus_PoreRadius_h

#include "Atoms/Ball.h"
#include "Atoms/PointBins.h"
#include "vtkIsthmusFiltersPocketsModule.h"

#include <vector>

namespace isthmus
{

/// Atoms with a spatial index, for the clearance around a place.
class AtomField
{
public:
  explicit AtomField(const std::vector<Ball>& atoms);

  /// Distance of `place` from the nearest atom's surface, and that atom. The search is faster the
  /// closer the guess is to that distance.
  struct Clearance
  {
    double Radius;
    std::int64_t Atom;
  };
  VTKISTHMUSFILTERSPOCKETS_EXPORT Clearance At(const Point3& place, double guess = 0.0) const;

  /// The atoms whose surface is within `reach` of `place`.
  std::vector<Ball> Near(const Point3& place, double reach) const;

  /// The numbers of these atoms, unordered.
  std::vector<std::int64_t> Touching(const Point3& place, double reach) const;

private:
  const std::vector<Ball>& Atoms;
  double Largest = 0.0;
  PointBins Bins;
};

struct Plane
{
  Point3 Origin;
  Point3 Normal; ///< of length 1
};

struct PlaneBall
{
  Point3 Center;
  double Radius;
};

/// Limits of a climb.
struct Climb
{
  double Reach;           ///< from the start
  double Enough;          ///< radius at which the climb stops
  double Tolerance;       ///< length of the last step
  double Clearance = 0.0; ///< approximate clearance at the start, if known; saves time
};

/**
 * Climbs from `start` to a local maximum, within the plane, of the distance from the nearest atom's
 * surface.
 *
 * The distance is the least of smooth functions. Each step maximises the minimum of their linear
 * models in a square whose size is adapted to the success of the step. The last steps converge
 * quadratically to a point where three atoms touch the ball. About 30 steps.
 */
PlaneBall ClimbInPlane(
  const AtomField& atoms, const Plane& plane, const Point3& start, const Climb& climb);

/// The best result of climbs from `starts` and from places around the first one within a ball of
/// radius `width`.
PlaneBall LargestBallInPlane(const AtomField& atoms, const Plane& plane,
  const std::vector<Point3>& starts, double width, double enough);

}

#endif
