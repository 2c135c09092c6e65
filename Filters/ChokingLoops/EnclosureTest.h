/**
 * @file EnclosureTest.h
 * @brief Which components of a closed surface enclose a point?
 */
#ifndef isthmus_EnclosureTest_h
#define isthmus_EnclosureTest_h

#include "ChokingLoops/SurfaceHomology.h"
#include "Core/Bounds3.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/**
 * Counts the crossings of a ray, component by component, modulo 2: no orientation is needed, and a
 * ray through an edge is counted once, since both triangles decide by the same number.
 *
 * Building takes O(n), a query the triangles of one bin (some tens).
 */
class EnclosureTest
{
public:
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT EnclosureTest(
    const SurfaceView& mesh, const SurfaceHomology& homology);

  /// Ascending ids of the components that enclose `p`: an odd number of them means inside. Within
  /// rounding (1e-12 of the size) of the surface either answer may come.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<int> Enclosing(const Point3& p) const;

private:
  std::size_t Bin(double v, std::size_t axis) const;

  std::vector<Point3> Points; ///< turned into general position
  SurfaceView Mesh;
  const SurfaceHomology& Homology;
  Bounds3 Box;
  std::size_t Bins = 1;
  std::vector<SimplexId> First;
  std::vector<SimplexId> Inside;
};

}

#endif
