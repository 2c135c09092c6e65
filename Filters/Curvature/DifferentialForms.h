/**
 * @file DifferentialForms.h
 * @brief Gauss map, shape operator, fundamental forms and normal curvature, from principal
 * curvatures.
 *
 * At a point with unit normal n, principal curvatures k_1 >= k_2 and principal directions t_1, t_2,
 * the shape operator is S = k_1 t_1 t_1^T + k_2 t_2 t_2^T, and in the direction of a unit tangent w
 * the surface bends with the normal curvature w^T S w = k_1 cos^2 + k_2 sin^2 of the angle between
 * t_1 and w (Euler). To second order, the height of the surface above its tangent plane at w, along
 * the outward normal, is -w^T S w / 2.
 *
 * The fundamental forms need a parametrisation: the surface is taken as a graph over the coordinate
 * plane whose axis is closest to the normal. If z is that axis and x and y are the two that follow
 * it cyclically (z, x, y form a right-handed system), a point is (u, v, f(u, v)), f_u = -n_x / n_z,
 * and
 *
 *     x_u = (1, 0, f_u),  x_v = (0, 1, f_v)
 *     E = x_u . x_u,  F = x_u . x_v,  G = x_v . x_v
 *     L = x_u . S x_u,  M = x_u . S x_v,  N = x_v . S x_v
 *
 * so that K = (L N - M^2) / (E G - F^2), H = (E N - 2 F M + G L) / (2 (E G - F^2)), and sqrt(E G -
 * F^2) is the area of the surface per unit area of the plane. (X. Feng's thesis, 2.3 to 2.26, 5.30
 * to 5.41.) Signs: for a sphere L, N, k_1 and k_2 are positive, whatever the direction of n.
 */
#ifndef isthmus_DifferentialForms_h
#define isthmus_DifferentialForms_h

#include "Core/Geometry.h"
#include "vtkIsthmusFiltersCurvatureModule.h" // for the export macro

#include <array>

class vtkDataArraySelection;
class vtkDataSet;

namespace isthmus
{

/// The second-order approximation of a surface at a point.
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

/// @pre The normal is a unit vector, or zero, in which case all results are zero.
DifferentialForms ComputeForms(const LocalShape& shape);

/// The normal curvature in the direction of the tangential component of `direction`; 0 if that is
/// zero.
double NormalCurvature(const LocalShape& shape, const Point3& direction);

/// Which arrays to add.
struct DifferentialFormsSelection
{
  bool GaussMap = false;
  bool ShapeOperator = false;
  bool First = false;
  bool Second = false;
  bool AreaElement = false;
  bool NormalCurvature = false;
  Point3 Direction{}; ///< of NormalCurvature

  DifferentialFormsSelection() = default;
  /// Those whose names `arrays` has.
  DifferentialFormsSelection(vtkDataArraySelection* arrays, const double direction[3]);

  bool AnyForm() const
  {
    return this->ShapeOperator || this->First || this->Second || this->AreaElement;
  }
  bool Any() const { return this->GaussMap || this->AnyForm() || this->NormalCurvature; }

  /// @throws std::invalid_argument if the direction is needed and is zero or not finite.
  VTKISTHMUSFILTERSCURVATURE_EXPORT void Check() const;
};

/// Adds the arrays to the points of `output`, from its arrays `GaussMap`, `MaximumCurvature`,
/// `MinimumCurvature`, `PrincipalDirection1` and `PrincipalDirection2`, in their type; directions
/// are projected to the plane perpendicular to the normal. Does nothing if one of these is missing.
/// `GaussMap` itself is removed if it is not selected.
void AddDifferentialForms(const DifferentialFormsSelection& selection, vtkDataSet* output);

}

#endif
