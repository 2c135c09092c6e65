/**
 * @class vtkHighOrderDiffusion
 * @brief Nonlinear diffusion of a volume, of order 2 to 8, with all parameters as set.
 *
 * Two flows of X. Feng's thesis (equations 4.32 to 4.36), q = Order, L the Laplacian:
 *
 *     Hyperdiffusion  u_t = sum_p (-1)^p div(d_p c grad L^p u) + Fidelity (input - u) + P,
 *                     c = exp(-|grad u|^2 / (2 Sigma^2)), p = q alone or 0 to q
 *     GeometricFlow   u_t = (-1)^q d_q sqrt(g) div(grad T / sqrt(g)) + Fidelity (input - u) + P,
 *                     T = L^q u, g = 1 + |grad T|^2 / Sigma^2
 *
 * with Neumann boundaries: no flux, so that Hyperdiffusion keeps the mean. The sign of the odd
 * orders is chosen so that they diffuse. Finally, with ResidualSmoothing, long waves that the
 * diffusion removed are restored. Time must be set; vtkDenoiseMap chooses equation and time
 * automatically.
 *
 * The output array has the input array's name; OutputArrayTable() lists the field data. Sigma 0 is
 * derived from the noise (EstimateNoise of NoiseEstimate.h).
 *
 * Cost: time in proportion to nodes x sqrt(Time) with SuperTimeStepping, nodes x Time with
 * ForwardEuler. Memory in addition to input and output, in volumes of the output's type: 4 with
 * SuperTimeStepping and two more for Order 0 on one rank; 1 to 3 with ForwardEuler. Fidelity (the
 * input) and UseSource (P) each need one more volume.
 *
 * @sa vtkDenoiseMap vtkDiffusionHighPass vtkPDETransform
 */
#ifndef vtkHighOrderDiffusion_h
#define vtkHighOrderDiffusion_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Imaging/HighOrderDiffusion.h"
#include "vtkDiffusionAlgorithm.h"
#include "vtkIsthmusFiltersImagingModule.h"

class VTKISTHMUSFILTERSIMAGING_EXPORT vtkHighOrderDiffusion : public vtkDiffusionAlgorithm
{
public:
  static vtkHighOrderDiffusion* New();
  vtkTypeMacro(vtkHighOrderDiffusion, vtkDiffusionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FlowType
  {
    Hyperdiffusion = 0,
    GeometricFlow = 1
  };
  enum EdgeStoppingType
  {
    None = 0,
    Gaussian = 1,
    LocalVariance = 2
  };
  enum IntegratorType
  {
    ForwardEuler = 0,
    SuperTimeStepping = 1
  };

  ///@{
  /// Hyperdiffusion or GeometricFlow.
  ISTHMUS_PARAMETER(Flow, int);
  ///@}

  ///@{
  /// q, 0 to 3: the equation is of order 2q + 2.
  ISTHMUS_PARAMETER(Order, int);
  ///@}

  ///@{
  /// Combine the hyperdiffusions of all orders from 0 to Order instead of using only Order.
  ISTHMUS_PARAMETER_SWITCH(LowerOrders);
  ///@}

  ///@{
  /// Diffusivities d_0 to d_3, length^(2p + 2) per unit of time.
  ISTHMUS_PARAMETER_VECTOR4(Diffusivity, double);
  ///@}

  ///@{
  /// Coefficient of Hyperdiffusion: None (constant), Gaussian (stops at gradients above
  /// Sigma), LocalVariance (Sigma is the standard deviation in a Window, equation 4.35: of the
  /// values for Order 0, of their gradient for Order 1 to 3).
  ISTHMUS_PARAMETER(EdgeStopping, int);
  ///@}

  ///@{
  /// Gradient that counts as an edge, in data units per length; 0: 1.5 times the noise level
  /// divided by the smallest spacing.
  ISTHMUS_PARAMETER(Sigma, double);
  ///@}

  ///@{
  /// Width of the window of LocalVariance in nodes: odd, at least 3.
  ISTHMUS_PARAMETER(Window, int);
  ///@}

  ///@{
  /// Standard deviation (length) of the Gaussian applied to u before the gradient of the
  /// coefficient is computed, so that noise is not mistaken for edges (Catte et al. 1992); 0: as
  /// in 4.34.
  ISTHMUS_PARAMETER(PreSmoothing, double);
  ///@}

  ///@{
  /// Standard deviation (length) of a Gaussian that smooths input - result; the smoothed difference
  /// is added to the result, which thus keeps the long waves of the input; 0: nothing is added.
  ISTHMUS_PARAMETER(ResidualSmoothing, double);
  ///@}

  ///@{
  /// Strength of the term that pulls the values back to the input, per unit of time.
  ISTHMUS_PARAMETER(Fidelity, double);
  ///@}

  ///@{
  /// Add the second input array, `SetInputArrayToProcess(1, ...)`, as the source P (data unit per
  /// unit of time).
  vtkSetMacro(UseSource, bool);
  vtkGetMacro(UseSource, bool);
  vtkBooleanMacro(UseSource, bool);
  ///@}

  ///@{
  /// End time, in the unit given by those of lengths and diffusivities. Must be set: 0, the
  /// default, is an error.
  ISTHMUS_PARAMETER(Time, double);
  ///@}

  ///@{
  /// SuperTimeStepping (second order in time, cost grows with the square root of Time) or
  /// ForwardEuler.
  ISTHMUS_PARAMETER(Integrator, int);
  ///@}

  ///@{
  /// Number of equal steps; 0 chooses the steps automatically. Too few steps are refused,
  /// with the limit in the message.
  ISTHMUS_PARAMETER(Steps, int);
  ///@}

  ///@{
  /// Lengths in units of the smallest spacing (on) or in the data's unit, angstrom
  /// for maps (off). Times, diffusivities and gradients follow.
  vtkSetMacro(VoxelUnits, bool);
  vtkGetMacro(VoxelUnits, bool);
  vtkBooleanMacro(VoxelUnits, bool);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkHighOrderDiffusion();
  ~vtkHighOrderDiffusion() override = default;

  int HaloWidth() override;
  void Process(isthmus::DiffusionImage<float>& image) override;
  void Process(isthmus::DiffusionImage<double>& image) override;

private:
  template <typename T>
  void Diffuse(isthmus::DiffusionImage<T>& image);

  vtkHighOrderDiffusion(const vtkHighOrderDiffusion&) = delete;
  void operator=(const vtkHighOrderDiffusion&) = delete;

  isthmus::DiffusionParameters Parameters;
  bool UseSource = false;
};

#endif
