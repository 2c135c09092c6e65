/**
 * @file BoundaryForces.h
 * @brief Forces of the field and the ions on the atoms, through the surface that moves with them.
 *
 * The energy is stationary in the potential, so its derivative with respect to the position of the
 * surface is that at a fixed field (the sharp form of W. Im, D. Beglov and B. Roux, Comput. Phys.
 * Commun. 111 (1998) 59, whose surface is smeared). A point that moves outwards by dn changes it by
 * (pull dn dA), with
 *
 *   pull = kT / (8 pi C) [ (1 / eps_m - 1 / eps_s) (eps_s d_n phi)^2
 *                          + (eps_s - eps_m) |grad_t phi|^2 ]
 *
 * phi in kT/e just outside: the field draws the solvent towards the charges. The boundary of the
 * ions moves with the surface. The pull there is their osmotic pressure relative to the bulk, sum c
 * (exp(-z phi) - 1), or sum c z^2 phi^2 / 2 for the linear equation. The share of each atom in the
 * motion of the surface: SurfaceMotion.
 *
 * A point of the surface moves along its normal by sum_i Part_i . dr_i when the atoms move by dr_i.
 * The vectors Part_i of a point add up to its normal, so the surface moves with the whole molecule.
 */
#ifndef isthmus_BoundaryForces_h
#define isthmus_BoundaryForces_h

#include "Electrostatics/GridPotential.h"
#include "Electrostatics/PoissonBoltzmannParameters.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

#include <cstddef>
#include <cstdint>

namespace isthmus
{

struct SurfaceShare
{
  std::size_t Atom;
  Point3 Part;
};

/// Sorts the atoms into cells of about their size. Memory: 8 bytes for each atom and each cell.
class SurfaceMotion
{
public:
  /**
   * With a decay: the level of sum_i exp(-decay (|x - r_i|^2 / R_i^2 - 1)), whose parts follow from
   * its gradient (terms below 1e-6 and atoms without a radius have none). With decay 0: any other
   * surface, each point of which belongs to the atom with the least |x - r| - R. That is exact for
   * a union of balls and an approximation for other surfaces. The object refers to `atoms`.
   * @pre `atoms` is not empty.
   */
  SurfaceMotion(const std::vector<ChargedAtom>& atoms, double decay);

  /// Computes the shares of a point with an outward unit normal; replaces the contents of `shares`.
  /// O(atoms near).
  void At(const Point3& x, const Point3& normal, std::vector<SurfaceShare>& shares) const;

private:
  template <class Visit>
  void ForEachNear(
    const std::array<std::int64_t, 3>& middle, std::int64_t ring, const Visit& visit) const;
  std::array<std::int64_t, 3> FindCell(const Point3& x) const;
  void GaussianShares(const Point3& x, std::vector<SurfaceShare>& shares) const;
  std::size_t Owner(const Point3& x) const;

  const std::vector<ChargedAtom>& Atoms;
  double Decay;
  double Largest = 0.0; ///< radius
  double Cell = 1.0;
  Point3 Low{ 0.0, 0.0, 0.0 };
  std::array<std::int64_t, 3> Cells{ 1, 1, 1 };
  std::vector<std::size_t> First, Order; ///< atoms by cell
};

/// The pull at each crossing of the surface with the grid, in kcal/mol/angstrom^3; 0 where the
/// field could not be fitted. O(crossings), parallel.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::vector<double> PullAtCrossings(
  const GridPotential& solution, double kelvin);

/// The forces on each atom along the axes of the grid, in kT/angstrom.
struct BoundaryForces
{
  std::vector<Point3> Dielectric, Ionic;
};

/**
 * Of a solved problem. The integral over the surface is the sum over crossings of the grid's edges
 * along each axis, |n_axis| times the area between edges for each; ions at a distance from the
 * surface are summed over the nodes at their border. O(crossings times atoms near + nodes); bitwise
 * the same on any number of threads.
 */
BoundaryForces ForcesOnBoundary(const GridPotential& solution, const SurfaceMotion& motion);

}

#endif
