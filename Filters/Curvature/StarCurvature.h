/**
 * @file StarCurvature.h
 * @brief Angle defect, cotangent sum and area of one point of a triangle surface.
 */
#ifndef isthmus_StarCurvature_h
#define isthmus_StarCurvature_h

#include "Core/TriangleMesh.h"
#include "Curvature/SurfaceCurvatureParameters.h"
#include "Surfaces/TriangleStars.h"

#include <Eigen/Dense>

namespace isthmus
{

/// Sums over the triangles around a point; see SurfaceCurvature.h for the formulas.
struct StarSums
{
  double Angle = 0.0;
  double Area = 0.0;
  Eigen::Vector3d Normal = Eigen::Vector3d::Zero();    ///< weighted with areas, not normalised
  Eigen::Vector3d Cotangent = Eigen::Vector3d::Zero(); ///< 4 A H n
  bool Degenerate = false; ///< a triangle has no area, to rounding; it is left out
};

StarSums SumStar(
  const SurfaceView& mesh, const TriangleStars& stars, vtkIdType point, DualArea rule);

}

#endif
