/**
 * @class vtkSurfaceRemesh
 * @brief Remeshes a surface to triangles of even size and good angles, or simplifies it.
 *
 * Input: vtkPolyData, manifold and oriented, boundaries allowed (polygons are triangulated).
 * Output: vtkPolyData of triangles. Points lie on the old surface; its point data are interpolated
 * to them (except vtkIdType and string arrays, which are dropped), field data are kept, cell data
 * are not. Boundaries with all their corners, and edges whose adjacent normals differ by more than
 * FeatureAngle, are kept: to a thousandth of the edge length, by Delaunay to MaximumDistance.
 * Simplification keeps boundaries; other sharp edges go last, but go if the number requires it.
 *
 * Sources: M. Botsch, L. Kobbelt, doi:10.1145/1057432.1057457; J.-D. Boissonnat, S. Oudot,
 * doi:10.1016/j.gmod.2005.01.004; P. Lindstrom, G. Turk, doi:10.1109/VISUAL.1998.745314; all by
 * CGAL. On failure, there is one error through vtkErrorMacro and the output is empty. The whole
 * surface is needed on one rank. One thread.
 */
#ifndef vtkSurfaceRemesh_h
#define vtkSurfaceRemesh_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Remeshing/SurfaceRemesh.h"
#include "vtkIsthmusFiltersRemeshingModule.h"
#include "vtkPolyDataAlgorithm.h"

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
    ByNumberOfTriangles
  };

  ///@{
  /// ByRelativeEdgeLength, ByEdgeLength: remesh; ByNumberOfTriangles: simplify.
  vtkSetMacro(Target, int);
  vtkGetMacro(Target, int);
  ///@}

  ///@{
  /// Edge length relative to the mean edge length of the input.
  vtkSetMacro(RelativeEdgeLength, double);
  vtkGetMacro(RelativeEdgeLength, double);
  ///@}

  ///@{
  /// Edge length in the unit of the surface.
  ISTHMUS_PARAMETER(EdgeLength, double);
  ///@}

  ///@{
  /// Number of triangles to simplify to. Where k triangles meet at a point, simplifying takes a
  /// time that grows as k^3 (seconds for 500): remesh such surfaces first.
  vtkSetMacro(NumberOfTriangles, vtkIdType);
  vtkGetMacro(NumberOfTriangles, vtkIdType);
  ///@}

  enum MethodType
  {
    Isotropic,
    Delaunay
  };

  ///@{
  /// How edge lengths are reached. Isotropic: edges are split, collapsed and flipped
  /// until they have about the length. Delaunay: restricted Delaunay refinement, which bounds
  /// circumscribed circles by that of an equilateral triangle of the length (edges by 1.155 times
  /// the length), the angles by MinimumAngle and the distance from the old surface by
  /// MaximumDistance.
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /// Delaunay: least angle of triangles away from features, in degrees, 0 to 30.
  ISTHMUS_PARAMETER(MinimumAngle, double);
  ///@}

  ///@{
  /// Delaunay: how far triangles may be from the old surface, in its unit; 0: a tenth of
  /// the edge length.
  ISTHMUS_PARAMETER(MaximumDistance, double);
  ///@}

  ///@{
  /// Number of rounds of isotropic remeshing, 1 to 100.
  ISTHMUS_PARAMETER(NumberOfIterations, int);
  ///@}

  ///@{
  /// Remeshing keeps edges sharper than this, in degrees between normals; 180: none.
  ISTHMUS_PARAMETER(FeatureAngle, double);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkSurfaceRemesh() = default;
  ~vtkSurfaceRemesh() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceRemesh(const vtkSurfaceRemesh&) = delete;
  void operator=(const vtkSurfaceRemesh&) = delete;

  void CheckParameters() const;

  isthmus::SurfaceRemeshParameters Parameters;
  int Target = ByRelativeEdgeLength;
  double RelativeEdgeLength = 1.0;
  vtkIdType NumberOfTriangles = 10000;
  int Method = Isotropic;
};

#endif
