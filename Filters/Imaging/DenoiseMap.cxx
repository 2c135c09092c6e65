#include "Imaging/DenoiseMap.h"

#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Imaging/ChebyshevFilter.h"
#include "Imaging/SuperTimeStepping.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{

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
    return values[n] == fill && // spares nearly all nodes the divisions
      IsFillNode(
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

/// `change` becomes the change of `values` by the diffusion; `values` may be overwritten.
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

/// The noise that the choice is made for, in units of the sample. `known`: its standard deviation
/// if it is known to be white, or 0; `estimate`: for volumes that are too small for measuring a
/// spectrum.
NoiseSpectrum ChooseSpectrum(const VolumeSample& sample, double known,
  const NoiseEstimate& estimate, const std::array<double, 3>& spacing)
{
  if (known > 0.0)
  {
    return WhiteNoise(known / sample.Scale);
  }
  NoiseSpectrum noise = EstimateNoiseSpectrum(sample, spacing);
  // Rounded, since its last bits may depend on the number of ranks.
  const double white = static_cast<double>(static_cast<float>(estimate.Noise)) / sample.Scale;
  if (!(white > 0.0))
  {
    return WhiteNoise(0.0);
  }
  return noise.Found ? noise : WhiteNoise(white);
}

/// Gain and GainError of `result`: the risk of the whole volume, from its `residual` (mean square
/// of what was changed), the `power` of its noise and the covariance of the sample. `counted`:
/// number of nodes outside of the constant background.
void EstimateGain(const VolumeSample& sample, const NoiseSpectrum& spectrum,
  const DenoisingChoice& choice, double residual, double power, double counted,
  DenoiseMapResult& result)
{
  const double covariance = choice.Covariance / choice.NoisePower * power;
  double variance = 2.0 * power * power * choice.Spread * choice.Spread * spectrum.Coherence /
    std::max(1.0, counted);
  if (!choice.IsLinear())
  {
    // The covariance of a linear choice is exact, that of edge stopping is measured on the trials.
    double trials = 0.0;
    for (const TrialBlock& trial : sample.Trials)
    {
      trials += static_cast<double>(trial.Inner.Count());
    }
    variance += 8.0 * power * std::abs(covariance) * spectrum.Coherence / trials;
  }
  const double error = std::sqrt(variance);
  // The estimate may be below 0: a risk below its own standard error is not resolved.
  const double risk = std::max(residual - power + 2.0 * covariance, 0.5 * error);
  result.Gain = 10.0 * std::log10(power / risk);
  result.GainError = 10.0 / std::log(10.0) * error / risk;
}

}

std::string DenoiseMapResult::Sentence() const
{
  if (this->Diffusion.Time == 0.0)
  {
    return "Nothing was changed.";
  }
  const double gain = std::round(10.0 * this->Gain) / 10.0;
  return this->IsLinear()
    ? JoinText("Order ", this->Diffusion.Order, ", linear, time ", this->Diffusion.Time,
        "; estimated gain ", gain, " dB")
    : JoinText("Order ", this->Diffusion.Order, ", edge stopping at gradients of ",
        this->Diffusion.Sigma, ", time ", this->Diffusion.Time, "; estimated gain ", gain, " dB");
}

void Check(const DenoiseMapParameters& parameters)
{
  Check(static_cast<const DenoisingSearch&>(parameters));
  RequireRange("KnownNoise", parameters.KnownNoise, 0.0, Unlimited, "0 stands for an estimate.");
}

template <typename T>
DenoiseMapResult DenoiseMap(const DiffusionGrid<T>& grid, const DenoiseMapParameters& parameters,
  T* values, const T* noise, const ProgressCallback& progress)
{
  Check(parameters);
  DenoiseMapResult result;
  result.Estimate = EstimateNoise(grid, values);
  if (result.Estimate.FewValues)
  {
    return result;
  }
  const double measured = noise ? MeasuredNoise(grid, noise) : 0.0;
  const VolumeSample sample = SampleVolume(grid, values, noise);
  const NoiseSpectrum spectrum = ChooseSpectrum(
    sample, measured > 0.0 ? measured : parameters.KnownNoise, result.Estimate, grid.Spacing);
  result.NoiseLevel = spectrum.Deviation * sample.Scale;
  result.White = spectrum.White;
  result.Background = spectrum.Background;
  if (!(spectrum.Deviation > 0.0))
  {
    return result;
  }
  // Shares of the time, for the progress.
  const double searched = parameters.Goal == DenoisingGoal::Volumes ? 0.5 : 0.25;
  const DenoisingChoice choice =
    ChooseDenoising(sample, spectrum, grid.Spacing, parameters, Between(progress, 0.0, searched));
  if (!(choice.Risk() < choice.NoisePower))
  {
    return result; // the input has the least estimated error
  }
  result.Diffusion = choice.Parameters;
  result.Diffusion.Sigma *= sample.Scale;
  auto change = NewVolume<T>(grid.Size());
  result.Report =
    FindChange(grid, result.Diffusion, values, change.get(), Between(progress, searched, 1.0));
  const double background = ClearBackground(grid, sample, values, change.get());
  const double residual = ExactMeanSquare(grid, change.get());
  const double power = noise ? ExactMeanSquare(grid, noise)
                             : result.NoiseLevel * result.NoiseLevel * (1.0 - background);
  const double nodes = static_cast<double>(sample.Whole[0] * sample.Whole[1] * sample.Whole[2]);
  EstimateGain(sample, spectrum, choice, residual, power, nodes * (1.0 - background), result);
  if (choice.IsLinear())
  {
    result.Report.Change = { std::sqrt(residual) };
    result.Report.Residual = { std::sqrt(residual) / result.Diffusion.Time };
  }
  result.RiskTime = choice.RiskTime;
  result.RiskValue = choice.RiskValue;
  std::for_each(result.RiskValue.begin(), result.RiskValue.end(),
    [square = sample.Scale * sample.Scale](double& value) { value *= square; });
  Combine(grid.Size(), values, change.get(), [](T value, T by) { return value + by; });
  grid.Exchange(values);
  return result;
}

template DenoiseMapResult DenoiseMap(const DiffusionGrid<float>&, const DenoiseMapParameters&,
  float*, const float*, const ProgressCallback&);
template DenoiseMapResult DenoiseMap(const DiffusionGrid<double>&, const DenoiseMapParameters&,
  double*, const double*, const ProgressCallback&);

}
