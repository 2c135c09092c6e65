#include "vtkHighOrderDiffusion.h"

#include "Core/NumberText.h"
#include "Imaging/AutomaticDenoising.h"
#include "Imaging/DiffusionImage.h"
#include "Imaging/HighOrderDiffusion.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
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
    return isthmus::HaloWidth(parameters);
  }
  catch (const std::invalid_argument&)
  {
    return 0; // RequestData will say what is wrong
  }
}

template <typename T>
void vtkHighOrderDiffusion::Denoise(isthmus::DiffusionImage<T>& image)
{
  isthmus::DiffusionParameters parameters = this->GetParameters();
  auto values = image.Copy(this->ChosenScalars(image.GetInput()), this->GetMaskInvalid());
  if (!(this->KnownNoise >= 0.0) || std::isinf(this->KnownNoise))
  {
    throw std::invalid_argument("KnownNoise must be a finite number, 0 (estimated) or more.");
  }
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
    this->Explain(noise, std::accumulate(report.Change.begin(), report.Change.end(), 0.0));
  }
  image.AddResult(values, true);
  image.AddFieldData("StepTime", report.Time);
  image.AddFieldData("StepChange", report.Change);
  image.AddFieldData("StepResidual", report.Residual);
  image.AddFieldData("NoiseLevel", { noise.Noise });
  image.AddFieldData("UsedSigma", { parameters.Sigma });
  image.AddFieldData("UsedPreSmoothing", { parameters.PreSmoothing });
  image.AddFieldData("UsedResidualSmoothing", { parameters.ResidualSmoothing });
  image.AddFieldData("UsedTime", { parameters.Time });
}

void vtkHighOrderDiffusion::Explain(const isthmus::NoiseEstimate& noise, double change)
{
  constexpr char remedy[] = " To smooth it anyway, switch Automatic off and set Time.";
  if (noise.FewValues)
  {
    vtkWarningMacro(<< isthmus::TextOf(
                      "The volume has only a few values, like a mask, labels or a constant: there "
                      "is no noise in it, and it is left as it is.",
                      remedy));
  }
  else if (!(noise.Noise > 0.0))
  {
    vtkWarningMacro(<< isthmus::TextOf(
                      "No noise was found in the volume, which is left as it is: most nodes are "
                      "the mean of their neighbours.",
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
