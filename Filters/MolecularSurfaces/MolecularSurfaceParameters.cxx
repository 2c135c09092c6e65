#include "MolecularSurfaces/MolecularSurfaceParameters.h"

#include "Core/RangeChecks.h"

namespace isthmus
{

void Check(const SurfaceFlowParameters& parameters)
{
  RequireAbove("Spacing", parameters.Spacing, 0.0, LargestLength, "It is in angstrom.");
  RequireRange("Enlargement", parameters.Enlargement, 1.0, LargestLength,
    "It multiplies the radii that the flow starts from.");
  RequireRange("EvolutionTime", parameters.EvolutionTime, 0.0, Unlimited,
    "It is the duration of the flow, in square angstrom.");
  RequireRange("ProbeRadius", parameters.ProbeRadius, 0.0, LargestLength, "0: no probe.");
  RequireRange("Padding", parameters.Padding, 0.0, LargestLength,
    "It is the distance from the enlarged atoms to the border of the grid.");
}

void Check(const SolventParameters& parameters)
{
  RequireRange(
    "SurfaceTension", parameters.SurfaceTension, 0.0, 1e3, "It is an energy per square angstrom.");
  RequireRange("Pressure", parameters.Pressure, -1e3, 1e3, "It is an energy per cubic angstrom.");
  RequireRange("SolventDensity", parameters.SolventDensity, 0.0, Unlimited,
    "It is in molecules per cubic angstrom.");
  RequireRange("SolventRadius", parameters.SolventRadius, 0.0, LargestLength, "It is in angstrom.");
  RequireRange(
    "SolventWellDepth", parameters.SolventWellDepth, 0.0, Unlimited, "It is in kcal/mol.");
}

void CheckMoving(const SolventParameters& parameters)
{
  Check(parameters);
  RequireAbove(
    "SurfaceTension", parameters.SurfaceTension, 0.0, 1e3, "It is an energy per square angstrom.");
}

SurfaceFlowParameters MolecularFlowParameters::Flow() const
{
  SurfaceFlowParameters flow = *this;
  if (this->Preset != FlowPreset::Custom)
  {
    flow.Enlargement = this->Preset == FlowPreset::Coarse ? 2.0 : 1.3;
    flow.EvolutionTime = 2.5;
    flow.Steady = this->Preset == FlowPreset::Hull || this->Preset == FlowPreset::Channel;
    flow.ProbeRadius = this->Preset == FlowPreset::Channel ? 1.4 : 0.0;
  }
  return flow;
}

void Check(const MolecularFlowParameters& parameters)
{
  RequireChoice("Preset", parameters.Preset, FlowPreset::Channel);
  RequireChoice("Method", parameters.Method, FlowMethod::SolventExcluded);
  Check(parameters.Flow());
  CheckMoving(parameters);
  RequireThat(parameters.Level > 0.0 && parameters.Level < 1.0, "Level", parameters.Level,
    "it must be above 0 (outside) and below 1 (inside)");
  RequireRange("TimeSteps", parameters.TimeSteps, 0, 10000);
}

}
