/**
 * @file ContourPlaces.h
 * @brief Where in its cell, or in an empty one beside it, a point of dual contouring goes.
 *
 * It goes where the planes of its crossings meet best. Where that is outside its cell, in one that
 * no crossing bounds, it may stay there: an edge that pokes through a face of a cell without
 * crossing a line of the grid has its point there, and nobody else has one. It may go to any cell
 * beside its own where no edges are known and all its planes, more than would meet by themselves,
 * pass within 0.02 spacings of one point of an edge or corner. Otherwise it is kept in its cell.
 * Where sharp edges or corners of the surface are known, it goes to the one in that cell that fits
 * its planes best, which is exact where these, of faces that bend, are not; into the cell beside
 * its own only where they pass within 0.05 spacings of that edge.
 */
#ifndef isthmus_ContourPlaces_h
#define isthmus_ContourPlaces_h

#include "Contouring/HermiteGrid.h"
#include "Contouring/DualCells.h"
#include "Contouring/QuadricError.h"

namespace isthmus
{

struct ContourPlace
{
  Point3 At;
  bool IsSharp; ///< on a sharp edge or corner that was known
};

class ContourPlaces
{
public:
  /// The arguments are kept by reference.
  ContourPlaces(
    const HermiteGrid& grid, const DualCells& cells, const DualContouringParameters& parameters);

  /// For piece `i` of the `count` pieces in the active cell `cell` with these planes, which are the
  /// tangent ones or those that meet better (MeetingPlanes.h). O(log n)
  ContourPlace Place(
    std::int64_t cell, const QuadraticErrors* pieces, std::size_t count, std::size_t i) const;
  /// The same, but in the cell, whatever is in the others.
  Point3 Inside(std::int64_t cell, const QuadraticErrors& planes) const;

private:
  bool IsEmpty(std::int64_t cell) const;
  /// Do the planes pass within `spacings` of `x`, in the mean of squares?
  bool PassBy(const QuadraticErrors& planes, const Point3& x, double spacings) const;
  /// Are there more planes than an edge or corner needs, and do all pass by `x`?
  bool MeetOnEdge(const QuadraticErrors& planes, const Point3& x) const;

  const HermiteGrid& Grid;
  const DualCells& Cells;
  const DualContouringParameters& Parameters;
  const ContourFeatures Features;
};

}

#endif
