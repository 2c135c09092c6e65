#include "vtkHighOrderDiffusion.h"

#include "Core/NumberText.h"
#include "Imaging/DiffusionImage.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

vtkStandardNewMacro(vtkHighOrderDiffusion);

vtkHighOrderDiffusion::vtkHighOrderDiffusion() = default;

void vtkHighOrderDiffusion::CheckParameters() const
{
  isthmus::Check(this->Denoising);
  isthmus::Check(this->Parameters);
}

int vtkHighOrderDiffusion::HaloWidth()
{
  try
  {
    this->CheckParameters();
    isthmus::DiffusionParameters parameters = this->Parameters;
    if (this->ChoosesByRisk())
    {
      parameters.Order = 3; // whatever is chosen
    }
    return isthmus::HaloWidth(parameters);
  }
  catch (const std::invalid_argument&)
  {
    return 0; // RequestData will say what is wrong
  }
}

bool vtkHighOrderDiffusion::ChoosesByRisk() const
{
  using Type = isthmus::DiffusionParameters;
  const Type& given = this->Parameters;
  return this->Automatic && given.Flow == Type::FlowType::Hyperdiffusion && !given.LowerOrders &&
    given.EdgeStopping != Type::EdgeStoppingType::LocalVariance && given.Fidelity == 0.0 &&
    !this->UseSource &&
    std::all_of(
      given.Diffusivity.begin(), given.Diffusivity.end(), [](double d) { return d == 1.0; });
}

template <typename T>
void vtkHighOrderDiffusion::DenoiseByRisk(isthmus::DiffusionImage<T>& image)
{
  isthmus::AutomaticParameters parameters = this->Denoising;
  parameters.LinearOnly = this->GetEdgeStopping() == None;
  parameters.Integrator = this->Parameters.Integrator;
  parameters.Steps = this->Parameters.Steps;
  auto values = image.Copy(this->ChosenScalars(image.GetInput()), this->GetMaskInvalid());
  const isthmus::NoiseEstimate simple =
    isthmus::EstimateNoise(image.GetGrid(), values->GetPointer(0));
  parameters.SimpleEstimate = simple.Noise;
  using Array = typename isthmus::DiffusionImage<T>::Array;
  vtkSmartPointer<Array> noise;
  vtkInformationVector* const arrays = this->GetInformation()->Get(INPUT_ARRAYS_TO_PROCESS());
  if (arrays && arrays->GetNumberOfInformationObjects() > 2)
  {
    noise = image.Copy(this->GetInputArrayToProcess(2, image.GetInput()), false);
  }
  isthmus::AutomaticResult result;
  if (!simple.FewValues)
  {
    result = isthmus::DenoiseByRisk<T>(image.GetGrid(), parameters, values->GetPointer(0),
      noise ? noise->GetPointer(0) : nullptr, image.GetProgress());
  }
  isthmus::NoiseEstimate found = simple;
  found.Noise = result.NoiseLevel;
  this->Explain(
    found, result.Report.Change.empty() ? 0.0 : result.Report.Change.back(), result.Background);
  image.AddResult(values, true);
  const isthmus::DiffusionParameters& used = result.Parameters;
  const bool linear = used.EdgeStopping == isthmus::DiffusionParameters::EdgeStoppingType::None;
  image.AddFieldData("StepTime", result.Report.Time);
  image.AddFieldData("StepChange", result.Report.Change);
  image.AddFieldData("StepResidual", result.Report.Residual);
  image.AddFieldData("NoiseLevel", { result.NoiseLevel });
  image.AddFieldData("UsedOrder", { static_cast<double>(used.Order) });
  image.AddFieldData("UsedEdgeStopping", { linear ? 0.0 : 1.0 });
  image.AddFieldData("UsedSigma", { linear ? 0.0 : used.Sigma });
  image.AddFieldData("UsedPreSmoothing", { linear ? 0.0 : used.PreSmoothing });
  image.AddFieldData("UsedResidualSmoothing", { 0.0 });
  image.AddFieldData("UsedTime", { used.Time });
  image.AddFieldData("EstimatedGain", { result.Gain });
  image.AddFieldData("EstimatedGainError", { result.GainError });
  image.AddFieldData("RiskTime", result.RiskTime);
  image.AddFieldData("RiskValue", result.RiskValue);
  image.AddFieldText("Choice", result.Sentence());
}

template <typename T>
void vtkHighOrderDiffusion::Denoise(isthmus::DiffusionImage<T>& image)
{
  this->CheckParameters();
  if (this->ChoosesByRisk())
  {
    this->DenoiseByRisk(image);
    return;
  }
  isthmus::DiffusionParameters parameters = this->Parameters;
  auto values = image.Copy(this->ChosenScalars(image.GetInput()), this->GetMaskInvalid());
  isthmus::NoiseEstimate noise = isthmus::EstimateNoise(image.GetGrid(), values->GetPointer(0));
  if (this->Denoising.KnownNoise > 0.0)
  {
    noise.Noise = this->Denoising.KnownNoise;
  }
  const auto& spacing = image.GetGrid().Spacing;
  const double voxel = *std::min_element(spacing.begin(), spacing.end());
  if (this->Automatic)
  {
    isthmus::ChooseDenoisingParameters(noise, this->Denoising.Strength, voxel, parameters);
  }
  else if (parameters.Sigma == 0.0)
  {
    parameters.Sigma = isthmus::NoiseGradient(noise, voxel);
  }
  using Array = typename isthmus::DiffusionImage<T>::Array;
  vtkSmartPointer<Array> input, source;
  if (parameters.Fidelity > 0.0)
  {
    input = image.Duplicate(values, "Input");
  }
  if (this->UseSource)
  {
    source = image.Copy(this->GetInputArrayToProcess(1, image.GetInput()), false);
  }
  const isthmus::DiffusionReport report = isthmus::Diffuse<T>(image.GetGrid(), parameters,
    values->GetPointer(0), input ? input->GetPointer(0) : nullptr,
    source ? source->GetPointer(0) : nullptr, isthmus::Between(image.GetProgress(), 0.0, 0.85));
  if (parameters.ResidualSmoothing > 0.0)
  {
    // Copied only now that the steps' volumes are free again.
    auto residual = image.Copy(this->ChosenScalars(image.GetInput()), this->GetMaskInvalid());
    isthmus::AddSmoothedResidual<T>(image.GetGrid(), parameters.ResidualSmoothing,
      residual->GetPointer(0), values->GetPointer(0),
      isthmus::Between(image.GetProgress(), 0.85, 1.0));
  }
  if (this->Automatic)
  {
    this->Explain(noise, std::accumulate(report.Change.begin(), report.Change.end(), 0.0), true);
  }
  image.AddResult(values, true);
  image.AddFieldData("StepTime", report.Time);
  image.AddFieldData("StepChange", report.Change);
  image.AddFieldData("StepResidual", report.Residual);
  image.AddFieldData("NoiseLevel", { noise.Noise });
  image.AddFieldData("UsedOrder", { static_cast<double>(parameters.Order) });
  image.AddFieldData("UsedEdgeStopping", { static_cast<double>(parameters.EdgeStopping) });
  image.AddFieldData("UsedSigma", { parameters.Sigma });
  image.AddFieldData("UsedPreSmoothing", { parameters.PreSmoothing });
  image.AddFieldData("UsedResidualSmoothing", { parameters.ResidualSmoothing });
  image.AddFieldData("UsedTime", { parameters.Time });
}

void vtkHighOrderDiffusion::Explain(
  const isthmus::NoiseEstimate& noise, double change, bool background)
{
  // With the default edge stopping, whose Sigma follows from the noise found, hardly anything would
  // change again.
  constexpr char remedy[] = " To smooth it anyway, switch Automatic off, set EdgeStopping to None, "
                            "and set Time.";
  if (noise.FewValues)
  {
    vtkWarningMacro(<< isthmus::TextOf(
                      "The volume has only a few distinct values, like a mask, labels or a "
                      "constant. It contains no noise and is returned unchanged.",
                      remedy));
  }
  else if (!(noise.Noise > 0.0))
  {
    vtkWarningMacro(<< isthmus::TextOf("No noise was found in the volume, which is returned "
                                       "unchanged: most values equal the mean of their neighbours.",
                      remedy));
  }
  else if (change < 1e-3 * noise.Deviation && !background)
  {
    vtkWarningMacro(
      << isthmus::TextOf(
           "Hardly anything was changed. If there is noise, it is coloured: its power falls "
           "towards the finest waves, like that of the map, but neither as if a Gaussian had "
           "smoothed it, nor is there background without signal in which it could be measured. "
           "Give KnownNoise, or use Denoise From Half Maps.",
           remedy));
  }
  else if (change < 1e-4 * noise.Deviation)
  {
    vtkWarningMacro(<< isthmus::TextOf("Hardly anything was changed: the noise found, ",
                      noise.Noise, ", is ", 100.0 * noise.Noise / noise.Deviation,
                      " % of the values' standard deviation. Raise Strength.", remedy));
  }
}

void vtkHighOrderDiffusion::Process(isthmus::DiffusionImage<float>& image)
{
  this->Denoise(image);
}

void vtkHighOrderDiffusion::Process(isthmus::DiffusionImage<double>& image)
{
  this->Denoise(image);
}

void vtkHighOrderDiffusion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Automatic: " << this->Automatic << '\n';
  os << indent << "Goal: " << this->GetGoal() << '\n';
  os << indent << "Strength: " << this->Denoising.Strength << '\n';
  os << indent << "KnownNoise: " << this->Denoising.KnownNoise << '\n';
  os << indent << "Flow: " << this->GetFlow() << '\n';
  os << indent << "Order: " << this->Parameters.Order << '\n';
  os << indent << "LowerOrders: " << this->Parameters.LowerOrders << '\n';
  os << indent << "Diffusivity:";
  for (const double diffusivity : this->Parameters.Diffusivity)
  {
    os << ' ' << diffusivity;
  }
  os << '\n';
  os << indent << "EdgeStopping: " << this->GetEdgeStopping() << '\n';
  os << indent << "Sigma: " << this->Parameters.Sigma << '\n';
  os << indent << "Window: " << this->Parameters.Window << '\n';
  os << indent << "PreSmoothing: " << this->Parameters.PreSmoothing << '\n';
  os << indent << "ResidualSmoothing: " << this->Parameters.ResidualSmoothing << '\n';
  os << indent << "Fidelity: " << this->Parameters.Fidelity << '\n';
  os << indent << "UseSource: " << this->UseSource << '\n';
  os << indent << "Time: " << this->Parameters.Time << '\n';
  os << indent << "Integrator: " << this->GetIntegrator() << '\n';
  os << indent << "Steps: " << this->Parameters.Steps << '\n';
}
