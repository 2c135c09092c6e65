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

#include "Contouring/DelaunayIsosurface.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersContouringModule.h"
#include "vtkPolyDataAlgorithm.h"

class VTKISTHMUSFILTERSCONTOURING_EXPORT vtkDelaunayIsosurface : public vtkPolyDataAlgorithm
{
public:
  static vtkDelaunayIsosurface* New();
  vtkTypeMacro(vtkDelaunayIsosurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  ///@{
  /// The inside is where the value is above the level (densities).
  ISTHMUS_PARAMETER_SWITCH(InsideIsHigher);
  ///@}

  ///@{
  /// Lower bound of the angles of triangles, in degrees, 0 to 30.
  ISTHMUS_PARAMETER(Angle, double);
  ///@}

  ///@{
  /// Upper bound of the radius of the surface Delaunay ball of a triangle, in the unit of the
  /// spacing; 0: 1.5 times the smallest spacing.
  ISTHMUS_PARAMETER(Radius, double);
  ///@}

  ///@{
  /// Upper bound of the distance from the circumcenter of a triangle to the level set, in the unit
  /// of the spacing; 0: a quarter of the smallest spacing.
  ISTHMUS_PARAMETER(Distance, double);
  ///@}

  ///@{
  /// Number of points of the surface at which refinement is stopped with an error.
  ISTHMUS_PARAMETER(MaximumNumberOfPoints, vtkIdType);
  ///@}

  /// Value of the level set, in the unit of the scalars; unless it is given, the policy is that
  /// of AutomaticLevel.h.
  ISTHMUS_AUTOMATIC_UNLESS_GIVEN(Level);

protected:
  vtkDelaunayIsosurface();
  ~vtkDelaunayIsosurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkDelaunayIsosurface(const vtkDelaunayIsosurface&) = delete;
  void operator=(const vtkDelaunayIsosurface&) = delete;

  isthmus::DelaunayIsosurfaceParameters Parameters; ///< but its Level
};

#endif
