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
 * bits), each with a switch: `GaussianCurvature` (1/length^2), `MeanCurvature`, `MaximumCurvature`
 * (kappa_1), `MinimumCurvature` (kappa_2), `Curvedness` (1/length), `ShapeIndex` (in [-1, 1]); off
 * by default `PrincipalDirection1`, `PrincipalDirection2` (unit vectors in world axes, tangent to
 * the level set; their sign is arbitrary), `SurfaceType` (unsigned char; names below and in the
 * field array `SurfaceTypeNames`), `NormalCurvature` in a given direction, and with
 * GenerateDifferentialForms `GaussMap`, `ShapeOperator`, `FirstFundamentalForm`,
 * `SecondFundamentalForm`, `AreaElement` (CurvatureArrays.h). With AutomaticScale also
 * `CurvatureScale`, the standard deviation of the Gaussian that smoothed the scalars (the same
 * everywhere; 0 for none), and `CurvatureError`, the standard error of the mean curvature
 * (1/length, bias included; 0 where CurvatureValid is 0), both estimated from the image alone
 * (CurvatureScale.h). Lengths are in the image's unit, angstrom for molecular maps. All other
 * arrays of the input are kept; on a surface, MeanCurvature becomes the active scalars.
 *
 * Field data, on a surface with triangles and one rank: `GaussianCurvatureIntegral` (no unit) and
 * `GaussBonnetEulerNumber`, the integral divided by 2 pi, which is close to the Euler number of a
 * closed surface if its curvature is accurate (GaussBonnet.h).
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

#include "Curvature/CurvatureArrays.h"
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
   * Order of the differences: 2 (the default) or 4, which is far more accurate on smooth data and
   * more sensitive to noise.
   */
  vtkSetMacro(Accuracy, int);
  vtkGetMacro(Accuracy, int);
  ///@}

  ///@{
  /**
   * Whether the scalar is higher inside (on, the default: densities) or lower (off: distances).
   */
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  ///@{
  /**
   * Whether to choose the scale of the smoothing by the estimated error of the curvature (the
   * default) or to use Scale. SetScale() switches it off unless it was set explicitly before, so
   * programs written for fixed scales keep their results.
   */
  virtual void SetAutomaticScale(bool automatic);
  vtkGetMacro(AutomaticScale, bool);
  vtkBooleanMacro(AutomaticScale, bool);
  ///@}

  ///@{
  /**
   * Standard deviation of a Gaussian that smooths the scalars first, in the unit of the spacing
   * (angstrom); the kernel is cut at 4 standard deviations. Default 0: no smoothing. Used if
   * AutomaticScale is off. Choose a value of about the size of the smallest feature to be
   * distinguished from noise.
   */
  virtual void SetScale(double scale);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /**
   * Sign of the shape index: Thesis (the default; peak -1, pit +1) or Koenderink (peak +1, pit -1).
   */
  vtkSetMacro(ShapeIndexConvention, int);
  vtkGetMacro(ShapeIndexConvention, int);
  ///@}

  /// GenerateGaussianCurvature etc. select the arrays to compute. They are on by default, except
  /// for principal directions, surface type, GenerateDifferentialForms and GenerateNormalCurvature
  /// (along NormalCurvatureDirection). FlatTolerance, GaussianTolerance and MeanTolerance are the
  /// bounds below which `SurfaceType` treats values as zero, without unit, default 1e-3 each; a
  /// point is flat if curvedness x the smallest spacing is at most FlatTolerance. The whole list is
  /// in CurvatureArrays.h.
  ISTHMUS_CURVATURE_ARRAYS();

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

  int Accuracy = 2;
  bool InsideIsHigher = true;
  double Scale = 0.0;
  bool AutomaticScale = true;
  int ShapeIndexConvention = Thesis;

private:
  vtkHessianCurvature(const vtkHessianCurvature&) = delete;
  void operator=(const vtkHessianCurvature&) = delete;

  void CheckParameters();
  void WarnIfThin(const int whole[6], bool atPoints);
  void AddCurvature(vtkImageData* image, vtkDataArray* scalars, vtkPoints* points,
    const isthmus::CurvatureScale& scale, vtkDataSet* output);
  isthmus::CurvatureScale ChosenScale(
    vtkImageData* image, vtkDataArray* scalars, vtkInformation* imageInfo);
  bool NeedsLargerExtent(vtkInformation* request, vtkInformation* imageInfo,
    vtkInformation* pointsInfo, vtkInformation* outInfo);

  // Ghost layers to request in a second pass if the first did not provide enough of the image.
  int MoreLayers = 0;
  bool AutomaticScaleGiven = false;
};

#endif
