/**
 * @file InterfaceJumpConditions.h
 * @brief The jump conditions at the surface, built into a fit of the potential on both sides.
 *
 * With n the outward normal, W the curvature tensor, rho = eps_m / eps_s and y = x - x0, the total
 * potential is a quadratic p- inside with the unknowns
 *
 *     phi0, a = d_n phi-, b (tangential gradient), Hn1, Hn2, H11, H22, H12,   Hnn = -H11 - H22,
 *
 * and p+ outside, which follows from the jump conditions [phi] = 0, [eps d_n phi] = 0 along the
 * surface, differentiated along it, and from the equation outside (K = kappa^2 phi0, or 0):
 *
 *     a+ = rho a,  b+ = b,  Ht+ = Ht + (rho - 1) a W,  Hnt+ = rho Hnt - (1 - rho) W b,
 *     Hnn+ = K - tr Ht+.
 *
 * The unknowns are fitted by weighted least squares to all nodes around: p-(y) = u + T2G(y) inside,
 * where u is the reaction potential and T2G the second-order Taylor polynomial of the charges' own
 * potential G, and p+(y) = u outside. Both sides share one fit, so no side ever lacks neighbours.
 * In addition, equations inside have the weight (eps_m / eps_s)^FitExponent, since their truncation
 * error is larger by 1 / rho.
 */
#ifndef isthmus_InterfaceJumpConditions_h
#define isthmus_InterfaceJumpConditions_h

#include "Electrostatics/InterfaceGeometry.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

namespace isthmus
{

/// Parameters that all fits on a grid share.
struct FitMedium
{
  double SoluteDielectric = 2.0;
  double SolventDielectric = 80.0;
  double InsideWeight = 1.0;
  double KappaSquared = 0.0; ///< K / phi0 at the surface; 0 under a layer without ions
  double Length = 1.0;       ///< the unit of length of the fit, about the spacing
};

/// A node that takes part.
struct FitNode
{
  Point3 Offset; ///< from the point
  bool Inside;
  double Weight;
};

constexpr std::size_t MaxFitNodes = 64;

/// The nodes around an edge (4 x 3 x 3) or a point (4 x 4 x 4), x running fastest.
struct FitNodes
{
  std::array<FitNode, MaxFitNodes> Node;
  std::array<std::int64_t, MaxFitNodes> Id;
  std::size_t Count = 0;
};

/// A linear function of the fit's data: sum of Weight[i] x data of node i.
using FitFunctional = std::array<double, MaxFitNodes>;

enum class FitQuality
{
  Quadratic = 0,
  Linear = 1, ///< too few nodes for a quadratic, or an ill-posed one
  None = 2
};

/// Values wanted of the fit.
struct FitTarget
{
  enum Quantity
  {
    InsideValue,  ///< p- at Offset
    OutsideValue, ///< p+ at Offset
    SurfaceValue, ///< phi0
    NormalSlope,  ///< a, inside
    TangentX,     ///< component of b
    TangentY,
    TangentZ
  };
  Quantity What;
  Point3 Offset{ 0.0, 0.0, 0.0 };
};

/**
 * Fits at a point with the given frame and writes one functional for each target. The functionals
 * take as data phi: u + T2G(y) at inside nodes, u at outside nodes. With None nothing is written.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT FitQuality FitInterface(const FitMedium& medium,
  const SurfaceFrame& frame, const FitNodes& nodes, const std::vector<FitTarget>& targets,
  std::vector<FitFunctional>& functionals);

}

#endif
