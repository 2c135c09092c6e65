/**
 * @class vtkDenoiseMap
 * @brief Denoises a volume by the diffusion with the least estimated error.
 *
 * Candidates are hyperdiffusions (vtkHighOrderDiffusion): linear ones of orders 0 to 3 and, for
 * Goal Volumes, those of orders 0 to 2 with edge stopping. The mean squared error of each is
 * estimated by Stein's unbiased risk estimate (DenoisingRisk.h) for noise whose level and spectrum
 * are estimated from the volume (NoiseSpectrum.h). Constant background, e.g. outside a mask, is not
 * changed.
 *
 * The output array has the input array's name; OutputArrayTable() lists the field data. A warning
 * says why where nothing or hardly anything is changed.
 *
 * Where an array of noise like the volume's is known, e.g. from half maps, it is set by
 * `SetInputArrayToProcess(1, ...)` and gives level and spectrum.
 *
 * Memory in addition to input and output, Goal Surfaces: one volume of the output's type, two
 * planes along x and z for each of the 10 to 60 terms of the series (3 volumes on several ranks
 * instead), and a sample of the volume of up to 100 MiB.
 *
 * @sa vtkDenoiseFromHalfMaps vtkHighOrderDiffusion
 */
#ifndef vtkDenoiseMap_h
#define vtkDenoiseMap_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Imaging/DenoiseMap.h"
#include "vtkDiffusionAlgorithm.h"
#include "vtkIsthmusFiltersImagingModule.h"

class VTKISTHMUSFILTERSIMAGING_EXPORT vtkDenoiseMap : public vtkDiffusionAlgorithm
{
public:
  static vtkDenoiseMap* New();
  vtkTypeMacro(vtkDenoiseMap, vtkDiffusionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum GoalType
  {
    Surfaces = 0,
    Volumes = 1
  };

  ///@{
  /// Purpose of the denoised volume: Surfaces, for which linear diffusions are chosen
  /// that improve second derivatives, and thus normals and curvature of level sets; or Volumes, for
  /// the least mean squared error of the values.
  ISTHMUS_PARAMETER(Goal, int);
  ///@}

  ///@{
  /// How much to denoise, from 0 (light) to 1 (strong): the smoothing length is 2^(Strength - 1/2)
  /// times the best one.
  ISTHMUS_PARAMETER(Strength, double);
  ///@}

  ///@{
  /// Standard deviation of the noise if it is known to be white; 0: level and spectrum
  /// are estimated where the volume is not constant.
  ISTHMUS_PARAMETER(KnownNoise, double);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkDenoiseMap();
  ~vtkDenoiseMap() override = default;

  int HaloWidth() override;
  void Process(isthmus::DiffusionImage<float>& image) override;
  void Process(isthmus::DiffusionImage<double>& image) override;

private:
  template <typename T>
  void Denoise(isthmus::DiffusionImage<T>& image);
  void WarnIfUnchanged(const isthmus::DenoiseMapResult& result);

  vtkDenoiseMap(const vtkDenoiseMap&) = delete;
  void operator=(const vtkDenoiseMap&) = delete;

  isthmus::DenoiseMapParameters Parameters;
};

#endif
