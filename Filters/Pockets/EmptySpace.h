/**
 * @file EmptySpace.h
 * @brief Empty volume of each tetrahedron between balls, and the surface of the balls facing it.
 *
 * With K the dual complex of the balls' union (the simplices of value 0 and less), the volume of
 * the union is the alternating sum over K of the intersections of the balls of a simplex: single
 * balls - intersections of two (lenses) + of three - of four (H. Edelsbrunner, Discrete Comput.
 * Geom. 13 (1995) 415). Each term is divided among the tetrahedra around its simplex in proportion
 * to their angles there. A tetrahedron of K is full; the empty volume of any other one is
 *
 *   volume - sum of sectors + sum of slices of lenses - sum of halves of intersections of three,
 *
 * and similarly for the area of each atom. The value of a single tetrahedron may be negative. Sums
 * over the tetrahedra of a void are exact; where a region ends at a mouth, balls are divided by
 * sectors and not by the mouth's triangles, so that the parts of any division of space add up to
 * the whole.
 */
#ifndef isthmus_EmptySpace_h
#define isthmus_EmptySpace_h

#include "Atoms/BallOverlap.h"
#include "Core/Progress.h"
#include "Persistence/RegularFiltration.h"

namespace isthmus
{

struct EmptyCell
{
  double Volume = 0.0;          ///< outside all balls
  std::array<double, 4> Area{}; ///< area of the balls' surface, by the tetrahedron's corners
};

/// The triangle opposite to each corner of each tetrahedron.
using FacesByCell = HandleVector<TetrahedronId, std::array<TriangleId, 4>>;

/// The empty space of tetrahedron `cell`, which must not belong to K (its value is above 0). About
/// 3 us.
EmptyCell MeasureEmptySpace(
  const RegularFiltration& f, const FacesByCell& faces, TetrahedronId cell);

FacesByCell FacesOfCells(const CellFiltration& complex);

/**
 * The area of a triangle outside the discs around its corners, by Green's theorem along its border:
 * exact also where a disc reaches across the opposite edge or contains another one. In the square
 * of the unit of `corners` and `radii`; a radius of 0 means no disc. Constant time.
 */
double MeasureOpenArea(const std::array<Point3, 3>& corners, const std::array<double, 3>& radii);

/// Volume and surface of the union of all balls.
struct UnionMeasure
{
  double Volume = 0.0;
  double Area = 0.0;
};

/**
 * The union of the balls of `f`; `empty` holds MeasureEmptySpace() each tetrahedron (zeros for
 * those of K). Needs at least one tetrahedron. @throws Cancelled
 */
UnionMeasure MeasureUnion(const RegularFiltration& f,
  const HandleVector<TetrahedronId, EmptyCell>& empty, const ProgressCallback& progress = {});

/**
 * The union of any number of balls that have no tetrahedron, since their centers lie in one plane
 * or line or are fewer than four: the alternating sum over the dual complex, which contains no
 * tetrahedra. The triangulation includes six balls of radius 0 far away, which add nothing to the
 * union. @throws Cancelled
 */
UnionMeasure MeasureFlatUnion(
  std::vector<Point3> centers, std::vector<double> radii, const ProgressCallback& progress = {});

}

#endif
