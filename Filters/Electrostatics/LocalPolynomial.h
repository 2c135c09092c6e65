/**
 * @file LocalPolynomial.h
 * @brief The level function between the nodes: polynomials of degree five along each axis.
 */
#ifndef isthmus_LocalPolynomial_h
#define isthmus_LocalPolynomial_h

#include "Electrostatics/LevelFunction.h"

#include <array>
#include <cstdint>

namespace isthmus
{

constexpr int Reach = 6;  ///< nodes along a line
constexpr int Before = 2; ///< of them, before the first end of the edge

/// Weights of the six nodes -2..3 for the value and two derivatives (per spacing) at t.
struct LineWeights
{
  double Value[Reach], First[Reach], Second[Reach];
};

/// @param t place on the edge between nodes 0 and 1, in spacings.
LineWeights WeightsAt(double t);

/// The function at a node of the box.
double Sample(
  const LevelFunction& level, const SolverBox& box, const std::array<std::int64_t, 3>& p);

/// Value and derivatives at a point, of the polynomial through the 6^3 nodes around it.
struct LocalPolynomial
{
  double Value = 0.0;
  Point3 Gradient{ 0.0, 0.0, 0.0 };
  double Hessian[3][3] = {};

  LocalPolynomial(const LevelFunction& level, const SolverBox& box, const Point3& x);
};

}

#endif
