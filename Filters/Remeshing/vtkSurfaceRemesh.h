/**
 * @class vtkSurfaceRemesh
 * @brief Triangles of even size and good angles, or fewer of them, for a surface that has others.
 *
 * Input: vtkPolyData, manifold and oriented, boundaries allowed (polygons are triangulated).
 * Output: vtkPolyData of triangles. Points lie on the old surface; its point data are interpolated
 * to them (except vtkIdType and string arrays, which are dropped), field data are kept, cell data
 * are not. Boundaries, and edges whose adjacent normals differ by more than FeatureAngle, are kept.
 *
 * Sources: M. Botsch, L. Kobbelt, doi:10.1145/1057432.1057457; J.-D. Boissonnat, S. Oudot,
 * doi:10.1016/j.gmod.2005.01.004; P. Lindstrom, G. Turk, doi:10.1109/VISUAL.1998.745314; all by
 * CGAL. On failure, there is one error through vtkErrorMacro and the output is empty. The whole
 * surface is needed on one rank. One thread.
 */
#ifndef vtkSurfaceRemesh_h
#define vtkSurfaceRemesh_h

#include "Core/Deprecation.h"
#include "vtkIsthmusFiltersRemeshingModule.h"
#include "vtkPolyDataAlgorithm.h"

namespace isthmus
{
struct RemeshedSurface;
struct SurfaceView;
}

class VTKISTHMUSFILTERSREMESHING_EXPORT vtkSurfaceRemesh : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceRemesh* New();
  vtkTypeMacro(vtkSurfaceRemesh, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum TargetType
  {
    ByRelativeEdgeLength,
    ByEdgeLength,
    ByNumberOfTriangles,
    RELATIVE_EDGE_LENGTH ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use ByRelativeEdgeLength") =
      ByRelativeEdgeLength,
    EDGE_LENGTH ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use ByEdgeLength") = ByEdgeLength,
    NUMBER_OF_TRIANGLES ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use ByNumberOfTriangles") =
      ByNumberOfTriangles
  };

  ///@{
  /// ByRelativeEdgeLength, ByEdgeLength: remesh; ByNumberOfTriangles: simplify. Default
  /// ByRelativeEdgeLength.
  vtkSetClampMacro(Target, int, ByRelativeEdgeLength, ByNumberOfTriangles);
  vtkGetMacro(Target, int);
  ///@}

  ///@{
  /// Edge length relative to the mean edge length of the input. Default 1.
  vtkSetMacro(RelativeEdgeLength, double);
  vtkGetMacro(RelativeEdgeLength, double);
  ///@}

  ///@{
  /// Edge length in the unit of the surface. Default 1.
  vtkSetMacro(EdgeLength, double);
  vtkGetMacro(EdgeLength, double);
  ///@}

  ///@{
  /// Number of triangles to simplify to. Default 10,000. Where k triangles meet at a point,
  /// simplifying takes a time that grows as k^3 (3 s for 500): remesh such surfaces first.
  vtkSetMacro(NumberOfTriangles, vtkIdType);
  vtkGetMacro(NumberOfTriangles, vtkIdType);
  ///@}

  enum MethodType
  {
    Isotropic,
    Delaunay
  };

  ///@{
  /// How edge lengths are reached. Isotropic (default): edges are split, collapsed and flipped
  /// until they have about the length. Delaunay: restricted Delaunay refinement, which bounds
  /// circumscribed circles by that of an equilateral triangle of the length (edges by 1.155 times
  /// the length), the angles by MinimumAngle and the distance from the old surface by
  /// MaximumDistance.
  vtkSetClampMacro(Method, int, Isotropic, Delaunay);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /// Delaunay: least angle of triangles away from features, in degrees, 0 to 30. Default 25.
  vtkSetClampMacro(MinimumAngle, double, 0.0, 30.0);
  vtkGetMacro(MinimumAngle, double);
  ///@}

  ///@{
  /// Delaunay: how far triangles may be from the old surface, in its unit. Default 0: a tenth of
  /// the edge length.
  vtkSetClampMacro(MaximumDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /// Number of rounds of isotropic remeshing. Default 5.
  vtkSetClampMacro(NumberOfIterations, int, 1, 100);
  vtkGetMacro(NumberOfIterations, int);
  ///@}

  ///@{
  /// Remeshing keeps edges sharper than this, in degrees between normals; 180: none. Default 60.
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

protected:
  vtkSurfaceRemesh() = default;
  ~vtkSurfaceRemesh() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceRemesh(const vtkSurfaceRemesh&) = delete;
  void operator=(const vtkSurfaceRemesh&) = delete;

  isthmus::RemeshedSurface RemeshIsotropic(const isthmus::SurfaceView& mesh, double length);
  isthmus::RemeshedSurface RefineDelaunay(const isthmus::SurfaceView& mesh, double length);

  int Target = ByRelativeEdgeLength;
  double RelativeEdgeLength = 1.0;
  double EdgeLength = 1.0;
  vtkIdType NumberOfTriangles = 10000;
  int Method = Isotropic;
  double MinimumAngle = 25.0;
  double MaximumDistance = 0.0;
  int NumberOfIterations = 5;
  double FeatureAngle = 60.0;
};

#endif
