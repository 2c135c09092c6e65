/**
 * @class vtkTetrahedralMesher
 * @brief Fills a closed surface, or the box around it, with tetrahedra: TetGen, CGAL, stuffing.
 *
 * Input: vtkPolyData, a closed, manifold, oriented surface without self-intersections (polygons are
 * triangulated), of any number of components, some of which may be cavities of others. It is
 * checked first; errors name the ids of the triangles, and defects are repaired if Repair is on.
 *
 * Output: vtkUnstructuredGrid of tetrahedra in the units of the surface, with the arrays of
 * OutputArrayTable(). Field data of the input are kept. If tetrahedra exceed the bounds below, a
 * warning states by how much; so it does if Automatic moved the surface.
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

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Tetrahedra/TetrahedralMesher.h"
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
    Automatic
  };

  enum SideType
  {
    Inside,
    Outside,
    Both
  };

  ///@{
  /// Meshing backend. Automatic first tries the backend that moves the surface least, and the next
  /// one if that fails: TetGen, TetGen after repair, CGAL after repair, isosurface stuffing from
  /// the winding number (AutomaticMesher.h).
  vtkSetMacro(Library, int);
  vtkGetMacro(Library, int);
  ///@}

  ///@{
  /// Inside: the solids; Outside: the box without the solids, including their cavities; Both.
  ///
  ISTHMUS_PARAMETER(Side, int);
  ///@}

  ///@{
  /// Distance from the surface to the box, in diagonals of the surface's bounds; Outside and Both
  /// only.
  ISTHMUS_PARAMETER(BoxMargin, double);
  ///@}

  ///@{
  /// Repair a surface with defects (RepairSurface of SurfaceRepair.h) and report what was changed;
  /// Automatic repairs if necessary.
  vtkSetMacro(Repair, bool);
  vtkGetMacro(Repair, bool);
  vtkBooleanMacro(Repair, bool);
  ///@}

  ///@{
  /// TetGen: add no points to the surface, so that its triangles are unchanged; tetrahedra next to
  /// small or flat ones then exceed the bounds below. The faces of the box are split as the bounds
  /// require.
  ISTHMUS_PARAMETER_SWITCH_OF(Parameters.TetGen, PreserveSurface);
  ///@}

  ///@{
  /// TetGen: bound on circumradius / shortest edge (0.612 is a regular tetrahedron); 0 switches
  /// refinement off.
  ISTHMUS_PARAMETER_OF(Parameters.TetGen, RadiusEdgeRatio, double);
  ///@}

  ///@{
  /// TetGen: target for the smallest dihedral angle, in degrees, 0 to 40.
  ISTHMUS_PARAMETER_OF(Parameters.TetGen, MinimumDihedralAngle, double);
  ///@}

  ///@{
  /// TetGen: bound on the volume of a tetrahedron, in cubed units of the surface; 0: none.
  ISTHMUS_PARAMETER_OF(Parameters.TetGen, MaximumVolume, double);
  ///@}

  ///@{
  /// TetGen: the executable, found on PATH.
  ISTHMUS_PARAMETER_OF(Parameters.TetGen, TetGenCommand, const std::string&);
  ///@}

  ///@{
  /// TetGen: wall time after which it is stopped, in seconds; each run of Automatic has a quarter
  /// of it.
  ISTHMUS_PARAMETER_OF(Parameters.TetGen.Limits, TimeLimit, double);
  ///@}

  ///@{
  /// Memory limit of TetGen and stuffing in MiB; 0: three quarters of the machine's
  /// memory, with Automatic at most 8 GiB. TetGen is stopped with an error if it needs more.
  vtkSetMacro(MemoryLimit, int);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  ///@{
  /// CGAL: lower bound of the angles of surface triangles, in degrees, at most 30.
  ISTHMUS_PARAMETER_OF(Parameters.CGAL, FacetAngle, double);
  ///@}

  ///@{
  /// CGAL: bound on the radius of a surface triangle, in units of the surface; 0: 1/40 of the
  /// diagonal of its bounds.
  ISTHMUS_PARAMETER_OF(Parameters.CGAL, FacetSize, double);
  ///@}

  ///@{
  /// CGAL: bound on the distance between the old and the new surface, in units of the surface; 0: a
  /// tenth of the facet size.
  ISTHMUS_PARAMETER_OF(Parameters.CGAL, FacetDistance, double);
  ///@}

  ///@{
  /// CGAL: bound on circumradius / shortest edge of a tetrahedron, at least 2.
  ISTHMUS_PARAMETER_OF(Parameters.CGAL, CellRadiusEdgeRatio, double);
  ///@}

  ///@{
  /// CGAL: bound on the circumradius of a tetrahedron, in units of the surface; 0: 1/40 of the
  /// diagonal of its bounds. Outside these bounds, sizes grow by 0.3 times the distance.
  ISTHMUS_PARAMETER_OF(Parameters.CGAL, CellSize, double);
  ///@}

  ///@{
  /// CGAL: iterations of Lloyd's and of the ODT optimisation after refinement, 0 to 100.
  ISTHMUS_PARAMETER_OF(Parameters.CGAL, LloydIterations, int);
  ISTHMUS_PARAMETER_OF(Parameters.CGAL, ODTIterations, int);
  ///@}

  ///@{
  /// CGAL: Lloyd and ODT each stop after this many seconds, so their results depend on the machine.
  ///
  ISTHMUS_PARAMETER_OF(Parameters.CGAL, OptimisationTimeLimit, double);
  ///@}

  ///@{
  /// CGAL: time limit, in seconds, for moving the points of slivers; 0: they are not moved.
  ISTHMUS_PARAMETER_OF(Parameters.CGAL, PerturbTimeLimit, double);
  ///@}

  ///@{
  /// CGAL: finally remove slivers by assigning weights to their points (exudation).
  ISTHMUS_PARAMETER_SWITCH_OF(Parameters.CGAL, Exude);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkTetrahedralMesher() = default;
  ~vtkTetrahedralMesher() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTetrahedralMesher(const vtkTetrahedralMesher&) = delete;
  void operator=(const vtkTetrahedralMesher&) = delete;

  isthmus::TetrahedralParameters ResolvedParameters() const;

  isthmus::TetrahedralParameters Parameters; ///< but its Library
  int Library = Automatic;
  bool Repair = false;
  int MemoryLimit = 0;
};

#endif
