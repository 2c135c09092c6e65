/**
 * @file TransportCurrents.h
 * @brief Currents through cross-sections of a channel, flux densities at nodes, and curves of
 * currents against voltage or concentration.
 */
#ifndef isthmus_TransportCurrents_h
#define isthmus_TransportCurrents_h

#include "Solvation/PoissonNernstPlanck.h"

namespace isthmus
{

/// Currents in pA, positive along the membrane's normal.
struct CurrentProfile
{
  std::vector<double> Along;                 ///< of the sections, angstrom from the centre
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
CurrentProfile CurrentsOf(const PoissonNernstPlanck& solution);

/// The flux of a species at a node, in ions per nanosecond and square angstrom: the mean over its
/// faces.
Point3 FluxAt(const PoissonNernstPlanck& solution, SpeciesId species, std::int64_t node);

/// pA for one ion of charge 1 e per nanosecond.
double PicoamperePerIon();

/// The stored result for one point.
struct TransportPoint
{
  double Voltage = 0.0; ///< mV
  double Factor = 1.0;  ///< of the baths' concentrations
  CurrentProfile Profile;
  IonTransportReport Report;
};

/// Voltages in equal steps, the factor 1.
/// @throws std::invalid_argument for ends out of range or fewer than two points.
std::vector<TransportPoint> SweptVoltages(double from, double to, int points);

/// Factors in equal ratios, at one voltage.
/// @throws std::invalid_argument for ends out of range or fewer than two points.
std::vector<TransportPoint> SweptFactors(double from, double to, int points, double voltage);

/// The current state of a solution.
TransportPoint PointOf(const PoissonNernstPlanck& solution);

/// Solves for the voltage and factor of `point`, starting from `solution`, and stores the result.
/// @throws the exceptions of PoissonNernstPlanck::Solve.
void SolveAt(
  TransportPoint& point, PoissonNernstPlanck& solution, const ProgressCallback& progress = {});

}

#endif
