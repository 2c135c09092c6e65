/**
 * @class vtkPDETransform
 * @brief Splits a volume into modes, from the finest detail to a smooth rest, that add up to it.
 *
 * Repeated high-pass filters by diffusion of falling order (Y. Wang, G. W. Wei, S. Yang, J. Sci.
 * Comput. 50 (2012) 495): mode k is what the k-th low-pass filter removes from what the previous
 * ones have left. Low-pass filter k halves the amplitude of waves of the wavelength FirstWavelength
 * WavelengthRatio^(k-1).
 *
 * Output arrays: those of OutputArrayTable(), of which `Residue` is active; their sum is the input
 * up to the rounding of the additions. Times are chosen from wavelengths; orders fall by one from
 * FirstOrder to LastOrder. All modes come from one Chebyshev recurrence of the Laplacian
 * (PDETransform.h), to 1e-7 of the input (float) or 1e-13 (double), apart from rounding. Cost: the
 * number of terms of this recurrence is about three times the longest wavelength in voxels. Memory:
 * n + 1 output volumes, and two planes along x and z for each term, at most four volumes.
 *
 * @sa vtkHighOrderDiffusion vtkDiffusionHighPass
 */
#ifndef vtkPDETransform_h
#define vtkPDETransform_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Imaging/PDETransform.h"
#include "vtkDiffusionAlgorithm.h"
#include "vtkIsthmusFiltersImagingModule.h"

class VTKISTHMUSFILTERSIMAGING_EXPORT vtkPDETransform : public vtkDiffusionAlgorithm
{
public:
  static vtkPDETransform* New();
  vtkTypeMacro(vtkPDETransform, vtkDiffusionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Number of modes, 1 to 16, not counting the residue.
  ISTHMUS_PARAMETER(NumberOfModes, int);
  ///@}

  ///@{
  /// Order q of the first low-pass, 0 to 3; it falls by one from mode to mode.
  ISTHMUS_PARAMETER(FirstOrder, int);
  ///@}

  ///@{
  /// Order of the last low-pass.
  ISTHMUS_PARAMETER(LastOrder, int);
  ///@}

  ///@{
  /// Wavelength (length) of the waves that the first low-pass halves.
  ISTHMUS_PARAMETER(FirstWavelength, double);
  ///@}

  ///@{
  /// Ratio of a mode's wavelength to that of the preceding mode.
  ISTHMUS_PARAMETER(WavelengthRatio, double);
  ///@}

  ///@{
  /// Lengths in units of the smallest spacing (on) or in the data's unit, angstrom
  /// for maps (off).
  vtkSetMacro(VoxelUnits, bool);
  vtkGetMacro(VoxelUnits, bool);
  vtkBooleanMacro(VoxelUnits, bool);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkPDETransform();
  ~vtkPDETransform() override = default;

  int HaloWidth() override;
  void Process(isthmus::DiffusionImage<float>& image) override;
  void Process(isthmus::DiffusionImage<double>& image) override;

private:
  template <typename T>
  void Transform(isthmus::DiffusionImage<T>& image);

  vtkPDETransform(const vtkPDETransform&) = delete;
  void operator=(const vtkPDETransform&) = delete;

  isthmus::PDETransformParameters Parameters;
};

#endif
