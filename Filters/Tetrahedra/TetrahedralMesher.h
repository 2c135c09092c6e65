/**
 * @file TetrahedralMesher.h
 * @brief Tetrahedra inside, outside or on both sides of a closed surface, by TetGen or by CGAL.
 *
 * TetGen: H. Si, ACM Trans. Math. Softw. 41 (2015) 11, doi:10.1145/2629697; run as a separate
 * program (TetGenTetrahedra.cxx). CGAL: P. Alliez et al., 3D Mesh Generation, CGAL 5.5 User and
 * Reference Manual; Delaunay refinement of J.-D. Boissonnat, S. Oudot, Graph. Models 67 (2005) 405.
 */
#ifndef isthmus_TetrahedralMesher_h
#define isthmus_TetrahedralMesher_h

#include "Core/ChildProcess.h"
#include "Core/Progress.h"
#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "Surfaces/ShellNesting.h"
#include "Tetrahedra/MeshedSide.h"
#include "vtkIsthmusFiltersTetrahedraModule.h"

#include <string>

namespace isthmus
{

enum class TetrahedralLibrary
{
  TetGen,
  CGAL
};

/// Criteria of TetGen. The switches are those in section 4.2 of its manual.
struct TetGenCriteria
{
  bool PreserveSurface =
    true; ///< no new point on the surface (Y): its triangles are faces of the mesh
  double RadiusEdgeRatio = 2.0; ///< circumradius / shortest edge at most (q), but for one in a
                                ///< thousand where shells are near each other; 0: no refinement
  double MinimumDihedralAngle = 0.0; ///< degrees (q/); 0: not requested
  double MaximumVolume = 0.0;        ///< of a tetrahedron (a), in cubed units of the data; 0: none
  std::string TetGenCommand = "tetgen"; ///< found on PATH
  ChildLimits Limits;
};

/// Criteria of CGAL (thesis, 4.4.1.5). Lengths are in units of the data; 0: a fortieth of the
/// diagonal of the surface's box for sizes, a tenth of the facet size for the distance.
struct CGALCriteria
{
  double FacetAngle = 25.0;         ///< smallest angle of a surface triangle, degrees, at most 30
  double FacetSize = 0.0;           ///< radius of the surface Delaunay ball at most
  double FacetDistance = 0.0;       ///< its center to the triangle's circumcenter at most
  double CellRadiusEdgeRatio = 2.0; ///< circumradius / shortest edge at most
  double CellSize = 0.0;            ///< circumradius of a tetrahedron at most
  std::int64_t MaximumPoints = 5'000'000; ///< refinement beyond it is an error
  // Optimisation after refinement, in this order. Steps with a time limit may not be reproducible.
  int LloydIterations = 0; ///< points to the middles of their Voronoi cells, at most 100
  int ODTIterations = 0;   ///< points to where tetrahedra follow |x|^2 best, at most 100
  double OptimisationTimeLimit = 60.0; ///< of Lloyd and of ODT at most, each
  double PerturbTimeLimit = 0.0;       ///< time limit for moving points of slivers; 0: not moved
  bool Exude = true;                   ///< removes slivers by weights of their points
};

struct TetrahedralParameters
{
  TetrahedralLibrary Library = TetrahedralLibrary::TetGen;
  MeshedSide Side = MeshedSide::Inside;
  double BoxMargin = 0.5; ///< Outside, Both: distance of surface and box, in diagonals of the
                          ///< surface's box
  bool Repaired = false;  ///< repair was tried: if defects remain, the message states that
  TetGenCriteria TetGen;
  CGALCriteria CGAL;
};

/**
 * Tetrahedra of the regions of ShellNesting on the requested side; Regions holds their ids (solids
 * 1, 2, ..., exterior 0, cavities -1, -2, ...).
 *
 * @pre `surface` is a closed, manifold, oriented surface without self-intersections, whatever way
 * it faces; all of that is checked first.
 * @throws std::invalid_argument with a message that names the defects and their triangles;
 * std::runtime_error when the library fails, runs out of memory or time, or gives tetrahedra that
 * do not fill the regions (TetGen with PreserveSurface: to 1e-9 of their volume); Cancelled.
 *
 * Cost: TetGen needs 220 bytes for each tetrahedron in its own process, and about the same amount
 * of disk space for text files. For times of both libraries see BenchMeshing.
 */
VTKISTHMUSFILTERSTETRAHEDRA_EXPORT TetrahedralMesh MeshTetrahedra(const SurfaceView& surface,
  const TetrahedralParameters& parameters, const ProgressCallback& progress = {});

/**
 * Text for a warning about tetrahedra that exceed the bounds of the library that made them: the
 * radius-edge ratio, and the volume for TetGen. Empty where they hold. O(tetrahedra).
 */
VTKISTHMUSFILTERSTETRAHEDRA_EXPORT std::string UnmetBounds(
  const TetrahedralMesh& mesh, const TetrahedralParameters& parameters);

/// Checks the parameters of the chosen library. @throws std::invalid_argument with the name, the
/// value and the range of an invalid parameter.
VTKISTHMUSFILTERSTETRAHEDRA_EXPORT void Check(const TetrahedralParameters& parameters);

/// The input of the two libraries: a checked surface, its regions, and the box if there is one.
struct TetrahedralTask
{
  SurfaceView Surface;
  const ShellNesting& Nesting;
  const TetrahedralParameters& Parameters;
  TriangleMesh Box;     ///< 12 triangles facing outward; empty for MeshedSide::Inside
  SpaceRegion Exterior; ///< between the surface and the box

  /// Whether the requested side includes the region with this id.
  bool IsWanted(int region) const
  {
    const MeshedSide side = this->Parameters.Side;
    return side == MeshedSide::Both || (region > 0) == (side == MeshedSide::Inside);
  }
};

/// TetGen on a checked surface (TetGenTetrahedra.cxx).
TetrahedralMesh TetGenTetrahedra(const TetrahedralTask& task, const ProgressCallback& progress);

/// CGAL's Mesh_3 on a checked surface (CGALTetrahedra.cxx).
TetrahedralMesh CGALTetrahedra(const TetrahedralTask& task, const ProgressCallback& progress);

}

#endif
