/**
 * @file StuffingWarp.h
 * @brief Which lattice points are moved onto the surface, and where the surface cuts the rest.
 */
#ifndef isthmus_StuffingWarp_h
#define isthmus_StuffingWarp_h

#include "Tetrahedra/StuffingLattice.h"

#include <vector>

namespace isthmus
{

/// Side of a lattice point: inside 1, outside -1, moved onto the surface 0.
class StuffingWarp
{
public:
  /// Moves each point whose nearest crossing of the surface with one of its edges (by linear
  /// interpolation) is within the alphas to that crossing, all points at once and in parallel.
  StuffingWarp(const StuffingLattice& lattice, const ProgressCallback& progress);

  int Side(const LatticePoint& p) const;
  Point3 Position(const LatticePoint& p) const;
  /// Crossing on the edge between two points of different sides, neither of them moved.
  Point3 Crossing(const LatticePoint& a, const LatticePoint& b) const;

  /// How far a point is moved.
  double MoveLength(const LatticePoint& p) const;
  /// Moves a point back; crossings too near to it are put off to the alphas.
  void Keep(const LatticePoint& p);
  /// Calls of Keep() so far.
  std::int64_t Stayed() const { return this->StayedCount; }

private:
  static constexpr unsigned char Unmoved = 255;

  unsigned char NearestCrossing(const LatticePoint& p, std::int64_t node) const;
  double FractionFrom(std::int64_t node, std::int64_t other) const;

  const StuffingLattice& Lattice;
  std::vector<unsigned char> Edge; ///< of each node: along which it is moved
  std::int64_t StayedCount = 0;
};

}

#endif
