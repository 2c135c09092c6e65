/**
 * @file HandleFilling.h
 * @brief A surface without its small handles and tunnels.
 */
#ifndef isthmus_HandleFilling_h
#define isthmus_HandleFilling_h

#include "ChokingLoops/ChokingLoops.h"
#include "Core/TriangleMesh.h"

#include <optional>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// A thickened membrane, which fills a tunnel or cuts a handle.

/// A closed solid that faces outward.
struct MembranePlate
{
  TriangleMesh Solid;       ///< all of its points are at the edge of the plate
  std::vector<Point3> Loop; ///< the loop that the membrane spans, evenly spaced
  double Area = 0.0;        ///< of the membrane, within the loop
  double Thickness = 0.0;
};

/**
 * The filling of least area of a closed curve (PolygonFilling()), extended beyond the curve by
 * `rim` and thickened to `thickness`, half to either side. Empty if the filling fails or the plate
 * intersects itself.
 *
 * The curve is sampled at 32 to 256 points, where possible no farther apart than half of `rim`.
 */
std::optional<MembranePlate> PlateOn(const std::vector<Point3>& loop, double thickness, double rim);

// ------------------------------------------------------------------------------------------
// A surface without its small handles and tunnels.
//
// Source: X. Feng, PhD thesis, chapter 6, names topological filtering as a use of choking loops:
// small tunnels filled, thin handles cut.

/// The filling of one handle or tunnel.
struct HandleFill
{
  FeatureKind Kind = FeatureKind::Handle;
  double Radius = 0.0;    ///< of the ball that got stuck there
  double Area = 0.0;      ///< of the membrane
  double Thickness = 0.0; ///< of the plate
};

struct FilledSurface
{
  TriangleMesh Mesh;        ///< faces outward
  std::vector<int> Filling; ///< per triangle: 1 + index in Fills; 0: from the input surface
  std::vector<HandleFill> Fills;
  std::int64_t Genus =
    0; ///< of Mesh, all components together; lower by Fills.size() than that of the input
  std::size_t Left = 0; ///< handles and tunnels below the size that could not be filled
  RepairReport Repairs;
};

/**
 * Removes the handles and tunnels with a radius below a size, the smallest first, by surgery along
 * their membranes (MakeLoopFeature()). The plate of a tunnel is added to the solid that the surface
 * encloses, that of a handle is subtracted from it. Each operation must lower the genus by one,
 * keep the number of components, and change the volume by the membrane's area times the thickness
 * (within a factor of 2). If it does not, or if the feature has several loops, the surface is not
 * changed there and the feature is counted in Left.
 *
 * One cut removes a handle together with the tunnel that it surrounds: if two membranes cross, the
 * second is postponed until the surface has been analysed again after the first cut.
 *
 * Away from the plates the surface is bitwise unchanged. A plate is thinned by factors of two, down
 * to an eighth, where its edge would otherwise protrude from the wall that holds it.
 *
 * @throws everything that Check() and ChokingLoops throw; Cancelled. Time: one ChokingLoops per
 * round (usually one or two), and O(n log n) per plate.
 */
FilledSurface FillHandles(TriangleMesh surface, const HandleFillingParameters& parameters,
  const ProgressCallback& progress = {});

}

#endif
