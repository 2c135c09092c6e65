#include "vtkHighOrderDiffusion.h"

#include "Core/NumberText.h"
#include "Core/RangeChecks.h"
#include "Imaging/AutomaticDenoising.h"
#include "Imaging/DiffusionImage.h"
#include "Imaging/HighOrderDiffusion.h"

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

namespace
{

template <typename Enumeration>
Enumeration Choice(const char* name, int value, Enumeration last)
{
  if (value < 0 || value > static_cast<int>(last))
  {
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
      ", but must be from 0 to " + std::to_string(static_cast<int>(last)) + '.');
  }
  return static_cast<Enumeration>(value);
}

}

vtkHighOrderDiffusion::vtkHighOrderDiffusion() = default;

isthmus::DiffusionParameters vtkHighOrderDiffusion::GetParameters()
{
  using Parameters = isthmus::DiffusionParameters;
  Parameters parameters;
  parameters.Flow = Choice("Flow", this->Flow, Parameters::FlowType::GeometricFlow);
  parameters.EdgeStopping =
    Choice("EdgeStopping", this->EdgeStopping, Parameters::EdgeStoppingType::LocalVariance);
  parameters.Integrator =
    Choice("Integrator", this->Integrator, Parameters::IntegratorType::SuperTimeStepping);
  parameters.Order = this->Order;
  parameters.LowerOrders = this->LowerOrders;
  std::copy_n(this->Diffusivity, 4, parameters.Diffusivity.begin());
  isthmus::RequireThat(!std::isnan(this->Sigma), "Sigma", this->Sigma, "it must be a number");
  parameters.Sigma = this->Sigma > 0.0 || this->Sigma < 0.0 ? this->Sigma : 1.0;
  parameters.Window = this->Window;
  parameters.PreSmoothing = this->PreSmoothing;
  parameters.ResidualSmoothing = this->ResidualSmoothing;
  parameters.Fidelity = this->Fidelity;
  parameters.Time = this->Time;
  parameters.Steps = this->Steps;
  isthmus::Check(parameters);
  return parameters;
}

int vtkHighOrderDiffusion::HaloWidth()
{
  try
  {
    isthmus::DiffusionParameters parameters = this->GetParameters();
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
  return this->Automatic && this->Flow == Hyperdiffusion && !this->LowerOrders &&
    this->EdgeStopping != LocalVariance && this->Fidelity == 0.0 && !this->UseSource &&
    std::all_of(this->Diffusivity, this->Diffusivity + 4, [](double d) { return d == 1.0; });
}

template <typename T>
void vtkHighOrderDiffusion::DenoiseByRisk(isthmus::DiffusionImage<T>& image)
{
  const isthmus::DiffusionParameters given = this->GetParameters();
  isthmus::AutomaticParameters parameters;
  parameters.Search.Goal = Choice("Goal", this->Goal, isthmus::DenoisingGoal::Volumes);
  parameters.Search.LinearOnly = this->EdgeStopping == None;
  parameters.Search.Strength = this->Strength;
  parameters.KnownNoise = this->KnownNoise;
  parameters.Integrator = given.Integrator;
  parameters.Steps = given.Steps;
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
  isthmus::RequireRange("Strength", this->Strength, 0.0, 1.0);
  if (!(this->KnownNoise >= 0.0) || std::isinf(this->KnownNoise))
  {
    throw std::invalid_argument("KnownNoise must be a finite number, 0 (estimated) or more.");
  }
  if (this->ChoosesByRisk())
  {
    this->DenoiseByRisk(image);
    return;
  }
  isthmus::DiffusionParameters parameters = this->GetParameters();
  auto values = image.Copy(this->ChosenScalars(image.GetInput()), this->GetMaskInvalid());
  isthmus::NoiseEstimate noise = isthmus::EstimateNoise(image.GetGrid(), values->GetPointer(0));
  if (this->KnownNoise > 0.0)
  {
    noise.Noise = this->KnownNoise;
  }
  const auto& spacing = image.GetGrid().Spacing;
  const double voxel = *std::min_element(spacing.begin(), spacing.end());
  if (this->Automatic)
  {
    isthmus::ChooseDenoisingParameters(noise, this->Strength, voxel, parameters);
  }
  else if (this->Sigma == 0.0)
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
  os << indent << "Goal: " << this->Goal << '\n';
  os << indent << "Strength: " << this->Strength << '\n';
  os << indent << "KnownNoise: " << this->KnownNoise << '\n';
  os << indent << "Flow: " << this->Flow << '\n';
  os << indent << "Order: " << this->Order << '\n';
  os << indent << "LowerOrders: " << this->LowerOrders << '\n';
  os << indent << "Diffusivity: " << this->Diffusivity[0] << ' ' << this->Diffusivity[1] << ' '
     << this->Diffusivity[2] << ' ' << this->Diffusivity[3] << '\n';
  os << indent << "EdgeStopping: " << this->EdgeStopping << '\n';
  os << indent << "Sigma: " << this->Sigma << '\n';
  os << indent << "Window: " << this->Window << '\n';
  os << indent << "PreSmoothing: " << this->PreSmoothing << '\n';
  os << indent << "ResidualSmoothing: " << this->ResidualSmoothing << '\n';
  os << indent << "Fidelity: " << this->Fidelity << '\n';
  os << indent << "UseSource: " << this->UseSource << '\n';
  os << indent << "Time: " << this->Time << '\n';
  os << indent << "Integrator: " << this->Integrator << '\n';
  os << indent << "Steps: " << this->Steps << '\n';
}
