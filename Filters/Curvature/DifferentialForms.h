/**
 * @file DifferentialForms.h
 * @brief Gauss map, shape operator, fundamental forms and normal curvature, from principal ones.
 *
 * At a point with unit normal n, principal curvatures k_1 >= k_2 and principal directions t_1, t_2,
 * the shape operator is S = k_1 t_1 t_1^T + k_2 t_2 t_2^T, and in the direction of a unit tangent w
 * the surface bends with the normal curvature w^T S w = k_1 cos^2 + k_2 sin^2 of the angle between
 * t_1 and w (Euler). The height of the surface above its tangent plane, along the outward normal,
 * is -w^T S w / 2 at w, to second order.
 *
 * The fundamental forms need a parametrisation: the graph over the coordinate plane that the normal
 * is closest to the axis of. With that axis z and the two that follow it cyclically, x and y (z, x,
 * y in the order of a right-handed system), a point is (u, v, f(u, v)), f_u = -n_x / n_z, and
 *
 *     x_u = (1, 0, f_u),  x_v = (0, 1, f_v)
 *     E = x_u . x_u,  F = x_u . x_v,  G = x_v . x_v
 *     L = x_u . S x_u,  M = x_u . S x_v,  N = x_v . S x_v
 *
 * so that K = (L N - M^2) / (E G - F^2), H = (E N - 2 F M + G L) / (2 (E G - F^2)), and
 * sqrt(E G - F^2) is the area of the surface above a unit of area of the plane. (X. Feng's thesis,
 * 2.3 to 2.26, 5.30 to 5.41.) Signs: a sphere has positive L, N, k_1 and k_2, whichever way n is.
 */
#ifndef isthmus_DifferentialForms_h
#define isthmus_DifferentialForms_h

#include "Core/Geometry.h"
#include "vtkIsthmusFiltersCurvatureModule.h" // for the export macro

#include <array>

class vtkDataSet;

namespace isthmus
{

/// A surface at one of its points, to second order.
struct LocalShape
{
  Point3 Normal{ 0.0, 0.0, 0.0 };
  Point3 Direction1{ 0.0, 0.0, 0.0 }; ///< of Maximum
  Point3 Direction2{ 0.0, 0.0, 0.0 };
  double Maximum = 0.0;
  double Minimum = 0.0;
};

struct DifferentialForms
{
  std::array<double, 6> ShapeOperator{}; ///< xx, yy, zz, xy, yz, xz
  std::array<double, 3> First{};         ///< E, F, G
  std::array<double, 3> Second{};        ///< L, M, N
  double AreaElement = 0.0;              ///< sqrt(E G - F^2)
};

/// @pre The normal is a unit vector, or zero: then all is zero.
VTKISTHMUSFILTERSCURVATURE_EXPORT DifferentialForms FormsOf(const LocalShape& shape);

/// In the direction of the part of `direction` that is tangent to the surface; 0 where there is
/// none.
VTKISTHMUSFILTERSCURVATURE_EXPORT double NormalCurvature(
  const LocalShape& shape, const Point3& direction);

struct DifferentialFormsSelection
{
  bool Forms = false;
  bool NormalCurvature = false;
  Point3 Direction{ 1.0, 0.0, 0.0 };

  bool Any() const { return this->Forms || this->NormalCurvature; }

  /// @throws std::invalid_argument where the direction is needed and is zero or not finite.
  VTKISTHMUSFILTERSCURVATURE_EXPORT void Check() const;
};

/// Adds the arrays to the points of `output`, from its arrays `GaussMap`, `MaximumCurvature`,
/// `MinimumCurvature`, `PrincipalDirection1` and `PrincipalDirection2`, in their type; directions
/// are turned into the plane across the normal. Nothing where one of these is missing. `GaussMap`
/// itself goes where the forms are not wanted.
VTKISTHMUSFILTERSCURVATURE_EXPORT void AddDifferentialForms(
  const DifferentialFormsSelection& selection, vtkDataSet* output);

}

#endif
