/**
 * @file SurfaceMotion.h
 * @brief How a molecule's surface moves when one of its atoms does.
 *
 * A point of the surface moves along its normal by sum_i Part_i . dr_i when the atoms move by dr_i.
 * The parts of a point add up to the normal, so that the surface goes along with all of the atoms.
 */
#ifndef isthmus_SurfaceMotion_h
#define isthmus_SurfaceMotion_h

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

/// Atoms in cells of about their size. Memory 8 bytes an atom and cell.
class VTKISTHMUSFILTERSELECTROSTATICS_EXPORT SurfaceMotion
{
public:
  /**
   * With a decay: the level of sum_i exp(-decay (|x - r_i|^2 / R_i^2 - 1)), whose parts follow from
   * its gradient (terms below 1e-6 and atoms without a radius have none). With decay 0: any other
   * surface, each point of which belongs to the atom with the least |x - r| - R. That is exact for
   * a union of balls, a rule for others. Refers to the atoms. @pre There are some.
   */
  SurfaceMotion(const std::vector<ChargedAtom>& atoms, double decay);

  /// The shares of a point with an outward unit normal, replacing what is there. O(atoms near).
  void At(const Point3& x, const Point3& normal, std::vector<SurfaceShare>& shares) const;

private:
  template <class Visit>
  void ForNear(
    const std::array<std::int64_t, 3>& middle, std::int64_t ring, const Visit& visit) const;
  std::array<std::int64_t, 3> CellOf(const Point3& x) const;
  void OfGaussians(const Point3& x, std::vector<SurfaceShare>& shares) const;
  std::size_t Owner(const Point3& x) const;

  const std::vector<ChargedAtom>& Atoms;
  double Decay;
  double Largest = 0.0; ///< radius
  double Cell = 1.0;
  Point3 Low{ 0.0, 0.0, 0.0 };
  std::array<std::int64_t, 3> Cells{ 1, 1, 1 };
  std::vector<std::size_t> First, Order; ///< atoms by cell
};

}

#endif
