#include "Contouring/DualContouring.h"

#include "Contouring/ContourRefinement.h"

#include <stdexcept>

namespace isthmus
{
namespace
{

void Check(const HermiteGrid& grid, const DualContouringParameters& parameters)
{
  if (!(parameters.FeatureThreshold >= 0.0 && parameters.FeatureThreshold <= 1.0))
  {
    throw std::invalid_argument("The feature threshold must be from 0 to 1.");
  }
  if (!(parameters.Reach >= 0.0 && parameters.Reach <= 1.0))
  {
    throw std::invalid_argument("The reach of a vertex must be from 0 to 1 spacings.");
  }
  if (!(parameters.Tolerance >= 0.0) || std::isinf(parameters.Tolerance))
  {
    throw std::invalid_argument("The tolerance is a length: give a positive one, or 0 for the "
                                "surface of all cells.");
  }
  if (parameters.FreeOfCrossings && (parameters.Reach > 0.0 || !parameters.Triangles))
  {
    throw std::invalid_argument("Only triangles whose points stay in their cells can be kept from "
                                "crossing: set the reach to 0 and ask for triangles.");
  }
  const auto& n = grid.Shape.Dimensions;
  if (n[0] < 2 || n[1] < 2 || n[2] < 2)
  {
    throw std::invalid_argument("The grid has fewer than two nodes along an axis.");
  }
}

}

DualContour DualContouring(const HermiteGrid& grid, const DualContouringParameters& parameters,
  const ProgressCallback& progress)
{
  Check(grid, parameters);
  const UniformContour uniform = MakeUniformContour(grid, parameters, Between(progress, 0.0, 0.5));
  Report(progress, 0.5);
  DualContour contour = RefinedContour(uniform, parameters, Between(progress, 0.5, 1.0));
  Report(progress, 1.0);
  return contour;
}

}
