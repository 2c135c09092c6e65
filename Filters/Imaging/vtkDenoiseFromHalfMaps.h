/**
 * @class vtkDenoiseFromHalfMaps
 * @brief Denoises the mean of two half maps; their difference gives the noise level.
 *
 * Two maps of the same thing from independent halves of the data, a and b, have the mean
 * (a + b) / 2, whose noise is (a - b) / 2, which contains no signal: its standard deviation is
 * known and need not be estimated. The mean is passed to vtkHighOrderDiffusion with that
 * KnownNoise.
 *
 * Input 0 and 1: vtkImageData of the same nodes (dimensions, spacing, origin, direction to 1e-4 of
 * a spacing), one-component point scalars each. Nodes where the halves are equal, as outside of a
 * mask, do not count for the noise.
 *
 * Output: the denoised mean, with the arrays and field data of vtkHighOrderDiffusion and the name
 * of the first half's array. Equal halves have no noise: an error says so. Both are needed whole.
 *
 * @sa vtkHighOrderDiffusion
 */
#ifndef vtkDenoiseFromHalfMaps_h
#define vtkDenoiseFromHalfMaps_h

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
  /// How much to denoise, from 0 (light) to 1 (strong). Default 0.5.
  vtkSetMacro(Strength, double);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /// q, 0 to 3: the equation is of order 2q + 2. Default 0.
  vtkSetMacro(Order, int);
  vtkGetMacro(Order, int);
  ///@}

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

  double Strength = 0.5;
  int Order = 0;
};

#endif
