/**
 * @file AutomaticMesher.h
 * @brief Tetrahedra for any surface that looks closed, by the backend that moves the surface least.
 */
#ifndef isthmus_AutomaticMesher_h
#define isthmus_AutomaticMesher_h

#include "Core/Progress.h"
#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "Tetrahedra/MeshedSide.h"
#include "Tetrahedra/TetrahedralMesher.h"

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// Isosurface stuffing of the region that a triangle soup encloses, by its winding number.

struct SolidStuffingParameters
{
  double CellSize = 0.0; ///< a length; 0: a hundredth of the diagonal
  MeshedSide Side = MeshedSide::Inside;
  double BoxMargin = 0.5;         ///< Outside, Both: in diagonals of the surface's box
  std::uint64_t MaximumBytes = 0; ///< of the lattice; 0: no limit
};

/**
 * Meshes the space in which the winding number of `soup` is above one half, whatever its
 * orientation, with tetrahedra: region 1 inside, 0 outside. The distances to the soup determine the
 * position of the new surface between the points of the lattice, so that it is the old surface
 * where that is closed, and spans the holes.
 *
 * Cost: two winding numbers for each cell, by a tree, in parallel.
 * @pre corners exist and are finite.
 * @throws std::invalid_argument if nothing is enclosed; otherwise as IsosurfaceStuffing.
 */
TetrahedralMesh StuffSolid(const SurfaceView& soup, const SolidStuffingParameters& parameters,
  const ProgressCallback& progress = {});

enum class MeshingBackend
{
  TetGen,         ///< on the surface as it is
  RepairedTetGen, ///< on the surface as RepairSurface leaves it
  RepairedCGAL,   ///< a new surface close to that one
  Stuffing        ///< a new surface where the winding number is half
};

struct AutomaticMesh
{
  TetrahedralMesh Mesh; ///< OriginalPoints: of the surface given
  MeshingBackend Backend = MeshingBackend::TetGen;
  std::string Report;     ///< the backend, why others failed, how far the surface moved
  std::string Changes;    ///< what repair changed, if it was used; else empty
  double Hausdorff = 0.0; ///< between the surface and the boundary of the solids
  /// Volume enclosed by the input triangles after consistent orientation. Holes are closed by cones
  /// to the middle of their box; regions that are enclosed twice count twice.
  double VolumeBefore = 0.0;
  double VolumeAfter =
    0.0; ///< of the solids These two differ by more than a hundredth: the enclosed volume depends
         ///< on how holes and crossings are interpreted, as the report states.
  bool IsDoubtful = false;
};

/**
 * Backends are tried until one neither fails nor exceeds a limit: TetGen (the surface is kept),
 * TetGen after RepairSurface, CGAL after RepairSurface, and isosurface stuffing
 * (IsosurfaceStuffing.h) of the region in which the winding number (WindingNumber.h) is above one
 * half, which makes no assumptions about the surface.
 *
 * Each run of TetGen may take a quarter of `parameters.TetGen.Limits.TimeLimit`; its memory limit
 * is Limits.Bytes, also for stuffing. Stuffing uses cells of CGAL.CellSize, or a hundredth of the
 * diagonal, and has region 1 for all solids and 0 for everything else. A repair that loses parts of
 * the surface (farther from it than a fiftieth of the diagonal) is not used.
 *
 * @throws std::invalid_argument on parameters out of range, and when nothing is enclosed, with what
 * is wrong with the surface; Cancelled.
 */
AutomaticMesh AutomaticTetrahedra(const SurfaceView& surface,
  const TetrahedralParameters& parameters, const ProgressCallback& progress = {});

}

#endif
