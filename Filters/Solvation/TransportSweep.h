/**
 * @file TransportSweep.h
 * @brief A curve of currents over voltages or concentrations, each point from the one before.
 */
#ifndef isthmus_TransportSweep_h
#define isthmus_TransportSweep_h

#include "Solvation/TransportCurrents.h"
#include "vtkIsthmusFiltersSolvationModule.h"

namespace isthmus
{

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

/// What there is of a solution where it stands.
VTKISTHMUSFILTERSSOLVATION_EXPORT TransportPoint PointOf(const PoissonNernstPlanck& solution);

/// Solves at the point's voltage and factor, from where `solution` stands, and keeps what is found.
/// @throws what PoissonNernstPlanck::Solve does.
VTKISTHMUSFILTERSSOLVATION_EXPORT void SolveAt(
  TransportPoint& point, PoissonNernstPlanck& solution, const ProgressCallback& progress = {});

}

#endif
