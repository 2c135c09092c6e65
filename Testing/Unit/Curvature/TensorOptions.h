/**
 * @file TensorOptions.h
 * @brief Curvature by the edge tensor over a neighbourhood, and by a fit of normals.
 */
#ifndef isthmus_TensorOptions_h
#define isthmus_TensorOptions_h

#include "Curvature/SurfaceCurvature.h"

namespace isthmus::testing
{

inline SurfaceCurvatureOptions Tensor(CurvatureNeighbourhood neighbourhood, double radius = 0.0)
{
  SurfaceCurvatureOptions options;
  options.Method = CurvatureEstimate::EdgeTensor;
  options.Neighbourhood = neighbourhood;
  options.Radius = radius;
  return options;
}

inline SurfaceCurvatureOptions Fit(double radius = 0.0)
{
  SurfaceCurvatureOptions options;
  options.Method = CurvatureEstimate::NormalFit;
  options.Radius = radius;
  return options;
}

}

#endif
