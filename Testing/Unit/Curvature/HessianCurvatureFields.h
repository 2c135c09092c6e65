/**
 * @file HessianCurvatureFields.h
 * @brief Fields whose level sets are known, on lattices of any direction, and what the filter
 * computes for them.
 */
#ifndef isthmus_HessianCurvatureFields_h
#define isthmus_HessianCurvatureFields_h

#include "FieldImage.h"
#include "vtkHessianCurvature.h"

#include <cmath>

namespace isthmus::testing
{

/// 1 / (1 + q), level sets around the origin with half axes 4 : 3 : 2, turned to no grid axis.
inline double Ellipsoids(double x, double y, double z)
{
  return 1.0 / (1.0 + x * x / 16.0 + y * y / 9.0 + z * z / 4.0);
}

inline double Spheres(double x, double y, double z)
{
  return 1.0 / (1.0 + x * x + y * y + z * z);
}

inline Lattice Block()
{
  Lattice lattice = CenteredCube(17, 1.0);
  lattice.Dimensions = { 17, 15, 13 };
  lattice.Origin = { 0.3, 0.4, 0.5 };
  return lattice;
}

/// The lattice rotated about an axis that is not one of its own.
inline Lattice Rotate(Lattice lattice)
{
  const double c = std::cos(0.6), s = std::sin(0.6), t = std::cos(1.1), u = std::sin(1.1);
  lattice.Direction = { c, -s * t, s * u, s, c * t, -c * u, 0.0, u, t };
  return lattice;
}

inline double Value(vtkHessianCurvature* filter, const char* name, vtkIdType id)
{
  return PointArray(filter->GetOutputDataObject(0), name)->GetComponent(id, 0);
}

}

#endif
