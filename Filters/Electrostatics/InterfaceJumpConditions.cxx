#include "Electrostatics/InterfaceJumpConditions.h"

#include <Eigen/Dense>

#include <cmath>

namespace isthmus
{
namespace
{

constexpr int Unknowns = 9;
constexpr int LinearUnknowns = 4; // phi0, a, b1, b2
constexpr std::size_t FewestForQuadratic = 14;
constexpr std::size_t FewestForLinear = 5;
/// Fits that amplify the data more than this are rejected.
constexpr double LargestGain = 1e3;

using Basis = std::array<double, Unknowns>;

/// The point's coordinates along normal and two tangents, and the curvature in them, by `Length`.
struct LocalFrame
{
  Point3 N, T1, T2;
  double W11, W22, W12;
  double Inverse;

  LocalFrame(const SurfaceFrame& frame, double length)
    : N(frame.Normal)
    , Inverse(1.0 / length)
  {
    std::size_t small = 0;
    for (std::size_t a = 1; a < 3; ++a)
    {
      small = std::abs(this->N[a]) < std::abs(this->N[small]) ? a : small;
    }
    Point3 e{ 0.0, 0.0, 0.0 };
    e[small] = 1.0;
    this->T1 = Cross(this->N, e);
    const double norm = std::sqrt(Dot(this->T1, this->T1));
    for (double& c : this->T1)
    {
      c /= norm;
    }
    this->T2 = Cross(this->N, this->T1);
    this->W11 = length * Bend(frame, this->T1, this->T1);
    this->W22 = length * Bend(frame, this->T2, this->T2);
    this->W12 = length * Bend(frame, this->T1, this->T2);
  }

  Point3 Local(const Point3& y) const
  {
    return { this->Inverse * Dot(this->N, y), this->Inverse * Dot(this->T1, y),
      this->Inverse * Dot(this->T2, y) };
  }

  static double Bend(const SurfaceFrame& f, const Point3& a, const Point3& b)
  {
    const auto& w = f.Curvature;
    return a[0] * b[0] * w[0] + a[1] * b[1] * w[1] + a[2] * b[2] * w[2] +
      (a[0] * b[1] + a[1] * b[0]) * w[3] + (a[0] * b[2] + a[2] * b[0]) * w[4] +
      (a[1] * b[2] + a[2] * b[1]) * w[5];
  }
};

/// The unknowns' functions in p-, harmonic: H_nn = -H_11 - H_22.
Basis InsideBasis(const Point3& y)
{
  const double n = y[0], t = y[1], s = y[2];
  return { 1.0, n, t, s, n * t, n * s, 0.5 * (t * t - n * n), 0.5 * (s * s - n * n), t * s };
}

/// The same unknowns in p+, by the jump conditions.
Basis OutsideBasis(const Point3& y, const LocalFrame& f, double rho, double k)
{
  const double n = y[0], t = y[1], s = y[2];
  const double tt = 0.5 * (t * t - n * n);
  const double ss = 0.5 * (s * s - n * n);
  return { 1.0 + 0.5 * k * n * n, rho * n + (rho - 1.0) * (f.W11 * tt + f.W22 * ss + f.W12 * t * s),
    t - (1.0 - rho) * n * (f.W11 * t + f.W12 * s), s - (1.0 - rho) * n * (f.W12 * t + f.W22 * s),
    rho * n * t, rho * n * s, tt, ss, t * s };
}

Basis TargetBasis(const FitTarget& target, const LocalFrame& f, double rho, double k)
{
  Basis basis{};
  switch (target.What)
  {
    case FitTarget::InsideValue:
      return InsideBasis(f.Local(target.Offset));
    case FitTarget::OutsideValue:
      return OutsideBasis(f.Local(target.Offset), f, rho, k);
    case FitTarget::SurfaceValue:
      basis[0] = 1.0;
      return basis;
    case FitTarget::NormalSlope:
      basis[1] = f.Inverse;
      return basis;
    default:
      const auto a = static_cast<std::size_t>(target.What - FitTarget::TangentX);
      basis[2] = f.Inverse * f.T1[a];
      basis[3] = f.Inverse * f.T2[a];
      return basis;
  }
}

/// The nodes that are usable, as rows.
struct Rows
{
  std::array<Basis, MaxFitNodes> Row;
  std::array<double, MaxFitNodes> Weight;
  std::array<std::size_t, MaxFitNodes> Node;
  std::size_t Count = 0;
};

Rows UsableRows(const FitMedium& medium, const LocalFrame& f, const FitNodes& nodes)
{
  const double rho = medium.SoluteDielectric / medium.SolventDielectric;
  const double k = medium.KappaSquared * medium.Length * medium.Length;
  Rows rows;
  for (std::size_t i = 0; i < nodes.Count; ++i)
  {
    const FitNode& node = nodes.Node[i];
    const Point3 y = f.Local(node.Offset);
    // A node on the wrong side of the osculating paraboloid belongs to another sheet.
    const double side =
      y[0] + 0.5 * (f.W11 * y[1] * y[1] + f.W22 * y[2] * y[2] + 2.0 * f.W12 * y[1] * y[2]);
    if ((node.Inside ? side : -side) > 0.25)
    {
      continue;
    }
    rows.Row[rows.Count] = node.Inside ? InsideBasis(y) : OutsideBasis(y, f, rho, k);
    rows.Weight[rows.Count] = node.Weight * (node.Inside ? medium.InsideWeight : 1.0);
    rows.Node[rows.Count++] = i;
  }
  return rows;
}

/// Solves for the first `N` unknowns; false if that is impossible or amplifies errors too much.
template <int N>
bool Solve(const Rows& rows, const std::vector<Basis>& targets,
  std::vector<FitFunctional>& functionals, double largestGain)
{
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  Matrix normal = Matrix::Zero();
  for (std::size_t i = 0; i < rows.Count; ++i)
  {
    const Eigen::Map<const Vector> row(rows.Row[i].data());
    normal.template selfadjointView<Eigen::Lower>().rankUpdate(row, rows.Weight[i]);
  }
  for (int d = 0; d < N; ++d)
  {
    // Keeps the matrix positive definite where the nodes leave an unknown undetermined.
    normal(d, d) *= 1.0 + 1e-10;
  }
  const Eigen::LLT<Matrix> factor(normal);
  if (factor.info() != Eigen::Success)
  {
    return false;
  }
  for (std::size_t t = 0; t < targets.size(); ++t)
  {
    const Vector z = factor.solve(Eigen::Map<const Vector>(targets[t].data()));
    functionals[t].fill(0.0);
    double gain = 0.0;
    for (std::size_t i = 0; i < rows.Count; ++i)
    {
      const double s = rows.Weight[i] * z.dot(Eigen::Map<const Vector>(rows.Row[i].data()));
      functionals[t][rows.Node[i]] = s;
      gain += std::abs(s);
    }
    if (!(gain < largestGain))
    {
      return false;
    }
  }
  return true;
}

}

FitQuality FitInterface(const FitMedium& medium, const SurfaceFrame& frame, const FitNodes& nodes,
  const std::vector<FitTarget>& targets, std::vector<FitFunctional>& functionals)
{
  const LocalFrame local(frame, medium.Length);
  const double rho = medium.SoluteDielectric / medium.SolventDielectric;
  const double k = medium.KappaSquared * medium.Length * medium.Length;
  const Rows rows = UsableRows(medium, local, nodes);
  std::vector<Basis> wanted;
  double scale = 1.0;
  for (const FitTarget& target : targets)
  {
    wanted.push_back(TargetBasis(target, local, rho, k));
    // Slopes are values divided by the spacing, and large if that is small.
    scale = target.What > FitTarget::SurfaceValue ? std::max(1.0, local.Inverse) : scale;
  }
  functionals.resize(targets.size());
  if (rows.Count >= FewestForQuadratic &&
    Solve<Unknowns>(rows, wanted, functionals, LargestGain * scale))
  {
    return FitQuality::Quadratic;
  }
  if (rows.Count >= FewestForLinear &&
    Solve<LinearUnknowns>(rows, wanted, functionals, LargestGain * scale))
  {
    return FitQuality::Linear;
  }
  return FitQuality::None;
}

}
