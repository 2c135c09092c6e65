#include "Imaging/DiffusionParameters.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace isthmus
{
namespace
{

void Require(bool holds, const char* what, double value, const char* rule)
{
  if (!holds)
  {
    std::ostringstream text;
    text << what << " is " << value << ", but must be " << rule << '.';
    throw std::invalid_argument(text.str());
  }
}

}

void Check(const DiffusionParameters& parameters)
{
  using Parameters = DiffusionParameters;
  Require(
    parameters.Order >= 0 && parameters.Order <= 3, "Order", parameters.Order, "0, 1, 2 or 3");
  Require(parameters.Time >= 0.0 && std::isfinite(parameters.Time), "Time", parameters.Time,
    "finite and not negative");
  Require(parameters.Steps >= 0, "Steps", parameters.Steps, "positive, or 0 for automatic steps");
  Require(parameters.Fidelity >= 0.0 && std::isfinite(parameters.Fidelity), "Fidelity",
    parameters.Fidelity, "finite and not negative");
  Require(parameters.PreSmoothing >= 0.0 && std::isfinite(parameters.PreSmoothing), "PreSmoothing",
    parameters.PreSmoothing, "finite and not negative");
  Require(parameters.ResidualSmoothing >= 0.0 && std::isfinite(parameters.ResidualSmoothing),
    "ResidualSmoothing", parameters.ResidualSmoothing, "finite and not negative");
  for (const double diffusivity : parameters.Diffusivity)
  {
    Require(diffusivity >= 0.0 && std::isfinite(diffusivity), "A diffusivity", diffusivity,
      "finite and not negative");
  }
  const double highest = parameters.Diffusivity[static_cast<std::size_t>(parameters.Order)];
  Require(highest > 0.0, "The diffusivity of the highest order", highest, "positive");
  const bool geometric = parameters.Flow == Parameters::FlowType::GeometricFlow;
  const bool local = parameters.EdgeStopping == Parameters::EdgeStoppingType::LocalVariance;
  if (geometric || parameters.EdgeStopping == Parameters::EdgeStoppingType::Gaussian)
  {
    Require(parameters.Sigma > 0.0 && std::isfinite(parameters.Sigma), "Sigma", parameters.Sigma,
      "finite and positive");
  }
  if (local)
  {
    Require(parameters.Window >= 3 && parameters.Window % 2 == 1, "Window", parameters.Window,
      "odd and at least 3, so that it has a middle");
  }
}

}
