/**
 * @file GridChecks.h
 * @brief Grids and meshes for them, with distance and inside by brute force.
 */
#ifndef isthmus_GridChecks_h
#define isthmus_GridChecks_h

#include "Core/Geometry.h"
#include "SurfaceModels.h"
#include "Surfaces/SurfaceCrossings.h"

#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkTriangle.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus::testing
{

inline GridShape Cube(int nodes, double side)
{
  const double h = side / (nodes - 1);
  return { { nodes, nodes, nodes }, { h, h, h } };
}

inline Model Translate(Model model, double x, double y, double z)
{
  for (Vector& p : model.Points)
  {
    p = { p[0] + x, p[1] + y, p[2] + z };
  }
  return model;
}

/// Distance to the nearest of all triangles, by VTK's point-triangle distance.
inline double BruteForce(const Model& model, const Vector& x)
{
  double nearest = std::numeric_limits<double>::infinity();
  vtkNew<vtkTriangle> triangle;
  for (const auto& t : model.Triangles)
  {
    double closest[3], parameters[3], weights[3], squared = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      triangle->GetPoints()->SetPoint(
        c, model.Points[static_cast<std::size_t>(t[static_cast<std::size_t>(c)])].data());
    }
    int part = 0;
    triangle->EvaluatePosition(x.data(), closest, part, parameters, squared, weights);
    nearest = std::min(nearest, squared);
  }
  return std::sqrt(nearest);
}

/// Sum of the solid angles of all triangles seen from `x`, over 4 pi: 1 inside, 0 outside.
inline double WindingNumber(const Model& model, const Vector& x)
{
  double sum = 0.0;
  for (const auto& t : model.Triangles)
  {
    double r[3][3], length[3];
    for (std::size_t c = 0; c < 3; ++c)
    {
      vtkMath::Subtract(model.Points[static_cast<std::size_t>(t[c])].data(), x.data(), r[c]);
      length[c] = vtkMath::Norm(r[c]);
    }
    const double volume = vtkMath::Determinant3x3(r[0], r[1], r[2]);
    const double rest = length[0] * length[1] * length[2] + vtkMath::Dot(r[0], r[1]) * length[2] +
      vtkMath::Dot(r[1], r[2]) * length[0] + vtkMath::Dot(r[2], r[0]) * length[1];
    sum += 2.0 * std::atan2(volume, rest);
  }
  return sum / (4.0 * Pi);
}

}

#endif
