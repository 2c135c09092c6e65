#include "Solvation/SolvationParameters.h"

#include "Core/RangeChecks.h"

namespace isthmus
{
namespace
{

void CheckTolerance(const char* property, double value)
{
  RequireAbove(property, value, 0.0, 1.0, "It is a relative change.");
}

}

void Check(const UpdatePolicy& policy)
{
  RequireRange("UpdatePeriod", policy.UpdatePeriod, 1, 1e6);
  RequireRange("MaximumUpdates", policy.MaximumUpdates, 1, 1e6);
  RequireAbove("SurfaceRelaxation", policy.SurfaceRelaxation, 0.0, 1.0,
    "It is the fraction of each motion that is used.");
  RequireAbove("FieldRelaxation", policy.FieldRelaxation, 0.0, 1.0,
    "It is the fraction of each new force that is used.");
}

void Check(const SolvationParameters& parameters)
{
  Check(parameters.Flow);
  CheckMoving(parameters.Solvent);
  Check(parameters.Potential);
  Check(parameters.Policy);
  CheckTolerance("EnergyTolerance", parameters.EnergyTolerance);
}

void Check(const MovingChannelParameters& parameters)
{
  CheckMoving(parameters.Solvent);
  Check(parameters.Policy);
  CheckTolerance("UpdateTolerance", parameters.UpdateTolerance);
}

}
