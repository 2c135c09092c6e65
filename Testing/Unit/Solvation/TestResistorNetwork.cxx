// Networks of conductors whose values are known: a line, a grid of random conductances with a
// manufactured solution, and the same in another unit.

#include "Solvation/ResistorNetwork.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace isthmus;

namespace
{

using Dimensions = std::array<std::int64_t, 3>;
constexpr Dimensions Size{ 7, 6, 5 };

/// Random conductances and diagonals times `unit`; the values on the faces along the first axis are
/// given.
class RandomNetwork
{
public:
  explicit RandomNetwork(double unit)
    : Held(static_cast<std::size_t>(Size[0] * Size[1] * Size[2]), 0)
    , Network(Size, Held)
  {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> conductance(0.1, 10.0);
    for (std::int64_t node = 0; node < this->Nodes(); ++node)
    {
      const Dimensions at = At(node);
      this->Held[static_cast<std::size_t>(node)] = at[0] == 0 || at[0] == Size[0] - 1;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double g = unit * conductance(random);
        this->Network.Edge(axis, node) = at[axis] < Size[axis] - 1 ? g : 0.0;
      }
      this->Network.Diagonal(node) = 0.1 * unit * conductance(random);
      this->Exact.push_back(std::sin(0.7 * static_cast<double>(node)));
    }
    this->Network.Factor();
  }

  static Dimensions At(std::int64_t node)
  {
    return { node % Size[0], node / Size[0] % Size[1], node / (Size[0] * Size[1]) };
  }
  std::int64_t Nodes() const { return static_cast<std::int64_t>(this->Held.size()); }

  /// A u at each node, term by term, and the sum of the magnitudes g |u| at nodes without a given
  /// value.
  std::vector<double> Times(const std::vector<double>& u, double& magnitudes)
  {
    const Dimensions step{ 1, Size[0], Size[0] * Size[1] };
    std::vector<double> result;
    magnitudes = 0.0;
    for (std::int64_t node = 0; node < this->Nodes(); ++node)
    {
      const auto n = static_cast<std::size_t>(node);
      double conductances = this->Network.Diagonal(node);
      double sum = conductances * u[n];
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const auto add = [&](double g, std::int64_t other)
        {
          sum += g * (u[n] - u[static_cast<std::size_t>(other)]);
          conductances += g;
        };
        if (At(node)[axis] < Size[axis] - 1)
        {
          add(this->Network.Edge(axis, node), node + step[axis]);
        }
        if (At(node)[axis] > 0)
        {
          add(this->Network.Edge(axis, node - step[axis]), node - step[axis]);
        }
      }
      result.push_back(this->Held[n] ? 0.0 : sum);
      magnitudes += this->Held[n] ? 0.0 : conductances * std::abs(u[n]);
    }
    return result;
  }

  std::vector<unsigned char> Held;
  ResistorNetwork Network;
  std::vector<double> Exact;
};

std::vector<double> Start(const RandomNetwork& random)
{
  std::vector<double> u = random.Exact;
  for (std::size_t n = 0; n < u.size(); ++n)
  {
    u[n] = random.Held[n] ? u[n] : 0.0;
  }
  return u;
}

}

TEST(ResistorNetwork, ALineDividesTheVoltageByItsResistances)
{
  const std::vector<unsigned char> held{ 1, 0, 0, 1 };
  ResistorNetwork network({ 4, 1, 1 }, held);
  network.Edge(0, 0) = 1.0;
  network.Edge(0, 1) = 0.5;
  network.Edge(0, 2) = 0.25;
  network.Factor();
  std::vector<double> u{ 7.0, 0.0, 0.0, 0.0 };
  const ResistorNetwork::Answer answer = network.Solve(u, {}, { 1e-13, 0.0 });
  EXPECT_TRUE(answer.Converged);
  EXPECT_GE(answer.Iterations, 1);
  EXPECT_LE(answer.Iterations, 3);
  EXPECT_NEAR(u[1], 6.0, 1e-12);
  EXPECT_NEAR(u[2], 4.0, 1e-12);
  EXPECT_EQ(u[0], 7.0);
  EXPECT_EQ(u[3], 0.0);
}

TEST(ResistorNetwork, RecoversAManufacturedSolution)
{
  RandomNetwork random(1.0);
  double magnitudes = 0.0;
  const std::vector<double> source = random.Times(random.Exact, magnitudes);
  EXPECT_NEAR(random.Network.SumOfMagnitudes(random.Exact), magnitudes, 1e-12 * magnitudes);
  std::vector<double> u = Start(random);
  double sum = 0.0;
  double ignored = 0.0;
  const std::vector<double> product = random.Times(u, ignored);
  for (std::size_t n = 0; n < u.size(); ++n)
  {
    sum += std::abs(source[n] - product[n]);
  }
  EXPECT_NEAR(random.Network.Residual(u, source), sum, 1e-12 * sum);
  const ResistorNetwork::Answer answer = random.Network.Solve(u, source, { 1e-11 * sum, 0.0 });
  EXPECT_TRUE(answer.Converged);
  EXPECT_LE(answer.Residual, 1e-11 * sum);
  EXPECT_GT(answer.Iterations, 3);
  EXPECT_LT(answer.Iterations, 60);
  for (std::size_t n = 0; n < u.size(); ++n)
  {
    EXPECT_NEAR(u[n], random.Exact[n], 1e-9);
  }
}

TEST(ResistorNetwork, DoesNotDependOnTheUnitOfConductance)
{
  const auto solved = [](double unit)
  {
    RandomNetwork random(unit);
    double ignored = 0.0;
    std::vector<double> u = Start(random);
    const auto answer =
      random.Network.Solve(u, random.Times(random.Exact, ignored), { 0.0, 1e-6, 100 });
    EXPECT_TRUE(answer.Converged);
    u.push_back(answer.Iterations);
    u.push_back(answer.Residual / unit);
    u.push_back(random.Network.SumOfMagnitudes(random.Exact) / unit);
    return u;
  };
  EXPECT_EQ(solved(0x1p-60), solved(1.0));
}

TEST(ResistorNetwork, AtMostTheIterationsThatAreAllowed)
{
  RandomNetwork random(1.0);
  double ignored = 0.0;
  std::vector<double> u = Start(random);
  const auto answer =
    random.Network.Solve(u, random.Times(random.Exact, ignored), { 0.0, 1e-12, 3 });
  EXPECT_FALSE(answer.Converged);
  EXPECT_EQ(answer.Iterations, 3);
}

TEST(ResistorNetwork, WithoutVoltageThereIsNothingToIterate)
{
  const std::vector<unsigned char> held{ 1, 0, 0, 1 };
  ResistorNetwork network({ 4, 1, 1 }, held);
  for (const std::int64_t edge : { 0, 1, 2 })
  {
    network.Edge(0, edge) = 1.0;
  }
  network.Factor();
  std::vector<double> u(4, 0.0);
  const ResistorNetwork::Answer answer = network.Solve(u, {}, { 0.0, 0.0 });
  EXPECT_TRUE(answer.Converged);
  EXPECT_EQ(answer.Iterations, 0);
  EXPECT_EQ(u, std::vector<double>(4, 0.0));
}
