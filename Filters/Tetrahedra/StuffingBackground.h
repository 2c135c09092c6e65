/**
 * @file StuffingBackground.h
 * @brief The tetrahedra of the graded body-centred cubic lattice.
 *
 * Labelle and Shewchuk, 2007, section 4. Between two octants of one size four tetrahedra share the
 * edge of their centres (cut in two where an edge of the face is split by smaller neighbours). A
 * face to smaller octants, or to the outside of the box, is a fan about its middle; a face to a
 * larger octant is cut by the diagonal through the larger face's middle. All dihedral angles are
 * from 45 to 135 degrees.
 */
#ifndef isthmus_StuffingBackground_h
#define isthmus_StuffingBackground_h

#include "Tetrahedra/StuffingLattice.h"

#include <vector>

namespace isthmus
{

/// The octant of a cell: its first finest cell and its side in finest cells.
struct Octant
{
  LatticePoint First;
  int Level;

  std::int64_t Side() const { return std::int64_t{ 1 } << this->Level; }
  LatticePoint Centre() const
  {
    const std::int64_t s = this->Side();
    return { 2 * this->First[0] + s, 2 * this->First[1] + s, 2 * this->First[2] + s };
  }
};

/// The tetrahedra of one octant that it, and not a neighbour, has to make: at most 48.
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

}

#endif
