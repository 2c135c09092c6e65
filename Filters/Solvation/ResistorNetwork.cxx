#include "Solvation/ResistorNetwork.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr double Modified = 0.97;   // of the fill that is added to the pivot
constexpr double Smallest = 0.25;   // a pivot below this part of its row is not trusted
constexpr int IterationsToLook = 8; // between reports

}

ResistorNetwork::ResistorNetwork(
  const std::array<std::int64_t, 3>& dimensions, const std::vector<unsigned char>& held)
  : Nodes(dimensions[0] * dimensions[1] * dimensions[2])
  , Steps{ 1, dimensions[0], dimensions[0] * dimensions[1] }
  , Margin(Steps[2])
  , Held(held)
{
  const auto size = static_cast<std::size_t>(this->Nodes + 2 * this->Margin);
  for (std::vector<double>* all : { &this->Edges[0], &this->Edges[1], &this->Edges[2],
         &this->Diagonals, &this->Sum, &this->Inverse, &this->R, &this->Z, &this->P, &this->Q })
  {
    all->assign(size, 0.0);
  }
}

void ResistorNetwork::Factor()
{
  const double* edge[3] = { this->Edges[0].data(), this->Edges[1].data(), this->Edges[2].data() };
  const auto free = [this](std::int64_t at)
  {
    const std::int64_t node = at - this->Margin;
    return node < this->Nodes && !this->Held[static_cast<std::size_t>(node)];
  };
  for (std::int64_t p = this->Margin; p < this->Margin + this->Nodes; ++p)
  {
    double sum = this->Diagonals[static_cast<std::size_t>(p)];
    for (std::size_t a = 0; a < 3; ++a)
    {
      sum += edge[a][p] + edge[a][p - this->Steps[a]];
    }
    double& inverse = this->Inverse[static_cast<std::size_t>(p)];
    inverse = 0.0;
    this->Sum[static_cast<std::size_t>(p)] = free(p) ? sum : 0.0;
    if (!free(p) || !(sum > 0.0))
    {
      continue;
    }
    double pivot = sum;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::int64_t q = p - this->Steps[a];
      const double g = edge[a][q];
      if (g == 0.0)
      {
        continue;
      }
      double fill = 0.0;
      for (std::size_t b = 0; b < 3; ++b)
      {
        fill += b != a && edge[b][q] > 0.0 && free(q + this->Steps[b]) ? edge[b][q] : 0.0;
      }
      pivot -= g * this->Inverse[static_cast<std::size_t>(q)] * (g + Modified * fill);
    }
    inverse = 1.0 / (pivot < Smallest * sum ? sum : pivot);
  }
}

double ResistorNetwork::Residual(const std::vector<double>& u, const std::vector<double>& source)
{
  std::copy(u.begin(), u.end(), this->P.begin() + this->Margin);
  const double* x = this->Edges[0].data();
  const double* y = this->Edges[1].data();
  const double* z = this->Edges[2].data();
  const double* v = this->P.data();
  double total = 0.0;
  for (std::int64_t p = this->Margin; p < this->Margin + this->Nodes; ++p)
  {
    const auto node = static_cast<std::size_t>(p - this->Margin);
    double r = 0.0;
    if (!this->Held[node])
    {
      // Differences first: u itself may be much larger than they are.
      const std::int64_t i = p - 1, j = p - this->Steps[1], k = p - this->Steps[2];
      r = (source.empty() ? 0.0 : source[node]) -
        this->Diagonals[static_cast<std::size_t>(p)] * v[p] + x[p] * (v[p + 1] - v[p]) +
        x[i] * (v[i] - v[p]) + y[p] * (v[p + this->Steps[1]] - v[p]) + y[j] * (v[j] - v[p]) +
        z[p] * (v[p + this->Steps[2]] - v[p]) + z[k] * (v[k] - v[p]);
    }
    this->R[static_cast<std::size_t>(p)] = r;
    total += std::abs(r);
  }
  return total;
}

double ResistorNetwork::SumOfMagnitudes(const std::vector<double>& u) const
{
  double total = 0.0;
  for (std::size_t node = 0; node < u.size(); ++node)
  {
    total += this->Sum[node + static_cast<std::size_t>(this->Margin)] * std::abs(u[node]);
  }
  return total;
}

double ResistorNetwork::Multiply()
{
  const double* x = this->Edges[0].data();
  const double* y = this->Edges[1].data();
  const double* z = this->Edges[2].data();
  const double* sum = this->Sum.data();
  const double* v = this->P.data();
  double* to = this->Q.data();
  const std::int64_t sy = this->Steps[1], sz = this->Steps[2];
  for (std::int64_t p = this->Margin; p < this->Margin + this->Nodes; ++p)
  {
    to[p] = sum[p] * v[p] - (x[p] * v[p + 1] + x[p - 1] * v[p - 1]) -
      (y[p] * v[p + sy] + y[p - sy] * v[p - sy]) - (z[p] * v[p + sz] + z[p - sz] * v[p - sz]);
  }
  double product = 0.0;
  for (std::int64_t p = this->Margin; p < this->Margin + this->Nodes; ++p)
  {
    product += v[p] * to[p]; // v is 0 where it is held, whatever stands there in Q
  }
  return product;
}

double ResistorNetwork::Precondition()
{
  const double* x = this->Edges[0].data();
  const double* y = this->Edges[1].data();
  const double* z = this->Edges[2].data();
  const double* inverse = this->Inverse.data();
  const double* r = this->R.data();
  double* w = this->Z.data();
  const std::int64_t sy = this->Steps[1], sz = this->Steps[2];
  const std::int64_t last = this->Margin + this->Nodes;
  for (std::int64_t p = this->Margin; p < last; ++p)
  {
    const double known = r[p] + y[p - sy] * w[p - sy] + z[p - sz] * w[p - sz];
    w[p] = inverse[p] * (known + x[p - 1] * w[p - 1]);
  }
  double product = 0.0;
  for (std::int64_t p = last - 1; p >= this->Margin; --p)
  {
    const double known = y[p] * w[p + sy] + z[p] * w[p + sz];
    w[p] += inverse[p] * (known + x[p] * w[p + 1]);
    product += r[p] * w[p];
  }
  return product;
}

ResistorNetwork::Answer ResistorNetwork::Solve(std::vector<double>& u,
  const std::vector<double>& source, const Control& control, const ProgressCallback& progress)
{
  Answer answer;
  answer.Residual = this->Residual(u, source);
  std::fill(this->P.begin(), this->P.end(), 0.0);
  double before = 0.0;
  const double limit = std::max(control.Limit, control.Reduction * answer.Residual);
  while (!(answer.Residual <= limit))
  {
    if (!std::isfinite(answer.Residual))
    {
      throw std::runtime_error("The iteration diverged: choose a smaller Spacing, a "
                               "smaller Voltage, or look for charges that touch the water.");
    }
    if (answer.Iterations == control.MaximumIterations)
    {
      return answer;
    }
    if (answer.Iterations % IterationsToLook == 0)
    {
      Report(progress, 0.0);
    }
    const double now = this->Precondition();
    const double beta = before > 0.0 ? now / before : 0.0;
    before = now;
    for (std::size_t p = 0; p < this->P.size(); ++p)
    {
      this->P[p] = this->Z[p] + beta * this->P[p];
    }
    const double energy = this->Multiply();
    if (!(energy > 0.0))
    {
      return answer; // rounding is all that is left
    }
    const double step = now / energy;
    answer.Residual = 0.0;
    for (std::int64_t node = 0; node < this->Nodes; ++node)
    {
      const auto p = static_cast<std::size_t>(node + this->Margin);
      if (this->Inverse[p] > 0.0)
      {
        u[static_cast<std::size_t>(node)] += step * this->P[p];
        this->R[p] -= step * this->Q[p];
        answer.Residual += std::abs(this->R[p]);
      }
    }
    ++answer.Iterations;
  }
  answer.Converged = true;
  return answer;
}

}
