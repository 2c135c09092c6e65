#include "vtkHighOrderDiffusion.h"

#include "Imaging/DiffusionImage.h"
#include "Imaging/NoiseEstimate.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkHighOrderDiffusion);

const std::vector<isthmus::OutputArray>& vtkHighOrderDiffusion::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "INPUT", 1, "of the scalars", ArrayChoice::None,
      "the values after the diffusion, with the input array's name" },
    { 0, ArrayPlace::Field, "NoiseLevel", 1, "of the scalars", ArrayChoice::None,
      "standard deviation of the noise; where Sigma is derived from it" },
    { 0, ArrayPlace::Field, "UsedSigma", 1, "of the scalars per length", ArrayChoice::None,
      "where it is derived from the noise" },
    { 0, ArrayPlace::Field, "StepTime", 1, "", ArrayChoice::None, "time at the end of each step" },
    { 0, ArrayPlace::Field, "StepChange", 1, "of the scalars", ArrayChoice::None,
      "rms of what the step changed" },
    { 0, ArrayPlace::Field, "StepResidual", 1, "of the scalars per time", ArrayChoice::None,
      "rms of the rate at the start of the step" },
  };
  return table;
}

vtkHighOrderDiffusion::vtkHighOrderDiffusion() = default;

int vtkHighOrderDiffusion::HaloWidth()
{
  try
  {
    isthmus::Check(this->Parameters);
    return isthmus::HaloWidth(this->Parameters);
  }
  catch (const std::invalid_argument&)
  {
    return 0; // Process() will throw it again, where it becomes an error of the filter
  }
}

template <typename T>
void vtkHighOrderDiffusion::Diffuse(isthmus::DiffusionImage<T>& image)
{
  isthmus::Check(this->Parameters); // before volumes are allocated
  isthmus::DiffusionParameters parameters = this->Parameters;
  auto values = image.Copy(this->ChosenScalars(image.GetInput()), this->GetMaskInvalid());
  if (parameters.UsesSigma() && parameters.Sigma == 0.0)
  {
    const auto& spacing = image.GetGrid().Spacing;
    const isthmus::NoiseEstimate noise =
      isthmus::EstimateNoise(image.GetGrid(), values->GetPointer(0));
    parameters.Sigma =
      isthmus::NoiseGradient(noise, *std::min_element(spacing.begin(), spacing.end()));
    image.AddFieldData("NoiseLevel", { noise.Noise });
    image.AddFieldData("UsedSigma", { parameters.Sigma });
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
  image.AddResult(values, true);
  image.AddFieldData("StepTime", report.Time);
  image.AddFieldData("StepChange", report.Change);
  image.AddFieldData("StepResidual", report.Residual);
}

void vtkHighOrderDiffusion::Process(isthmus::DiffusionImage<float>& image)
{
  this->Diffuse(image);
}

void vtkHighOrderDiffusion::Process(isthmus::DiffusionImage<double>& image)
{
  this->Diffuse(image);
}

void vtkHighOrderDiffusion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VoxelUnits: " << this->VoxelUnits << '\n';
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
