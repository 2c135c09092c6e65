/**
 * @file TransportCurrents.h
 * @brief Currents through cross-sections of a channel, and flux densities at nodes.
 */
#ifndef isthmus_TransportCurrents_h
#define isthmus_TransportCurrents_h

#include "Solvation/PoissonNernstPlanck.h"

namespace isthmus
{

/// Currents in pA, positive along the membrane's normal.
struct CurrentProfile
{
  std::vector<double> Along;                 ///< of the sections, angstrom from the center
  std::vector<std::vector<double>> Currents; ///< by species, one for each section

  double Mean(std::size_t species) const;
  double Mean() const; ///< of all species together
  /// The largest difference of a section's whole current from the mean, as a part of the sum of the
  /// species' sizes; 0 where there is no current.
  double Spread() const;
};

/**
 * There is a section, normal to the channel, between each two layers of the domain. Its current is
 * that of the edges of the grid that pass through it, even if they are oblique to the section.
 * Inflow and outflow of each node are equal, so the currents through all sections are the same up
 * to the accuracy of the solution. O(nodes).
 */
CurrentProfile ComputeCurrents(const PoissonNernstPlanck& solution);

/// The flux of a species at a node, in ions per nanosecond and square angstrom: the mean over its
/// faces.
Point3 FluxAt(const PoissonNernstPlanck& solution, SpeciesId species, std::int64_t node);

/// pA for an ion of 1 e per nanosecond.
double PicoamperePerIon();

}

#endif
