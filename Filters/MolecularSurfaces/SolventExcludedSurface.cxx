#include "MolecularSurfaces/SolventExcludedSurface.h"

#include "MolecularSurfaces/BallDistance.h"
#include "MolecularSurfaces/FlowBand.h"
#include "MolecularSurfaces/FlowMemory.h"
#include "MolecularSurfaces/FlowResult.h"
#include "MolecularSurfaces/FlowStart.h"
#include "MolecularSurfaces/SolventExcludedDistance.h"

namespace isthmus
{

SurfaceFlowResult SolventExcludedSurface(const std::vector<Ball>& balls,
  const SurfaceFlowParameters& parameters, const ProgressCallback& progress)
{
  SurfaceFlowResult result;
  CheckFlow(balls, parameters);
  if (balls.empty())
  {
    return result;
  }
  CheckFlowMemory(balls, FlowGridAround(balls, parameters));
  FlowField field(FlowGrid(FlowGridAround(balls, parameters)));
  DistanceToBalls(field.Grid, balls, 1.0, 0.0, static_cast<double>(FlowGrid::Band), field.Ceiling,
    Between(progress, 0.0, 0.2));
  CheckAnythingInside(field, balls, parameters);
  if (parameters.ProbeRadius > 0.0)
  {
    SolventExcludedDistance(
      field.Grid, balls, parameters.ProbeRadius, field.Distance, Between(progress, 0.2, 0.9));
  }
  else
  {
    field.Distance = field.Ceiling;
  }
  FindBand(field);
  Record(field, 0.0, result);
  StoreDistances(field, result);
  Report(progress, 1.0);
  return result;
}

}
