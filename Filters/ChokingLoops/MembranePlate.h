/**
 * @file MembranePlate.h
 * @brief A membrane with a thickness: what fills a tunnel, or cuts a handle.
 */
#ifndef isthmus_MembranePlate_h
#define isthmus_MembranePlate_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <optional>

namespace isthmus
{

/// A closed solid that faces outward.
struct MembranePlate
{
  TriangleMesh Solid;       ///< all of its points are at its edge
  std::vector<Point3> Loop; ///< the loop that it spans, evenly spaced
  double Area = 0.0;        ///< of the membrane, within the loop
  double Thickness = 0.0;
};

/**
 * The filling of least area of a closed curve (PolygonFilling()), continued beyond the curve by
 * `rim` within its surface and made `thickness` thick, half to either side. Nothing where the
 * filling fails or the plate crosses itself.
 *
 * The curve is taken at points no farther apart than half of `rim`, between 32 and 256 of them.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::optional<MembranePlate> PlateOn(
  const std::vector<Point3>& loop, double thickness, double rim);

}

#endif
