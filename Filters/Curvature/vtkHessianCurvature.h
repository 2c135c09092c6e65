/**
 * @class   vtkHessianCurvature
 * @brief   Computes the curvature of the level sets of a volume from its first and second
 * derivatives.
 *
 * Input 0 is a vtkImageData with a scalar point array of one component; input 1, optional, a
 * vtkPolyData. Without input 1 the output is the image with the curvature of the level set through
 * each of its nodes; with it, the output is the poly data with the curvature of the level set
 * through each of its points (the usual case: an isosurface of the image). In both cases no mesh is
 * involved: only the positions of the points are used, so the quality of the triangulation does not
 * matter.
 *
 * **Arrays**, on points, float (double for scalars of type double or integers of more than 16
 * bits): those of OutputArrayTable() that GetOutputArraySelection() has, by default
 * `GaussianCurvature`, `MeanCurvature`, `MaximumCurvature`, `MinimumCurvature`, `ShapeIndex` and
 * `Curvedness`. With AutomaticScale also `CurvatureScale` and `CurvatureError`, both estimated from
 * the image alone (CurvatureScale.h). Lengths are in the image's unit, angstrom for molecular maps.
 * All other arrays of the input are kept; on a surface, MeanCurvature becomes the active scalars.
 * Field data, on a surface with triangles and one rank: `GaussianCurvatureIntegral` and
 * `GaussBonnetEulerNumber` (GaussBonnet.h).
 *
 * **Validity.** `CurvatureValid` is 1 where the values are meaningful. It is 0, and all values are
 * 0, where the stencil leaves the grid (the outer 1 or 2 layers of nodes for Accuracy 2 or 4, and
 * everything beyond), where a value in the stencil is not finite, and where the gradient vanishes:
 * |gradient| at most 1e-6 x spacing x |Hessian|, or at most the rounding of the scalar type, 4
 * epsilon x |value| / spacing. At points, the stencil consists of all (4 R)^3 surrounding nodes,
 * with R = Accuracy / 2.
 *
 * **Sign.** A sphere has positive curvature, 1/r, like all surfaces that bend away from the outward
 * normal. The inside is where the scalar is higher; for fields that grow outwards, such as signed
 * distances, switch InsideIsHigher off. kappa_1 is always the maximum.
 *
 * **Method.** Central differences of order Accuracy, then the Hessian matrix projected to the
 * tangent plane (HessianCurvature.h has formulas and sources); at points, the differences of the
 * surrounding nodes are blended so that the order of accuracy is kept (PointDerivative.h). Any
 * spacing and direction matrix.
 *
 * **Ranks and threads.** Ghost layers are requested as needed, so any number of MPI ranks gives the
 * same values up to rounding, and bitwise the same scale; on one rank AutomaticScale requests the
 * whole image. With input 1, a rank requests its piece of the image, and in a second pass more if
 * its points lie elsewhere. Results do not depend on the number of threads.
 *
 * **Errors** (one message, empty output): no scalars, several components, cell data, Accuracy other
 * than 2 or 4, negative or infinite Scale or tolerance. An empty image or surface is not an error.
 * An image too thin for the stencil causes a warning, and no value is valid. On one rank, it is an
 * error if all points lie outside the image, and a warning if more than half of them do.
 *
 * **Cost.** O(nodes) or O(points). Memory is needed only for the output and a few rows per thread,
 * unless the scalars are smoothed: then also for one or two copies of the scalars, and the time
 * grows with scale / spacing. Integers of more than 16 bits need a copy of type double.
 * AutomaticScale adds about a second, whatever the size of the image, and the time of a second
 * smoothing.
 */
#ifndef vtkHessianCurvature_h
#define vtkHessianCurvature_h

#include "Core/FilterProperties.h"
#include "Curvature/CurvatureArrays.h"
#include "Curvature/HessianCurvature.h"
#include "vtkDataSetAlgorithm.h"
#include "vtkIsthmusFiltersCurvatureModule.h" // for the export macro

class vtkDataArray;
class vtkImageData;
class vtkPoints;

namespace isthmus
{
struct CurvatureScale;
}

class VTKISTHMUSFILTERSCURVATURE_EXPORT vtkHessianCurvature : public vtkDataSetAlgorithm
{
public:
  static vtkHessianCurvature* New();
  vtkTypeMacro(vtkHessianCurvature, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShapeIndexConventions
  {
    Thesis = 0,
    Koenderink = 1
  };

  ///@{
  /**
   * Order of the differences: 2 or 4, which is far more accurate on smooth data and
   * more sensitive to noise.
   */
  ISTHMUS_PARAMETER(Accuracy, int);
  ///@}

  ///@{
  /**
   * Whether the scalar is higher inside (on: densities) or lower (off: distances).
   */
  ISTHMUS_PARAMETER_SWITCH(InsideIsHigher);
  ///@}

  ///@{
  /**
   * Sign of the shape index: Thesis (peak -1, pit +1) or Koenderink (peak +1, pit -1).
   */
  ISTHMUS_PARAMETER(ShapeIndexConvention, int);
  ///@}

  /// The arrays that the filter adds to its output, and which of them are optional.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// FlatTolerance, GaussianTolerance and MeanTolerance are the bounds below which `SurfaceType`
  /// treats values as zero, without unit; a point is flat if
  /// curvedness x the smallest spacing is at most FlatTolerance. NormalCurvatureDirection is that
  /// of `NormalCurvature`. (CurvatureArrays.h)
  ISTHMUS_CURVATURE_PROPERTIES();

  /// Which arrays to compute.
  ISTHMUS_OUTPUT_ARRAY_SELECTION();

  /**
   * Standard deviation of a Gaussian that smooths the scalars first, in the unit of the spacing
   * (angstrom); the kernel is cut at 4 standard deviations; 0: no smoothing. Unless it is given, it
   * is chosen by the estimated error of the curvature. Choose a value of about the size of the
   * smallest feature to be distinguished from noise.
   */
  ISTHMUS_AUTOMATIC_UNLESS_GIVEN(Scale);

protected:
  vtkHessianCurvature();
  ~vtkHessianCurvature() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  isthmus::HessianCurvatureOptions Parameters;

private:
  vtkHessianCurvature(const vtkHessianCurvature&) = delete;
  void operator=(const vtkHessianCurvature&) = delete;

  void CheckParameters();
  void WarnIfThin(const int whole[6], bool atPoints);
  void AddCurvature(vtkImageData* image, vtkDataArray* scalars, vtkPoints* points,
    const isthmus::CurvatureScale& scale, vtkDataSet* output);
  void AddForms(vtkDataSet* output);
  isthmus::CurvatureScale ChooseScale(
    vtkImageData* image, vtkDataArray* scalars, vtkInformation* imageInfo);
  bool NeedsLargerExtent(vtkInformation* request, vtkInformation* imageInfo,
    vtkInformation* pointsInfo, vtkInformation* outInfo);

  // Ghost layers to request in a second pass if the first did not provide enough of the image.
  int MoreLayers = 0;
};

#endif
