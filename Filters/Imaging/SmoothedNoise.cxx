#include "Imaging/SmoothedNoise.h"

#include "Core/Geometry.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace isthmus
{
namespace
{

constexpr std::size_t lengthCount = 150;
constexpr double shortest = 0.4, longest = 4.0;           ///< lengths tried, in the least spacing
constexpr std::size_t fewestLarge = 16, fewestSmall = 48; ///< blocks of 16^3 and of 8^3 nodes
constexpr std::size_t fewestWaves = 12;                   ///< of a bin in a block
constexpr double agreement = 0.12;                        ///< of the logarithms of floors
constexpr double evenness = 1.3; ///< of floors by the lower quartile and the lowest decile
constexpr double visible = 1e-5; ///< least density, relative to the largest
constexpr double normalKurtosis = 3.6;
constexpr double lowerQuartile = -0.6745, lowestDecile = -1.2816; ///< of the normal distribution

/// exp(-length^2 omega^2) at frequencies in the middle of `count` equal parts of 0 to pi / spacing.
std::vector<double> AxisDensity(double length, double spacing, std::size_t count)
{
  std::vector<double> density(count);
  for (std::size_t m = 0; m < count; ++m)
  {
    const double omega =
      Pi * (static_cast<double>(m) + 0.5) / (static_cast<double>(count) * spacing);
    density[m] = std::exp(-length * length * omega * omega);
  }
  return density;
}

/// Variance along an axis of noise whose density is 1 at omega = 0.
double AxisVariance(std::int64_t n, double length, double spacing)
{
  constexpr std::size_t fine = 256;
  const std::vector<double> density = AxisDensity(length, spacing, fine);
  return n == 1 ? 1.0 : std::accumulate(density.begin(), density.end(), 0.0) / double(fine);
}

/// Expected squares of the cosine waves along an axis of n nodes.
std::vector<double> ExpectedAxisSquares(std::int64_t n, double length, double spacing)
{
  const auto count = static_cast<std::size_t>(n);
  std::vector<double> expected(count, 1.0);
  if (n == 1)
  {
    return expected;
  }
  constexpr std::size_t fine = 256;
  const std::vector<double> density = AxisDensity(length, spacing, fine);
  std::vector<double> covariance(count, 0.0);
  for (std::size_t x = 0; x < count; ++x)
  {
    for (std::size_t m = 0; m < fine; ++m)
    {
      covariance[x] += density[m] *
        std::cos(Pi * (static_cast<double>(m) + 0.5) / double(fine) * static_cast<double>(x)) /
        double(fine);
    }
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    std::vector<double> wave(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      wave[i] = std::sqrt((k == 0 ? 1.0 : 2.0) / static_cast<double>(n)) *
        std::cos(Pi * static_cast<double>(k * (2 * i + 1)) / static_cast<double>(2 * n));
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      for (std::size_t j = 0; j < count; ++j)
      {
        sum += wave[i] * wave[j] * covariance[i > j ? i - j : j - i];
      }
    }
    expected[k] = std::max(sum, 0.0);
  }
  return expected;
}

bool HasLargeBlocks(const BlockWaves& waves)
{
  return waves.Bin.size() > 1000;
}

using BinValues = std::array<double, waveBins>;

/// The statistics of the blocks for noise of one length.
struct Whitened
{
  double Length = 0.0, Variance = 0.0;       ///< of noise of density 1
  std::vector<double> Expected;              ///< squares of a block's waves
  BinValues Floor{}, Power{};                ///< logarithm of the floor; sum of Expected
  std::array<bool, waveBins> Seen{}, Even{}; ///< could be detected; is the same everywhere
};

/// The fit of length and level, in four steps.
///
/// 1. Whitening: for each length, the squares of a block's waves are divided by their expectation
///    for density 1. It is exact for a block, since a block's ends change its waves by 5 to 20 %.
/// 2. Floors: the lower quartile over the blocks of the mean of each bin, corrected for the spread
///    of chi squared. Bins in which the lowest tenth of the blocks has clearly less are not the
///    same everywhere and do not count.
/// 3. Fit: floors that agree are explained. The largest number of them is chosen, among equals the
/// least variance.
/// 4. Rejection: the fit is refused if the explained bins are few or have gaps, if their waves are
/// not
///    normally distributed (a texture), or if the noise had nearly all of the variance of the
///    volume: then a map that is full of detail looks the same.
class SmoothedNoiseFit
{
public:
  SmoothedNoiseFit(const BlockWaves& waves, const std::array<double, 3>& spacing)
    : Waves(waves)
    , Spacing(spacing)
    , Lengths(lengthCount)
  {
    for (std::size_t n = 0; n < waves.Bin.size(); ++n)
    {
      if (waves.Bin[n] >= 0)
      {
        this->BinWaves[static_cast<std::size_t>(waves.Bin[n])].push_back(n);
      }
    }
    const double least = *std::min_element(spacing.begin(), spacing.end());
    ParallelFor(0, static_cast<std::int64_t>(lengthCount), 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          const double part = static_cast<double>(n) / static_cast<double>(lengthCount - 1);
          this->Lengths[static_cast<std::size_t>(n)] =
            this->Whiten(least * shortest * std::pow(longest / shortest, part));
        }
      });
  }

  /// The lowest noise among the fits that explain about as many bins as the best.
  SmoothedNoise Find(double total) const
  {
    std::vector<Candidate> candidates;
    for (const Whitened& length : this->Lengths)
    {
      for (std::size_t bin = 0; bin < waveBins; ++bin)
      {
        if (length.Seen[bin] && length.Even[bin])
        {
          this->AddCandidate(length, length.Floor[bin], candidates);
        }
      }
    }
    double most = 0.0;
    for (const Candidate& candidate : candidates)
    {
      most = std::max(most, candidate.Score);
    }
    const Candidate* best = nullptr;
    for (const Candidate& candidate : candidates)
    {
      constexpr double aboutAsMany = 1.0;
      if (candidate.Score > most - aboutAsMany &&
        (!best || candidate.Variance() < best->Variance()))
      {
        best = &candidate;
      }
    }
    SmoothedNoise noise;
    if (best && this->IsBelievable(*best, total))
    {
      noise.Found = true;
      noise.Length = best->Smoothing->Length;
      noise.Variance = best->Variance();
      noise.Share = best->Share;
      noise.Density = this->GridDensity(*best);
    }
    return noise;
  }

private:
  /// A length, a level, and the bins that agree with them.
  struct Candidate
  {
    const Whitened* Smoothing = nullptr;
    double Level = 0.0; ///< logarithm of A
    double Share = 0.0, Score = 0.0;
    std::vector<std::size_t> Bins;

    double Variance() const { return std::exp(this->Level) * this->Smoothing->Variance; }
  };

  Whitened Whiten(double length) const
  {
    Whitened result;
    result.Length = length;
    result.Variance = 1.0;
    std::array<std::vector<double>, 3> expected;
    for (std::size_t a = 0; a < 3; ++a)
    {
      expected[a] = ExpectedAxisSquares(this->Waves.Size[a], length, this->Spacing[a]);
      result.Variance *= AxisVariance(this->Waves.Size[a], length, this->Spacing[a]);
    }
    for (const double z : expected[2])
    {
      for (const double y : expected[1])
      {
        for (const double x : expected[0])
        {
          result.Expected.push_back(x * y * z);
        }
      }
    }
    const double largest = *std::max_element(result.Expected.begin(), result.Expected.end());
    double strongest = 0.0;
    for (std::size_t bin = 0; bin < waveBins; ++bin)
    {
      for (const std::size_t wave : this->BinWaves[bin])
      {
        result.Power[bin] += result.Expected[wave];
      }
      strongest = std::max(strongest, result.Power[bin] / this->Count(bin));
    }
    for (std::size_t bin = 0; bin < waveBins; ++bin)
    {
      result.Seen[bin] = this->BinWaves[bin].size() >= fewestWaves &&
        result.Power[bin] / this->Count(bin) > visible * strongest;
      if (result.Seen[bin])
      {
        const std::vector<double> powers = this->BinPowers(bin, result.Expected, 1e-14 * largest);
        const double floor =
          Quantile(powers, 0.25) / SpreadAtQuantile(this->Count(bin), lowerQuartile);
        const double lowest =
          Quantile(powers, 0.1) / SpreadAtQuantile(this->Count(bin), lowestDecile);
        result.Floor[bin] = std::log(std::max(floor, std::numeric_limits<double>::min()));
        result.Even[bin] = floor < evenness * lowest;
      }
    }
    return result;
  }

  double Count(std::size_t bin) const
  {
    return std::max(1.0, static_cast<double>(this->BinWaves[bin].size()));
  }

  /// Mean over a bin's waves of their squares over the expected ones, for each block.
  std::vector<double> BinPowers(
    std::size_t bin, const std::vector<double>& expected, double least) const
  {
    std::vector<double> inverse;
    for (const std::size_t wave : this->BinWaves[bin])
    {
      inverse.push_back(1.0 / std::max(expected[wave], least) / this->Count(bin));
    }
    std::vector<double> powers;
    for (const std::vector<float>& squares : this->Waves.Squares)
    {
      double sum = 0.0;
      for (std::size_t n = 0; n < inverse.size(); ++n)
      {
        sum += inverse[n] * static_cast<double>(squares[this->BinWaves[bin][n]]);
      }
      powers.push_back(sum);
    }
    return powers;
  }

  void AddCandidate(const Whitened& length, double level, std::vector<Candidate>& candidates) const
  {
    Candidate candidate;
    candidate.Smoothing = &length;
    double weights = 0.0, distances = 0.0, power = 0.0, all = 0.0;
    for (std::size_t bin = 0; bin < waveBins; ++bin)
    {
      all += this->BinWaves[bin].size() >= fewestWaves ? length.Power[bin] : 0.0;
      const double difference = length.Floor[bin] - level;
      if (!length.Seen[bin])
      {
        continue;
      }
      if (difference < -2.5 * agreement)
      {
        return; // less than this noise
      }
      if (length.Even[bin] && std::abs(difference) < agreement)
      {
        candidate.Bins.push_back(bin);
        const double weight = std::sqrt(this->Count(bin));
        candidate.Level += weight * length.Floor[bin];
        weights += weight;
        distances += std::abs(difference) / agreement;
        power += length.Power[bin];
      }
    }
    const std::size_t fewest = HasLargeBlocks(this->Waves) ? 5 : 7;
    if (candidate.Bins.size() < fewest)
    {
      return;
    }
    const auto bins = static_cast<double>(candidate.Bins.size());
    const auto span = static_cast<double>(
      std::count(length.Seen.begin() + static_cast<std::ptrdiff_t>(candidate.Bins.front()),
        length.Seen.begin() + static_cast<std::ptrdiff_t>(candidate.Bins.back()) + 1, true));
    candidate.Share = power / all;
    // Small blocks have few waves each, and the tail of a spectrum alone is ambiguous.
    const double leastShare = !HasLargeBlocks(this->Waves) ? 0.4 : bins < 7.0 ? 0.05 : 0.0;
    if (bins >= 0.75 * span && candidate.Share >= leastShare)
    {
      candidate.Level /= weights;
      candidate.Score = bins + 2.0 * candidate.Share - distances / bins;
      candidates.push_back(candidate);
    }
  }

  /// Whether noise is a more likely explanation than a texture.
  bool IsBelievable(const Candidate& candidate, double total) const
  {
    const double kurtosis = this->ComputeKurtosis(candidate);
    const auto seen = static_cast<double>(
      std::count(candidate.Smoothing->Seen.begin(), candidate.Smoothing->Seen.end(), true));
    const bool explainsAll =
      static_cast<double>(candidate.Bins.size()) >= 0.8 * seen && kurtosis < 3.3;
    // Small blocks do not show long waves, in which signal would be seen.
    const double most = !HasLargeBlocks(this->Waves) ? 0.5 : explainsAll ? 0.87 : 0.7;
    return static_cast<double>(candidate.Bins.size()) >= 0.4 * seen && kurtosis < normalKurtosis &&
      candidate.Variance() < most * total &&
      (HasLargeBlocks(this->Waves) || this->ShareOfBlocks(candidate) > 0.6);
  }

  /// Mean kurtosis of the whitened waves of the explained bins in their quieter blocks.
  double ComputeKurtosis(const Candidate& candidate) const
  {
    double sum = 0.0, waves = 0.0;
    for (const std::size_t bin : candidate.Bins)
    {
      const std::vector<double> powers = this->BinPowers(bin, candidate.Smoothing->Expected, 0.0);
      const double limit = Quantile(powers, 0.3);
      double squares = 0.0, fourths = 0.0, count = 0.0;
      for (std::size_t block = 0; block < powers.size(); ++block)
      {
        if (powers[block] > limit)
        {
          continue;
        }
        for (const std::size_t wave : this->BinWaves[bin])
        {
          const double square = static_cast<double>(this->Waves.Squares[block][wave]) /
            candidate.Smoothing->Expected[wave];
          squares += square;
          fourths += square * square;
          count += 1.0;
        }
      }
      sum += count * fourths * count / (squares * squares);
      waves += count;
    }
    return sum / waves;
  }

  /// Share of the blocks that have, over all explained bins, the noise's power.
  double ShareOfBlocks(const Candidate& candidate) const
  {
    std::vector<double> powers(this->Waves.Squares.size(), 0.0);
    double count = 0.0;
    for (const std::size_t bin : candidate.Bins)
    {
      const std::vector<double> part = this->BinPowers(bin, candidate.Smoothing->Expected, 0.0);
      for (std::size_t block = 0; block < powers.size(); ++block)
      {
        powers[block] += this->Count(bin) * part[block];
      }
      count += this->Count(bin);
    }
    const double tolerance = 3.0 * std::sqrt(2.0 / count) + 0.1;
    const auto like = std::count_if(powers.begin(), powers.end(),
      [&](double power)
      { return std::abs(power / count / std::exp(candidate.Level) - 1.0) < tolerance; });
    return static_cast<double>(like) / static_cast<double>(powers.size());
  }

  /// Mean of the density over the waves of each bin, of a grid of 32 nodes along each axis.
  std::vector<double> GridDensity(const Candidate& candidate) const
  {
    constexpr std::size_t fine = 32;
    const double bound = SpectralBound(this->Spacing);
    std::array<std::vector<double>, 3> density, modes;
    for (std::size_t a = 0; a < 3; ++a)
    {
      if (this->Waves.Size[a] == 1)
      {
        density[a] = { 1.0 };
        modes[a] = { 0.0 };
        continue;
      }
      density[a] = AxisDensity(candidate.Smoothing->Length, this->Spacing[a], fine);
      const std::vector<double> twice = AxisModes(2 * fine, this->Spacing[a], bound);
      for (std::size_t m = 0; m < fine; ++m)
      {
        modes[a].push_back(twice[2 * m + 1]);
      }
    }
    std::vector<double> sum(waveBins, 0.0), count(waveBins, 0.0);
    for (std::size_t k = 0; k < modes[2].size(); ++k)
    {
      for (std::size_t j = 0; j < modes[1].size(); ++j)
      {
        for (std::size_t i = 0; i < modes[0].size(); ++i)
        {
          const std::size_t bin = FrequencyBin(modes[0][i] + modes[1][j] + modes[2][k]);
          sum[bin] += density[0][i] * density[1][j] * density[2][k];
          count[bin] += 1.0;
        }
      }
    }
    const double level = std::exp(candidate.Level);
    for (std::size_t bin = waveBins; bin-- > 0;)
    {
      sum[bin] = count[bin] > 0.0 ? level * sum[bin] / count[bin]
        : bin + 1 < waveBins      ? sum[bin + 1]
                                  : 0.0;
    }
    return sum;
  }

  const BlockWaves& Waves;
  std::array<double, 3> Spacing;
  std::array<std::vector<std::size_t>, waveBins> BinWaves;
  std::vector<Whitened> Lengths;
};

}

SmoothedNoise FindSmoothedNoise(
  const BlockWaves& waves, const std::array<double, 3>& spacing, double total)
{
  if (waves.Squares.size() < (HasLargeBlocks(waves) ? fewestLarge : fewestSmall))
  {
    return {};
  }
  return SmoothedNoiseFit(waves, spacing).Find(total);
}

}
