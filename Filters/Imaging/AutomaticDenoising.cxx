#include "Imaging/AutomaticDenoising.h"

#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Imaging/ChebyshevFilter.h"
#include "Imaging/SuperTimeStepping.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{

double NoiseGradient(const NoiseEstimate& noise, double voxel)
{
  return noise.Noise > 0.0 ? 1.5 * noise.Noise / voxel : 1.0;
}

void ChooseDenoisingParameters(
  const NoiseEstimate& noise, double strength, double voxel, DiffusionParameters& parameters)
{
  const double variance = noise.Deviation * noise.Deviation - noise.Noise * noise.Noise;
  const double signal = std::sqrt(std::max(variance, 1e-3 * noise.Deviation * noise.Deviation));
  if (!(noise.Noise > 0.0) || !(signal > 0.0))
  {
    parameters.Time = 0.0; // nothing to remove
    return;
  }
  // Fitted to the optima found by search on a phantom at signal-to-noise ratios 1, 0.3 and 0.1
  // (ratios of variances, so 1, 1.8 and 3.2 here); README has the table.
  const double ratio = noise.Noise / signal;
  parameters.Sigma = 0.32 * signal / voxel;
  parameters.PreSmoothing = voxel * std::clamp(0.9 * std::pow(ratio, 0.25), 0.5, 3.0);
  // Lower orders spread wider for the same detail kept, higher ones less.
  constexpr double ofOrder[] = { 1.6, 1.0, 0.85, 0.75 };
  const double length =
    voxel * 1.26 * std::pow(std::min(ratio, 10.0), 0.35) * std::exp2(strength - 0.5);
  parameters.ResidualSmoothing = 1.45 * length;
  parameters.Time = std::pow(ofOrder[parameters.Order] * length, 2 * parameters.Order + 2) /
    parameters.Diffusivity[static_cast<std::size_t>(parameters.Order)];
}

namespace
{

/// Replaces a[n] by body(a[n], b[n]), in parallel.
template <typename T, typename Body>
void Combine(std::int64_t size, T* a, const T* b, Body&& body)
{
  ParallelFor(0, size, 1 << 16,
    [=](std::int64_t first, std::int64_t last)
    { std::transform(a + first, a + last, b + first, a + first, body); });
}

/// Sets `change` to 0 at nodes of the constant background of `values`, and its mean to 0 by a
/// constant at the others; returns the background's share.
template <typename T>
double ClearBackground(
  const DiffusionGrid<T>& grid, const VolumeSample& sample, const T* values, T* change)
{
  if (!sample.HasFill)
  {
    return 0.0;
  }
  const Index3 size = grid.Dimensions;
  auto isBackground = [values, size, fill = static_cast<T>(sample.Fill)](std::int64_t n)
  {
    return IsFillNode(
      values, size, Index3{ n % size[0], n / size[0] % size[1], n / (size[0] * size[1]) }, fill);
  };
  const auto count = SumRows<1>(grid,
    [&](std::int64_t begin, std::int64_t end, std::array<double, 1>& sum)
    {
      for (std::int64_t n = begin; n < end; ++n)
      {
        if (isBackground(n))
        {
          change[n] = T(0);
          sum[0] += 1.0;
        }
      }
    });
  const double nodes = static_cast<double>(sample.Whole[0] * sample.Whole[1] * sample.Whole[2]);
  if (count[0] < nodes)
  {
    const double mean = ExactMean(grid, change) * nodes / (nodes - count[0]);
    ParallelFor(0, grid.Size(), 1 << 16,
      [=](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          change[n] = isBackground(n) ? T(0) : static_cast<T>(change[n] - mean);
        }
      });
  }
  return count[0] / nodes;
}

/// `change` becomes what the diffusion changes in `values`, which may be overwritten.
template <typename T>
DiffusionReport FindChange(const DiffusionGrid<T>& grid, const DiffusionParameters& parameters,
  const T* values, T* change, const ProgressCallback& progress)
{
  if (parameters.EdgeStopping == DiffusionParameters::EdgeStoppingType::None)
  {
    const double bound = LaplacianBound<T>(grid.Spacing);
    const std::vector<double> series = ChebyshevSeries([&](double s)
      { return std::exp(-parameters.Time * std::pow(s * bound, parameters.Order + 1)); },
      SeriesTolerance<T>());
    AddChebyshevSeries<T>(grid, { series }, values, { change }, progress);
    DiffusionReport report;
    report.Time = { parameters.Time };
    report.Evaluations = static_cast<std::int64_t>(series.size()) - 1;
    return report;
  }
  std::copy_n(values, grid.Size(), change);
  DiffusionReport report = Diffuse<T>(grid, parameters, change, nullptr, nullptr, progress);
  Combine(grid.Size(), change, values, [](T after, T before) { return after - before; });
  return report;
}

/// Standard deviation of the noise where there is any.
template <typename T>
double MeasuredNoise(const DiffusionGrid<T>& grid, const T* noise)
{
  const auto counts = SumRows<2>(grid,
    [noise](std::int64_t begin, std::int64_t end, std::array<double, 2>& sum)
    {
      sum[0] += static_cast<double>(
        std::count_if(noise + begin, noise + end, [](T value) { return value != T(0); }));
      sum[1] += static_cast<double>(end - begin);
    });
  return counts[0] > 0.0 ? std::sqrt(ExactMeanSquare(grid, noise) * counts[1] / counts[0]) : 0.0;
}

/// The noise that the choice is made for, in units of the sample.
NoiseSpectrum NoiseOf(const VolumeSample& sample, const AutomaticParameters& parameters,
  double measured, const std::array<double, 3>& spacing)
{
  if (parameters.KnownNoise > 0.0 || measured > 0.0)
  {
    return WhiteNoise((measured > 0.0 ? measured : parameters.KnownNoise) / sample.Scale);
  }
  NoiseSpectrum noise = EstimateNoiseSpectrum(sample, spacing);
  // Rounded, since its last bits may depend on how many ranks there are.
  const double simple =
    static_cast<double>(static_cast<float>(parameters.SimpleEstimate)) / sample.Scale;
  if (!(simple > 0.0))
  {
    return WhiteNoise(0.0);
  }
  return noise.Found ? noise : WhiteNoise(simple);
}

}

std::string AutomaticResult::Sentence() const
{
  if (this->Parameters.Time == 0.0)
  {
    return "Nothing was changed.";
  }
  const bool linear = this->Parameters.EdgeStopping == DiffusionParameters::EdgeStoppingType::None;
  const double gain = std::round(10.0 * this->Gain) / 10.0;
  return linear
    ? TextOf("Order ", this->Parameters.Order, ", linear, time ", this->Parameters.Time,
        "; estimated gain ", gain, " dB")
    : TextOf("Order ", this->Parameters.Order, ", edge stopping at gradients of ",
        this->Parameters.Sigma, ", time ", this->Parameters.Time, "; estimated gain ", gain, " dB");
}

void Check(const AutomaticParameters& parameters)
{
  Check(static_cast<const DenoisingSearch&>(parameters));
  RequireRange("KnownNoise", parameters.KnownNoise, 0.0, Unlimited, "0 stands for an estimate.");
}

template <typename T>
AutomaticResult DenoiseByRisk(const DiffusionGrid<T>& grid, const AutomaticParameters& parameters,
  T* values, const T* noise, const ProgressCallback& progress)
{
  Check(parameters);
  AutomaticResult result;
  const double measured = noise ? MeasuredNoise(grid, noise) : 0.0;
  const VolumeSample sample = SampleVolume(grid, values, noise);
  const NoiseSpectrum spectrum = NoiseOf(sample, parameters, measured, grid.Spacing);
  result.NoiseLevel = spectrum.Deviation * sample.Scale;
  result.White = spectrum.White;
  result.Background = spectrum.Background;
  if (!(spectrum.Deviation > 0.0))
  {
    return result;
  }
  const double searched = parameters.Goal == DenoisingGoal::Volumes ? 0.5 : 0.25;
  DenoisingChoice choice =
    ChooseDenoising(sample, spectrum, grid.Spacing, parameters, Between(progress, 0.0, searched));
  if (!(choice.Risk() < choice.NoisePower))
  {
    return result;
  }
  result.Parameters = choice.Parameters;
  result.Parameters.Sigma *= sample.Scale;
  result.Parameters.Integrator = parameters.Integrator;
  result.Parameters.Steps = parameters.Steps;
  auto change = NewVolume<T>(grid.Size());
  result.Report =
    FindChange(grid, result.Parameters, values, change.get(), Between(progress, searched, 1.0));
  const double background = ClearBackground(grid, sample, values, change.get());
  const double nodes = static_cast<double>(sample.Whole[0] * sample.Whole[1] * sample.Whole[2]);
  // The error of the whole: its residual, and what the sample says of the rest.
  const double square = sample.Scale * sample.Scale;
  const double residual = ExactMeanSquare(grid, change.get());
  const double power = noise ? ExactMeanSquare(grid, noise)
                             : result.NoiseLevel * result.NoiseLevel * (1.0 - background);
  const double covariance = choice.Covariance / choice.NoisePower * power;
  double trials = 0.0;
  for (const TrialBlock& trial : sample.Trials)
  {
    trials += static_cast<double>(trial.Inner.Count());
  }
  double variance = 2.0 * power * power * choice.Spread * choice.Spread * spectrum.Coherence /
    std::max(1.0, nodes * (1.0 - background));
  if (!choice.IsLinear())
  {
    variance += 8.0 * power * std::abs(covariance) * spectrum.Coherence / trials;
  }
  const double error = std::sqrt(variance);
  const double risk = std::max(residual - power + 2.0 * covariance, 0.5 * error);
  result.Gain = 10.0 * std::log10(power / risk);
  result.GainError = 10.0 / std::log(10.0) * error / risk;
  if (choice.IsLinear())
  {
    result.Report.Change = { std::sqrt(residual) };
    result.Report.Residual = { std::sqrt(residual) / result.Parameters.Time };
  }
  result.RiskTime = choice.RiskTime;
  result.RiskValue = choice.RiskValue;
  std::for_each(
    result.RiskValue.begin(), result.RiskValue.end(), [square](double& value) { value *= square; });
  Combine(grid.Size(), values, change.get(), [](T value, T by) { return value + by; });
  grid.Exchange(values);
  return result;
}

template AutomaticResult DenoiseByRisk(const DiffusionGrid<float>&, const AutomaticParameters&,
  float*, const float*, const ProgressCallback&);
template AutomaticResult DenoiseByRisk(const DiffusionGrid<double>&, const AutomaticParameters&,
  double*, const double*, const ProgressCallback&);

template <typename T>
void AddSmoothedResidual(const DiffusionGrid<T>& grid, double deviation, T* residual, T* values,
  const ProgressCallback& progress)
{
  Combine(grid.Size(), residual, values, [](T input, T value) { return input - value; });
  DiffusionParameters heat;
  heat.Order = 0;
  heat.EdgeStopping = DiffusionParameters::EdgeStoppingType::None;
  heat.Time = deviation * deviation / 2.0;
  // Explicit steps of 0.6 of the limit leave next to nothing of the shortest waves, which are
  // noise; super steps would halve them at best.
  heat.Integrator = DiffusionParameters::IntegratorType::ForwardEuler;
  heat.Steps =
    static_cast<int>(std::ceil(heat.Time / (0.6 * ExplicitStepLimit(heat, grid.Spacing))));
  Diffuse<T>(grid, heat, residual, nullptr, nullptr, progress);
  Combine(grid.Size(), values, residual, [](T value, T back) { return value + back; });
}

template void AddSmoothedResidual(
  const DiffusionGrid<float>&, double, float*, float*, const ProgressCallback&);
template void AddSmoothedResidual(
  const DiffusionGrid<double>&, double, double*, double*, const ProgressCallback&);

}
