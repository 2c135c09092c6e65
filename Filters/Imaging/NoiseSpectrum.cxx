#include "Imaging/NoiseSpectrum.h"

#include "Imaging/SmoothedNoise.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isthmus
{
namespace
{

/// Bins with less than this share of the strongest one's power are dominated by leakage.
constexpr double weak = 0.02;

/// Power and fourth power of a block's waves, bin by bin.
struct BlockPower
{
  std::array<double, waveBins> Square{}, Fourth{};
};

/// The powers of all blocks.
class Spectra
{
public:
  explicit Spectra(const BlockWaves& waves)
    : Powers(waves.Squares.size())
  {
    for (const int bin : waves.Bin)
    {
      if (bin >= 0)
      {
        this->Count[static_cast<std::size_t>(bin)] += 1.0;
      }
    }
    for (std::size_t block = 0; block < this->Powers.size(); ++block)
    {
      BlockPower& power = this->Powers[block];
      for (std::size_t n = 1; n < waves.Bin.size(); ++n)
      {
        const auto bin = static_cast<std::size_t>(waves.Bin[n]);
        const auto square = static_cast<double>(waves.Squares[block][n]);
        power.Square[bin] += square;
        power.Fourth[bin] += square * square;
      }
    }
  }

  /// Waves with sqrt(s) from `low` to `high`.
  double Waves(double low, double high) const
  {
    double waves = 0.0;
    this->ForBins(low, high, [&](std::size_t bin) { waves += this->Count[bin]; });
    return waves;
  }

  /// Mean power of these waves, for each block.
  std::vector<double> BandPower(double low, double high) const
  {
    std::vector<double> powers;
    for (const BlockPower& power : this->Powers)
    {
      double sum = 0.0;
      this->ForBins(low, high, [&](std::size_t bin) { sum += power.Square[bin]; });
      powers.push_back(sum / std::max(1.0, this->Waves(low, high)));
    }
    return powers;
  }

  /// The power of noise alone, if at least a quarter of the blocks have nothing else there.
  double Floor(double low, double high) const
  {
    const double waves = this->Waves(low, high);
    if (waves < 8.0)
    {
      return -1.0;
    }
    constexpr double lowerQuartile = -0.6745;
    return Quantile(this->BandPower(low, high), 0.25) / SpreadAtQuantile(waves, lowerQuartile);
  }

  double Bin(std::size_t bin, const std::vector<std::size_t>& blocks) const
  {
    double sum = 0.0;
    for (const std::size_t block : blocks)
    {
      sum += this->Powers[block].Square[bin];
    }
    return sum / std::max(1.0, this->Count[bin] * static_cast<double>(blocks.size()));
  }

  /// The lower quartile of each bin over the blocks, corrected for its spread.
  std::vector<double> LowQuantiles() const
  {
    std::vector<double> quantiles(waveBins, 0.0);
    for (std::size_t bin = 0; bin < waveBins; ++bin)
    {
      std::vector<double> powers(this->Powers.size());
      std::transform(this->Powers.begin(), this->Powers.end(), powers.begin(),
        [&](const BlockPower& power)
        { return power.Square[bin] / std::max(1.0, this->Count[bin]); });
      quantiles[bin] =
        Quantile(powers, 0.25) / SpreadAtQuantile(std::max(1.0, this->Count[bin]), -0.6745);
    }
    return quantiles;
  }

  /// For each block, the mean over these waves of their power over that of `reference`, where that
  /// is not 0.
  std::vector<double> RelativePower(
    const std::vector<double>& reference, double low, double high) const
  {
    const double waves = std::max(1.0, this->CountWaves(reference, low, high));
    std::vector<double> powers;
    for (const BlockPower& power : this->Powers)
    {
      double sum = 0.0;
      this->ForBins(low, high,
        [&](std::size_t bin)
        { sum += reference[bin] > 0.0 ? power.Square[bin] / reference[bin] : 0.0; });
      powers.push_back(sum / waves);
    }
    return powers;
  }

  /// The number of these waves.
  double CountWaves(const std::vector<double>& reference, double low, double high) const
  {
    double waves = 0.0;
    this->ForBins(
      low, high, [&](std::size_t bin) { waves += reference[bin] > 0.0 ? this->Count[bin] : 0.0; });
    return waves;
  }

  double Waves(std::size_t bin) const { return this->Count[bin]; }

  /// Mean kurtosis of the waves' amplitudes, bin by bin; 3 for normal ones.
  double Kurtosis(double low, double high, const std::vector<std::size_t>& blocks) const
  {
    double weighted = 0.0, weights = 0.0, strongest = 0.0;
    this->ForBins(
      low, high, [&](std::size_t bin) { strongest = std::max(strongest, this->Bin(bin, blocks)); });
    this->ForBins(low, high,
      [&](std::size_t bin)
      {
        double fourth = 0.0;
        const double square = this->Bin(bin, blocks);
        for (const std::size_t block : blocks)
        {
          fourth += this->Powers[block].Fourth[bin];
        }
        const double count = this->Count[bin] * static_cast<double>(blocks.size());
        if (count > 100.0 && square > weak * strongest)
        {
          weighted += fourth / (square * square); // count times the bin's kurtosis
          weights += count;
        }
      });
    return weights > 0.0 ? weighted / weights : 0.0;
  }

private:
  template <typename Body>
  void ForBins(double low, double high, Body&& body) const
  {
    for (std::size_t bin = 0; bin < waveBins; ++bin)
    {
      const double center = (static_cast<double>(bin) + 0.5) / static_cast<double>(waveBins);
      if (center >= low && center < high)
      {
        body(bin);
      }
    }
  }

  std::vector<BlockPower> Powers;
  std::array<double, waveBins> Count{};
};

/**
 * The blocks without signal: as quiet, over the spectrum, as the quietest tenth suggests for noise
 * that is the same everywhere. Empty if the next quietest are far from that.
 */
std::vector<std::size_t> QuietBlocks(const Spectra& spectra)
{
  constexpr double low = 0.04, high = 0.5;
  constexpr double lowestDecile = -1.2816;
  auto withoutWeak = [](std::vector<double> reference)
  {
    const auto last = reference.begin() + static_cast<std::ptrdiff_t>(high * waveBins);
    const double strongest = *std::max_element(reference.begin(), last);
    std::replace_if(
      reference.begin(), reference.end(), [=](double p) { return p < weak * strongest; }, 0.0);
    return reference;
  };
  std::vector<std::size_t> quiet;
  // Powers are compared with those of the spectrum itself: at first a low quantile of each bin.
  std::vector<double> reference = withoutWeak(spectra.LowQuantiles());
  for (int round = 0; round < 2; ++round)
  {
    const double degrees = std::max(1.0, spectra.CountWaves(reference, low, high));
    const std::vector<double> power = spectra.RelativePower(reference, low, high);
    const double level = Quantile(power, 0.1) / SpreadAtQuantile(degrees, lowestDecile);
    const double limit = level * (1.0 + 2.0 * std::sqrt(2.0 / degrees));
    if (Quantile(power, 0.25) > 1.3 * limit)
    {
      return {};
    }
    quiet.clear();
    for (std::size_t n = 0; n < power.size(); ++n)
    {
      if (power[n] <= limit)
      {
        quiet.push_back(n);
      }
    }
    for (std::size_t bin = 0; bin < waveBins; ++bin)
    {
      reference[bin] = spectra.Bin(bin, quiet);
    }
    reference = withoutWeak(reference);
  }
  // Where no other blocks have clearly more, a texture that fills the volume looks like noise.
  const std::vector<double> power = spectra.RelativePower(reference, low, 0.25);
  const double mean = std::accumulate(power.begin(), power.end(), 0.0) / double(power.size());
  constexpr double standsOut = 1.2;
  return mean >= standsOut ? quiet : std::vector<std::size_t>();
}

/// The variance in the volume; if it has a constant background, in the blocks without it.
double SampleVariance(const VolumeSample& sample)
{
  if (!sample.HasFill)
  {
    return 1.0; // values are in units of their standard deviation
  }
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (const std::vector<float>& block : sample.Small.Values)
  {
    for (const float value : block)
    {
      sum += double(value);
      squares += double(value) * double(value);
    }
    count += static_cast<double>(block.size());
  }
  const double mean = sum / count;
  return squares / count - mean * mean;
}

}

double NoiseSpectrum::At(double s) const
{
  if (this->White)
  {
    return this->Deviation * this->Deviation;
  }
  const double position = std::sqrt(std::clamp(s, 0.0, 1.0)) * double(waveBins) - 0.5;
  const double low = std::clamp(std::floor(position), 0.0, double(waveBins) - 2.0);
  const auto bin = static_cast<std::size_t>(low);
  const double part = std::clamp(position - low, 0.0, 1.0);
  return (1.0 - part) * this->Density[bin] + part * this->Density[bin + 1];
}

NoiseSpectrum WhiteNoise(double deviation)
{
  NoiseSpectrum noise;
  noise.Found = true;
  noise.Deviation = deviation;
  return noise;
}

std::array<std::vector<double>, 3> LaplacianModes(
  const Index3& whole, const std::array<double, 3>& spacing)
{
  std::array<std::vector<double>, 3> modes;
  for (std::size_t a = 0; a < 3; ++a)
  {
    modes[a] = AxisModes(std::min<std::int64_t>(64, whole[a]), spacing[a], SpectralBound(spacing));
  }
  return modes;
}

namespace
{

/// Sets level and coherence from the density, on the waves of the whole grid.
void SetLevel(const Index3& whole, const std::array<double, 3>& spacing, NoiseSpectrum& noise)
{
  double sum = 0.0, squares = 0.0, count = 0.0;
  const auto modes = LaplacianModes(whole, spacing);
  for (const double z : modes[2])
  {
    for (const double y : modes[1])
    {
      for (const double x : modes[0])
      {
        const double power = noise.At(x + y + z);
        sum += power;
        squares += power * power;
        count += 1.0;
      }
    }
  }
  noise.Deviation = std::sqrt(sum / count);
  noise.Coherence = sum > 0.0 ? squares * count / (sum * sum) : 1.0;
}

/// Noise of a Gaussian correlation. Its density is scaled to its variance, since the sum over the
/// waves of a finite grid has the longest ones in full.
NoiseSpectrum SmoothedSpectrum(
  const SmoothedNoise& found, const Index3& whole, const std::array<double, 3>& spacing)
{
  NoiseSpectrum noise;
  noise.Found = true;
  noise.White = false;
  noise.Density = found.Density;
  SetLevel(whole, spacing, noise);
  const double scale = found.Variance / (noise.Deviation * noise.Deviation);
  std::for_each(
    noise.Density.begin(), noise.Density.end(), [scale](double& power) { power *= scale; });
  noise.Deviation = std::sqrt(found.Variance);
  return noise;
}

/// The spectrum of blocks without signal; not found where there are none.
NoiseSpectrum BackgroundSpectrum(
  const BlockWaves& waves, const VolumeSample& sample, const std::array<double, 3>& spacing)
{
  const Spectra spectra(waves);
  NoiseSpectrum noise;
  const std::vector<std::size_t> quiet = QuietBlocks(spectra);
  constexpr double normal = 4.0;
  if (quiet.size() < 4 || spectra.Kurtosis(0.06, 0.5, quiet) > normal)
  {
    return noise;
  }
  noise.White = false;
  noise.Density.resize(waveBins);
  for (std::size_t bin = 0; bin < waveBins; ++bin)
  {
    noise.Density[bin] = spectra.Bin(bin, quiet);
  }
  for (std::size_t bin = waveBins; bin-- > 0;)
  {
    if (spectra.Waves(bin) < 1.0 && bin + 1 < waveBins)
    {
      noise.Density[bin] = noise.Density[bin + 1]; // longer waves than a block has
    }
  }
  SetLevel(sample.Whole, spacing, noise);
  // With a larger share of the variance it is more likely a texture that fills the volume. A masked
  // map has no background left, so the limit is lower.
  const double mostNoise = sample.HasFill ? 0.45 : 0.62;
  noise.Found = noise.Deviation * noise.Deviation <= mostNoise * SampleVariance(sample);
  return noise;
}

}

NoiseSpectrum EstimateNoiseSpectrum(
  const VolumeSample& sample, const std::array<double, 3>& spacing)
{
  NoiseSpectrum white;
  constexpr std::size_t fewest = 8;
  if (sample.Small.Values.size() < fewest)
  {
    return white;
  }
  const BlockWaves ofSmall = TransformBlocks(sample.Small, spacing);
  const Spectra small(ofSmall);
  // The upper end of the spectrum; its last part alone where there is clearly less.
  double floor = small.Floor(0.75, 1.01);
  for (const double low : { 0.84, 0.9 })
  {
    const double power = small.Floor(low, 1.01);
    constexpr double clearly = 0.92;
    if (power >= 0.0 && power < clearly * floor)
    {
      floor = power;
    }
  }
  if (floor < 0.0)
  {
    floor = std::max(0.0, small.Floor(0.5, 1.01)); // a slice or a row
  }
  white = WhiteNoise(std::sqrt(floor));
  // White noise is a constant floor below the signal in longer waves; coloured noise decreases to
  // the end.
  constexpr double falling = 2.5;
  const double before = small.Floor(0.76, 0.86), last = small.Floor(0.9, 1.01);
  if (before < 0.0 || last < 0.0 || before <= falling * last)
  {
    return white;
  }
  const BlockWaves ofLarge = TransformBlocks(sample.Large, spacing);
  const bool large = sample.Large.Values.size() >= 2 * fewest;
  const SmoothedNoise correlated =
    FindSmoothedNoise(large ? ofLarge : ofSmall, spacing, SampleVariance(sample));
  // A fit to the tail of a spectrum does not determine the rest if the noise has another shape.
  constexpr double tail = 0.15;
  if (correlated.Found && correlated.Share >= tail)
  {
    return SmoothedSpectrum(correlated, sample.Whole, spacing);
  }
  const bool largeOnes = sample.Large.Values.size() >= 3 * fewest;
  NoiseSpectrum background = BackgroundSpectrum(largeOnes ? ofLarge : ofSmall, sample, spacing);
  if (background.Found)
  {
    return background;
  }
  if (correlated.Found)
  {
    return SmoothedSpectrum(correlated, sample.Whole, spacing);
  }
  white.Background = false;
  return white;
}

}
