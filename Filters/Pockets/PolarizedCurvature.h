/**
 * @file PolarizedCurvature.h
 * @brief Products of a surface's principal curvatures with the electrostatic potential on it.
 *
 * With Phi the potential at a point, Phi+ = max(Phi, 0), Phi- = min(Phi, 0), and kappa_1 >= kappa_2
 * the principal curvatures (a sphere's are positive), the four polarized curvatures are
 *
 *     Phi+ kappa_1,  Phi+ kappa_2,  Phi- kappa_1,  Phi- kappa_2,
 *
 * and their large amplitudes indicate (X. Feng's thesis, section 5.2.5, Table 5.7)
 *
 *                      kappa_1 > 0                        kappa_2 < 0
 *     Phi > 0   1 negatively charged protein   2 negatively charged small ligand
 *     Phi < 0   3 positively charged protein   4 positively charged small ligand
 *
 * The combined map Phi kappa_2 is the one of Fig. 5.9. The thesis does not say to which class a
 * saddle (kappa_1 > 0 and kappa_2 < 0) belongs: here it has the class with the larger amplitude, or
 * the ligand class if both are equal. Units: potential kT/e, curvature 1/angstrom, products kT/(e
 * angstrom).
 */
#ifndef isthmus_PolarizedCurvature_h
#define isthmus_PolarizedCurvature_h

#include "Core/GridView.h"
#include "Core/Progress.h"

#include <vtkType.h>

#include <algorithm>
#include <array>

namespace isthmus
{

enum class SiteClass : unsigned char
{
  None = 0,
  NegativeProtein = 1,
  NegativeLigand = 2,
  PositiveProtein = 3,
  PositiveLigand = 4
};

constexpr unsigned char NumberOfSiteClasses = 5;

/// For example "site for a negatively charged small ligand".
const char* SiteClassName(SiteClass site);

/// The quantities at a point of a surface, see above.
struct PolarizedPoint
{
  double PositiveKappa1;
  double PositiveKappa2;
  double NegativeKappa1;
  double NegativeKappa2;
  double CombineSurfaces; ///< Phi kappa_2
  SiteClass Site;         ///< None if no amplitude is above `least`, and for NaN
};

inline PolarizedPoint Polarize(double potential, double kappa1, double kappa2, double least)
{
  // NaN stays NaN: std::max(NaN, 0) would, std::max(0, NaN) would not.
  const double positive = std::max(potential, 0.0);
  const double negative = std::min(potential, 0.0);
  PolarizedPoint point{ positive * kappa1, positive * kappa2, negative * kappa1, negative * kappa2,
    potential * kappa2, SiteClass::None };
  const double amplitude = potential > 0.0 ? potential : -potential;
  const bool protein = kappa1 > 0.0 && amplitude * kappa1 > least;
  const bool ligand = kappa2 < 0.0 && amplitude * -kappa2 > least;
  if (ligand && !(protein && kappa1 > -kappa2))
  {
    point.Site = potential > 0.0 ? SiteClass::NegativeLigand : SiteClass::PositiveLigand;
  }
  else if (protein)
  {
    point.Site = potential > 0.0 ? SiteClass::NegativeProtein : SiteClass::PositiveProtein;
  }
  return point;
}

/// Transformation from world to grid: node indices = Matrix (x, y, z, 1), with rows of four
/// numbers.
using GridTransform = std::array<double, 12>;

/**
 * `grid` interpolated at `count` points (x y z each): trilinear between nodes (thesis 5.18 to
 * 5.20), NaN outside the grid and where one of the surrounding nodes is not finite. A point at most
 * 1e-9 grid spacings outside counts as being on the border. T is float or double.
 *
 * Runs in parallel; bitwise the same on any number of threads. Throws Cancelled.
 */
template <typename T>
void SamplePotential(const GridView<const T>& grid, const GridTransform& toGrid,
  const double* points, vtkIdType count, double* values, const ProgressCallback& progress = {});

}

#endif
