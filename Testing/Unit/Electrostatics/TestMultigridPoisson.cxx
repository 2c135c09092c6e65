// A single cycle: how much of a residual one cycle leaves, on any number of nodes, stretched
// spacings and jumps of the permittivity; the sums over charges by tree against direct ones; the
// harmonic fit on harmonic functions.

#include "Electrostatics/ChargeTree.h"
#include "Electrostatics/ChargesOnGrid.h"
#include "Electrostatics/HarmonicFit.h"
#include "Electrostatics/MultigridPoisson.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace isthmus;

namespace
{

using Dimensions = std::array<std::int64_t, 3>;

/// A box of 80 around a ball of 2, with random numbers as right-hand side.
struct Problem
{
  Dimensions n;
  Point3 Weights;
  EdgePermittivity Permittivity;
  std::vector<double> Right;
  std::shared_ptr<std::vector<float>> Diagonal;

  Problem(const Dimensions& dimensions, const Point3& weights, double solute)
    : n(dimensions)
    , Weights(weights)
  {
    this->Permittivity.Table[0] = 80.0F;
    this->Permittivity.Table[1] = static_cast<float>(solute);
    const std::int64_t size = this->n[0] * this->n[1] * this->n[2];
    for (auto& code : this->Permittivity.Code)
    {
      code.resize(static_cast<std::size_t>(size));
    }
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    for (std::int64_t p = 0; p < size; ++p)
    {
      const double x = 2.0 * static_cast<double>(p % n[0]) / static_cast<double>(n[0]) - 1.0;
      const double y = 2.0 * static_cast<double>(p / n[0] % n[1]) / static_cast<double>(n[1]) - 1.0;
      const double z =
        2.0 * static_cast<double>(p / (n[0] * n[1])) / static_cast<double>(n[2]) - 1.0;
      for (auto& code : this->Permittivity.Code)
      {
        code[static_cast<std::size_t>(p)] = x * x + y * y + z * z < 0.3 ? 1 : 0;
      }
      this->Right.push_back(this->OnBorder(p) ? 0.0 : value(random));
    }
  }
  bool OnBorder(std::int64_t p) const
  {
    const std::int64_t i = p % n[0], j = p / n[0] % n[1], k = p / (n[0] * n[1]);
    return i == 0 || j == 0 || k == 0 || i == n[0] - 1 || j == n[1] - 1 || k == n[2] - 1;
  }
  double Edge(std::size_t a, std::int64_t p) const
  {
    const auto code = this->Permittivity.Code[a][static_cast<std::size_t>(p)];
    return this->Weights[a] * static_cast<double>(this->Permittivity.Table[code]);
  }
  /// r -= A z.
  void Subtract(const std::vector<float>& z, std::vector<double>& r) const
  {
    const std::int64_t steps[3] = { 1, n[0], n[0] * n[1] };
    for (std::int64_t p = 0; p < n[0] * n[1] * n[2]; ++p)
    {
      if (this->OnBorder(p))
      {
        continue;
      }
      const auto at = [&](std::int64_t q)
      { return static_cast<double>(z[static_cast<std::size_t>(q)]); };
      double sum = this->Diagonal
        ? static_cast<double>((*this->Diagonal)[static_cast<std::size_t>(p)]) * at(p)
        : 0.0;
      for (std::size_t a = 0; a < 3; ++a)
      {
        sum += this->Edge(a, p) * (at(p) - at(p + steps[a])) +
          this->Edge(a, p - steps[a]) * (at(p) - at(p - steps[a]));
      }
      r[static_cast<std::size_t>(p)] -= sum;
    }
  }
};

double Norm(const std::vector<double>& r)
{
  double sum = 0.0;
  for (const double x : r)
  {
    sum += x * x;
  }
  return std::sqrt(sum);
}

/// The share of the residual after a cycle, on average over the last four of ten.
double Reduction(const Problem& problem)
{
  MultigridPoisson multigrid(problem.n, problem.Weights, problem.Permittivity);
  multigrid.SetDiagonal(problem.Diagonal);
  std::vector<double> r = problem.Right;
  std::vector<float> z(r.size());
  double sixth = 0.0;
  for (int cycle = 0; cycle < 10; ++cycle)
  {
    multigrid.Cycle(r, z);
    problem.Subtract(z, r);
    sixth = cycle == 5 ? Norm(r) : sixth;
  }
  return std::pow(Norm(r) / sixth, 0.25);
}

TEST(MultigridPoisson, ACycleLeavesASmallPartOnAnyNumberOfNodes)
{
  EXPECT_LT(Reduction(Problem({ 33, 33, 33 }, { 1, 1, 1 }, 80.0)), 0.25);
  EXPECT_LT(Reduction(Problem({ 33, 33, 33 }, { 1, 1, 1 }, 2.0)), 0.5);
  // Coarse grids that extend beyond the border reduce the residual less.
  for (const Dimensions& n :
    { Dimensions{ 32, 47, 38 }, Dimensions{ 64, 12, 25 }, Dimensions{ 5, 4, 6 } })
  {
    EXPECT_LT(Reduction(Problem(n, { 1, 1, 1 }, 80.0)), 0.65) << n[0] << " " << n[1] << " " << n[2];
    EXPECT_LT(Reduction(Problem(n, { 1, 1, 1 }, 2.0)), 0.7) << n[0] << " " << n[1] << " " << n[2];
  }
}

TEST(MultigridPoisson, StretchedSpacingsAreSemicoarsened)
{
  EXPECT_LT(Reduction(Problem({ 33, 33, 33 }, { 1, 1, 0.1 }, 2.0)), 0.6);
  EXPECT_LT(Reduction(Problem({ 33, 33, 33 }, { 0.01, 1, 1 }, 2.0)), 0.6);
}

TEST(MultigridPoisson, ADiagonalOnlyHelps)
{
  Problem problem({ 33, 32, 31 }, { 1, 1, 1 }, 2.0);
  problem.Diagonal = std::make_shared<std::vector<float>>(problem.Right.size(), 5.0F);
  EXPECT_LT(Reduction(problem), 0.5);
}

TEST(MultigridPoisson, IdenticalOnAnyNumberOfThreads)
{
  const Problem problem({ 33, 47, 38 }, { 1, 1, 1 }, 2.0);
  std::vector<float> answers[2];
  for (int threads = 1; threads <= 2; ++threads)
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
      [&]()
      {
        MultigridPoisson multigrid(problem.n, problem.Weights, problem.Permittivity);
        answers[threads - 1].resize(problem.Right.size());
        multigrid.Cycle(problem.Right, answers[threads - 1]);
      });
  }
  EXPECT_EQ(answers[0], answers[1]);
}

ChargeList RandomCharges(std::size_t count)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0.0, 40.0), charge(-1.0, 1.0);
  ChargeList charges;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point3 x{ place(random), place(random), place(random) };
    charges.Add(x, charge(random));
  }
  return charges;
}

TEST(ChargeSums, DerivativesMatchTheSum)
{
  const ChargeList charges = RandomCharges(21);
  const Point3 x{ 50.0, 20.0, -10.0 };
  const SecondOrderTaylor taylor = CoulombSum(charges, x);
  EXPECT_NEAR(taylor.Value, CoulombValue(charges, x, 0.0), 1e-13);
  EXPECT_NEAR(taylor.Value, ScreenedSum(charges, 0.0, x), 1e-13);
  for (const Point3& y :
    { Point3{ 0.1, 0, 0 }, Point3{ 0.05, -0.07, 0.02 }, Point3{ 0, 0.05, 0.08 } })
  {
    const double there = CoulombValue(charges, { x[0] + y[0], x[1] + y[1], x[2] + y[2] }, 0.0);
    EXPECT_NEAR(taylor.At(y), there, 1e-6);
  }
  EXPECT_LT(ScreenedSum(charges, 0.1, x) / taylor.Value, 0.5);
}

TEST(ChargeSums, OfOneChargeAreAnalytic)
{
  ChargeList charges;
  charges.Add({ 1.0, 2.0, 3.0 }, -2.0);
  for (double r = 0.125; r < 300.0; r *= 1.37)
  {
    const Point3 x{ 1.0 + r, 2.0, 3.0 };
    const double coulomb = -2.0 / (x[0] - 1.0);
    EXPECT_DOUBLE_EQ(CoulombValue(charges, x, 0.1), coulomb);
    const double expected = coulomb * std::exp(-(x[0] - 1.0));
    EXPECT_NEAR(ScreenedSum(charges, 1.0, x) / expected, 1.0, 5e-15) << r;
    // Eight and more are summed by vector instructions.
    ChargeList nine;
    for (int i = 0; i < 9; ++i)
    {
      nine.Append(charges, 0, 1);
    }
    EXPECT_NEAR(ScreenedSum(nine, 1.0, x) / (9.0 * expected), 1.0, 5e-15) << r;
    const SecondOrderTaylor taylor = CoulombSum(charges, x);
    EXPECT_NEAR(taylor.Gradient[0] / (-coulomb / r), 1.0, 1e-12);
    EXPECT_NEAR(taylor.Hessian[0] / (2.0 * coulomb / (r * r)), 1.0, 1e-12);
    EXPECT_NEAR(taylor.Hessian[1] / (-coulomb / (r * r)), 1.0, 1e-12);
  }
  EXPECT_DOUBLE_EQ(CoulombValue(charges, { 1.0, 2.0, 3.05 }, 0.1), -20.0);
}

TEST(ChargesOnGrid, NodesNearerThanAQuarterOfASpacingAreTakenAtThatDistance)
{
  SolverBox box;
  box.Dimensions = { 11, 9, 10 };
  box.Spacing = { 0.5, 0.8, 1.0 };
  box.Corner = { -2.0, -3.0, -4.0 };
  ChargeList charges;
  charges.Add(box.Position(3, 3, 3), 1.0); // on a node
  Point3 off = box.Position(8, 6, 7);
  off[0] += 0.15; // farther than 0.125 from it
  charges.Add(off, 3.0);
  std::vector<double> g(static_cast<std::size_t>(box.Size()), 0.0);
  ChargesAtNodes(charges, box,
    [&](std::int64_t node, double value) { g[static_cast<std::size_t>(node)] = value; });
  for (std::int64_t node = 0; node < box.Size(); ++node)
  {
    double expected = 0.0;
    for (std::size_t i = 0; i < charges.Size(); ++i)
    {
      const Point3 d = box.Position(node) - Point3{ charges.X[i], charges.Y[i], charges.Z[i] };
      expected += charges.Charge[i] / std::max(0.125, std::sqrt(Dot(d, d)));
    }
    EXPECT_NEAR(g[static_cast<std::size_t>(node)], expected, 1e-12 * expected) << node;
  }
}

TEST(ChargeTree, SumsAgreeWithDirectOnes)
{
  const ChargeList charges = RandomCharges(FewestForTree + 1000);
  SolverBox box;
  box.Dimensions = { 40, 40, 40 };
  box.Spacing = { 2.0, 2.0, 2.0 };
  box.Corner = { -20.0, -20.0, -20.0 };
  std::vector<Point3> points;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-15.0, 55.0);
  for (int i = 0; i < 300; ++i)
  {
    points.push_back({ place(random), place(random), place(random) });
  }
  const auto sums = ChargesAtPoints(charges, box, points);
  double worst = 0.0, worstSlope = 0.0, scale = 0.0, slopes = 0.0;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const SecondOrderTaylor exact = CoulombSum(charges, points[p]);
    worst = std::max(worst, std::abs(sums[p].Value - exact.Value));
    scale += std::abs(exact.Value) / static_cast<double>(points.size());
    for (std::size_t a = 0; a < 3; ++a)
    {
      worstSlope = std::max(worstSlope, std::abs(sums[p].Gradient[a] - exact.Gradient[a]));
      slopes += std::abs(exact.Gradient[a]) / static_cast<double>(3 * points.size());
    }
  }
  EXPECT_LT(worst, 1e-3 * scale);
  EXPECT_LT(worstSlope, 2e-3 * slopes);
}

TEST(HarmonicFit, HarmonicPolynomialsAreExactAlsoFromOneSide)
{
  SolverBox box;
  box.Dimensions = { 20, 20, 20 };
  box.Spacing = { 0.5, 0.5, 0.5 };
  const auto f = [](const Point3& x)
  {
    return 1.0 + 2.0 * x[0] - x[1] + x[0] * x[2] +
      x[2] * (2.0 * x[2] * x[2] - 3.0 * x[0] * x[0] - 3.0 * x[1] * x[1]);
  };
  std::vector<double> u;
  std::vector<unsigned char> inside;
  for (std::int64_t node = 0; node < box.Size(); ++node)
  {
    const Point3 x = box.Position(node);
    inside.push_back(x[0] + 0.3 * x[1] < 5.6 ? 1 : 0);
    u.push_back(inside.back() ? f(x) : 1e6);
  }
  for (const Point3& x : { Point3{ 3.1, 4.2, 5.3 }, Point3{ 4.2, 4.3, 4.4 } })
  {
    const ValueAndGradient fit = HarmonicAt(box, inside, u, x).value();
    EXPECT_NEAR(fit.Value, f(x), 1e-6 * std::abs(f(x)));
    EXPECT_NEAR(fit.Gradient[0], 2.0 + x[2] - 6.0 * x[2] * x[0], 1e-4);
  }
  EXPECT_FALSE(HarmonicAt(box, inside, u, { 9.4, 9.4, 5.0 }));
}

TEST(ChargeTree, ScreenedSumsAreTheSameByTreeAndByVectorInstructions)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0.0, 30.0), charge(-1.0, 1.0);
  ChargeList charges;
  for (int i = 0; i < 5003; ++i)
  {
    charges.Add({ place(random), place(random), place(random) }, charge(random));
  }
  const ChargeTree tree(charges);
  for (const double kappa : { 0.0, 0.13, 3.0, 60.0 })
  {
    for (const Point3& x : { Point3{ 45.0, 12.0, 3.0 }, Point3{ 15.1, 14.9, 15.0 } })
    {
      double sum = 0.0, absolute = 0.0;
      for (std::size_t i = 0; i < charges.Size(); ++i)
      {
        const double r = std::hypot(x[0] - charges.X[i], x[1] - charges.Y[i], x[2] - charges.Z[i]);
        sum += charges.Charge[i] * std::exp(-kappa * r) / r;
        absolute += std::abs(charges.Charge[i]) * std::exp(-kappa * r) / r;
      }
      EXPECT_NEAR(ScreenedSum(charges, kappa, x), sum, 1e-12 * absolute + 1e-290);
      // Where boxes are many Debye lengths large, all values are practically zero.
      EXPECT_NEAR(tree.ScreenedSum(x, kappa), sum, 1e-4 * absolute + 1e-12) << kappa;
    }
  }
}

}
