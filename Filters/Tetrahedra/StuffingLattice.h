/**
 * @file StuffingLattice.h
 * @brief The body-centred cubic lattice of isosurface stuffing, its values and its octree.
 *
 * Positions on the lattice are in halves of a cell: corners of cells have three even numbers,
 * centres three odd ones. Centres of larger cells and middles of their edges fall on corners of the
 * finest ones, so that one table of values serves every size.
 */
#ifndef isthmus_StuffingLattice_h
#define isthmus_StuffingLattice_h

#include "Core/Geometry.h"
#include "Core/Progress.h"
#include "Tetrahedra/StuffingParameters.h"

#include <functional>
#include <vector>

namespace isthmus
{

using LatticePoint = std::array<std::int64_t, 3>;
using LatticeTetrahedron = std::array<LatticePoint, 4>;

/// The fourteen edges at a lattice point: six long ones along the axes, eight short ones.
constexpr std::size_t LatticeEdges = 14;
extern const std::array<LatticePoint, LatticeEdges> LatticeSteps;

class StuffingLattice
{
public:
  /// Cells that cover `bounds` and the margin.
  /// @throws std::invalid_argument for more than 2^18 cells along an axis, and std::runtime_error
  /// with both figures where MaximumBytes is passed.
  StuffingLattice(const Bounds3& bounds, const StuffingParameters& parameters);

  /// Bytes that Sample() and Grade() will take.
  double Bytes() const;

  /// Values at all corners and centres, in parallel; then marks the cells near the surface.
  void Sample(const std::function<double(const Point3&)>& field, const ProgressCallback& progress);

  /// Merges cells away from the surface, up to 2^levels, neighbours differing by one level at most.
  void Grade(int levels);

  const std::array<std::int64_t, 3>& Cells() const { return this->Count; }
  Point3 Position(const LatticePoint& p) const;

  /// Place in the table of values; -1 for what is neither a corner nor a centre of a finest cell.
  std::int64_t Node(const LatticePoint& p) const;
  std::int64_t Nodes() const { return this->Corners + this->Centres; }
  LatticePoint PointOf(std::int64_t node) const;
  double Value(std::int64_t node) const { return this->Values[static_cast<std::size_t>(node)]; }
  bool IsInside(std::int64_t node) const { return this->Value(node) > 0.0; }

  std::int64_t Cell(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return i + this->Count[0] * (j + this->Count[1] * k);
  }
  /// Two layers of cells around each that the surface crosses: all tetrahedra that it may change.
  bool IsNear(std::int64_t cell) const { return this->Near[static_cast<std::size_t>(cell)] != 0; }
  bool IsNear(const LatticePoint& node) const;
  int Level(const LatticePoint& cell) const
  {
    return this->Levels.empty()
      ? 0
      : this->Levels[static_cast<std::size_t>(this->Cell(cell[0], cell[1], cell[2]))];
  }

private:
  void MarkCrossed(std::int64_t layer);
  void Dilate();

  std::array<std::int64_t, 3> Count{ 0, 0, 0 };
  Point3 Origin{ 0, 0, 0 };
  double Size = 1.0;
  std::int64_t Corners = 0;
  std::int64_t Centres = 0;
  std::vector<double> Values;
  std::vector<unsigned char> Near;
  std::vector<unsigned char> Levels; ///< of the octant each finest cell belongs to; empty: all 0
};

}

#endif
