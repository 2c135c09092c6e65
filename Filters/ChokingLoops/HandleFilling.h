/**
 * @file HandleFilling.h
 * @brief A surface without its small handles and tunnels.
 */
#ifndef isthmus_HandleFilling_h
#define isthmus_HandleFilling_h

#include "ChokingLoops/ChokingLoops.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <optional>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// A membrane with a thickness: what fills a tunnel, or cuts a handle.

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

// ------------------------------------------------------------------------------------------
// A surface without its small handles and tunnels.
//
// Source: X. Feng, PhD thesis, chapter 6, names topological filtering as a use of choking loops:
// small tunnels filled, thin handles cut.

struct HandleFillingParameters
{
  /// Handles and tunnels with a smaller radius are removed. In the unit of the points.
  double Below = 0.0;
  /// Of what fills a tunnel, or of the gap that cuts a handle: in its radii.
  double Thickness = 0.25;
  bool Inside = true;  ///< cut handles
  bool Outside = true; ///< fill tunnels
  ChokingLoopParameters Analysis;
};

/// What was done about one handle or tunnel.
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
  std::vector<int> Filling; ///< one for each triangle: 1 + place in Fills; 0: of the surface given
  std::vector<HandleFill> Fills;
  std::int64_t Genus = 0; ///< of Mesh, all components together; it was by Fills.size() higher
  std::size_t Left = 0;   ///< handles and tunnels below the size that could not be filled
  RepairReport Repairs;
};

/**
 * Surgery along the membranes of the handles and tunnels (MakeLoopFeature()) with a radius below a
 * size, the smallest first. A tunnel's membrane, made a plate, is joined to what the surface
 * encloses, and a handle's is taken out of it. Each lowers the genus by one, which is held to, as
 * are the number of components and the volume (within a factor of 2 of the membrane's area times
 * the thickness); what fails that, or has several loops, is counted in Left, and the surface stays
 * as it was there.
 *
 * A handle and the tunnel it winds round go by one cut: of two that cross, the second waits until
 * what the first has left is analysed again.
 *
 * Away from the plates, the surface stays bit for bit. A plate is thinner by halves (an eighth at
 * most) where its edge would come out of the wall that holds it.
 *
 * @throws std::invalid_argument for a size that is not above 0, a thickness not in (0, 1], and as
 * ChokingLoops does; Cancelled.
 * Time: one ChokingLoops for each round (mostly one or two), and O(n log n) for each plate.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT FilledSurface FillHandles(TriangleMesh surface,
  const HandleFillingParameters& parameters, const ProgressCallback& progress = {});

}

#endif
