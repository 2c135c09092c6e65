#include "Curvature/CurvatureScale.h"

#include "Core/Geometry.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace isthmus
{
namespace
{

using Node = std::array<std::int64_t, 3>;

constexpr double largestScale = 8.0;      // u; reaches 35 nodes to each side
constexpr double scalesInThickness = 8.0; // of the image, at least
constexpr double edgeScale = 2.0;         // u, where edges are distinguished from noise
constexpr std::size_t edgeIndex = 5;      // of this scale among the candidates
constexpr std::size_t mostSamples = 2000; // standard error of a variance: 3 %
constexpr double latticeNodes = 30000.0;
constexpr std::size_t fewestSamples = 30;
constexpr double significance = 1.5;          // of a mean square over that of noise
constexpr double MedianOfChiSquared = 0.4549; // with 1 degree of freedom
constexpr double LeastGradientShare = 0.05;   // of the edges' squared gradient
constexpr double missing = -std::numeric_limits<double>::infinity();

double MeanSpacing(const std::array<double, 3>& spacing)
{
  return std::cbrt(spacing[0]) * std::cbrt(spacing[1]) * std::cbrt(spacing[2]);
}

/// The scales, in the unit of the spacing; the last one is used only as the successor of the one
/// before.
std::vector<double> CandidateScales(const std::array<double, 3>& spacing, const Node& whole)
{
  const double unit = MeanSpacing(spacing);
  double most = largestScale;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    most =
      std::min(most, static_cast<double>(whole[axis]) * spacing[axis] / unit / scalesInThickness);
  }
  // A little more than the number: kernels, cut at 4 deviations, must not lose a node by rounding.
  constexpr double margin = 1.0 + 1e-6;
  std::vector<double> scales{ 0.0 };
  for (int k = 0; 0.5 * std::exp2(0.5 * k) <= most * std::sqrt(2.0) * margin; ++k)
  {
    scales.push_back(0.5 * std::exp2(0.5 * k) * margin * unit);
  }
  return scales;
}

/// Samples of scale number k: fewer at large scales, whose cost grows as their cube and of which
/// fewer are independent.
std::size_t CountSamples(double scale)
{
  const double share = std::min(1.0, edgeScale / std::max(scale, 1.0));
  return static_cast<std::size_t>(static_cast<double>(mostSamples) * share * share);
}

/// Runs in a fixed order that is independent of the lattice.
void Shuffle(std::vector<Node>& nodes)
{
  std::mt19937_64 random(1);
  for (std::size_t i = nodes.size(); i > 1; --i)
  {
    std::swap(nodes[i - 1], nodes[random() % i]);
  }
}

/// `count` numbers for each node, by `work(node, numbers)` on a rank that has the required values,
/// otherwise `missing`.
template <typename Work>
std::vector<double> EvaluateAtNodes(const std::vector<Node>& nodes, std::size_t count, Work&& work,
  const MaximumOverRanks& combine, const ProgressCallback& progress)
{
  std::vector<double> numbers(nodes.size() * count, missing);
  ParallelFor(
    0, static_cast<std::int64_t>(nodes.size()), 4,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        double* out = numbers.data() + i * count;
        if (work(nodes[i], out) &&
          !std::all_of(out, out + count, [](double x) { return std::isfinite(x); }))
        {
          std::fill_n(out, count, missing); // a value that is not a number is within reach
        }
      }
    },
    progress);
  if (combine && !numbers.empty())
  {
    combine(numbers.data(), static_cast<std::int64_t>(numbers.size()));
  }
  return numbers;
}

double Square(double x)
{
  return x * x;
}

double SquaredNorm(const std::array<double, 3>& v)
{
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

/// The nodes used to measure noise, and those at edges.
struct Samples
{
  std::vector<Node> Background, Edges;
  double Gradient = 0.0; ///< typical of edges, at edgeScale
};

/// Squared gradients at nodes at edgeScale; `missing` where all values around are the same.
template <typename T>
std::vector<double> SquaredGradients(const GridPart<T>& part, const std::vector<Node>& nodes,
  const MaximumOverRanks& combine, const ProgressCallback& progress)
{
  return EvaluateAtNodes(
    nodes, 1,
    [&](const Node& node, double* out)
    {
      NodeDerivatives at;
      if (!SmoothedGradient(part, node, edgeScale, at))
      {
        return false;
      }
      constexpr double rounding = 1e-12; // of sums of doubles
      const double square = SquaredNorm(at.Gradient);
      *out = std::sqrt(square) > rounding * std::abs(at.Value) ? square : missing;
      return true;
    },
    combine, progress);
}

/// Variance of one component of the gradient of noise, from squared gradients of which some belong
/// to edges: those beyond 3 deviations (9 variances) are removed until nothing changes.
double ClippedVariance(std::vector<double> squares)
{
  constexpr double cut = 9.0;
  // Chi-squared distributions of 3 and 5 degrees of freedom; the latter is the former's first
  // moment.
  const double tail = std::sqrt(2.0 * cut / Pi) * std::exp(-0.5 * cut);
  const double three = std::erf(std::sqrt(0.5 * cut)) - tail;
  const double five = three - tail * cut / 3.0;
  const double factor = 3.0 * five / three;
  if (squares.empty())
  {
    return 0.0;
  }
  std::sort(squares.begin(), squares.end());
  constexpr double quarter = 1.2125; // quantile of the chi-squared distribution with 3 degrees
  double variance = squares[squares.size() / 4] / quarter;
  for (int round = 0; round < 30; ++round)
  {
    double sum = 0.0;
    std::size_t count = 0;
    for (; count < squares.size() && squares[count] < cut * variance; ++count)
    {
      sum += squares[count];
    }
    const double next = count > 0 ? sum / static_cast<double>(count) / factor : 0.0;
    const bool settled = std::abs(next - variance) < 1e-3 * variance;
    variance = next;
    if (settled || variance == 0.0)
    {
      break;
    }
  }
  return variance;
}

std::vector<Node> LatticeNodes(const Node& whole)
{
  const double nodes =
    static_cast<double>(whole[0]) * static_cast<double>(whole[1]) * static_cast<double>(whole[2]);
  const auto stride = std::max<std::int64_t>(
    1, static_cast<std::int64_t>(std::ceil(std::cbrt(nodes / latticeNodes))));
  constexpr std::int64_t margin = DifferenceReach + 1;
  std::vector<Node> lattice;
  for (std::int64_t k = margin; k < whole[2] - margin; k += stride)
  {
    for (std::int64_t j = margin; j < whole[1] - margin; j += stride)
    {
      for (std::int64_t i = margin; i < whole[0] - margin; i += stride)
      {
        lattice.push_back({ i, j, k });
      }
    }
  }
  return lattice;
}

/// The nodes around `nodes` at a third of the lattice's stride: small objects in large images have
/// few nodes of the lattice.
std::vector<Node> NodesBetween(const std::vector<Node>& nodes, const Node& whole)
{
  const std::vector<Node> lattice = LatticeNodes(whole);
  const std::int64_t step = lattice.size() > 1 ? (lattice[1][0] - lattice[0][0]) / 3 : 0;
  std::vector<Node> between;
  for (const Node& node : nodes)
  {
    for (int n = 0; n < 27 && step > 0; ++n)
    {
      const Node near{ node[0] + (n % 3 - 1) * step, node[1] + (n / 3 % 3 - 1) * step,
        node[2] + (n / 9 - 1) * step };
      bool inside = n != 13; // the node itself
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        inside =
          inside && near[axis] > DifferenceReach && near[axis] < whole[axis] - DifferenceReach - 1;
      }
      if (inside)
      {
        between.push_back(near);
      }
    }
  }
  return between;
}

/// Edges: gradients beyond 5 times that of noise and beyond the typical one of edges, the square
/// root of sum g^4 over sum g^2. Background: within 3 deviations of a Maxwell distribution.
template <typename T>
Samples FindSamples(
  const GridPart<T>& part, const MaximumOverRanks& combine, const ProgressCallback& progress)
{
  std::vector<Node> nodes = LatticeNodes(part.Whole);
  Shuffle(nodes);
  const std::vector<double> squares =
    SquaredGradients(part, nodes, combine, Between(progress, 0.0, 0.8));
  std::vector<double> present;
  std::copy_if(squares.begin(), squares.end(), std::back_inserter(present),
    [](double square) { return square != missing; });
  const double variance = ClippedVariance(present);
  constexpr double background = 9.0, edge = 25.0; // squares of 3 and 5 deviations
  double fourth = 0.0, second = 0.0;
  for (const double square : squares)
  {
    if (square > edge * variance)
    {
      fourth += square * square;
      second += square;
    }
  }
  Samples samples;
  if (!(second > 0.0))
  {
    return samples;
  }
  samples.Gradient = std::sqrt(fourth / second);
  const double least = std::max(edge * variance, Square(samples.Gradient));
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (squares[i] > least)
    {
      samples.Edges.push_back(nodes[i]);
    }
    else if (squares[i] != missing && squares[i] < background * variance)
    {
      samples.Background.push_back(nodes[i]);
    }
  }
  if (samples.Edges.size() < mostSamples / 2)
  {
    const std::vector<Node> between = NodesBetween(samples.Edges, part.Whole);
    const std::vector<double> more =
      SquaredGradients(part, between, combine, Between(progress, 0.8, 1.0));
    for (std::size_t i = 0; i < between.size(); ++i)
    {
      if (more[i] > least)
      {
        samples.Edges.push_back(between[i]);
      }
    }
    Shuffle(samples.Edges);
  }
  return samples;
}

/// Orders of the differences from which white noise is estimated.
constexpr std::array<int, 2> differenceOrders{ 5, 8 };

/// Writes for each axis the square of the difference of each order of the values along it, around
/// `node`, divided by the variance that white noise of variance 1 has in it. Returns false if not
/// all required nodes are available.
template <typename T>
bool SquaredDifferences(const GridPart<T>& part, const Node& node, double* out)
{
  Node at = node;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    at[axis] -= part.First[axis];
    const int reach = differenceOrders.back() / 2;
    if (at[axis] < reach || at[axis] + reach >= part.Values.Dimensions[axis])
    {
      return false;
    }
  }
  const T* values = &part.Values(at[0], at[1], at[2]);
  const Node strides{ 1, part.Values.Dimensions[0],
    part.Values.Dimensions[0] * part.Values.Dimensions[1] };
  for (const int order : differenceOrders)
  {
    for (const std::int64_t stride : strides)
    {
      double sum = 0.0, squares = 0.0, binomial = 1.0;
      for (int i = 0; i <= order; ++i)
      {
        sum += (i % 2 == 0 ? binomial : -binomial) *
          static_cast<double>(values[(i - order / 2) * stride]);
        squares += Square(binomial);
        binomial *= static_cast<double>(order - i) / (i + 1);
      }
      *out++ = Square(sum) / squares;
    }
  }
  return true;
}

/// Deviation of white noise at `nodes`, from differences along the axes; 0 if there is none, or
/// none that differs from structure. Differences of noise have the same normalized variance at any
/// order; those of a smooth function fall from order to order (J. J. More, S. M. Wild, SIAM J. Sci.
/// Comput. 33 (2011) 1292). Medians, since kinks of distance functions have differences as noise
/// has.
template <typename T>
double WhiteNoiseOfDifferences(const GridPart<T>& part, std::vector<Node> nodes,
  const MaximumOverRanks& combine, const ProgressCallback& progress)
{
  constexpr std::size_t axes = 3, count = axes * differenceOrders.size();
  nodes.resize(std::min(nodes.size(), mostSamples));
  const std::vector<double> numbers = EvaluateAtNodes(
    nodes, count,
    [&](const Node& node, double* out) { return SquaredDifferences(part, node, out); }, combine,
    progress);
  std::array<double, differenceOrders.size()> variances{};
  for (std::size_t order = 0; order < differenceOrders.size(); ++order)
  {
    std::vector<double> squares;
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      const double* first = numbers.data() + i * count + order * axes;
      if (*first != missing)
      {
        squares.insert(squares.end(), first, first + axes);
      }
    }
    if (squares.size() < axes * fewestSamples)
    {
      return 0.0;
    }
    const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
    std::nth_element(squares.begin(), middle, squares.end());
    variances[order] = *middle / MedianOfChiSquared;
  }
  // Of tanh(x / w), the ratio is 0.4 at w = 1.6 nodes and 0.7 at half a node, which is a step.
  constexpr double alike = 0.7;
  return variances.back() > alike * variances.front() ? std::sqrt(variances.back()) : 0.0;
}

/// Derivatives of some nodes at one scale.
struct Responses
{
  std::vector<NodeDerivatives> Filter, Reference;
  std::vector<char> Valid;
};

template <typename T>
Responses ResponsesAt(const GridPart<T>& part, std::vector<Node> nodes, double scale, int accuracy,
  const MaximumOverRanks& combine, const ProgressCallback& progress)
{
  constexpr std::size_t each = 10, both = 2 * each;
  const auto store = [](const NodeDerivatives& from, double* to)
  {
    *to = from.Value;
    std::copy(from.Gradient.begin(), from.Gradient.end(), to + 1);
    std::copy(from.Hessian.begin(), from.Hessian.end(), to + 4);
  };
  const auto load = [](const double* from)
  {
    NodeDerivatives to;
    to.Value = *from;
    std::copy_n(from + 1, 3, to.Gradient.begin());
    std::copy_n(from + 4, 6, to.Hessian.begin());
    return to;
  };
  nodes.resize(std::min(nodes.size(), CountSamples(scale)));
  const std::vector<double> numbers = EvaluateAtNodes(
    nodes, both,
    [&](const Node& node, double* out)
    {
      NodeDerivatives filter, reference;
      if (!DifferentiateSmoothed(part, node, scale, accuracy, filter, reference))
      {
        return false;
      }
      store(filter, out);
      store(reference, out + each);
      return true;
    },
    combine, progress);
  Responses responses;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const double* from = numbers.data() + i * both;
    responses.Valid.push_back(*from != missing ? 1 : 0);
    responses.Filter.push_back(load(from));
    responses.Reference.push_back(load(from + each));
  }
  return responses;
}

/// Mean curvature of the level set, up to its sign, from derivatives with another one's normal:
/// linear in the Hessian matrix.
double MeanCurvature(const NodeDerivatives& at, const NodeDerivatives& normal, double gradient)
{
  const auto& n = normal.Gradient;
  const auto& h = at.Hessian;
  const double across = n[0] * n[0] * h[0] + n[1] * n[1] * h[1] + n[2] * n[2] * h[2] +
    2.0 * (n[0] * n[1] * h[3] + n[0] * n[2] * h[4] + n[1] * n[2] * h[5]);
  const double square = SquaredNorm(n);
  return -0.5 * (h[0] + h[1] + h[2] - (square > 0.0 ? across / square : 0.0)) / gradient;
}

/// Median square of the sums of two second derivatives, as a variance; 0 if their distribution is
/// far from normal, as where a density without noise fades away.
double MedianVariance(const Responses& responses)
{
  std::vector<double> squares;
  for (std::size_t i = 0; i < responses.Valid.size(); ++i)
  {
    const auto& h = responses.Filter[i].Hessian;
    if (responses.Valid[i])
    {
      squares.insert(
        squares.end(), { Square(h[1] + h[2]), Square(h[0] + h[2]), Square(h[0] + h[1]) });
    }
  }
  if (squares.size() < 3 * fewestSamples)
  {
    return 0.0;
  }
  const auto quantile = [&](double share)
  {
    const auto at = squares.begin() +
      static_cast<std::ptrdiff_t>(share * static_cast<double>(squares.size() - 1));
    std::nth_element(squares.begin(), at, squares.end());
    return *at;
  };
  // Of the chi-squared distribution with 1 degree of freedom, whose median is 0.17 of the other
  // quantile; noise whose deviation varies threefold has 0.06.
  constexpr double least = 0.05;
  const double middle = quantile(0.5);
  return middle > least * quantile(0.9) ? middle / MedianOfChiSquared : 0.0;
}

/// Independent kinds of noise that add up.
using Noise = std::vector<CorrelatedNoise>;

/// A linear combination of the Laplacians of filters.
struct Term
{
  double Factor;
  DerivativeFilter Filter;
};

double LaplacianVariance(
  const Noise& noise, const std::vector<Term>& terms, const std::array<double, 3>& spacing)
{
  double variance = 0.0;
  for (const CorrelatedNoise& kind : noise)
  {
    for (const Term& a : terms)
    {
      for (const Term& b : terms)
      {
        variance += a.Factor * b.Factor *
          CovarianceOfDerivatives(kind, a.Filter, b.Filter, spacing).Laplacian;
      }
    }
  }
  return std::max(0.0, variance);
}

double GradientVariance(
  const Noise& noise, const DerivativeFilter& filter, const std::array<double, 3>& spacing)
{
  double variance = 0.0;
  for (const CorrelatedNoise& kind : noise)
  {
    variance += CovarianceOfDerivatives(kind, filter, filter, spacing).Gradient;
  }
  return variance;
}

/// The nodes at which noise that differences show is small beside the gradient, for volumes without
/// a background, as those of distances; none if there is no such noise. Without the nodes near
/// kinks of distances, whose second derivatives are far beyond those of others.
template <typename T>
Samples FindSamplesWithoutBackground(const GridPart<T>& part, const MaximumOverRanks& combine)
{
  std::vector<Node> nodes = LatticeNodes(part.Whole);
  Shuffle(nodes);
  nodes.resize(std::min(nodes.size(), mostSamples));
  const double deviation = WhiteNoiseOfDifferences(part, nodes, combine, {});
  Samples samples;
  if (!(deviation > 0.0))
  {
    return samples;
  }
  constexpr double edge = 25.0; // square of 5 deviations
  const double least =
    edge * GradientVariance({ { deviation, 0.0 } }, { edgeScale, 2 }, part.Values.Spacing);
  const Responses responses = ResponsesAt(part, nodes, edgeScale, 2, combine, {});
  std::vector<double> bends;
  for (std::size_t i = 0; i < responses.Valid.size(); ++i)
  {
    const auto& h = responses.Filter[i].Hessian;
    bends.push_back(responses.Valid[i]
        ? h[0] * h[0] + h[1] * h[1] + h[2] * h[2] + 2.0 * (h[3] * h[3] + h[4] * h[4] + h[5] * h[5])
        : 0.0);
  }
  std::vector<double> sorted = bends;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  constexpr double kink = 9.0; // of the median square
  double fourth = 0.0, second = 0.0;
  for (std::size_t i = 0; i < bends.size(); ++i)
  {
    const double square = SquaredNorm(responses.Filter[i].Gradient);
    if (responses.Valid[i] && square > least && bends[i] <= kink * *middle)
    {
      samples.Edges.push_back(nodes[i]);
      fourth += square * square;
      second += square;
    }
  }
  samples.Gradient = second > 0.0 ? std::sqrt(fourth / second) : 0.0;
  return samples;
}

/// The estimate of one run: scales, and what was measured at them. Lengths are in the unit u.
struct Search
{
  std::array<double, 3> Spacing;
  int Accuracy = 2;
  std::vector<double> Scales;
  double EdgeGradient = 0.0;
  std::vector<Responses> Edges;
  Noise Kinds;

  std::vector<double> LeastSquaredGradient;
  std::vector<double> Variance, Bias, Since, DifferenceSquare, DifferenceVariance;

  DerivativeFilter Filter(std::size_t k) const { return { this->Scales[k], this->Accuracy }; }
  DerivativeFilter Reference(std::size_t k) const
  {
    return { this->Scales[k], ReferenceAccuracy(this->Accuracy) };
  }

  void FitBackground(const std::vector<double>& measured);
  void AdaptNoiseToEdges();
  void AddWhiteNoise(double deviation);
  double Curvature(std::size_t k, const NodeDerivatives& at, const NodeDerivatives& normal) const;
  double BiasSinceFinerScales(std::size_t k) const;
  void Measure(std::size_t k);
  void CompleteBias();
  void BoundBiasWithoutSmoothing(std::size_t k);
  template <typename F>
  double MeanOverEdges(std::size_t k, F&& f) const;
};

/// Mean of f(index) over the nodes that are valid at scale k and the one before.
template <typename F>
double Search::MeanOverEdges(std::size_t k, F&& f) const
{
  const Responses& one = this->Edges[k];
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < one.Valid.size(); ++i)
  {
    if (one.Valid[i] && (k == 0 || this->Edges[k - 1].Valid[i]))
    {
      sum += f(i);
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

/// The mean curvature of a level set at scale k with another one's normal. Gradients far below
/// those of the edges at that scale have a lower bound: the curvature there is unrelated to the
/// edges.
double Search::Curvature(
  std::size_t k, const NodeDerivatives& at, const NodeDerivatives& normal) const
{
  return MeanCurvature(
    at, normal, std::sqrt(std::max(this->LeastSquaredGradient[k], SquaredNorm(at.Gradient))));
}

/// Deviation and correlation whose variances are proportional to the measured ones. The variances
/// of Gaussian-correlated noise at all scales follow exactly from both (CovarianceOfDerivatives),
/// so coloured noise is measured, not assumed white.
void Search::FitBackground(const std::vector<double>& measured)
{
  this->Kinds.clear();
  if (measured.size() < 3)
  {
    return;
  }
  double least = std::numeric_limits<double>::max();
  CorrelatedNoise best;
  constexpr double longest = 7.402612;
  constexpr int lengths = 38; // 0, then 0.3 to 7.4 u, in eighths of an octave
  for (int n = 0; n <= lengths; ++n)
  {
    const double correlation = n == 0 ? 0.0 : longest * std::exp2((n - lengths) / 8.0);
    std::vector<double> logs;
    double mean = 0.0;
    for (std::size_t k = 0; k < measured.size(); ++k)
    {
      const double unitVariance =
        LaplacianVariance({ { 1.0, correlation } }, { { 1.0, this->Filter(k) } }, this->Spacing);
      logs.push_back(std::log(measured[k] / unitVariance));
      mean += logs.back() / static_cast<double>(measured.size());
    }
    double misfit = 0.0;
    for (const double value : logs)
    {
      misfit += Square(value - mean);
    }
    if (misfit < least)
    {
      least = misfit;
      best = { std::exp(0.5 * mean), correlation };
    }
  }
  // Values that are smooth over more than that are the tail of a density, not noise.
  if (best.Correlation < longest)
  {
    this->Kinds.push_back(best);
  }
}

/// Noise as estimated from the edges: how the Laplacians there change from scale to scale. Smooth
/// data add to the change, so it is an upper bound of the noise: what exceeds it in the background
/// is structure of the background. Additional white noise at the edges decreases from one change to
/// the next as only white noise does.
void Search::AdaptNoiseToEdges()
{
  const double perGradient = this->MeanOverEdges(edgeIndex,
    [&](std::size_t i) { return 1.0 / SquaredNorm(this->Edges[edgeIndex].Filter[i].Gradient); });
  std::array<double, edgeIndex> changes;
  for (std::size_t k = 0; k < edgeIndex; ++k)
  {
    changes[k] = 4.0 / perGradient *
      this->MeanOverEdges(edgeIndex,
        [&](std::size_t i)
        {
          const NodeDerivatives& normal = this->Edges[edgeIndex].Filter[i];
          const double gradient = std::sqrt(SquaredNorm(normal.Gradient));
          return Square(MeanCurvature(this->Edges[k + 1].Filter[i], normal, gradient) -
            MeanCurvature(this->Edges[k].Filter[i], normal, gradient));
        });
  }
  const auto variance = [&](const Noise& noise, std::size_t k)
  {
    return LaplacianVariance(
      noise, { { 1.0, this->Filter(k + 1) }, { -1.0, this->Filter(k) } }, this->Spacing);
  };
  if (!this->Kinds.empty())
  {
    double share = 1.0;
    for (std::size_t k = 0; k < edgeIndex; ++k)
    {
      share = std::min(share, changes[k] / variance(this->Kinds, k));
    }
    constexpr double certain = 0.8; // of variances with an uncertainty of a tenth
    if (share < certain)
    {
      this->Kinds[0].Deviation *= std::sqrt(share);
    }
  }
  const Noise white{ { 1.0, 0.0 } };
  const auto excess = [&](std::size_t k)
  {
    return (changes[k] - changes[k + 1] - variance(this->Kinds, k) + variance(this->Kinds, k + 1)) /
      (variance(white, k) - variance(white, k + 1));
  };
  const double square = excess(0);
  const double finest = LaplacianVariance(this->Kinds, { { 1.0, this->Filter(0) } }, this->Spacing);
  constexpr double notable =
    0.5; // of the background's variance, which has an uncertainty of a tenth
  const double next = excess(1);
  constexpr double alike = 1.3; // as in the next change: structure of the edges is not white
  if (square * LaplacianVariance(white, { { 1.0, this->Filter(0) } }, this->Spacing) >
      notable * finest &&
    next > 0.0 && next < alike * square)
  {
    this->Kinds.push_back({ std::sqrt(square), 0.0 });
  }
}

/// White noise that differences show beyond what is known, as that of rounding to few digits.
void Search::AddWhiteNoise(double deviation)
{
  const Term finest{ 1.0, this->Filter(0) };
  const double known = LaplacianVariance(this->Kinds, { finest }, this->Spacing);
  const double unit = LaplacianVariance({ { 1.0, 0.0 } }, { finest }, this->Spacing);
  constexpr double certain = 1.5; // of variances that are known to a tenth
  if (Square(deviation) * unit > certain * known)
  {
    this->Kinds.push_back({ std::sqrt(Square(deviation) - known / unit), 0.0 });
  }
}

/// The mean square bias of scale k that its change from finer scales shows, where it exceeds the
/// noise, less the error of the finer scale's differences. Once smoothing has removed features,
/// nothing changes: compared with the next scale, the bias would seem to be zero. For the
/// same reason, the bias is at least that of the finer scales.
double Search::BiasSinceFinerScales(std::size_t k) const
{
  const double least = LeastGradientShare * Square(this->EdgeGradient);
  double most = k > 0 ? this->Since[k - 1] : 0.0;
  for (std::size_t j = 0; j < k; ++j)
  {
    const double square = this->MeanOverEdges(k + 1,
      [&](std::size_t i)
      {
        const NodeDerivatives& normal = this->Edges[k].Filter[i];
        return Square(this->Curvature(k, this->Edges[k].Reference[i], normal) -
          this->Curvature(j, this->Edges[j].Reference[i], normal));
      });
    const double differences = this->MeanOverEdges(k + 1,
      [&](std::size_t i)
      {
        const NodeDerivatives& normal = this->Edges[k].Filter[i];
        return Square(this->Curvature(j, this->Edges[j].Filter[i], normal) -
          this->Curvature(j, this->Edges[j].Reference[i], normal));
      });
    const double perGradient = this->MeanOverEdges(k + 1,
      [&](std::size_t i)
      {
        return 1.0 /
          std::max(least,
            std::min(SquaredNorm(this->Edges[k].Filter[i].Gradient),
              SquaredNorm(this->Edges[j].Filter[i].Gradient)));
      });
    const double noise = perGradient / 4.0 *
      LaplacianVariance(
        this->Kinds, { { 1.0, this->Reference(k) }, { -1.0, this->Reference(j) } }, this->Spacing);
    constexpr double certain = 3.0; // times the part that noise causes
    if (square > certain * noise)
    {
      most =
        std::max(most, Square(std::max(0.0, std::sqrt(square - noise) - std::sqrt(differences))));
    }
  }
  return most;
}

/// Variance and bias of scale k, from the nodes that scale k + 1 has as well.
void Search::Measure(std::size_t k)
{
  const Responses &one = this->Edges[k], &next = this->Edges[k + 1];
  const double laplacian =
    LaplacianVariance(this->Kinds, { { 1.0, this->Filter(k) } }, this->Spacing);
  const double gradient = GradientVariance(this->Kinds, this->Filter(k), this->Spacing);
  // Noise adds to the square of the gradient; at scales that it dominates, a bound is enough.
  const double least = LeastGradientShare * Square(this->EdgeGradient);
  const double perGradient = this->MeanOverEdges(k + 1,
    [&](std::size_t i)
    { return 1.0 / std::max(SquaredNorm(one.Filter[i].Gradient) - 3.0 * gradient, least); });
  const double largestSquare = 0.01; // of a curvature, where noise dominates
  const double meanSquare = this->MeanOverEdges(k + 1,
    [&](std::size_t i)
    { return std::min(largestSquare, Square(this->Curvature(k, one.Filter[i], one.Filter[i]))); });
  this->Variance.push_back((laplacian / 4.0 + meanSquare * gradient) * perGradient);

  const double square = this->MeanOverEdges(k + 1,
    [&](std::size_t i)
    {
      const NodeDerivatives& normal = next.Filter[i];
      return Square(this->Curvature(k, one.Filter[i], normal) -
        2.0 * this->Curvature(k, one.Reference[i], normal) +
        this->Curvature(k + 1, next.Reference[i], normal));
    });
  const double laplacianOfBias = LaplacianVariance(this->Kinds,
    { { 1.0, this->Filter(k) }, { -2.0, this->Reference(k) }, { 1.0, this->Reference(k + 1) } },
    this->Spacing);
  const double noise = perGradient / 4.0 * laplacianOfBias;
  this->Since.push_back(this->BiasSinceFinerScales(k));
  const double since = this->Since.back();
  // If negative, the bias is hidden by noise; the magnitude is its upper bound.
  const double bias =
    square > significance * noise ? square - noise : -std::max(square, 2.0 * noise - square);
  this->Bias.push_back(since > 0.0 ? std::max(bias, since) : bias);

  // Differences of fourth order have no better reference: R is H there.
  const bool better = this->Accuracy == 2;
  const double change = better
    ? square
    : this->MeanOverEdges(k + 1,
        [&](std::size_t i)
        {
          return Square(this->Curvature(k + 1, next.Filter[i], next.Filter[i]) -
            this->Curvature(k, one.Filter[i], next.Filter[i]));
        });
  this->DifferenceVariance.push_back(better
      ? laplacianOfBias
      : LaplacianVariance(
          this->Kinds, { { 1.0, this->Filter(k + 1) }, { -1.0, this->Filter(k) } }, this->Spacing));
  const double known = perGradient / 4.0 * this->DifferenceVariance.back();
  this->DifferenceSquare.push_back(change > significance * known ? change - known : 0.0);
}

/// The bias that noise hides is a quarter of the next scale's, like a mean square that grows with
/// the fourth power of the scale. That of large scales, where differences are exact, grows at
/// least as fast; the change to the next scale is less informative if the Gaussian is as wide as
/// the object.
void Search::CompleteBias()
{
  for (std::size_t k = this->Bias.size(); k-- > 0;)
  {
    if (this->Bias[k] < 0.0)
    {
      const double most = -this->Bias[k];
      this->Bias[k] = k + 1 < this->Bias.size() ? std::min(most, this->Bias[k + 1] / 4.0) : most;
    }
  }
  constexpr std::size_t large = 8; // 5.7 u
  for (std::size_t k = large; k < this->Bias.size(); ++k)
  {
    this->Bias[k] = std::max(this->Bias[k], 4.0 * this->Bias[k - 1]);
  }
}

/// For no smoothing where scale k, with the least bias, has much less of it: there the
/// differences do not resolve the edges, so that their change with the order says too little of the
/// bias, and nothing of the place where it is large.
void Search::BoundBiasWithoutSmoothing(std::size_t k)
{
  constexpr double much = 4.0;
  if (much * this->Bias[k] > this->Bias[0])
  {
    return;
  }
  const double change = this->MeanOverEdges(k,
    [&](std::size_t i)
    {
      const NodeDerivatives& normal = this->Edges[k].Filter[i];
      return Square(this->Curvature(k, this->Edges[k].Filter[i], normal) -
        this->Curvature(0, this->Edges[0].Filter[i], normal));
    });
  this->Bias[0] = std::max(this->Bias[0], change);
  this->DifferenceSquare[0] = 0.0; // the same error everywhere
}

}

double CurvatureScale::Error(double mean, double difference, double gradient) const
{
  const double meanSquare = Square(mean * this->Unit);
  const double variance = this->LaplacianVariance / 4.0 + meanSquare * this->GradientVariance;
  const double noise = this->DifferenceVariance / 4.0;
  const double perGradient = gradient > 0.0 ? 1.0 / Square(gradient * this->Unit) : 0.0;
  const double change = difference * this->Unit;
  if (!(this->DifferenceSquare > 0.0))
  {
    const double bias = this->Samples > 0 ? this->BiasSquare : change * change;
    return std::sqrt(variance * perGradient + bias) / this->Unit;
  }
  // So that the bias does not vanish where D changes sign.
  constexpr double share = 0.02;
  const double known = this->DifferenceSquare / (this->DifferenceSquare + noise * perGradient);
  const double expected = known * known * change * change + known * noise * perGradient;
  const double bias =
    this->BiasSquare * (share + (1.0 - share) * expected / this->DifferenceSquare);
  return std::sqrt(variance * perGradient + bias) / this->Unit;
}

double LargestCandidateScale(
  const std::array<double, 3>& spacing, const std::array<std::int64_t, 3>& whole)
{
  return CandidateScales(spacing, whole).back();
}

template <typename T>
CurvatureScale ChooseCurvatureScale(const GridPart<T>& given, int accuracy,
  const MaximumOverRanks& combine, const ProgressCallback& progress)
{
  // In the unit u, since powers of tiny and huge spacings would overflow.
  const double unit = MeanSpacing(given.Values.Spacing);
  GridPart<T> part = given;
  for (double& length : part.Values.Spacing)
  {
    length /= unit;
  }
  Search search;
  search.Spacing = part.Values.Spacing;
  search.Accuracy = accuracy;
  search.Scales = CandidateScales(search.Spacing, part.Whole);
  CurvatureScale choice;
  choice.Unit = unit;
  choice.NextScale = 0.5 * unit;
  const std::size_t scales = search.Scales.size();
  if (scales <= edgeIndex)
  {
    return choice;
  }
  constexpr double found = 0.3; // share of the time
  Samples samples = FindSamples(part, combine, Between(progress, 0.0, found));
  if (samples.Edges.size() < fewestSamples)
  {
    samples = FindSamplesWithoutBackground(part, combine);
  }
  if (samples.Edges.size() < fewestSamples)
  {
    return choice;
  }
  search.EdgeGradient = samples.Gradient;
  constexpr double fittedScales = 2.1; // u; larger ones reach further from the background to edges
  std::vector<double> background;
  for (std::size_t k = 0; k < scales; ++k)
  {
    const auto step = [&](double from, double to)
    {
      const double each = (1.0 - found) / static_cast<double>(scales);
      return Between(progress, found + each * (static_cast<double>(k) + from),
        found + each * (static_cast<double>(k) + to));
    };
    search.Edges.push_back(
      ResponsesAt(part, samples.Edges, search.Scales[k], accuracy, combine, step(0.0, 0.5)));
    if (search.Scales[k] < fittedScales && background.size() == k)
    {
      const double variance = MedianVariance(
        ResponsesAt(part, samples.Background, search.Scales[k], accuracy, combine, step(0.5, 1.0)));
      if (variance >
        0.0) // otherwise edges reach into the background at this scale and all larger ones
      {
        background.push_back(variance);
      }
    }
  }
  search.FitBackground(background);
  search.AdaptNoiseToEdges();
  search.AddWhiteNoise(WhiteNoiseOfDifferences(part, samples.Edges, combine, {}));
  for (std::size_t k = 0; k < scales; ++k)
  {
    search.LeastSquaredGradient.push_back(LeastGradientShare *
      search.MeanOverEdges(
        k, [&](std::size_t i) { return SquaredNorm(search.Edges[k].Filter[i].Gradient); }));
  }
  for (std::size_t k = 0; k + 1 < scales; ++k)
  {
    search.Measure(k);
  }
  search.CompleteBias();
  std::size_t best = 0;
  for (std::size_t k = 1; k + 1 < scales; ++k)
  {
    if (search.Variance[k] + search.Bias[k] < search.Variance[best] + search.Bias[best])
    {
      best = k;
    }
  }
  // Where noise is no part of the error, smoothing would only trade one error of discretisation for
  // another, unless the differences do not resolve the edges at all.
  constexpr double notable = 0.1;    // of the squared error of the differences
  constexpr double unresolved = 0.1; // of it, by smoothing
  if (best > 0 && search.Variance[0] <= notable * search.Bias[0] &&
    search.Variance[best] + search.Bias[best] > unresolved * search.Bias[0])
  {
    search.BoundBiasWithoutSmoothing(best);
    best = 0;
  }
  // As in the array CurvatureScale: used as a fixed scale, it gives the same result.
  choice.Scale = static_cast<double>(static_cast<float>(search.Scales[best] * unit));
  choice.NextScale = search.Scales[best + 1] * unit;
  double square = 0.0;
  for (const CorrelatedNoise& kind : search.Kinds)
  {
    square += Square(kind.Deviation);
    choice.Correlation = std::max(choice.Correlation, kind.Correlation * unit);
  }
  choice.Noise = std::sqrt(square);
  choice.Samples = static_cast<std::int64_t>(samples.Edges.size());
  choice.LaplacianVariance =
    LaplacianVariance(search.Kinds, { { 1.0, search.Filter(best) } }, search.Spacing);
  choice.GradientVariance = GradientVariance(search.Kinds, search.Filter(best), search.Spacing);
  choice.DifferenceVariance = search.DifferenceVariance[best];
  choice.BiasSquare = search.Bias[best];
  choice.DifferenceSquare = search.DifferenceSquare[best];
  return choice;
}

#define ISTHMUS_INSTANTIATE(T)                                                                     \
  template CurvatureScale ChooseCurvatureScale(                                                    \
    const GridPart<T>&, int, const MaximumOverRanks&, const ProgressCallback&)
ISTHMUS_INSTANTIATE(float);
ISTHMUS_INSTANTIATE(double);
#undef ISTHMUS_INSTANTIATE

}
