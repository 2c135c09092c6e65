#include "vtkDenoiseMap.h"

#include "Core/NumberText.h"
#include "Imaging/DenoisingArrays.h"
#include "Imaging/DiffusionImage.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkDenoiseMap);

const std::vector<isthmus::OutputArray>& vtkDenoiseMap::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    ISTHMUS_DENOISING_ARRAY_ROWS,
  };
  return table;
}

vtkDenoiseMap::vtkDenoiseMap() = default;

int vtkDenoiseMap::HaloWidth()
{
  // Ranks exchange halos before the choice is made, so the widest of all candidates.
  isthmus::DiffusionParameters highest;
  highest.Order = 3;
  return isthmus::HaloWidth(highest);
}

template <typename T>
void vtkDenoiseMap::Denoise(isthmus::DiffusionImage<T>& image)
{
  isthmus::Check(this->Parameters); // before volumes are allocated
  auto values = image.Copy(this->ChosenScalars(image.GetInput()), this->GetMaskInvalid());
  using Array = typename isthmus::DiffusionImage<T>::Array;
  vtkSmartPointer<Array> noise;
  vtkInformationVector* const arrays = this->GetInformation()->Get(INPUT_ARRAYS_TO_PROCESS());
  if (arrays && arrays->GetNumberOfInformationObjects() > 1)
  {
    noise = image.Copy(this->GetInputArrayToProcess(1, image.GetInput()), false);
  }
  const isthmus::DenoiseMapResult result = isthmus::DenoiseMap<T>(image.GetGrid(), this->Parameters,
    values->GetPointer(0), noise ? noise->GetPointer(0) : nullptr, image.GetProgress());
  this->WarnIfUnchanged(result);
  image.AddResult(values, true);
  const isthmus::DiffusionParameters& used = result.Diffusion;
  const bool stopsAtEdges = !result.IsLinear();
  image.AddFieldData("StepTime", result.Report.Time);
  image.AddFieldData("StepChange", result.Report.Change);
  image.AddFieldData("StepResidual", result.Report.Residual);
  image.AddFieldData("NoiseLevel", { result.NoiseLevel });
  image.AddFieldData("UsedOrder", { static_cast<double>(used.Order) });
  image.AddFieldData("UsedEdgeStopping", { stopsAtEdges ? 1.0 : 0.0 });
  image.AddFieldData("UsedSigma", { stopsAtEdges ? used.Sigma : 0.0 });
  image.AddFieldData("UsedPreSmoothing", { stopsAtEdges ? used.PreSmoothing : 0.0 });
  image.AddFieldData("UsedTime", { used.Time });
  image.AddFieldData("EstimatedGain", { result.Gain });
  image.AddFieldData("EstimatedGainError", { result.GainError });
  image.AddFieldData("RiskTime", result.RiskTime);
  image.AddFieldData("RiskValue", result.RiskValue);
  image.AddFieldText("Choice", result.Sentence());
}

void vtkDenoiseMap::WarnIfUnchanged(const isthmus::DenoiseMapResult& result)
{
  constexpr char remedy[] =
    " To smooth it anyway, use High-Order Diffusion: set EdgeStopping to None, and set Time.";
  const double deviation = result.Estimate.Deviation;
  const std::vector<double>& changes = result.Report.Change;
  const double change = changes.empty() ? 0.0 : changes.back();
  if (result.Estimate.FewValues)
  {
    vtkWarningMacro(<< isthmus::JoinText(
                      "The volume has only a few distinct values, like a mask, labels or a "
                      "constant. It contains no noise and is returned unchanged.",
                      remedy));
  }
  else if (!(result.NoiseLevel > 0.0))
  {
    vtkWarningMacro(<< isthmus::JoinText(
                      "No noise was found in the volume, which is returned "
                      "unchanged: most values equal the mean of their neighbours.",
                      remedy));
  }
  else if (change < 1e-3 * deviation && !result.Background)
  {
    vtkWarningMacro(
      << isthmus::JoinText(
           "Hardly anything was changed. If there is noise, it is coloured: its power falls "
           "towards the finest waves, like that of the map, but not as that of noise smoothed by a "
           "Gaussian, and there is no background without signal in which it could be measured. "
           "Set KnownNoise, or use Denoise From Half Maps.",
           remedy));
  }
  else if (change < 1e-4 * deviation)
  {
    vtkWarningMacro(<< isthmus::JoinText("Hardly anything was changed: the noise found, ",
                      result.NoiseLevel, ", is ", 100.0 * result.NoiseLevel / deviation,
                      " % of the values' standard deviation. Raise Strength.", remedy));
  }
}

void vtkDenoiseMap::Process(isthmus::DiffusionImage<float>& image)
{
  this->Denoise(image);
}

void vtkDenoiseMap::Process(isthmus::DiffusionImage<double>& image)
{
  this->Denoise(image);
}

void vtkDenoiseMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Goal: " << this->GetGoal() << '\n';
  os << indent << "Strength: " << this->Parameters.Strength << '\n';
  os << indent << "KnownNoise: " << this->Parameters.KnownNoise << '\n';
}
