#include "Solvation/ResistorNetwork.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr double Modified = 0.97;       // of the fill that is added to the pivot
constexpr double Smallest = 0.25;       // a pivot below this part of its row is not trusted
constexpr int IterationsToLook = 8;     // between reports
constexpr std::int64_t Piece = 1 << 16; // nodes that a thread takes at once
constexpr std::int64_t MostSlabs = 8;

}

ResistorNetwork::ResistorNetwork(
  const std::array<std::int64_t, 3>& dimensions, const std::vector<unsigned char>& held)
  : Dimensions(dimensions)
  , Nodes(dimensions[0] * dimensions[1] * dimensions[2])
  , Slabs(std::clamp<std::int64_t>(Nodes / Piece, 1, std::min(MostSlabs, dimensions[2])))
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
  this->Zeros.assign(static_cast<std::size_t>(dimensions[0]), 0.0);
}

struct ResistorNetwork::Slab
{
  std::int64_t Number, FirstPlane, LastPlane; ///< LastPlane belongs to it
};

std::int64_t ResistorNetwork::FirstPlane(std::int64_t slab) const
{
  return slab * this->Dimensions[2] / this->Slabs;
}

void ResistorNetwork::ForEachSlab(const std::function<void(const Slab&)>& work) const
{
  ParallelFor(0, this->Slabs, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t slab = first; slab < last; ++slab)
      {
        work({ slab, this->FirstPlane(slab), this->FirstPlane(slab + 1) - 1 });
      }
    });
}

/// What `work(first, last)` returns, places with the margin, added in the order of the pieces.
template <typename Work>
double ResistorNetwork::SumOverNodes(Work&& work) const
{
  return ParallelReduce(this->Nodes, Piece, 0.0,
    [&](double& sum, std::int64_t first, std::int64_t last)
    { sum += work(this->Margin + first, this->Margin + last); });
}

void ResistorNetwork::Factor()
{
  this->ForEachSlab([this](const Slab& slab) { this->FactorSlab(slab); });
}

void ResistorNetwork::FactorSlab(const Slab& slab)
{
  const double* edge[3] = { this->Edges[0].data(), this->Edges[1].data(), this->Edges[2].data() };
  const std::int64_t begin = this->Margin + slab.FirstPlane * this->Steps[2];
  const std::int64_t end = this->Margin + (slab.LastPlane + 1) * this->Steps[2];
  const auto free = [this](std::int64_t at)
  {
    const std::int64_t node = at - this->Margin;
    return node < this->Nodes && !this->Held[static_cast<std::size_t>(node)];
  };
  for (std::int64_t p = begin; p < end; ++p)
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
      if (q < begin || edge[a][q] == 0.0)
      {
        continue;
      }
      double fill = 0.0;
      for (std::size_t b = 0; b < 3; ++b)
      {
        const std::int64_t r = q + this->Steps[b];
        fill += b != a && edge[b][q] > 0.0 && r < end && free(r) ? edge[b][q] : 0.0;
      }
      pivot -=
        edge[a][q] * this->Inverse[static_cast<std::size_t>(q)] * (edge[a][q] + Modified * fill);
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
  return this->SumOverNodes(
    [&](std::int64_t first, std::int64_t last)
    {
      double total = 0.0;
      for (std::int64_t p = first; p < last; ++p)
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
    });
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
  return this->SumOverNodes(
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t p = first; p < last; ++p)
      {
        to[p] = sum[p] * v[p] - (x[p] * v[p + 1] + x[p - 1] * v[p - 1]) -
          (y[p] * v[p + sy] + y[p - sy] * v[p - sy]) - (z[p] * v[p + sz] + z[p - sz] * v[p - sz]);
      }
      double product = 0.0;
      for (std::int64_t p = first; p < last; ++p)
      {
        product += v[p] * to[p]; // v is 0 where it is fixed, whatever the value in Q
      }
      return product;
    });
}

/// Z = solution for R by the slab's factor; returns R times Z. Row by row: neighbours beyond the
/// slab's first or last row or plane belong to another slab.
double ResistorNetwork::SolveSlab(const Slab& slab)
{
  const double* x = this->Edges[0].data();
  const double* y = this->Edges[1].data();
  const double* z = this->Edges[2].data();
  const double* inverse = this->Inverse.data();
  const double* r = this->R.data();
  double* w = this->Z.data();
  const std::int64_t row = this->Dimensions[0], rows = this->Dimensions[1];
  const std::int64_t sy = this->Steps[1], sz = this->Steps[2];
  const double* none = this->Zeros.data();
  const std::int64_t begin = slab.FirstPlane * rows, end = (slab.LastPlane + 1) * rows;
  for (std::int64_t line = begin; line < end; ++line)
  {
    const std::int64_t p = this->Margin + line * row;
    const bool hasY = line % rows > 0, hasZ = line >= begin + rows;
    const double* wy = hasY ? w + p - sy : none;
    const double* wz = hasZ ? w + p - sz : none;
    double last = 0.0;
    for (std::int64_t i = 0; i < row; ++i)
    {
      const double known = r[p + i] + y[p + i - sy] * wy[i] + z[p + i - sz] * wz[i];
      last = inverse[p + i] * (known + x[p + i - 1] * last);
      w[p + i] = last;
    }
  }
  double product = 0.0;
  for (std::int64_t line = end - 1; line >= begin; --line)
  {
    const std::int64_t p = this->Margin + line * row;
    const bool hasY = (line + 1) % rows > 0, hasZ = line < end - rows;
    const double* wy = hasY ? w + p + sy : none;
    const double* wz = hasZ ? w + p + sz : none;
    double last = 0.0;
    for (std::int64_t i = row - 1; i >= 0; --i)
    {
      const double known = y[p + i] * wy[i] + z[p + i] * wz[i];
      last = w[p + i] + inverse[p + i] * (known + x[p + i] * last);
      w[p + i] = last;
      product += r[p + i] * last;
    }
  }
  return product;
}

double ResistorNetwork::Precondition()
{
  std::vector<double> products(static_cast<std::size_t>(this->Slabs), 0.0);
  this->ForEachSlab([&](const Slab& slab)
    { products[static_cast<std::size_t>(slab.Number)] = this->SolveSlab(slab); });
  return std::accumulate(products.begin(), products.end(), 0.0);
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
    ParallelFor(this->Margin, this->Margin + this->Nodes, Piece,
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto p = static_cast<std::size_t>(first); p < static_cast<std::size_t>(last); ++p)
        {
          this->P[p] = this->Z[p] + beta * this->P[p];
        }
      });
    const double energy = this->Multiply();
    if (!(energy > 0.0))
    {
      return answer; // rounding is all that is left
    }
    const double step = now / energy;
    answer.Residual = this->SumOverNodes(
      [&](std::int64_t first, std::int64_t last)
      {
        double total = 0.0;
        for (auto p = static_cast<std::size_t>(first); p < static_cast<std::size_t>(last); ++p)
        {
          if (this->Inverse[p] > 0.0)
          {
            u[p - static_cast<std::size_t>(this->Margin)] += step * this->P[p];
            this->R[p] -= step * this->Q[p];
            total += std::abs(this->R[p]);
          }
        }
        return total;
      });
    ++answer.Iterations;
  }
  answer.Converged = true;
  return answer;
}

}
