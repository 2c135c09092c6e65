#include "MolecularSurfaces/FlowTimes.h"

#include <vtkInformation.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>

namespace isthmus
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

std::vector<double> FlowTimes(int steps, double whole, vtkInformation* input)
{
  std::vector<double> times;
  if (steps > 0 && whole > 0.0 && std::isfinite(whole) && !input->Has(Pipeline::TIME_STEPS()))
  {
    for (int step = 0; step <= steps; ++step)
    {
      times.push_back(whole * step / steps);
    }
  }
  return times;
}

void TellTimes(const std::vector<double>& times, vtkInformation* input, vtkInformation* output)
{
  if (!times.empty())
  {
    const double range[2] = { times.front(), times.back() };
    output->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    output->Set(Pipeline::TIME_RANGE(), range, 2);
  }
  else if (!input->Has(Pipeline::TIME_STEPS()))
  {
    output->Remove(Pipeline::TIME_STEPS());
    output->Remove(Pipeline::TIME_RANGE());
  }
}

double TimeAskedFor(const std::vector<double>& times, vtkInformation* output)
{
  if (!output->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    return times.back();
  }
  const double wanted = output->Get(Pipeline::UPDATE_TIME_STEP());
  return *std::min_element(times.begin(), times.end(),
    [wanted](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); });
}

}
