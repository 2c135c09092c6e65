#include "Imaging/HighOrderDiffusion.h"

#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Imaging/DiffusionEvaluation.h"
#include "Imaging/EdgeCoefficient.h"
#include "Imaging/SuperTimeStepping.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace isthmus
{
namespace
{

using Parameters = DiffusionParameters;

/// True if the coefficient needs more than a node's neighbours, so that it is stored for a step.
bool NeedsStoredCoefficient(const Parameters& parameters)
{
  using Type = Parameters::EdgeStoppingType;
  return parameters.Flow == Parameters::FlowType::Hyperdiffusion &&
    (parameters.EdgeStopping == Type::LocalVariance ||
      (parameters.EdgeStopping == Type::Gaussian && parameters.PreSmoothing > 0.0));
}

/// The operator of these parameters, without volumes.
template <typename T>
DiffusionOperator<T> MakeOperator(const Parameters& parameters)
{
  DiffusionOperator<T> diffusion;
  const auto order = static_cast<std::size_t>(parameters.Order);
  const double leading = parameters.Diffusivity[order] * (order % 2 == 0 ? 1.0 : -1.0);
  diffusion.Leading = static_cast<T>(leading);
  diffusion.Weights.assign(order + 1, T(0));
  diffusion.Weights[order] = T(1);
  for (std::size_t p = 0; parameters.LowerOrders && p < order; ++p)
  {
    const double weight = parameters.Diffusivity[p] * (p % 2 == 0 ? 1.0 : -1.0);
    diffusion.Weights[p] = static_cast<T>(weight / leading);
  }
  diffusion.Fidelity = static_cast<T>(parameters.Fidelity);
  if (parameters.Flow == Parameters::FlowType::GeometricFlow)
  {
    diffusion.Coefficient = DiffusionCoefficient::Gram;
    diffusion.GradientScale = parameters.Sigma;
  }
  else if (parameters.EdgeStopping != Parameters::EdgeStoppingType::None)
  {
    diffusion.Coefficient = DiffusionCoefficient::Gaussian;
    // Of LocalVariance the coefficient is stored, and this scale is not used.
    diffusion.GradientScale = parameters.UsesSigma() ? parameters.Sigma * std::sqrt(2.0) : 1.0;
  }
  return diffusion;
}

/// Volumes of T that steps go through; the values and the result of a step are exchanged.
enum Volume : std::size_t
{
  Now,   ///< the values
  Stage, ///< this and the next ones: the last two stages, and the memory of the next two
  OtherStage,
  ThirdStage, ///< where several stages are done in one pass
  FourthStage,
  FirstRate, ///< rate of change at the step's start
  NumberOfVolumes
};

/// The state of a diffusion between two steps.
template <typename T>
class Solver
{
public:
  Solver(const DiffusionGrid<T>& grid, const Parameters& parameters, T* values, const T* input,
    const T* source);

  /// Does a step; with `record`, adds it to the report. Throws when values cease to be finite.
  void Advance(
    const TimeStep& step, bool record, DiffusionReport& report, const ProgressCallback& progress);

  const T* Values() const { return this->Volumes[Now]; }
  double EndTime() const { return this->Time; }

private:
  T* NewVolume();
  Volume EulerStep(const TimeStep& step, const ProgressCallback& progress);
  using StageFunction = RowUpdate<T> (*)(int j, int stages, double length);
  void FirstStage(const RowUpdate<T>& update, const ProgressCallback& progress);
  Volume SuperStep(
    const TimeStep& step, StageFunction stageFactors, const ProgressCallback& progress);
  int ToMidpoint(double length, const ProgressCallback& progress);
  int FillCoefficient(Volume values, Volume scratch, Volume moreScratch);
  void Record(const TimeStep& step, const T* after, DiffusionReport& report) const;

  const DiffusionGrid<T>& Grid;
  const Parameters& Parameter;
  DiffusionOperator<T> Diffusion;
  std::vector<std::unique_ptr<T[]>> Owned;
  std::array<T*, NumberOfVolumes> Volumes{};
  T* Coefficient = nullptr; ///< stored where many stages use it or it is costly; or null
  double Time = 0.0;
};

template <typename T>
Solver<T>::Solver(const DiffusionGrid<T>& grid, const Parameters& parameters, T* values,
  const T* input, const T* source)
  : Grid(grid)
  , Parameter(parameters)
  , Diffusion(MakeOperator<T>(parameters))
{
  this->Diffusion.Dimensions = grid.Dimensions;
  this->Diffusion.Spacing = grid.Spacing;
  this->Diffusion.Input = input;
  this->Diffusion.Source = source;
  this->Volumes[Now] = values;
  this->Volumes[Stage] = this->NewVolume();
  const bool super = parameters.Integrator == Parameters::IntegratorType::SuperTimeStepping;
  const bool constant = this->Diffusion.Coefficient == DiffusionCoefficient::Constant;
  if (super || NeedsStoredCoefficient(parameters))
  {
    this->Volumes[OtherStage] = this->NewVolume();
  }
  if (super)
  {
    this->Volumes[FirstRate] = this->NewVolume();
    if (StagesPerPass(grid, this->Diffusion) > 1)
    {
      this->Volumes[ThirdStage] = this->NewVolume();
      this->Volumes[FourthStage] = this->NewVolume();
    }
  }
  if (NeedsStoredCoefficient(parameters) || (super && !constant))
  {
    this->Coefficient = this->NewVolume();
  }
}

template <typename T>
T* Solver<T>::NewVolume()
{
  this->Owned.push_back(isthmus::NewVolume<T>(this->Grid.Size()));
  return this->Owned.back().get();
}

/// From Now to Stage: an explicit step, or the first stage of a super step, with the rate and the
/// coefficient that the others need.
template <typename T>
void Solver<T>::FirstStage(const RowUpdate<T>& update, const ProgressCallback& progress)
{
  DiffusionPass<T> pass;
  pass.Updates = { update };
  pass.Current = this->Volumes[Now];
  pass.Out = this->Volumes[Stage];
  pass.StoreRate = this->Volumes[FirstRate];
  pass.StoreCoefficient = this->Diffusion.StoredCoefficient ? nullptr : this->Coefficient;
  // On several ranks all must stop at the same place, so not inside a stage.
  Evaluate(this->Diffusion, pass, this->Grid.ExchangeHalo ? nullptr : progress);
  Report(progress, 1.0);
  this->Grid.Exchange(pass.Out);
  if (pass.StoreCoefficient)
  {
    this->Grid.Exchange(this->Coefficient);
    this->Diffusion.StoredCoefficient = this->Coefficient;
  }
}

/// Returns which volume holds the result.
template <typename T>
Volume Solver<T>::EulerStep(const TimeStep& step, const ProgressCallback& progress)
{
  RowUpdate<T> update;
  update.RateFactor = static_cast<T>(step.Length);
  this->FirstStage(update, progress);
  return Stage;
}

template <typename T>
Volume Solver<T>::SuperStep(
  const TimeStep& step, StageFunction stageFactors, const ProgressCallback& progress)
{
  this->FirstStage(
    stageFactors(1, step.Stages, step.Length), Between(progress, 0.0, 1.0 / step.Stages));
  StageSequence<T> sequence;
  for (int j = 2; j <= step.Stages; ++j)
  {
    sequence.Updates.push_back(stageFactors(j, step.Stages, step.Length));
  }
  if (sequence.Updates.empty())
  {
    return Stage;
  }
  sequence.Before = this->Volumes[Now];
  sequence.Current = this->Volumes[Stage];
  sequence.First = this->Volumes[Now];
  sequence.FirstRate =
    sequence.Updates[0].FirstRateFactor != T(0) ? this->Volumes[FirstRate] : nullptr;
  std::copy_n(this->Volumes.begin() + Stage, sequence.Volumes.size(), sequence.Volumes.begin());
  const T* result = EvaluateStages(
    this->Grid, this->Diffusion, sequence, Between(progress, 1.0 / step.Stages, 1.0));
  return static_cast<Volume>(
    std::find(this->Volumes.begin(), this->Volumes.end(), result) - this->Volumes.begin());
}

/// Stores the coefficient of Volumes[values]; the two scratch volumes are overwritten. Returns the
/// number of evaluations that this is equivalent to.
template <typename T>
int Solver<T>::FillCoefficient(Volume values, Volume scratch, Volume moreScratch)
{
  int evaluations = 1;
  if (NeedsStoredCoefficient(this->Parameter))
  {
    EdgeCoefficientParameters edges;
    edges.PreSmoothing = this->Parameter.PreSmoothing;
    edges.Sigma = this->Parameter.Sigma;
    edges.LocalVariance =
      this->Parameter.EdgeStopping == Parameters::EdgeStoppingType::LocalVariance;
    edges.Order = this->Parameter.Order;
    edges.Window = this->Parameter.Window;
    evaluations = FillEdgeCoefficient<T>(this->Grid, edges, this->Volumes[values],
      { this->Volumes[scratch], this->Volumes[moreScratch] }, this->Coefficient);
  }
  else
  {
    this->Diffusion.StoredCoefficient = nullptr;
    DiffusionPass<T> pass;
    pass.Updates.resize(1);
    pass.Current = this->Volumes[values];
    pass.Out = this->Volumes[scratch];
    pass.StoreCoefficient = this->Coefficient;
    Evaluate(this->Diffusion, pass);
    this->Grid.Exchange(this->Coefficient);
  }
  this->Diffusion.StoredCoefficient = this->Coefficient;
  return evaluations;
}

/// Half a step ahead, for the coefficient there. Returns the number of evaluations.
template <typename T>
int Solver<T>::ToMidpoint(double length, const ProgressCallback& progress)
{
  const double limit = ExplicitStepLimit(this->Parameter, this->Grid.Spacing);
  const TimeStep half{ length / 2, FirstOrderStages(length / 2, limit) };
  const Volume middle = this->SuperStep(half, FirstOrderLegendreStage<T>, progress);
  return half.Stages +
    this->FillCoefficient(middle, middle == Stage ? OtherStage : Stage, FirstRate);
}

template <typename T>
void Solver<T>::Advance(
  const TimeStep& step, bool record, DiffusionReport& report, const ProgressCallback& progress)
{
  this->Diffusion.StoredCoefficient = nullptr;
  if (NeedsStoredCoefficient(this->Parameter))
  {
    report.Evaluations += this->FillCoefficient(Now, Stage, OtherStage);
  }
  const bool super = this->Parameter.Integrator == Parameters::IntegratorType::SuperTimeStepping;
  const double ahead = super && this->Coefficient ? 0.33 : 0.0;
  if (ahead > 0.0)
  {
    // All stages need one coefficient: in a changing one a long step would not be stable. That of
    // the step's middle makes it of second order.
    report.Evaluations += this->ToMidpoint(step.Length, Between(progress, 0.0, ahead));
  }
  const ProgressCallback rest = Between(progress, ahead, 1.0);
  const Volume result =
    super ? this->SuperStep(step, LegendreStage<T>, rest) : this->EulerStep(step, rest);
  report.Evaluations += step.Stages;
  this->Time += step.Length;
  if (record)
  {
    this->Record(step, this->Volumes[result], report);
  }
  std::swap(this->Volumes[Now], this->Volumes[result]);
}

template <typename T>
void Solver<T>::Record(const TimeStep& step, const T* after, DiffusionReport& report) const
{
  const T* before = this->Volumes[Now];
  const bool super = this->Parameter.Integrator == Parameters::IntegratorType::SuperTimeStepping;
  const T* rate = super ? this->Volumes[FirstRate] : nullptr;
  const auto sums = SumRows<3>(this->Grid,
    [=](std::int64_t begin, std::int64_t end, std::array<double, 3>& sum)
    {
      double change = 0.0, residual = 0.0;
      for (std::int64_t n = begin; n < end; ++n)
      {
        const double difference = static_cast<double>(after[n]) - static_cast<double>(before[n]);
        change += difference * difference;
        residual += rate ? static_cast<double>(rate[n]) * static_cast<double>(rate[n]) : 0.0;
      }
      sum[0] += change;
      sum[1] += residual;
      sum[2] += static_cast<double>(end - begin);
    });
  const double change = std::sqrt(sums[0] / sums[2]);
  if (!std::isfinite(change))
  {
    throw std::runtime_error("Some values are no longer finite: the diffusivities, the source or "
                             "the input are too large for this floating-point type.");
  }
  report.Time.push_back(this->Time);
  report.Change.push_back(change);
  report.Residual.push_back(super ? std::sqrt(sums[1] / sums[2]) : change / step.Length);
}

}

void Check(const Parameters& parameters)
{
  RequireChoice("Flow", parameters.Flow, Parameters::FlowType::GeometricFlow);
  RequireChoice(
    "EdgeStopping", parameters.EdgeStopping, Parameters::EdgeStoppingType::LocalVariance);
  RequireChoice("Integrator", parameters.Integrator, Parameters::IntegratorType::SuperTimeStepping);
  RequireRange("Order", parameters.Order, 0, 3);
  RequireAbove("Time", parameters.Time, 0.0, Unlimited,
    "The equation needs an end time. Denoise Map chooses the equation and its time automatically.");
  RequireRange("Steps", parameters.Steps, 0, Unlimited, "0 stands for automatic steps.");
  RequireRange("Fidelity", parameters.Fidelity, 0.0, Unlimited);
  RequireRange("PreSmoothing", parameters.PreSmoothing, 0.0, Unlimited);
  RequireRange("ResidualSmoothing", parameters.ResidualSmoothing, 0.0, Unlimited);
  for (const double diffusivity : parameters.Diffusivity)
  {
    RequireRange("Diffusivity", diffusivity, 0.0, Unlimited);
  }
  RequireAbove("Diffusivity of the highest order",
    parameters.Diffusivity[static_cast<std::size_t>(parameters.Order)], 0.0, Unlimited);
  RequireRange("Sigma", parameters.Sigma, 0.0, Unlimited);
  if (parameters.EdgeStopping == Parameters::EdgeStoppingType::LocalVariance)
  {
    RequireThat(parameters.Window >= 3 && parameters.Window % 2 == 1, "Window", parameters.Window,
      "it must be odd and at least 3, so that it has a middle");
  }
}

int HaloWidth(const Parameters& parameters)
{
  const int reach = MakeOperator<float>(parameters).Reach();
  // At the image's ends a window lies to one side of a node; gradients need one more node.
  const bool local = parameters.EdgeStopping == Parameters::EdgeStoppingType::LocalVariance;
  return std::max(reach, local ? parameters.Window + 1 : 0);
}

double ExplicitStepLimit(const Parameters& parameters, const std::array<double, 3>& spacing)
{
  auto diffusion = MakeOperator<double>(parameters);
  diffusion.Spacing = spacing;
  return 2.0 / diffusion.SpectralBound();
}

template <typename T>
DiffusionReport Diffuse(const DiffusionGrid<T>& grid, const Parameters& parameters, T* values,
  const T* input, const T* source, const ProgressCallback& progress,
  const DiffusionObserver<T>& observer)
{
  Check(parameters);
  if (parameters.UsesSigma())
  {
    RequireAbove("Sigma", parameters.Sigma, 0.0, Unlimited);
  }
  DiffusionReport report;
  const double limit = ExplicitStepLimit(parameters, grid.Spacing);
  const auto steps = parameters.Integrator == Parameters::IntegratorType::ForwardEuler
    ? EulerSteps(parameters.Time, limit, parameters.Steps)
    : SuperSteps(parameters.Time, limit, parameters.Steps);
  double work = 0.0, done = 0.0;
  for (const TimeStep& step : steps)
  {
    work += step.Stages;
  }
  Solver<T> solver(grid, parameters, values, input, source);
  grid.Exchange(values);
  const std::size_t curvePoints = 100;
  const std::size_t stride = (steps.size() + curvePoints - 1) / curvePoints;
  for (std::size_t n = 0; n < steps.size(); ++n)
  {
    const double next = done + steps[n].Stages / work;
    const bool record = (n + 1) % stride == 0 || n + 1 == steps.size();
    solver.Advance(steps[n], record, report, Between(progress, done, next));
    done = next;
    if (observer)
    {
      observer(solver.EndTime(), solver.Values());
    }
  }
  if (solver.Values() != values)
  {
    std::copy_n(solver.Values(), grid.Size(), values);
  }
  return report;
}

template DiffusionReport Diffuse(const DiffusionGrid<float>&, const Parameters&, float*,
  const float*, const float*, const ProgressCallback&, const DiffusionObserver<float>&);
template DiffusionReport Diffuse(const DiffusionGrid<double>&, const Parameters&, double*,
  const double*, const double*, const ProgressCallback&, const DiffusionObserver<double>&);

template <typename T>
void AddSmoothedResidual(const DiffusionGrid<T>& grid, double deviation, T* residual, T* values,
  const ProgressCallback& progress)
{
  const auto combine = [size = grid.Size()](T* a, const T* b, auto&& body)
  {
    ParallelFor(0, size, 1 << 16,
      [=](std::int64_t first, std::int64_t last)
      { std::transform(a + first, a + last, b + first, a + first, body); });
  };
  combine(residual, values, [](T input, T value) { return input - value; });
  DiffusionParameters heat;
  heat.Order = 0;
  heat.EdgeStopping = DiffusionParameters::EdgeStoppingType::None;
  heat.Time = deviation * deviation / 2.0;
  // Explicit steps of 0.6 of the limit remove nearly all of the shortest waves, which are noise;
  // super steps would at best halve them.
  heat.Integrator = DiffusionParameters::IntegratorType::ForwardEuler;
  heat.Steps =
    static_cast<int>(std::ceil(heat.Time / (0.6 * ExplicitStepLimit(heat, grid.Spacing))));
  Diffuse<T>(grid, heat, residual, nullptr, nullptr, progress);
  combine(values, residual, [](T value, T back) { return value + back; });
}

template void AddSmoothedResidual(
  const DiffusionGrid<float>&, double, float*, float*, const ProgressCallback&);
template void AddSmoothedResidual(
  const DiffusionGrid<double>&, double, double*, double*, const ProgressCallback&);

}
