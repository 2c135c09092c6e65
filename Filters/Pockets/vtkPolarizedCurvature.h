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
 * **Output**: the surface with its arrays and those of OutputArrayTable(): the potential Phi, its
 * positive and negative part times kappa_1 and kappa_2, `PolarizedCurvature` = Phi kappa_2, and the
 * class of binding site.
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
#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersPocketsModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the name of an array
#include <vector> // for the table of output arrays

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
  /// Point array of the image that contains the potential. Default: `Potential`, or the active
  /// scalars of an image without it; an array of any other name must exist.
  vtkSetMacro(PotentialArrayName, std::string);
  vtkGetMacro(PotentialArrayName, std::string);
  ///@}

  ///@{
  /// Amplitude |Phi kappa| up to which a point has class 0, kT/(e angstrom); at least 0. Default:
  /// 0.
  vtkSetMacro(ClassThreshold, double);
  vtkGetMacro(ClassThreshold, double);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

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
  void CheckValid(vtkDoubleArray* potential, const char* ifNone, const char* where);
  void AddProducts(vtkPolyData* surface, vtkDoubleArray* potential, vtkPolyData* output);
};

#endif
