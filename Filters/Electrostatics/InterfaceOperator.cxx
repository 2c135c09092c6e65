#include "Electrostatics/InterfaceOperator.h"

#include "Core/ParallelFor.h"

#include <algorithm>

namespace isthmus
{

InterfaceOperator::InterfaceOperator(const SolverBox& box, const std::vector<unsigned char>& inside,
  double soluteDielectric, double solventDielectric)
  : Box(box)
  , Inside(inside)
  , Solute(soluteDielectric)
  , Solvent(solventDielectric)
  , Weights(AxisWeights(box))
{
}

// All rows as if there were no surface; ApplyIrregularRows overwrites those next to it. With `sign`
// -1 and the right-hand side, the same pass computes a residual.
template <typename T>
void InterfaceOperator::ApplyRegularRows(
  const std::vector<T>& z, std::vector<double>& out, double sign) const
{
  const auto& n = this->Box.Dimensions;
  const std::int64_t nx = n[0];
  const std::int64_t nxy = n[0] * n[1];
  const double wx = this->Weights[0], wy = this->Weights[1], wz = this->Weights[2];
  const double center = 2.0 * (wx + wy + wz);
  const float* d = this->Diagonal ? this->Diagonal->data() : nullptr;
  ParallelFor(0, n[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      const T* u = z.data();
      double* to = out.data();
      for (std::int64_t k = first; k < last; ++k)
      {
        for (std::int64_t j = 0; j < n[1]; ++j)
        {
          const std::int64_t start = nx * (j + n[1] * k);
          // Dirichlet values on the border: rows of 0.
          if (k == 0 || j == 0 || k == n[2] - 1 || j == n[1] - 1)
          {
            std::fill(to + start, to + start + nx, 0.0);
            continue;
          }
          to[start] = to[start + nx - 1] = 0.0;
          for (std::int64_t p = start + 1; p < start + nx - 1; ++p)
          {
            const double eps =
              sign * (this->Inside[static_cast<std::size_t>(p)] ? this->Solute : this->Solvent);
            const double here = static_cast<double>(u[p]);
            to[p] = eps *
              (center * here -
                wx * (static_cast<double>(u[p - 1]) + static_cast<double>(u[p + 1])) -
                wy * (static_cast<double>(u[p - nx]) + static_cast<double>(u[p + nx])) -
                wz * (static_cast<double>(u[p - nxy]) + static_cast<double>(u[p + nxy])));
          }
          if (d)
          {
            for (std::int64_t p = start + 1; p < start + nx - 1; ++p)
            {
              to[p] += sign * static_cast<double>(d[p]) * static_cast<double>(u[p]);
            }
          }
        }
      }
    });
}

template <typename T>
void InterfaceOperator::ApplyIrregularRows(
  const std::vector<T>& z, std::vector<double>& out, double sign, bool withRight) const
{
  const float* d = this->Diagonal ? this->Diagonal->data() : nullptr;
  const InterfaceMatrixRows& rows = this->Rows;
  ParallelFor(0, static_cast<std::int64_t>(rows.Node.size()), 4096,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto r = static_cast<std::size_t>(first); r < static_cast<std::size_t>(last); ++r)
      {
        const T* u = z.data() + rows.Node[r];
        double sum =
          d ? rows.Scale[r] * static_cast<double>(d[rows.Node[r]]) * static_cast<double>(*u) : 0.0;
        for (auto e = static_cast<std::size_t>(rows.Start[r]);
             e < static_cast<std::size_t>(rows.Start[r + 1]); ++e)
        {
          sum += rows.Value[e] * static_cast<double>(u[rows.Column[e]]);
        }
        out[static_cast<std::size_t>(rows.Node[r])] =
          sign * sum + (withRight ? rows.RightSide[r] : 0.0);
      }
    });
}

// The term that rows of a closed cavity share (ClosedCavities.h): one sum for all of them.
template <typename T>
void InterfaceOperator::AddCavities(
  const std::vector<T>& z, std::vector<double>& out, double sign, bool withRight) const
{
  for (const CavityFlux& cavity : this->Rows.Cavities)
  {
    double sum = withRight ? -cavity.RightSide : 0.0;
    for (std::size_t i = 0; i < cavity.Column.size(); ++i)
    {
      sum += cavity.Value[i] * static_cast<double>(z[static_cast<std::size_t>(cavity.Column[i])]);
    }
    for (std::size_t i = 0; i < cavity.Row.size(); ++i)
    {
      const auto row = static_cast<std::size_t>(cavity.Row[i]);
      out[static_cast<std::size_t>(this->Rows.Node[row])] +=
        sign * this->Rows.Scale[row] * cavity.Share[i] * sum;
    }
  }
}

void InterfaceOperator::Apply(const std::vector<float>& z, std::vector<double>& out) const
{
  this->ApplyRegularRows(z, out, 1.0);
  this->ApplyIrregularRows(z, out, 1.0, false);
  this->AddCavities(z, out, 1.0, false);
}

void InterfaceOperator::Residual(const std::vector<double>& u, std::vector<double>& out) const
{
  this->ApplyRegularRows(u, out, -1.0);
  this->ApplyIrregularRows(u, out, -1.0, true);
  this->AddCavities(u, out, -1.0, true);
}

float InterfaceOperator::SmoothRow(std::size_t row, double common, double commonDiagonal,
  const std::vector<double>& r, std::vector<float>& z) const
{
  const InterfaceMatrixRows& rows = this->Rows;
  float* u = z.data() + rows.Node[row];
  const double extra = this->Diagonal ? rows.Scale[row] *
      static_cast<double>((*this->Diagonal)[static_cast<std::size_t>(rows.Node[row])])
                                      : 0.0;
  double sum = common + extra * static_cast<double>(*u);
  for (auto e = static_cast<std::size_t>(rows.Start[row]);
       e < static_cast<std::size_t>(rows.Start[row + 1]); ++e)
  {
    sum += rows.Value[e] * static_cast<double>(u[rows.Column[e]]);
  }
  const auto change = static_cast<float>((r[static_cast<std::size_t>(rows.Node[row])] - sum) /
    (rows.Diagonal[row] + extra + commonDiagonal));
  *u += change;
  return change;
}

/// Gauss-Seidel over the fitted rows, in a fixed order on one thread.
void InterfaceOperator::SmoothIrregular(const std::vector<double>& r, std::vector<float>& z) const
{
  for (std::size_t row = 0; row < this->Rows.Node.size(); ++row)
  {
    this->SmoothRow(row, 0.0, 0.0, r, z);
  }
  for (const CavityFlux& cavity : this->Rows.Cavities)
  {
    this->SmoothCavity(cavity, r, z);
  }
}

void InterfaceOperator::SmoothCavity(
  const CavityFlux& cavity, const std::vector<double>& r, std::vector<float>& z) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < cavity.Column.size(); ++i)
  {
    sum += cavity.Value[i] * static_cast<double>(z[static_cast<std::size_t>(cavity.Column[i])]);
  }
  for (std::size_t i = 0; i < cavity.Row.size(); ++i)
  {
    const auto row = static_cast<std::size_t>(cavity.Row[i]);
    const double share = this->Rows.Scale[row] * cavity.Share[i];
    // A changed value changes the shared sum of the rows that follow.
    const auto own =
      std::lower_bound(cavity.Column.begin(), cavity.Column.end(), this->Rows.Node[row]);
    const double value = cavity.Value[static_cast<std::size_t>(own - cavity.Column.begin())];
    sum += value * static_cast<double>(this->SmoothRow(row, share * sum, share * value, r, z));
  }
}

}
