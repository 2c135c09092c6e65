/**
 * @file HighOrderDiffusion.h
 * @brief Nonlinear diffusion of a volume, of order 2 to 8, by explicit or super time stepping.
 *
 * Two flows (X. Feng's thesis, equations 4.32 to 4.36, with the sign that makes odd orders
 * diffuse):
 *
 *     Hyperdiffusion  u_t = sum_p (-1)^p div(d_p c grad L^p u) + fidelity (input - u) + source
 *     GeometricFlow   u_t = (-1)^q d_q sqrt(g) div(grad T / sqrt(g)) + ...,  T = L^q u,
 *                     g = 1 + |grad T|^2 / sigma^2      (4.36 as printed has sigma = 1)
 *
 * L is the 7-point Laplacian, c = exp(-|grad u|^2 / (2 sigma^2)) at the nodes and its mean on the
 * faces, all boundaries are Neumann (mirrored at half a voxel), so Hyperdiffusion without fidelity
 * and source keeps the mean. Lengths, and with them times and diffusivities, are in the unit of the
 * grid's spacing.
 *
 * Super time stepping is the Runge-Kutta-Legendre method of second order (Meyer, Balsara, Aslam,
 * J. Comput. Phys. 257 (2014) 594): s stages reach (s^2 + s - 2)/4 times as far as one explicit
 * step, so the cost of an end time grows with its square root. If the coefficient changes with
 * time, its value at the middle of the step is used, which is computed by a step of half the
 * length; this is second order in time.
 */
#ifndef isthmus_HighOrderDiffusion_h
#define isthmus_HighOrderDiffusion_h

#include "Core/Progress.h"
#include "Imaging/DiffusionGrid.h"
#include "vtkIsthmusFiltersImagingModule.h"

#include <array>
#include <cstdint>
#include <functional>
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
  int Order = 0;            ///< q, 0 to 3: the equation's order is 2q + 2.
  bool LowerOrders = false; ///< Use hyperdiffusion of all orders from 0 to q.
  std::array<double, 4> Diffusivity{ 1.0, 1.0, 1.0, 1.0 }; ///< d_p, length^(2p + 2) / time
  /// Gradient that counts as an edge, data unit / length; above 0 where UsesSigma(). 0 stands for
  /// one that the caller derives from the noise level (NoiseGradient).
  double Sigma = 0.0;
  int Window = 5; ///< Width of the window of LocalVariance in nodes: odd, 3 or more.
  /// Standard deviation (length) of the Gaussian that is applied before the gradient.
  double PreSmoothing = 0.0;
  /// Standard deviation (length) of the Gaussian of AddSmoothedResidual; 0: nothing is added.
  /// Diffuse does not use it; the caller passes it to AddSmoothedResidual afterwards.
  double ResidualSmoothing = 0.0;
  double Fidelity = 0.0; ///< 1 / time
  double Time = 0.0;     ///< End time, above 0: it must be given, since it depends on the data.
  int Steps = 0; ///< Number of equal steps; 0 chooses them automatically (SuperTimeStepping.h).

  /// False where no gradient stops the flow, or where it is compared with those around it.
  bool UsesSigma() const
  {
    return this->Flow == FlowType::GeometricFlow ||
      this->EdgeStopping == EdgeStoppingType::Gaussian;
  }
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSIMAGING_EXPORT void Check(const DiffusionParameters& parameters);

/// The course of the diffusion, step by step, as a curve to plot.
struct DiffusionReport
{
  std::vector<double> Time;     ///< at the end of the step
  std::vector<double> Change;   ///< root mean square of the change in the step
  std::vector<double> Residual; ///< root mean square of the rate of change at the step's start
  std::int64_t Evaluations = 0; ///< of a right-hand side, those under PreSmoothing included
};

/// Called after each step with the time reached and the values at that time.
template <typename T>
using DiffusionObserver = std::function<void(double time, const T* values)>;

/// Number of nodes around those of a rank that the computation needs from other ranks.
VTKISTHMUSFILTERSIMAGING_EXPORT int HaloWidth(const DiffusionParameters& parameters);

/// The largest stable explicit step: 2 / (sum_p d_p lambda^(p+1) + fidelity), where lambda is
/// 4 (1/hx^2 + 1/hy^2 + 1/hz^2).
VTKISTHMUSFILTERSIMAGING_EXPORT double ExplicitStepLimit(
  const DiffusionParameters& parameters, const std::array<double, 3>& spacing);

/**
 * Diffuses `values` in place from time 0 to parameters.Time.
 *
 * `input` is read where Fidelity is not 0 (null otherwise), `source` may be null; both have the
 * grid's size.
 * @pre values are finite.
 * @throws std::invalid_argument for bad parameters, for fixed Steps that are larger than the
 * integrator can take (the message names the limit) and std::runtime_error for values that cease
 * to be finite. `observer` is called with the values after each step.
 *
 * Memory: volumes of T in addition to values, input and source. SuperTimeStepping needs 4: two for
 * stages, the first rate, and the coefficient (3 if it is constant), and two more for order 0 on
 * one rank, where several stages are done in one pass over memory. ForwardEuler needs 1 for the
 * next values, or 3 with LocalVariance or PreSmoothing. Time: proportional to nodes x Evaluations.
 */
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT DiffusionReport Diffuse(const DiffusionGrid<T>& grid,
  const DiffusionParameters& parameters, T* values, const T* input, const T* source,
  const ProgressCallback& progress = {}, const DiffusionObserver<T>& observer = {});

/**
 * Adds the smoothed residual G (input - values) to `values`, G a Gaussian by heat flow with Neumann
 * boundaries: waves much longer than G are those of the input again, waves much shorter remain
 * those of `values` (twicing: J. W. Tukey, Exploratory Data Analysis, 1977; for diffusions S. Osher
 * et al., Multiscale Model. Simul. 4 (2005) 460).
 *
 * `deviation` (a length above 0) is the standard deviation of G; `residual` holds the input and is
 * overwritten. Memory: one volume. Cost: about 5 (deviation / spacing)^2 evaluations of the heat
 * equation. Throws as Diffuse does.
 */
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT void AddSmoothedResidual(const DiffusionGrid<T>& grid,
  double deviation, T* residual, T* values, const ProgressCallback& progress = {});

}

#endif
