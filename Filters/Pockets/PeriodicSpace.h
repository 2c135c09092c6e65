/**
 * @file PeriodicSpace.h
 * @brief The space between the atoms of a crystal: its triangulation modulo the cell, and the
 * widest paths through it.
 *
 * Atoms and their images in and around one cell are triangulated. Coordinates are rounded so that
 * images are moved by exactly the cell's vectors; then the regular triangulation, which is unique
 * (ties are broken by the order of coordinates), repeats exactly as well. A tetrahedron belongs to
 * the triangulation of the infinite crystal if its orthogonal sphere lies within the block of
 * images, so the block is enlarged until this holds for one copy of each. Tetrahedra that differ by
 * vectors of the cell are one tetrahedron of the result, and each of its faces has the shift by
 * which the neighbour is reached.
 */
#ifndef isthmus_PeriodicSpace_h
#define isthmus_PeriodicSpace_h

#include "Atoms/Ball.h"
#include "Atoms/PeriodicCell.h"
#include "Pockets/CellAccessibility.h"

#include <functional>
#include <map>
#include <vector>

namespace isthmus
{

/// An atom of the input, or one of its copies.
struct AtomImage
{
  std::size_t Atom;
  CellShift Shift; ///< from the copy in the cell

  friend bool operator<(const AtomImage& a, const AtomImage& b)
  {
    return a.Atom != b.Atom ? a.Atom < b.Atom : a.Shift < b.Shift;
  }
};

/// A face of a tetrahedron.
struct PeriodicFace
{
  TetrahedronId Cell = TetrahedronId::None();
  std::size_t Corner = 0; ///< opposite to it
};

/// The widest way along one vector of the cell.
struct PeriodicPassage
{
  double Radius = 0.0;    ///< of the largest ball that passes
  PeriodicFace Narrowest; ///< the triangle that closes the way
};

struct PeriodicSpace
{
  explicit PeriodicSpace(const PeriodicCell& cell)
    : Cell(cell)
  {
  }

  PeriodicCell Cell; ///< with rounded vectors
  /// Points are images (as in Images); tetrahedra, triangles and their values are those of one
  /// cell. There are no edges. A tetrahedron may be its own neighbour, or twice that of another.
  RegularFiltration Filtration;
  std::vector<AtomImage> Images;
  FacesByCell Faces;
  /// For each face, by how much the stored copy of the neighbour is moved to be adjacent.
  HandleVector<TetrahedronId, std::array<CellShift, 4>> Steps;
  /// Empty space of each tetrahedron.
  HandleVector<TetrahedronId, EmptyCell> Empty;
  /// *Access*: the radius of the largest ball that gets there from infinitely far. TowardsOutside
  /// is not set.
  CellAccessibility Access;
  /// Along each vector of the cell: over all paths from a place to a copy of it that is displaced
  /// by a multiple of this vector.
  std::array<PeriodicPassage, 3> Passages;

  /// The tetrahedron with the largest clearance.
  TetrahedronId Widest() const;
  /// The tetrahedron with its atoms moved by whole cells; images are added where they are missing.
  void Move(TetrahedronId id, const CellShift& shift);

  std::map<AtomImage, SimplexId> NumberOfImage;
};

/**
 * Atoms enlarged by `probe`, in a periodic cell. All atoms within `reach` of the center of a
 * tetrahedron are among the images. O(n log n) in the images, whose number grows with the largest
 * empty ball.
 *
 * @throws std::invalid_argument if there is no atom.
 */
PeriodicSpace MakePeriodicSpace(const std::vector<Ball>& atoms, const PeriodicCell& cell,
  double probe, double reach, const std::function<void(double)>& predicted,
  const ProgressCallback& progress = {});

}

#endif
