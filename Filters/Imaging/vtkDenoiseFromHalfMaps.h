/**
 * @class vtkDenoiseFromHalfMaps
 * @brief Denoises the mean of two half maps; their difference gives the noise.
 *
 * Let a and b be two maps of the same object from independent halves of the data. The noise of
 * their mean (a + b) / 2 is like (a - b) / 2, which contains no signal: it has the same level,
 * spectrum and distribution in space. The mean is passed to vtkDenoiseMap with this difference
 * instead of an estimate of the noise. This is cross-validation: each half validates what is
 * computed from the other.
 *
 * Input 0 and 1: vtkImageData of the same nodes (dimensions, spacing, origin, direction to 1e-4 of
 * a spacing), one-component point scalars each. Nodes at which the halves are equal, e.g. outside a
 * mask, are ignored when the noise is measured.
 *
 * Output: the denoised mean, with the name of the first half's array, and the arrays of
 * OutputArrayTable(). `LocalResolution` (LocalResolution.h) does not depend on the unit of the
 * density. Equal half maps are refused with an error, since they have no noise. Both are needed
 * whole. Halves that do not belong together (HalfMapAgreement.h) give a warning with the factor,
 * offset or shift found; a linear difference of the second one is removed first.
 *
 * @sa vtkDenoiseMap
 */
#ifndef vtkDenoiseFromHalfMaps_h
#define vtkDenoiseFromHalfMaps_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Imaging/DenoisingRisk.h"
#include "vtkImageAlgorithm.h"
#include "vtkIsthmusFiltersImagingModule.h"

class VTKISTHMUSFILTERSIMAGING_EXPORT vtkDenoiseFromHalfMaps : public vtkImageAlgorithm
{
public:
  static vtkDenoiseFromHalfMaps* New();
  vtkTypeMacro(vtkDenoiseFromHalfMaps, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The other half: input 1.
  void SetOtherHalfConnection(vtkAlgorithmOutput* half) { this->SetInputConnection(1, half); }
  void SetOtherHalfData(vtkImageData* half);
  ///@}

  ///@{
  /// How much to denoise, from 0 (light) to 1 (strong).
  ISTHMUS_PARAMETER(Strength, double);
  ///@}

  ///@{
  /// Purpose of the denoised volume: vtkDenoiseMap::Surfaces or vtkDenoiseMap::Volumes.
  ISTHMUS_PARAMETER(Goal, int);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkDenoiseFromHalfMaps();
  ~vtkDenoiseFromHalfMaps() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  void Denoise(vtkImageData* one, vtkImageData* other, vtkImageData* output);

  vtkDenoiseFromHalfMaps(const vtkDenoiseFromHalfMaps&) = delete;
  void operator=(const vtkDenoiseFromHalfMaps&) = delete;

  isthmus::DenoisingSearch Parameters;
};

#endif
