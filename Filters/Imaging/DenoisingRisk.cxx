#include "Imaging/DenoisingRisk.h"

#include "Core/RangeChecks.h"
#include "Imaging/ChebyshevFilter.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus
{
namespace
{

constexpr int seriesDegree = 40; ///< of the polynomials of linear diffusions
constexpr int basisSize = seriesDegree + 1;
constexpr double probeStep = 0.1; ///< in standard deviations of the noise

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

DiffusionGrid<float> TrialGrid(const TrialBlock& trial, const std::array<double, 3>& spacing)
{
  DiffusionGrid<float> grid;
  grid.Dimensions = trial.Box.Size();
  grid.Spacing = spacing;
  return grid;
}

/// Offsets in Box of the inner nodes, in order.
std::vector<std::int64_t> InnerNodes(const TrialBlock& trial)
{
  std::vector<std::int64_t> nodes;
  nodes.reserve(static_cast<std::size_t>(trial.Inner.Count()));
  const Index3 size = trial.Box.Size();
  Index3 first, last;
  for (std::size_t a = 0; a < 3; ++a)
  {
    first[a] = trial.Inner.Begin[a] - trial.Box.Begin[a];
    last[a] = trial.Inner.End[a] - trial.Box.Begin[a];
  }
  for (std::int64_t k = first[2]; k < last[2]; ++k)
  {
    for (std::int64_t j = first[1]; j < last[1]; ++j)
    {
      for (std::int64_t i = first[0]; i < last[0]; ++i)
      {
        nodes.push_back(i + size[0] * (j + size[1] * k));
      }
    }
  }
  return nodes;
}

/// T_n of a block's values, n from 0 to `count` - 1.
class Basis
{
public:
  Basis(const TrialBlock& trial, const std::vector<float>& values,
    const std::array<double, 3>& spacing, int count)
    : Volumes(static_cast<std::size_t>(count), std::vector<float>(values.size()))
  {
    this->Volumes[0] = values;
    std::vector<float*> pointers;
    std::transform(this->Volumes.begin(), this->Volumes.end(), std::back_inserter(pointers),
      [](std::vector<float>& volume) { return volume.data(); });
    FillChebyshevBasis(TrialGrid(trial, spacing), pointers);
  }

  /// The combination with these coefficients.
  std::vector<float> Combine(const std::vector<double>& coefficients) const
  {
    std::vector<float> sum(this->Volumes[0].size(), 0.0f);
    for (std::size_t n = 0; n < coefficients.size(); ++n)
    {
      const auto factor = static_cast<float>(coefficients[n]);
      const float* term = this->Volumes[n].data();
      for (std::size_t i = 0; i < sum.size(); ++i)
      {
        sum[i] += factor * term[i];
      }
    }
    return sum;
  }

  /// Sum over nodes of weight v v^T, v the values of all volumes at a node.
  Matrix Gram(const std::vector<std::int64_t>& nodes, const std::vector<double>& weights) const
  {
    constexpr std::int64_t chunk = 2048;
    const auto total = static_cast<std::int64_t>(nodes.size());
    const auto rows = static_cast<Eigen::Index>(this->Volumes.size());
    std::vector<Matrix> parts(static_cast<std::size_t>((total + chunk - 1) / chunk));
    ParallelFor(0, static_cast<std::int64_t>(parts.size()), 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t part = first; part < last; ++part)
        {
          const std::int64_t begin = part * chunk, end = std::min(total, begin + chunk);
          Matrix values(rows, static_cast<Eigen::Index>(end - begin));
          for (Eigen::Index row = 0; row < rows; ++row)
          {
            const std::vector<float>& volume = this->Volumes[static_cast<std::size_t>(row)];
            for (std::int64_t n = begin; n < end; ++n)
            {
              values(row, static_cast<Eigen::Index>(n - begin)) =
                static_cast<double>(
                  volume[static_cast<std::size_t>(nodes[static_cast<std::size_t>(n)])]) *
                std::sqrt(weights[static_cast<std::size_t>(n)]);
            }
          }
          Matrix& gram = parts[static_cast<std::size_t>(part)];
          gram = Matrix::Zero(rows, rows);
          gram.selfadjointView<Eigen::Lower>().rankUpdate(values);
        }
      });
    Matrix sum = Matrix::Zero(rows, rows);
    for (const Matrix& part : parts)
    {
      sum += part;
    }
    return Matrix(sum.selfadjointView<Eigen::Lower>());
  }

private:
  std::vector<std::vector<float>> Volumes;
};

/// The weight of each node: none for constant background, which is left as it is.
std::vector<double> NodeWeights(const TrialBlock& trial, const std::vector<std::int64_t>& nodes)
{
  std::vector<double> weights;
  weights.reserve(nodes.size());
  std::transform(nodes.begin(), nodes.end(), std::back_inserter(weights),
    [&](std::int64_t node)
    { return trial.IsFill[static_cast<std::size_t>(node)] ? 0.0 : trial.Weight; });
  return weights;
}

/// Risks of linear filters from Gram matrices.
class LinearRisks
{
public:
  LinearRisks(
    const VolumeSample& sample, const NoiseSpectrum& noise, const std::array<double, 3>& spacing)
    : Bound(LaplacianBound<float>(spacing))
    , Gram(Matrix::Zero(basisSize, basisSize))
    , GramOfNoise(Matrix::Zero(basisSize, basisSize))
  {
    for (const TrialBlock& trial : sample.Trials)
    {
      const std::vector<std::int64_t> nodes = InnerNodes(trial);
      const Basis basis(trial, trial.Values, spacing, basisSize);
      const std::vector<double> weights = NodeWeights(trial, nodes);
      this->Gram += basis.Gram(nodes, weights);
      for (const double weight : weights)
      {
        this->Weight += weight;
      }
      if (!trial.Noise.empty())
      {
        this->Measured = true;
        this->GramOfNoise += Basis(trial, trial.Noise, spacing, basisSize).Gram(nodes, weights);
      }
    }
    this->FindTraces(sample, noise, spacing);
  }

  struct Terms
  {
    double Residual, NoisePower, Covariance;

    double Risk() const { return this->Residual - this->NoisePower + 2.0 * this->Covariance; }
  };

  Terms Evaluate(const std::vector<double>& coefficients) const
  {
    Vector filter = Vector::Zero(basisSize), identity = Vector::Zero(basisSize);
    for (std::size_t n = 0; n < coefficients.size(); ++n)
    {
      filter(static_cast<Eigen::Index>(n)) = coefficients[n];
    }
    identity(0) = 1.0;
    Terms terms{};
    if (!this->Measured)
    {
      terms.NoisePower = this->Weight * this->Trace(0);
      terms.Covariance = this->Weight * this->Trace.dot(filter);
    }
    const Vector change = filter - identity;
    terms.Residual = change.dot(this->Gram * change);
    if (this->Measured)
    {
      const Vector image = this->GramOfNoise * identity;
      terms.NoisePower = image.dot(identity);
      terms.Covariance = image.dot(filter);
    }
    return terms;
  }

  /// Root mean square of 1 - 2p over the noise.
  double Spread(const std::vector<double>& coefficients) const
  {
    double mean = 0.0, square = 0.0;
    for (const double node : this->SpreadNodes)
    {
      double value = 0.0, before = 1.0, now = 1.0 - 2.0 * node;
      const double x = now;
      for (std::size_t n = 0; n < coefficients.size(); ++n)
      {
        const double term = n == 0 ? 1.0 : now;
        value += coefficients[n] * term;
        if (n > 0)
        {
          const double next = 2.0 * x * now - before;
          before = now;
          now = next;
        }
      }
      square += (1.0 - 2.0 * value) * (1.0 - 2.0 * value);
      mean += 1.0;
    }
    return std::sqrt(square / mean);
  }

  double GetBound() const { return this->Bound; }

private:
  /// Means over the grid's modes of noise T_n.
  void FindTraces(
    const VolumeSample& sample, const NoiseSpectrum& noise, const std::array<double, 3>& spacing)
  {
    const auto modes = LaplacianModes(sample.Whole, spacing);
    const Vector sum =
      ParallelReduce(static_cast<std::int64_t>(modes[2].size()), 1, Vector(Vector::Zero(basisSize)),
        [&](Vector& part, std::int64_t first, std::int64_t last)
        {
          for (std::int64_t k = first; k < last; ++k)
          {
            for (const double y : modes[1])
            {
              for (const double x : modes[0])
              {
                AddMode(noise, modes[2][static_cast<std::size_t>(k)] + y + x, part);
              }
            }
          }
        });
    this->Trace = sum / static_cast<double>(modes[0].size() * modes[1].size() * modes[2].size());
    for (std::size_t k = 0; k < modes[2].size(); k += 3)
    {
      for (std::size_t j = 0; j < modes[1].size(); j += 3)
      {
        for (std::size_t i = 0; i < modes[0].size(); i += 3)
        {
          this->SpreadNodes.push_back(modes[2][k] + modes[1][j] + modes[0][i]);
        }
      }
    }
  }

  static void AddMode(const NoiseSpectrum& noise, double s, Vector& sum)
  {
    const double power = noise.At(s), x = 1.0 - 2.0 * s;
    double before = 1.0, now = x;
    sum(0) += power;
    for (Eigen::Index n = 1; n < basisSize; ++n)
    {
      sum(n) += power * now;
      const double next = 2.0 * x * now - before;
      before = now;
      now = next;
    }
  }

  double Bound, Weight = 0.0;
  bool Measured = false;
  Matrix Gram, GramOfNoise;
  Vector Trace;
  std::vector<double> SpreadNodes;
};

/// A linear diffusion as a polynomial; empty if the degree does not suffice.
std::vector<double> LinearPolynomial(int order, double time, double bound)
{
  std::vector<double> series = ChebyshevInterpolation(
    [=](double s) { return std::exp(-time * std::pow(s * bound, order + 1)); }, seriesDegree);
  double tail = 0.0;
  for (std::size_t n = seriesDegree - 4; n < series.size(); ++n)
  {
    tail += std::abs(series[n]);
  }
  return tail < 2e-3 ? series : std::vector<double>();
}

/// Best time of each order, and the curves.
struct LinearBest
{
  int Order = 0;
  double Time = 0.0, Value = std::numeric_limits<double>::max();
  std::array<double, 4> Length{ 0.0, 0.0, 0.0, 0.0 }; ///< time^(1 / (2q + 2))
  std::array<std::vector<double>, 4> Times, Values;
};

LinearBest SearchLinear(const LinearRisks& risks, double voxel)
{
  LinearBest best;
  for (int order = 0; order < 4; ++order)
  {
    const auto q = static_cast<std::size_t>(order);
    double least = std::numeric_limits<double>::max();
    for (double length = 0.15; length < 10.0; length *= std::exp2(1.0 / 16.0))
    {
      const double time = std::pow(length * voxel, 2 * order + 2);
      const std::vector<double> series = LinearPolynomial(order, time, risks.GetBound());
      if (series.empty())
      {
        break;
      }
      const double value = risks.Evaluate(series).Risk();
      best.Times[q].push_back(time);
      best.Values[q].push_back(value);
      if (value < least)
      {
        least = value;
        best.Length[q] = length;
      }
      if (value < best.Value)
      {
        best.Value = value;
        best.Order = order;
        best.Time = time;
      }
    }
  }
  return best;
}

/// +1 or -1 from a node's place (a mixing function: splitmix64).
float Sign(std::int64_t node)
{
  auto x = static_cast<std::uint64_t>(node) + 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return ((x ^ (x >> 31)) & 1u) != 0 ? 1.0f : -1.0f;
}

/// Noise like that of the volume, on a block.
std::vector<float> ProbeFor(const TrialBlock& trial, const VolumeSample& sample,
  const NoiseSpectrum& noise, const std::array<double, 3>& spacing)
{
  if (!trial.Noise.empty())
  {
    return trial.Noise;
  }
  const Index3 size = trial.Box.Size();
  std::vector<float> probe(trial.Values.size());
  for (std::int64_t n = 0; n < trial.Box.Count(); ++n)
  {
    const std::int64_t i = n % size[0] + trial.Box.Begin[0];
    const std::int64_t j = n / size[0] % size[1] + trial.Box.Begin[1];
    const std::int64_t k = n / (size[0] * size[1]) + trial.Box.Begin[2];
    probe[static_cast<std::size_t>(n)] = Sign(i + sample.Whole[0] * (j + sample.Whole[1] * k)) *
      static_cast<float>(noise.White ? noise.Deviation : 1.0);
  }
  if (!noise.White)
  {
    const std::vector<double> series = ChebyshevInterpolation(
      [&](double s) { return std::sqrt(std::max(0.0, noise.At(s))); }, seriesDegree);
    probe = Basis(trial, probe, spacing, seriesDegree + 1).Combine(series);
  }
  for (std::size_t n = 0; n < probe.size(); ++n)
  {
    probe[n] = trial.IsFill[n] ? 0.0f : probe[n];
  }
  return probe;
}

/// First and second derivatives at a node, and the curvature of the level set through it.
class LocalShape
{
public:
  /// Offsets to the neighbours along each axis, 0 for an axis of one node.
  LocalShape(const Index3& size, const std::array<double, 3>& spacing)
    : Size(size)
    , Step{ size[0] > 1 ? 1 : 0, size[1] > 1 ? size[0] : 0, size[2] > 1 ? size[0] * size[1] : 0 }
    , Spacing(spacing)
  {
  }

  /// Whether a node has all neighbours.
  bool IsInside(std::int64_t node) const
  {
    const Index3 at{ node % this->Size[0], node / this->Size[0] % this->Size[1],
      node / (this->Size[0] * this->Size[1]) };
    bool inside = true;
    for (std::size_t a = 0; a < 3; ++a)
    {
      inside = inside && (this->Size[a] == 1 || (at[a] > 0 && at[a] + 1 < this->Size[a]));
    }
    return inside;
  }

  Eigen::Vector3d Gradient(const float* at) const
  {
    Eigen::Vector3d gradient;
    for (int a = 0; a < 3; ++a)
    {
      const auto axis = static_cast<std::size_t>(a);
      gradient(a) = (double(at[this->Step[axis]]) - double(at[-this->Step[axis]])) /
        (2.0 * this->Spacing[axis]);
    }
    return gradient;
  }

  /// Laplacian less the second derivative along `gradient`: twice the mean curvature of the level
  /// set times the gradient's length, if that is the function's own gradient.
  double TangentialLaplacian(const float* at, const Eigen::Vector3d& gradient) const
  {
    Eigen::Matrix3d hessian;
    for (int a = 0; a < 3; ++a)
    {
      const auto i = static_cast<std::size_t>(a);
      const std::int64_t p = this->Step[i];
      hessian(a, a) = (double(at[p]) - 2.0 * double(at[0]) + double(at[-p])) /
        (this->Spacing[i] * this->Spacing[i]);
      for (int b = 0; b < a; ++b)
      {
        const auto j = static_cast<std::size_t>(b);
        const std::int64_t q = this->Step[j];
        hessian(a, b) = hessian(b, a) = p == 0 || q == 0
          ? 0.0
          : (double(at[p + q]) - double(at[p - q]) - double(at[q - p]) + double(at[-p - q])) /
            (4.0 * this->Spacing[i] * this->Spacing[j]);
      }
    }
    const double square = gradient.squaredNorm();
    return hessian.trace() - (square > 0.0 ? gradient.dot(hessian * gradient) / square : 0.0);
  }

  /// Twice the mean curvature of the level set.
  double Curvature(const float* at) const
  {
    const Eigen::Vector3d gradient = this->Gradient(at);
    const double length = gradient.norm();
    return length > 0.0 ? this->TangentialLaplacian(at, gradient) / length : 0.0;
  }

private:
  Index3 Size;
  std::array<std::int64_t, 3> Step;
  std::array<double, 3> Spacing;
};

/**
 * Risk of the mean curvature of level sets, where the gradient of a pilot is large, for the linear
 * candidates whose risk of the values is within 1 dB of the least one, that of the pilot.
 *
 * With g and n the pilot's gradient and its direction, A y = (L - d^2/dn^2) y / g is a noisy
 * measurement of twice the mean curvature, linear in y. The candidate's own prediction, the
 * curvature of f(y), is compared with it, as values are: the mean over nodes, weighted by g^2, of
 * (curvature of f(y) - A y)^2 + 2 A b (curvature of f(y + e b) - curvature of f(y)) / e, which is
 * the squared error but for a constant. Smoothing changes the profile of a surface along its normal
 * more than its curvature; comparing Laplacians would count that as an error.
 */
class CurvatureSearch
{
public:
  CurvatureSearch(const VolumeSample& sample, const NoiseSpectrum& noise,
    const std::array<double, 3>& spacing, const LinearRisks& risks, const LinearBest& values)
    : Sample(sample)
    , Noise(noise)
    , Spacing(spacing)
    , Pilot(LinearPolynomial(values.Order, values.Time, risks.GetBound()))
  {
    constexpr double oneDecibel = 1.26;
    const double voxel = *std::min_element(spacing.begin(), spacing.end());
    for (int order = 0; order < 4; ++order)
    {
      for (double length = 0.2; length < 8.0; length *= std::exp2(0.125))
      {
        const double time = std::pow(length * voxel, 2 * order + 2);
        std::vector<double> series = LinearPolynomial(order, time, risks.GetBound());
        if (!series.empty() && risks.Evaluate(series).Risk() <= oneDecibel * values.Value)
        {
          this->Candidates.push_back({ order, length, time, std::move(series), 0.0 });
        }
      }
    }
  }

  /// False where no gradient is clearly larger than the others.
  bool Search(LinearBest& best)
  {
    const double threshold = this->GradientThreshold();
    if (!(threshold > 0.0) || this->Candidates.empty())
    {
      return false;
    }
    for (const TrialBlock& trial : this->Sample.Trials)
    {
      this->Judge(trial, threshold);
    }
    std::array<double, 4> least;
    least.fill(std::numeric_limits<double>::max());
    for (const Candidate& candidate : this->Candidates)
    {
      const auto q = static_cast<std::size_t>(candidate.Order);
      best.Times[q].push_back(candidate.Time);
      best.Values[q].push_back(candidate.Value);
      if (candidate.Value < least[q])
      {
        least[q] = candidate.Value;
        best.Length[q] = candidate.Length;
      }
      if (candidate.Value < best.Value)
      {
        best.Value = candidate.Value;
        best.Order = candidate.Order;
        best.Time = candidate.Time;
      }
    }
    return true;
  }

private:
  struct Candidate
  {
    int Order;
    double Length, Time;
    std::vector<double> Series;
    double Value;
  };

  /// Nodes of a trial at which level sets are evaluated.
  std::vector<std::int64_t> Surroundings(const TrialBlock& trial, const LocalShape& shape) const
  {
    std::vector<std::int64_t> nodes;
    for (const std::int64_t node : InnerNodes(trial))
    {
      if (!trial.IsFill[static_cast<std::size_t>(node)] && shape.IsInside(node))
      {
        nodes.push_back(node);
      }
    }
    return nodes;
  }

  /// A tenth of nearly the largest squared gradient.
  double GradientThreshold() const
  {
    std::vector<double> squares;
    for (const TrialBlock& trial : this->Sample.Trials)
    {
      const LocalShape shape(trial.Box.Size(), this->Spacing);
      const std::vector<float> pilot =
        Basis(trial, trial.Values, this->Spacing, basisSize).Combine(this->Pilot);
      for (const std::int64_t node : this->Surroundings(trial, shape))
      {
        squares.push_back(shape.Gradient(pilot.data() + node).squaredNorm());
      }
    }
    if (squares.empty())
    {
      return 0.0;
    }
    const auto nearlyLast =
      squares.begin() + static_cast<std::ptrdiff_t>(0.995 * double(squares.size() - 1));
    std::nth_element(squares.begin(), nearlyLast, squares.end());
    return 0.1 * *nearlyLast;
  }

  void Judge(const TrialBlock& trial, double threshold)
  {
    const LocalShape shape(trial.Box.Size(), this->Spacing);
    const Basis values(trial, trial.Values, this->Spacing, seriesDegree + 1);
    const std::vector<float> probe = ProbeFor(trial, this->Sample, this->Noise, this->Spacing);
    const Basis probes(trial, probe, this->Spacing, seriesDegree + 1);
    const std::vector<float> pilot = values.Combine(this->Pilot);
    struct Place
    {
      std::int64_t Node;
      double Gradient, Measured, OfProbe;
    };
    std::vector<Place> places;
    for (const std::int64_t node : this->Surroundings(trial, shape))
    {
      const Eigen::Vector3d gradient = shape.Gradient(pilot.data() + node);
      if (gradient.squaredNorm() >= threshold)
      {
        places.push_back(
          { node, gradient.norm(), shape.TangentialLaplacian(trial.Values.data() + node, gradient),
            shape.TangentialLaplacian(probe.data() + node, gradient) });
      }
    }
    // Enough for a decision; a stride that is not a multiple of a row's length leaves no pattern.
    constexpr std::size_t enough = 40000;
    const std::size_t stride = (places.size() + enough - 1) / enough;
    ParallelFor(0, static_cast<std::int64_t>(this->Candidates.size()), 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t c = first; c < last; ++c)
        {
          Candidate& candidate = this->Candidates[static_cast<std::size_t>(c)];
          const std::vector<float> plain = values.Combine(candidate.Series);
          std::vector<float> probed = probes.Combine(candidate.Series);
          std::transform(plain.begin(), plain.end(), probed.begin(), probed.begin(),
            [](float value, float change) { return value + float(probeStep) * change; });
          double sum = 0.0;
          for (std::size_t n = 0; n < places.size(); n += stride)
          {
            const Place& place = places[n];
            const double curvature = shape.Curvature(plain.data() + place.Node);
            const double moved = shape.Curvature(probed.data() + place.Node) - curvature;
            const double error = place.Gradient * curvature - place.Measured;
            sum += error * error + 2.0 * place.OfProbe * place.Gradient * moved / probeStep -
              place.Measured * place.Measured;
          }
          candidate.Value += trial.Weight * static_cast<double>(stride) * sum;
        }
      });
  }

  const VolumeSample& Sample;
  const NoiseSpectrum& Noise;
  std::array<double, 3> Spacing;
  std::vector<double> Pilot;
  std::vector<Candidate> Candidates;
};

/// One run with edge stopping, judged after each step.
struct EdgeRun
{
  DiffusionParameters Parameters; ///< Time is the end
  std::vector<double> Time, Residual, Covariance;
};

/// Runs diffusions on all trial blocks, plain and with a probe.
class EdgeTrials
{
public:
  EdgeTrials(
    const VolumeSample& sample, const NoiseSpectrum& noise, const std::array<double, 3>& spacing)
    : Sample(sample)
    , Spacing(spacing)
  {
    for (const TrialBlock& trial : sample.Trials)
    {
      this->Nodes.push_back(InnerNodes(trial));
      this->Probes.push_back(ProbeFor(trial, sample, noise, spacing));
    }
  }

  std::vector<EdgeRun> Run(const std::vector<DiffusionParameters>& all) const
  {
    const std::size_t trials = this->Sample.Trials.size();
    // Task (n, trial, probed); each stores its inner values after each step.
    std::vector<Steps> steps(all.size() * trials * 2);
    ParallelFor(0, static_cast<std::int64_t>(steps.size()), 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t task = first; task < last; ++task)
        {
          const auto t = static_cast<std::size_t>(task);
          steps[t] = this->RunOne(all[t / (2 * trials)], t / 2 % trials, t % 2 == 1);
        }
      });
    std::vector<EdgeRun> runs;
    for (std::size_t n = 0; n < all.size(); ++n)
    {
      EdgeRun run;
      run.Parameters = all[n];
      run.Time = steps[n * trials * 2].Time;
      run.Residual.assign(run.Time.size(), 0.0);
      run.Covariance.assign(run.Time.size(), 0.0);
      for (std::size_t trial = 0; trial < trials; ++trial)
      {
        this->Judge(
          trial, steps[(n * trials + trial) * 2], steps[(n * trials + trial) * 2 + 1], run);
      }
      runs.push_back(std::move(run));
    }
    return runs;
  }

private:
  struct Steps
  {
    std::vector<double> Time;
    std::vector<std::vector<float>> Values;
  };

  Steps RunOne(const DiffusionParameters& parameters, std::size_t index, bool probed) const
  {
    const TrialBlock& trial = this->Sample.Trials[index];
    std::vector<float> values = trial.Values;
    if (probed)
    {
      std::transform(values.begin(), values.end(), this->Probes[index].begin(), values.begin(),
        [](float value, float probe) { return value + static_cast<float>(probeStep) * probe; });
    }
    Steps steps;
    auto observe = [&](double time, const float* now)
    {
      if (time < 0.04 * parameters.Time)
      {
        return; // too short a time to be the best
      }
      steps.Time.push_back(time);
      std::vector<float> inner(this->Nodes[index].size());
      std::transform(this->Nodes[index].begin(), this->Nodes[index].end(), inner.begin(),
        [now](std::int64_t node) { return now[node]; });
      steps.Values.push_back(std::move(inner));
    };
    Diffuse<float>(
      TrialGrid(trial, this->Spacing), parameters, values.data(), nullptr, nullptr, {}, observe);
    return steps;
  }

  void Judge(std::size_t index, const Steps& plain, const Steps& probed, EdgeRun& run) const
  {
    const TrialBlock& trial = this->Sample.Trials[index];
    for (std::size_t step = 0; step < plain.Time.size(); ++step)
    {
      double residual = 0.0, covariance = 0.0;
      for (std::size_t n = 0; n < this->Nodes[index].size(); ++n)
      {
        const auto node = static_cast<std::size_t>(this->Nodes[index][n]);
        if (trial.IsFill[node])
        {
          continue;
        }
        const auto f = static_cast<double>(plain.Values[step][n]);
        const double change = f - static_cast<double>(trial.Values[node]);
        residual += change * change;
        covariance += static_cast<double>(this->Probes[index][node]) *
          (static_cast<double>(probed.Values[step][n]) - f);
      }
      run.Residual[step] += trial.Weight * residual;
      run.Covariance[step] += trial.Weight * covariance / probeStep;
    }
  }

  const VolumeSample& Sample;
  std::array<double, 3> Spacing;
  std::vector<std::vector<std::int64_t>> Nodes;
  std::vector<std::vector<float>> Probes;
};

/// Keeps the best step of all runs.
struct EdgeBest
{
  EdgeRun Run;
  std::size_t Step = 0;
  double Value = std::numeric_limits<double>::max(); ///< risk without the noise's power

  void Consider(const std::vector<EdgeRun>& runs)
  {
    for (const EdgeRun& run : runs)
    {
      for (std::size_t step = 0; step < run.Time.size(); ++step)
      {
        const double value = run.Residual[step] + 2.0 * run.Covariance[step];
        if (value < this->Value)
        {
          this->Value = value;
          this->Run = run;
          this->Step = step;
        }
      }
    }
  }
};

/**
 * Searches Sigma, order and presmoothing one after the other.
 *
 * The first runs decide whether it is worthwhile: if none comes near `linearValue`, the risk of
 * the best linear diffusion without the noise's power, the search ends.
 */
class EdgeSearch
{
public:
  EdgeSearch(const EdgeTrials& trials, const LinearBest& linear, double deviation,
    const std::array<double, 3>& spacing)
    : Trials(trials)
    , Linear(linear)
    , Deviation(deviation)
    , Spacing(spacing)
    , Voxel(*std::min_element(spacing.begin(), spacing.end()))
  {
  }

  EdgeBest Search(double linearValue, double noisePower, const ProgressCallback& progress)
  {
    constexpr double near = 1.05, factor = 1.6, perOrder = 1.6;
    // Nearly all edges of a map that is sampled close to its resolution are lost with the usual
    // presmoothing of 0.7 voxels; without any, strong noise counts as edges.
    this->Try({ { 0, 0.5, 0.7 }, { 0, 0.6, 0.35 }, { 1, perOrder * 0.5, 0.7 } });
    Report(progress, 0.3);
    if (this->Best.Value - noisePower > near * (linearValue - noisePower))
    {
      return this->Best;
    }
    const Candidate start = this->BestCandidate();
    this->Try({ start.WithSigma(start.Sigma / factor), start.WithSigma(start.Sigma * factor) });
    Report(progress, 0.5);
    const Candidate scaled = this->BestCandidate();
    const double moved = scaled.Sigma / start.Sigma;
    std::vector<Candidate> next;
    if (std::abs(moved - 1.0) > 0.1)
    {
      next.push_back(scaled.WithSigma(scaled.Sigma * moved));
    }
    if (scaled.Order > 0)
    {
      next.push_back({ scaled.Order - 1, scaled.Sigma / perOrder, scaled.PreSmoothing });
    }
    if (scaled.Order < 2)
    {
      next.push_back({ scaled.Order + 1, scaled.Sigma * perOrder, scaled.PreSmoothing });
    }
    this->Try(next);
    Report(progress, 0.7);
    this->TryPreSmoothings();
    Report(progress, 0.9);
    const Candidate last = this->BestCandidate();
    this->Try({ last.WithSigma(last.Sigma * std::sqrt(moved > 1.0 ? factor : 1.0 / factor)) });
    Report(progress, 1.0);
    return this->Best;
  }

private:
  struct Candidate
  {
    int Order;
    double Sigma;        ///< in standard deviations of the noise per voxel
    double PreSmoothing; ///< in voxels

    Candidate WithSigma(double sigma) const { return { this->Order, sigma, this->PreSmoothing }; }
  };

  Candidate BestCandidate() const
  {
    const DiffusionParameters& best = this->Best.Run.Parameters;
    return { best.Order, best.Sigma * this->Voxel / this->Deviation,
      best.PreSmoothing / this->Voxel };
  }

  /// The presmoothings next to the best one, and the one after in the direction that is better.
  void TryPreSmoothings()
  {
    constexpr std::array<double, 6> lengths{ 0.0, 0.35, 0.5, 0.7, 1.0, 1.4 };
    const Candidate from = this->BestCandidate();
    auto isBest = [this](double length)
    { return std::abs(length - this->BestCandidate().PreSmoothing) < 1e-3; };
    auto indexOfBest = [&]
    { return std::find_if(lengths.begin(), lengths.end(), isBest) - lengths.begin(); };
    auto tryThem = [&](std::initializer_list<std::ptrdiff_t> indices)
    {
      std::vector<Candidate> candidates;
      for (const std::ptrdiff_t n : indices)
      {
        if (n >= 0 && n < static_cast<std::ptrdiff_t>(lengths.size()))
        {
          candidates.push_back({ from.Order, from.Sigma, lengths[static_cast<std::size_t>(n)] });
        }
      }
      this->Try(candidates);
    };
    const std::ptrdiff_t first = indexOfBest();
    tryThem({ first - 1, first + 1 });
    const std::ptrdiff_t second = indexOfBest();
    if (second != first)
    {
      tryThem({ 2 * second - first });
    }
  }

  DiffusionParameters ToParameters(const Candidate& candidate) const
  {
    DiffusionParameters parameters;
    parameters.Order = candidate.Order;
    parameters.EdgeStopping = DiffusionParameters::EdgeStoppingType::Gaussian;
    parameters.Sigma = candidate.Sigma * this->Deviation / this->Voxel;
    parameters.PreSmoothing = candidate.PreSmoothing * this->Voxel;
    // With edge stopping the best time is longer than without; the limit keeps the search from
    // taking most of the time.
    const auto q = static_cast<std::size_t>(candidate.Order);
    constexpr std::array<double, 3> least{ 6.0, 2.5, 0.4 };
    const double exponent = 2.0 * candidate.Order + 2.0;
    constexpr double mostSteps = 1500.0;
    parameters.Time = std::max(std::pow(1.6 * this->Linear.Length[q], exponent), least[q]) *
      std::pow(this->Voxel, exponent);
    const EdgeRun& best = this->Best.Run;
    if (!best.Time.empty() && best.Parameters.Order == candidate.Order)
    {
      parameters.Time = std::max(parameters.Time, 1.5 * best.Time[this->Best.Step]);
    }
    parameters.Time =
      std::min(parameters.Time, mostSteps * ExplicitStepLimit(parameters, this->Spacing));
    return parameters;
  }

  void Try(const std::vector<Candidate>& candidates)
  {
    std::vector<DiffusionParameters> all;
    std::transform(candidates.begin(), candidates.end(), std::back_inserter(all),
      [&](const Candidate& candidate) { return this->ToParameters(candidate); });
    this->Best.Consider(this->Trials.Run(all));
  }

  const EdgeTrials& Trials;
  const LinearBest& Linear;
  double Deviation;
  std::array<double, 3> Spacing;
  double Voxel;
  EdgeBest Best;
};

double MeanNoisePower(const VolumeSample& sample, const NoiseSpectrum& noise)
{
  double power = 0.0;
  for (const TrialBlock& trial : sample.Trials)
  {
    for (const std::int64_t node : InnerNodes(trial))
    {
      const auto n = static_cast<std::size_t>(node);
      const double deviation =
        trial.Noise.empty() ? noise.Deviation : static_cast<double>(trial.Noise[n]);
      power += trial.IsFill[n] ? 0.0 : trial.Weight * deviation * deviation;
    }
  }
  return power;
}

}

void Check(const DenoisingSearch& search)
{
  RequireChoice("Goal", search.Goal, DenoisingGoal::Volumes);
  RequireRange("Strength", search.Strength, 0.0, 1.0);
}

DenoisingChoice EvaluateDenoising(const VolumeSample& sample, const NoiseSpectrum& noise,
  const std::array<double, 3>& spacing, const DiffusionParameters& parameters)
{
  DenoisingChoice choice;
  choice.Parameters = parameters;
  if (choice.IsLinear())
  {
    const LinearRisks risks(sample, noise, spacing);
    const std::vector<double> series =
      LinearPolynomial(parameters.Order, parameters.Time, risks.GetBound());
    const auto terms = risks.Evaluate(series);
    choice.Residual = terms.Residual;
    choice.NoisePower = terms.NoisePower;
    choice.Covariance = terms.Covariance;
    choice.Spread = risks.Spread(series);
    return choice;
  }
  const EdgeRun run = EdgeTrials(sample, noise, spacing).Run({ parameters }).front();
  choice.Residual = run.Residual.back();
  choice.Covariance = run.Covariance.back();
  choice.NoisePower = MeanNoisePower(sample, noise);
  choice.Spread = 1.0;
  return choice;
}

DenoisingChoice ChooseDenoising(const VolumeSample& sample, const NoiseSpectrum& noise,
  const std::array<double, 3>& spacing, const DenoisingSearch& search,
  const ProgressCallback& progress)
{
  Check(search);
  const double voxel = *std::min_element(spacing.begin(), spacing.end());
  const LinearRisks risks(sample, noise, spacing);
  Report(progress, 0.1);
  const LinearBest best = SearchLinear(risks, voxel);
  DenoisingChoice choice;
  choice.Parameters.EdgeStopping = DiffusionParameters::EdgeStoppingType::None;
  auto stronger = [&search](DiffusionParameters& parameters)
  { parameters.Time *= std::exp2((2.0 * parameters.Order + 2.0) * (search.Strength - 0.5)); };
  auto take = [&](const LinearBest& linear)
  {
    choice.Parameters.Order = linear.Order;
    choice.Parameters.Time = linear.Time;
    stronger(choice.Parameters);
    std::vector<double> series;
    while (
      (series = LinearPolynomial(choice.Parameters.Order, choice.Parameters.Time, risks.GetBound()))
        .empty())
    {
      choice.Parameters.Time /= 1.2;
    }
    const auto terms = risks.Evaluate(series);
    choice.Residual = terms.Residual;
    choice.NoisePower = terms.NoisePower;
    choice.Covariance = terms.Covariance;
    choice.Spread = risks.Spread(series);
    choice.RiskTime = linear.Times[static_cast<std::size_t>(linear.Order)];
    choice.RiskValue = linear.Values[static_cast<std::size_t>(linear.Order)];
  };
  if (search.Goal == DenoisingGoal::Surfaces)
  {
    // Curvature alone would require more smoothing than one decibel allows, which moves surfaces;
    // Hessian Curvature adds it by its own scale. Edge stopping keeps noise where the gradient is
    // largest, on surfaces, so it is not a candidate.
    LinearBest ofCurvature;
    const bool found = CurvatureSearch(sample, noise, spacing, risks, best).Search(ofCurvature);
    take(found ? ofCurvature : best);
    Report(progress, 1.0);
    return choice;
  }
  take(best);
  if (search.LinearOnly)
  {
    Report(progress, 1.0);
    return choice;
  }
  const EdgeTrials trials(sample, noise, spacing);
  const EdgeBest edges =
    EdgeSearch(trials, best, noise.Deviation, spacing)
      .Search(best.Value + choice.NoisePower, choice.NoisePower, Between(progress, 0.15, 1.0));
  const EdgeRun& run = edges.Run;
  // Run again to the chosen time and to times between the steps, with the steps of the whole
  // volume.
  std::vector<DiffusionParameters> ends(3, run.Parameters);
  const double time = run.Time[edges.Step];
  const double before = edges.Step > 0 ? run.Time[edges.Step - 1] : 0.25 * time;
  const double after = edges.Step + 1 < run.Time.size() ? run.Time[edges.Step + 1] : 1.5 * time;
  ends[0].Time = std::sqrt(before * time);
  ends[1].Time = time;
  ends[2].Time = std::sqrt(time * after);
  const std::vector<EdgeRun> runs = trials.Run(ends);
  auto valueAtEnd = [](const EdgeRun& one)
  { return one.Residual.back() + 2.0 * one.Covariance.back(); };
  const EdgeRun& atEnd = *std::min_element(runs.begin(), runs.end(),
    [&](const EdgeRun& one, const EdgeRun& other) { return valueAtEnd(one) < valueAtEnd(other); });
  constexpr double clearly = 0.97;
  if (std::min(edges.Value, valueAtEnd(atEnd)) - choice.NoisePower >= clearly * best.Value)
  {
    return choice;
  }
  choice.Parameters = atEnd.Parameters;
  choice.Residual = atEnd.Residual.back();
  choice.Covariance = atEnd.Covariance.back();
  choice.Spread = 1.0;
  choice.RiskTime = run.Time;
  choice.RiskValue.clear();
  for (std::size_t step = 0; step < run.Time.size(); ++step)
  {
    choice.RiskValue.push_back(run.Residual[step] + 2.0 * run.Covariance[step] - choice.NoisePower);
  }
  if (atEnd.Parameters.Time != time)
  {
    const auto at =
      std::lower_bound(run.Time.begin(), run.Time.end(), atEnd.Parameters.Time) - run.Time.begin();
    choice.RiskTime.insert(choice.RiskTime.begin() + at, atEnd.Parameters.Time);
    choice.RiskValue.insert(choice.RiskValue.begin() + at, choice.Risk());
  }
  if (search.Strength != 0.5)
  {
    stronger(choice.Parameters);
    const EdgeRun other = trials.Run({ choice.Parameters }).front();
    choice.Residual = other.Residual.back();
    choice.Covariance = other.Covariance.back();
  }
  return choice;
}

}
