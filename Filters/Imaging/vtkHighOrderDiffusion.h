/**
 * @class vtkHighOrderDiffusion
 * @brief Denoises a volume by nonlinear diffusion of order 2 to 8.
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
 * diffusion removed are restored.
 *
 * Automatic chooses Order, edge stopping or none, Sigma, PreSmoothing and Time so
 * that the estimated error for the Goal is least (DenoisingRisk.h), for noise whose level and
 * spectrum are estimated from the image (NoiseSpectrum.h) unless KnownNoise is set. EdgeStopping
 * None restricts the choice to linear diffusions, which are computed as functions of the Laplacian,
 * without steps in time. Constant background, e.g. outside a mask, is not changed. Geometric flow,
 * LowerOrders, LocalVariance, Fidelity, UseSource and diffusivities other than 1 are not covered by
 * the search: with them a rule sets Sigma, PreSmoothing, Time and ResidualSmoothing from the noise
 * level and Strength. Without Automatic all parameters are used as set, except that a Sigma of 0 is
 * replaced by the noise level.
 *
 * The output array has the input array's name. Field data: the curves `StepTime`, `StepChange` (rms
 * of what a step changed) and `StepResidual` (rms of the rate at its start; for a linear choice
 * both describe the whole change), and NoiseLevel, `UsedOrder`, `UsedEdgeStopping`, `UsedSigma`,
 * `UsedPreSmoothing`, `UsedTime`, `UsedResidualSmoothing`. The search adds `EstimatedGain` (dB in
 * mean squared error) with its standard error `EstimatedGainError`, the curve RiskValue over
 * RiskTime of the chosen order and Sigma (estimated mean squared error; for surfaces that of the
 * Laplacian, unless that of the values decided) and Choice, a sentence. Where Automatic finds no
 * noise, or so little that nothing changes, a warning says why and what to do.
 *
 * Cost: time in proportion to nodes x sqrt(Time) with SuperTimeStepping, nodes x Time with
 * ForwardEuler. Memory in addition to input and output, in volumes of the output's type: 4 with
 * SuperTimeStepping (two stages, the first rate, the coefficient) and two more for Order 0 on one
 * rank; 1 to 3 with ForwardEuler. Automatic needs one more, and a sample of the volume of up to 100
 * MiB. Fidelity (the input) and UseSource (P) each need one more volume.
 *
 * @sa vtkDiffusionHighPass vtkPDETransform
 */
#ifndef vtkHighOrderDiffusion_h
#define vtkHighOrderDiffusion_h

#include "Core/FilterProperties.h"
#include "Imaging/AutomaticDenoising.h"
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

  enum GoalType
  {
    Surfaces = 0,
    Volumes = 1
  };

  ///@{
  /// Choose Order, edge stopping, Sigma, PreSmoothing and Time automatically by the estimated
  /// error.
  vtkSetMacro(Automatic, bool);
  vtkGetMacro(Automatic, bool);
  vtkBooleanMacro(Automatic, bool);
  ///@}

  ///@{
  /// Purpose of the denoised volume: Surfaces, for which linear diffusions are chosen
  /// that improve second derivatives, and thus normals and curvature of level sets; or Volumes, for
  /// the least mean squared error of the values. Used if Automatic is on.
  ISTHMUS_PARAMETER_OF(Denoising, Goal, int);
  ///@}

  ///@{
  /// How much to denoise, from 0 (light) to 1 (strong): the smoothing length is 2^(Strength - 1/2)
  /// times the best one. Used if Automatic is on.
  ISTHMUS_PARAMETER_OF(Denoising, Strength, double);
  ///@}

  ///@{
  /// Standard deviation of the noise if it is known to be white; 0: level and spectrum
  /// are estimated where the volume is not constant. Used if Automatic is on.
  ISTHMUS_PARAMETER_OF(Denoising, KnownNoise, double);
  ///@}

  ///@{
  /// Hyperdiffusion or GeometricFlow.
  ISTHMUS_PARAMETER(Flow, int);
  ///@}

  ///@{
  /// q, 0 to 3: the equation is of order 2q + 2. Chosen automatically if Automatic is
  /// on.
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
  /// values for Order 0, of their gradient for Order 1 to 3). With Automatic, None admits linear
  /// choices only.
  ISTHMUS_PARAMETER(EdgeStopping, int);
  ///@}

  ///@{
  /// Gradient that counts as an edge, in data units per length; 0: derived from the noise
  /// level.
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
  /// is added to the result, which thus keeps the long waves of the input (AutomaticDenoising.h);
  /// 0: nothing is added.
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
  /// End time, in the unit given by those of lengths and diffusivities.
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

protected:
  vtkHighOrderDiffusion();
  ~vtkHighOrderDiffusion() override = default;

  int HaloWidth() override;
  void Process(isthmus::DiffusionImage<float>& image) override;
  void Process(isthmus::DiffusionImage<double>& image) override;

private:
  void CheckParameters() const;
  bool ChoosesByRisk() const;
  template <typename T>
  void Denoise(isthmus::DiffusionImage<T>& image);
  template <typename T>
  void DenoiseByRisk(isthmus::DiffusionImage<T>& image);
  void Explain(const isthmus::NoiseEstimate& noise, double change, bool background);

  vtkHighOrderDiffusion(const vtkHighOrderDiffusion&) = delete;
  void operator=(const vtkHighOrderDiffusion&) = delete;

  isthmus::DiffusionParameters Parameters;
  isthmus::AutomaticParameters Denoising;
  bool Automatic = true;
  bool UseSource = false;
};

#endif
