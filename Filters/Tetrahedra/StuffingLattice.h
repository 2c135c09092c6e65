/**
 * @file StuffingLattice.h
 * @brief The lattice of isosurface stuffing: values, octree, tetrahedra, points moved to the
 * surface.
 */
#ifndef isthmus_StuffingLattice_h
#define isthmus_StuffingLattice_h

#include "Core/Geometry.h"
#include "Core/MemoryBudget.h"
#include "Core/Progress.h"
#include "Tetrahedra/MeshedSide.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// Parameters and constants of isosurface stuffing.

struct StuffingParameters
{
  double CellSize = 0.0; ///< side of the cubes of the lattice, a length; 0: the caller chooses one
  int GradingLevels = 0; ///< away from the surface cubes may be up to 2^levels as large; 0: uniform
  MeshedSide Side = MeshedSide::Inside;
  double Margin = 0.0; ///< length by which the box exceeds the bounds; three cells at least
  MemoryBudget Memory = MemoryBudget::ForBytes(0); ///< of the lattice; ForBytes(0): no limit
};

/// A lattice point is moved onto the surface if it is nearer than this fraction of an edge of the
/// lattice. Of the pairs of fractions that were compared, this one has the largest minimum angle
/// over all positions of the surface, random ones and extremes (TestIsosurfaceStuffing).
constexpr double StuffingAlphaLong = 0.28;
constexpr double StuffingAlphaShort = 0.392;

/// Bounds on all dihedral angles in degrees: the published ones.
constexpr double StuffingSmallestAngle = 10.78;
constexpr double StuffingLargestAngle = 164.74;

//--------------------------------------------------------------------------------------------------
// The body-centered cubic lattice of isosurface stuffing, its values and its octree.
//
// Positions on the lattice are in halves of a cell: corners of cells have three even numbers,
// centers three odd ones. Centers of larger cells and midpoints of their edges coincide with
// corners of the finest cells, so that one table of values is sufficient for all sizes.

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
  /// with both figures if Memory is exceeded.
  StuffingLattice(const Bounds3& bounds, const StuffingParameters& parameters);

  /// Bytes that Sample() and Grade() will take.
  double Bytes() const;

  /// Values at all corners and centers, in parallel; then marks the cells near the surface.
  void Sample(const std::function<double(const Point3&)>& field, const ProgressCallback& progress);

  /// Merges cells away from the surface, up to 2^levels; neighbours differ by at most one level.
  void Grade(int levels);

  const std::array<std::int64_t, 3>& Cells() const { return this->Count; }
  Point3 Position(const LatticePoint& p) const;

  /// Index in the table of values; -1 for positions that are neither a corner nor a center of a
  /// finest cell.
  std::int64_t Node(const LatticePoint& p) const;
  std::int64_t Nodes() const { return this->Corners + this->Centers; }
  LatticePoint GetPoint(std::int64_t node) const;
  double Value(std::int64_t node) const { return this->Values[static_cast<std::size_t>(node)]; }
  bool IsInside(std::int64_t node) const { return this->Value(node) > 0.0; }

  std::int64_t Cell(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return i + this->Count[0] * (j + this->Count[1] * k);
  }
  /// Whether a node is within two layers of cells around a cell that the surface crosses; these
  /// contain all tetrahedra that the surface may change.
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
  std::int64_t Centers = 0;
  std::vector<double> Values;
  std::vector<unsigned char> Near;
  std::vector<unsigned char> Levels; ///< of the octant each finest cell belongs to; empty: all 0
};

//--------------------------------------------------------------------------------------------------
// The tetrahedra of the graded body-centered cubic lattice.
//
// Labelle and Shewchuk, 2007, section 4. Between two octants of the same size, four tetrahedra
// share the edge between their centers (cut in two where an edge of the face is split by smaller
// neighbours). A face to smaller octants, or to the outside of the box, is a fan around its
// midpoint. A face to a larger octant is cut by the diagonal through the midpoint of the larger
// face. All dihedral angles are from 45 to 135 degrees.

/// An octant, given by its first finest cell and its side in finest cells.
struct Octant
{
  LatticePoint First;
  int Level;

  std::int64_t Side() const { return std::int64_t{ 1 } << this->Level; }
  LatticePoint Center() const
  {
    const std::int64_t s = this->Side();
    return { 2 * this->First[0] + s, 2 * this->First[1] + s, 2 * this->First[2] + s };
  }
};

/// The tetrahedra that one octant, and not a neighbour, has to create: at most 48.
class StuffingBackground
{
public:
  explicit StuffingBackground(const StuffingLattice& lattice)
    : Lattice(lattice)
  {
  }

  /// Appends the tetrahedra of `octant` to `out`. Their orientation is not fixed.
  void Append(const Octant& octant, std::vector<LatticeTetrahedron>& out) const;

  /// Calls visit(octant) for each octant that begins in layer k of the finest cells.
  template <typename Visit>
  void ForEachOctant(std::int64_t k, Visit&& visit) const
  {
    const auto& n = this->Lattice.Cells();
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        const Octant octant{ { i, j, k }, this->Lattice.Level({ i, j, k }) };
        if (((i | j | k) & (octant.Side() - 1)) == 0)
        {
          visit(octant);
        }
      }
    }
  }

private:
  using Face = std::array<LatticePoint, 4>;

  void AppendFan(
    const Octant& octant, const Face& face, std::vector<LatticeTetrahedron>& out) const;
  void AppendHalves(const Octant& octant, const Octant& larger, const Face& face,
    std::vector<LatticeTetrahedron>& out) const;
  bool IsSplit(const LatticePoint& a, const LatticePoint& b, int level) const;

  /// Visits the parts of the edge a b: one, or two where a smaller octant has a corner in between.
  template <typename Visit>
  void ForEachPart(const LatticePoint& a, const LatticePoint& b, int level, Visit&& visit) const
  {
    if (!this->IsSplit(a, b, level))
    {
      visit(a, b);
      return;
    }
    const LatticePoint middle{ (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 };
    visit(a, middle);
    visit(middle, b);
  }

  const StuffingLattice& Lattice;
};

//--------------------------------------------------------------------------------------------------
// Which lattice points are moved onto the surface, and where the surface cuts the rest.

/// Side of a lattice point: 1 inside, -1 outside, 0 if it was moved onto the surface.
class StuffingWarp
{
public:
  /// Moves each point whose nearest crossing of the surface with one of its edges (by linear
  /// interpolation) is within the alphas to that crossing, all points at once and in parallel.
  StuffingWarp(const StuffingLattice& lattice, const ProgressCallback& progress);

  int Side(const LatticePoint& p) const;
  Point3 Position(const LatticePoint& p) const;
  /// Crossing on the edge between two points on different sides, neither of which was moved.
  Point3 Crossing(const LatticePoint& a, const LatticePoint& b) const;

  /// How far a point is moved.
  double MoveLength(const LatticePoint& p) const;
  /// Moves a point back; crossings that are too near to it are moved away, to the distances of the
  /// alphas.
  void Keep(const LatticePoint& p);
  /// Number of calls of Keep() so far.
  std::int64_t NumberOfUnmoved() const { return this->StayedCount; }

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
