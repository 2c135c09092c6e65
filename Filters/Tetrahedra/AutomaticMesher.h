/**
 * @file AutomaticMesher.h
 * @brief Tetrahedra for any surface that looks closed: the way that moves it least is tried first.
 */
#ifndef isthmus_AutomaticMesher_h
#define isthmus_AutomaticMesher_h

#include "Core/TetrahedralMesh.h"
#include "Tetrahedra/TetrahedralMesher.h"
#include "vtkIsthmusFiltersTetrahedraModule.h"

namespace isthmus
{

enum class MeshingWay
{
  TetGen,         ///< on the surface as it is
  RepairedTetGen, ///< on the surface as RepairSurface leaves it
  RepairedCGAL,   ///< a new surface close to that one
  Stuffing        ///< a new surface where the winding number is half
};

struct AutomaticMesh
{
  TetrahedralMesh Mesh; ///< OriginalPoints: of the surface given
  MeshingWay Way = MeshingWay::TetGen;
  std::string Report;     ///< the way gone, why not another, how far the surface moved
  std::string Changes;    ///< what repair changed on that way; else empty
  double Hausdorff = 0.0; ///< between the surface and the skin of the solids
  /// Enclosed by the triangles given, turned alike: holes are closed by cones to the middle of
  /// their box, what they enclose twice counts twice.
  double VolumeBefore = 0.0;
  double VolumeAfter = 0.0; ///< of the solids
  /// These two differ by more than a hundredth: what the surface encloses is a matter of how its
  /// holes and crossings are understood. The report says so.
  bool IsDoubtful = false;
};

/**
 * Goes on to the next way whenever one ends in an error or passes a limit: TetGen (the surface
 * stays), TetGen after RepairSurface, CGAL after it, and isosurface stuffing (IsosurfaceStuffing.h)
 * of the place where the winding number (WindingNumber.h) is above one half, which needs nothing of
 * the surface.
 *
 * Each run of TetGen has a quarter of `parameters.TetGen.Limits.Seconds`; memory has its limit
 * (stuffing: Limits.Bytes, too). Stuffing takes cells of CGAL.CellSize, or a hundredth of the
 * diagonal; it has region 1 for all solids and 0 for all
 * else. A repair that loses parts of the surface (farther from it than a fiftieth of the diagonal)
 * is not taken.
 *
 * @throws std::invalid_argument on parameters out of range, and when nothing is enclosed, with what
 * is wrong with the surface; Cancelled.
 */
VTKISTHMUSFILTERSTETRAHEDRA_EXPORT AutomaticMesh AutomaticTetrahedra(const SurfaceView& surface,
  const TetrahedralParameters& parameters, const ProgressCallback& progress = {});

}

#endif
