/**
 * @file DiffusionParameters.h
 * @brief What HighOrderDiffusion is asked for, and its report; the equations are told there.
 */
#ifndef isthmus_DiffusionParameters_h
#define isthmus_DiffusionParameters_h

#include "vtkIsthmusFiltersImagingModule.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

struct DiffusionParameters
{
  enum class FlowType
  {
    Hyperdiffusion,
    GeometricFlow
  };
  enum class EdgeStoppingType
  {
    None,         ///< c = 1 (Hyperdiffusion only)
    Gaussian,     ///< one sigma for the whole grid
    LocalVariance ///< sigma from the input around each node (4.35; Hyperdiffusion only)
  };
  enum class IntegratorType
  {
    ForwardEuler,
    SuperTimeStepping
  };

  FlowType Flow = FlowType::Hyperdiffusion;
  EdgeStoppingType EdgeStopping = EdgeStoppingType::Gaussian;
  IntegratorType Integrator = IntegratorType::SuperTimeStepping;
  int Order = 1;            ///< q, 0 to 3: the equation's order is 2q + 2.
  bool LowerOrders = false; ///< Hyperdiffusion with the orders 0 to q together.
  std::array<double, 4> Diffusivity{ 1.0, 1.0, 1.0, 1.0 }; ///< d_p, length^(2p + 2) / time
  double Sigma = 1.0;        ///< Scale of gradients: data unit / length.
  int Window = 5;            ///< Nodes across the window of LocalVariance: odd, 3 or more.
  double PreSmoothing = 0.0; ///< Standard deviation (length) of the Gaussian under the gradient.
  /// Standard deviation (length) of the Gaussian of ReturnResidual, for whoever calls it after
  /// Diffuse, which does not read this; 0: nothing is returned.
  double ResidualSmoothing = 0.0;
  double Fidelity = 0.0; ///< 1 / time
  double Time = 1.0;     ///< End time.
  int Steps = 0;         ///< That many equal steps; 0 chooses them (see README).
};

/// @throws std::invalid_argument, in a sentence, for parameters that mean nothing.
VTKISTHMUSFILTERSIMAGING_EXPORT void Check(const DiffusionParameters& parameters);

/// What happened, step by step: a curve to plot.
struct DiffusionReport
{
  std::vector<double> Time;     ///< at the end of the step
  std::vector<double> Change;   ///< root mean square of what the step changed
  std::vector<double> Residual; ///< root mean square of the rate of change at the step's start
  std::int64_t Evaluations = 0; ///< of a right-hand side, those under PreSmoothing included
};

}

#endif
