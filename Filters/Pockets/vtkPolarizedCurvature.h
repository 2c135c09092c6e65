/**
 * @class   vtkPolarizedCurvature
 * @brief   Computes products of curvature and electrostatic potential on a surface, and
 * binding-site classes.
 *
 * Input 0: a vtkPolyData with the point arrays `MaximumCurvature` and `MinimumCurvature` (input
 * arrays 0 and 1), as created by vtkSurfaceCurvature and vtkHessianCurvature. The potential comes
 * from input 1, a vtkImageData (its point array PotentialArrayName), interpolated trilinearly at
 * the points in world coordinates; without that input, from a point array of the surface (input
 * array 2: `Potential`).
 *
 * **Output**: the surface with its arrays and, on points, double:
 * - `Potential` (kT/e, or the unit of the image): NaN at points off the grid;
 * - `PositivePotentialKappa1`, `PositivePotentialKappa2`, `NegativePotentialKappa1`,
 *   `NegativePotentialKappa2`: max(Phi, 0) or min(Phi, 0) times kappa_1 or kappa_2 (kT/(e
 *   angstrom)), NaN where the potential is NaN;
 * - `PolarizedCurvature` = Phi kappa_2;
 * - `SiteClass` (unsigned char): names in the field array `SiteClassNames`; a saddle has the class
 *   of its larger amplitude:
 *   - 0: none;
 *   - 1: site for a negatively charged protein (Phi > 0, kappa_1 > 0);
 *   - 2: site for a negatively charged small ligand (Phi > 0, kappa_2 < 0);
 *   - 3: site for a positively charged protein (Phi < 0, kappa_1 > 0);
 *   - 4: site for a positively charged small ligand (Phi < 0, kappa_2 < 0);
 * - `PotentialValid` (unsigned char): 0 if the point lies off the grid or a value around it is not
 *   finite, otherwise 1.
 *
 * At points that the curvature filters marked as not valid, the curvatures and therefore the
 * products are 0. Source: X. Feng's thesis, section 5.2.5, Table 5.7; PolarizedCurvature.h has the
 * formulas.
 *
 * **Errors** (message, empty output): missing arrays, no potential, a potential whose grid does not
 * overlap the surface. If some points are off the grid, a warning gives their number. As in all
 * filters (InputOverlap.h), there is another warning if most of the surface is off the grid or the
 * unit of length seems to differ. An empty surface is not an error.
 *
 * **Ranks.** Each MPI rank processes its piece of the surface and requests the whole potential.
 *
 * **Cost.** O(points), in parallel, bitwise the same on any number of threads; 57 bytes per point.
 */
#ifndef vtkPolarizedCurvature_h
#define vtkPolarizedCurvature_h

#include "Core/ArrayProperty.h"
#include "vtkIsthmusFiltersPocketsModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the name of an array

class vtkAlgorithmOutput;
class vtkDataArray;
class vtkDoubleArray;
class vtkImageData;

class VTKISTHMUSFILTERSPOCKETS_EXPORT vtkPolarizedCurvature : public vtkPolyDataAlgorithm
{
public:
  static vtkPolarizedCurvature* New();
  vtkTypeMacro(vtkPolarizedCurvature, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Input array 2 is the point array of the potential, `Potential` by default.
  ISTHMUS_NAMED_INPUT_ARRAYS();

  ///@{
  /// The image of the potential, optional: input 1.
  void SetPotentialConnection(vtkAlgorithmOutput* image) { this->SetInputConnection(1, image); }
  void SetPotentialData(vtkImageData* image);
  ///@}

  ///@{
  /// Point array of the image that contains the potential. Default: `Potential`. If the image has
  /// no array of that name, its active scalars are used.
  vtkSetMacro(PotentialArrayName, std::string);
  vtkGetMacro(PotentialArrayName, std::string);
  ///@}

  ///@{
  /// Amplitude |Phi kappa| up to which a point has class 0, kT/(e angstrom); at least 0. Default:
  /// 0.
  vtkSetMacro(ClassThreshold, double);
  vtkGetMacro(ClassThreshold, double);
  ///@}

protected:
  vtkPolarizedCurvature();
  ~vtkPolarizedCurvature() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::string PotentialArrayName = "Potential";
  double ClassThreshold = 0.0;

private:
  vtkPolarizedCurvature(const vtkPolarizedCurvature&) = delete;
  void operator=(const vtkPolarizedCurvature&) = delete;

  vtkDataArray* Scalar(int index, vtkPolyData* surface, const char* what, const char* remedy);
  void Sample(vtkPolyData* surface, vtkImageData* image, vtkDoubleArray* potential);
  void Copy(vtkPolyData* surface, vtkDoubleArray* potential);
  void AddProducts(vtkPolyData* surface, vtkDoubleArray* potential, vtkPolyData* output);
};

#endif
