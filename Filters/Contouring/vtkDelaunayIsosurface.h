/**
 * @class vtkDelaunayIsosurface
 * @brief A level set of a volume as a closed surface of well-shaped triangles.
 *
 * Input: vtkImageData with one-component point scalars of any number type, any spacing, origin and
 * direction. The level set is that of the trilinear interpolation. Where it leaves the volume it is
 * closed within one layer of cells around it.
 *
 * Output: vtkPolyData, triangles facing away from the inside, in world coordinates; closed and
 * manifold. Every angle is at least Angle; circumradii and the distance to the level set are at
 * most Radius and Distance. Refinement starts on every component that vtkFlyingEdges3D finds; if
 * the topology nevertheless differs from that surface, a warning states how.
 *
 * Source: J.-D. Boissonnat, S. Oudot, doi:10.1016/j.gmod.2005.01.004, by CGAL's Mesh_3; defaults
 * of the thesis (4.4.1.1) are Angle 30, Radius 0.8, Distance 0.8. On failure, there is one error
 * through vtkErrorMacro and the output is empty. The whole volume is needed on one rank. One
 * thread.
 */
#ifndef vtkDelaunayIsosurface_h
#define vtkDelaunayIsosurface_h

#include "vtkIsthmusFiltersContouringModule.h"
#include "vtkPolyDataAlgorithm.h"

class VTKISTHMUSFILTERSCONTOURING_EXPORT vtkDelaunayIsosurface : public vtkPolyDataAlgorithm
{
public:
  static vtkDelaunayIsosurface* New();
  vtkTypeMacro(vtkDelaunayIsosurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Value of the level set, in the unit of the scalars. Default 0.
  vtkSetMacro(Level, double);
  vtkGetMacro(Level, double);
  ///@}

  ///@{
  /// The inside is where the value is above the level (densities). Default on.
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  ///@{
  /// Lower bound of the angles of triangles, in degrees, 0 to 30. Default 30.
  vtkSetMacro(Angle, double);
  vtkGetMacro(Angle, double);
  ///@}

  ///@{
  /// Upper bound of the radius of the surface Delaunay ball of a triangle, in the unit of the
  /// spacing; 0: 1.5 times the smallest spacing. Default 0.
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /// Upper bound of the distance from the circumcentre of a triangle to the level set, in the unit
  /// of the spacing; 0: a quarter of the smallest spacing. Default 0.
  vtkSetMacro(Distance, double);
  vtkGetMacro(Distance, double);
  ///@}

  ///@{
  /// Number of points of the surface at which refinement is stopped with an error. Default 5
  /// million.
  vtkSetMacro(MaximumNumberOfPoints, vtkIdType);
  vtkGetMacro(MaximumNumberOfPoints, vtkIdType);
  ///@}

protected:
  vtkDelaunayIsosurface();
  ~vtkDelaunayIsosurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkDelaunayIsosurface(const vtkDelaunayIsosurface&) = delete;
  void operator=(const vtkDelaunayIsosurface&) = delete;

  double Level = 0.0;
  bool InsideIsHigher = true;
  double Angle = 30.0;
  double Radius = 0.0;
  double Distance = 0.0;
  vtkIdType MaximumNumberOfPoints = 5000000;
};

#endif
