/**
 * @file TransportCurrents.h
 * @brief Currents through cross-sections of a channel, flux densities at nodes, and curves of
 * currents over voltage or concentration.
 */
#ifndef isthmus_TransportCurrents_h
#define isthmus_TransportCurrents_h

#include "Solvation/PoissonNernstPlanck.h"
#include "vtkIsthmusFiltersSolvationModule.h"

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
 * A section lies between each two layers of the domain, normal to the channel: the edges of the
 * grid that go through it carry its current, oblique as it may lie to them. What a node takes in it
 * gives off, so currents through all sections are the same but for the accuracy of the solution.
 * O(nodes).
 */
VTKISTHMUSFILTERSSOLVATION_EXPORT CurrentProfile CurrentsOf(const PoissonNernstPlanck& solution);

/// The flux of a species at a node, ions a nanosecond and square angstrom: the mean of its faces'.
VTKISTHMUSFILTERSSOLVATION_EXPORT Point3 FluxAt(
  const PoissonNernstPlanck& solution, SpeciesId species, std::int64_t node);

/// pA for an ion of 1 e a nanosecond.
VTKISTHMUSFILTERSSOLVATION_EXPORT double PicoamperePerIon();

/// What is kept of one point.
struct TransportPoint
{
  double Voltage = 0.0; ///< mV
  double Factor = 1.0;  ///< of the baths' concentrations
  CurrentProfile Profile;
  IonTransportReport Report;
};

/// Voltages in equal steps, the factor 1.
/// @throws std::invalid_argument for ends out of range or less than two points.
VTKISTHMUSFILTERSSOLVATION_EXPORT std::vector<TransportPoint> SweptVoltages(
  double from, double to, int points);

/// Factors in equal ratios, at one voltage.
/// @throws std::invalid_argument for ends out of range or less than two points.
VTKISTHMUSFILTERSSOLVATION_EXPORT std::vector<TransportPoint> SweptFactors(
  double from, double to, int points, double voltage);

/// The current state of a solution.
VTKISTHMUSFILTERSSOLVATION_EXPORT TransportPoint PointOf(const PoissonNernstPlanck& solution);

/// Solves at the point's voltage and factor, starting from `solution`, and stores the result.
/// @throws what PoissonNernstPlanck::Solve does.
VTKISTHMUSFILTERSSOLVATION_EXPORT void SolveAt(
  TransportPoint& point, PoissonNernstPlanck& solution, const ProgressCallback& progress = {});

}

#endif
