/**
 * @file LineCorners.h
 * @brief Which points of the boundaries and feature lines of a surface have to stay. Private: only
 * for files that use CGAL.
 *
 * D. H. Douglas, T. K. Peucker, Cartographica 10 (1973) 112, doi:10.3138/FM57-6770-U75U-7727.
 */
#ifndef isthmus_LineCorners_h
#define isthmus_LineCorners_h

#include "Remeshing/CGALSurface.h"

#include <vector>

namespace isthmus::cgal
{

/// A boundary or feature line from one corner to the next one.
struct LineBetweenCorners
{
  std::vector<SurfaceMesh::Vertex_index> Points; ///< both ends included
  std::vector<SurfaceMesh::Edge_index> Edges;    ///< one fewer
};

/**
 * Lines of the edges for which `isLine[edge]`, cut at their corners: points at which other than two
 * such edges meet or two at an acute angle, and the points of a polyline that is nowhere farther
 * than `tolerance` (100 times that for lines inside) from the line. A closed line has at least two
 * corners. All other points may be moved along the line, or removed. O(n log n), O(n^2) at worst.
 * @pre `mesh` has no removed elements
 */
std::vector<LineBetweenCorners> CutLinesAtCorners(
  const SurfaceMesh& mesh, const std::vector<bool>& isLine, double tolerance);

}

#endif
