/**
 * @class vtkTetrahedralMesher
 * @brief Fills a closed surface, or the box around it, with tetrahedra: TetGen, CGAL, stuffing.
 *
 * Input: vtkPolyData, a closed, manifold, oriented surface without self-intersections (polygons are
 * triangulated), of any number of components, some of which may be cavities of others. It is
 * checked first; errors name the ids of the triangles, and defects are repaired if Repair is on.
 *
 * Output: vtkUnstructuredGrid of tetrahedra in the units of the surface. Cell array `RegionId`
 * (int): solids 1, 2, ..., exterior 0, cavities -1, -2, ... Point array OriginalPointId
 * (vtkIdType): the id of the point in the surface, or -1. Field data of the input are kept. After a
 * repair, the string Repair states what was changed. If tetrahedra exceed the bounds below, the
 * string UnmetBounds states by how much, and the same text is issued as a warning. With Automatic
 * there are the field arrays `Engine` (string: the backend used), `EngineReport` (string: the
 * reason, and how far the surface moved; also issued as a warning if it moved),
 * `HausdorffDistance`, `VolumeBefore` and `VolumeAfter` (of the solids), `VolumeIsDoubtful` (1
 * where these differ by more than a hundredth, else 0); by stuffing, RegionId is 1 in solids and 0
 * elsewhere.
 *
 * TetGen (H. Si, doi:10.1145/2629697) runs as a separate program, the command `tetgen` of the
 * Debian package of that name, within TimeLimit and MemoryLimit; it is killed on abort. CGAL
 * (Mesh_3) runs in this process; it makes a new surface within FacetDistance of the input and
 * rounds sharp edges.
 *
 * On failure, there is one error through vtkErrorMacro and the output is empty. Cost: see
 * TetrahedralMesher.h. The whole surface is needed on one rank.
 */
#ifndef vtkTetrahedralMesher_h
#define vtkTetrahedralMesher_h

#include "Core/Deprecation.h"
#include "vtkIsthmusFiltersTetrahedraModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <string>

class VTKISTHMUSFILTERSTETRAHEDRA_EXPORT vtkTetrahedralMesher : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkTetrahedralMesher* New();
  vtkTypeMacro(vtkTetrahedralMesher, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum LibraryType
  {
    TetGen,
    CGAL,
    Automatic,
    TETGEN ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use TetGen") = TetGen,
    AUTOMATIC ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use Automatic") = Automatic
  };

  enum SideType
  {
    Inside,
    Outside,
    Both,
    INSIDE ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use Inside") = Inside,
    OUTSIDE ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use Outside") = Outside,
    BOTH ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use Both") = Both
  };

  ///@{
  /// Meshing backend. Automatic first tries the backend that moves the surface least, and the next
  /// one if that fails: TetGen, TetGen after repair, CGAL after repair, isosurface stuffing from
  /// the winding number (AutomaticMesher.h). Default Automatic.
  vtkSetClampMacro(Library, int, TetGen, Automatic);
  vtkGetMacro(Library, int);
  ///@}

  ///@{
  /// Inside: the solids; Outside: the box without the solids, including their cavities; Both.
  /// Default Inside.
  vtkSetClampMacro(Side, int, Inside, Both);
  vtkGetMacro(Side, int);
  ///@}

  ///@{
  /// Distance from the surface to the box, in diagonals of the surface's bounds; Outside and Both
  /// only. Default 0.5.
  vtkSetMacro(BoxMargin, double);
  vtkGetMacro(BoxMargin, double);
  ///@}

  ///@{
  /// Repair a surface with defects (RepairSurface of SurfaceRepair.h) and report what was changed;
  /// Automatic repairs if necessary. Default off.
  vtkSetMacro(Repair, bool);
  vtkGetMacro(Repair, bool);
  vtkBooleanMacro(Repair, bool);
  ///@}

  ///@{
  /// TetGen: add no points to the surface, so that its triangles are unchanged; tetrahedra next to
  /// small or flat ones then exceed the bounds below. The faces of the box are split as the bounds
  /// require. Default on.
  vtkSetMacro(KeepSurface, bool);
  vtkGetMacro(KeepSurface, bool);
  vtkBooleanMacro(KeepSurface, bool);
  ///@}

  ///@{
  /// TetGen: bound on circumradius / shortest edge (0.612 is a regular tetrahedron); 0 switches
  /// refinement off. Default 2.
  vtkSetMacro(RadiusEdgeRatio, double);
  vtkGetMacro(RadiusEdgeRatio, double);
  ///@}

  ///@{
  /// TetGen: target for the smallest dihedral angle, in degrees, 0 to 40. Default 0.
  vtkSetMacro(MinimumDihedralAngle, double);
  vtkGetMacro(MinimumDihedralAngle, double);
  ///@}

  ///@{
  /// TetGen: bound on the volume of a tetrahedron, in cubed units of the surface; 0: none. Default
  /// 0.
  vtkSetMacro(MaximumVolume, double);
  vtkGetMacro(MaximumVolume, double);
  ///@}

  ///@{
  /// TetGen: the executable, found on PATH. Default "tetgen".
  vtkSetMacro(TetGenCommand, std::string);
  vtkGetMacro(TetGenCommand, std::string);
  ///@}

  ///@{
  /// TetGen: wall time after which it is stopped, in seconds; each run of Automatic has a quarter
  /// of it. Default 600.
  vtkSetMacro(TimeLimit, double);
  vtkGetMacro(TimeLimit, double);
  ///@}

  ///@{
  /// TetGen and stuffing: memory that they may use, in MiB; 0: three quarters of the machine's
  /// memory, and at most 8 GiB with Automatic. Default 0.
  vtkSetClampMacro(MemoryLimit, int, 0, VTK_INT_MAX);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  ///@{
  /// CGAL: lower bound of the angles of surface triangles, in degrees, at most 30. Default 25.
  vtkSetMacro(FacetAngle, double);
  vtkGetMacro(FacetAngle, double);
  ///@}

  ///@{
  /// CGAL: bound on the radius of a surface triangle, in units of the surface; 0: 1/40 of the
  /// diagonal of its bounds. Default 0.
  vtkSetMacro(FacetSize, double);
  vtkGetMacro(FacetSize, double);
  ///@}

  ///@{
  /// CGAL: bound on the distance between the old and the new surface, in units of the surface; 0: a
  /// tenth of the facet size. Default 0.
  vtkSetMacro(FacetDistance, double);
  vtkGetMacro(FacetDistance, double);
  ///@}

  ///@{
  /// CGAL: bound on circumradius / shortest edge of a tetrahedron, at least 2. Default 2.
  vtkSetMacro(CellRadiusEdgeRatio, double);
  vtkGetMacro(CellRadiusEdgeRatio, double);
  ///@}

  ///@{
  /// CGAL: bound on the circumradius of a tetrahedron, in units of the surface; 0: 1/40 of the
  /// diagonal of its bounds. Outside these bounds, sizes grow by 0.3 times the distance. Default 0.
  vtkSetMacro(CellSize, double);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /// CGAL: iterations of Lloyd's and of the ODT optimisation after refinement, 0 to 100. Default 0.
  vtkSetMacro(LloydIterations, int);
  vtkGetMacro(LloydIterations, int);
  vtkSetMacro(ODTIterations, int);
  vtkGetMacro(ODTIterations, int);
  ///@}

  ///@{
  /// CGAL: Lloyd and ODT each stop after this many seconds, so their results depend on the machine.
  /// Default 60.
  vtkSetMacro(OptimisationTimeLimit, double);
  vtkGetMacro(OptimisationTimeLimit, double);
  ///@}

  ///@{
  /// CGAL: time limit, in seconds, for moving the points of slivers; 0: they are not moved. Default
  /// 0.
  vtkSetMacro(PerturbTimeLimit, double);
  vtkGetMacro(PerturbTimeLimit, double);
  ///@}

  ///@{
  /// CGAL: finally remove slivers by assigning weights to their points (exudation). Default on.
  vtkSetMacro(Exude, bool);
  vtkGetMacro(Exude, bool);
  vtkBooleanMacro(Exude, bool);
  ///@}

protected:
  vtkTetrahedralMesher() = default;
  ~vtkTetrahedralMesher() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTetrahedralMesher(const vtkTetrahedralMesher&) = delete;
  void operator=(const vtkTetrahedralMesher&) = delete;

  int Library = Automatic;
  int Side = Inside;
  double BoxMargin = 0.5;
  bool Repair = false;
  bool KeepSurface = true;
  double RadiusEdgeRatio = 2.0;
  double MinimumDihedralAngle = 0.0;
  double MaximumVolume = 0.0;
  std::string TetGenCommand = "tetgen";
  double TimeLimit = 600.0;
  int MemoryLimit = 0;
  double FacetAngle = 25.0;
  double FacetSize = 0.0;
  double FacetDistance = 0.0;
  double CellRadiusEdgeRatio = 2.0;
  double CellSize = 0.0;
  int LloydIterations = 0;
  int ODTIterations = 0;
  double OptimisationTimeLimit = 60.0;
  double PerturbTimeLimit = 0.0;
  bool Exude = true;
};

#endif
