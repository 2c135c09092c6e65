// What is done on one grid of a multigrid cycle: smoothing, residuals down, corrections up.

#include "Core/ParallelFor.h"
#include "Electrostatics/MultigridEdges.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

template <typename Edges>
struct Stencil
{
  float Sum, Diagonal;

  Stencil(const Edges& e, const float* u, std::int64_t p, std::int64_t nx, std::int64_t nxy)
  {
    const float w0 = e(0, p - 1), w1 = e(0, p), s0 = e(1, p - nx), s1 = e(1, p);
    const float b0 = e(2, p - nxy), b1 = e(2, p);
    this->Sum = w0 * u[p - 1] + w1 * u[p + 1] + s0 * u[p - nx] + s1 * u[p + nx] + b0 * u[p - nxy] +
      b1 * u[p + nxy];
    this->Diagonal = w0 + w1 + s0 + s1 + b0 + b1;
  }
};

/// Of a line with one permittivity.
struct UniformStencil
{
  float X, Y, Z, Diagonal;

  UniformStencil(const MultigridLevel& level, float eps)
    : X(eps * level.Weight[0])
    , Y(eps * level.Weight[1])
    , Z(eps * level.Weight[2])
    , Diagonal(2.0F * (this->X + this->Y + this->Z))
  {
  }
  float Sum(const float* u, std::int64_t p, std::int64_t nx, std::int64_t nxy) const
  {
    return this->X * (u[p - 1] + u[p + 1]) + this->Y * (u[p - nx] + u[p + nx]) +
      this->Z * (u[p - nxy] + u[p + nxy]);
  }
};

template <typename Edges>
void SmoothLine(MultigridLevel& level, const Edges& edges, std::int64_t start, std::int64_t from)
{
  const std::int64_t nx = level.Dimensions[0];
  const std::int64_t nxy = nx * level.Dimensions[1];
  float* u = level.X.data();
  const float* b = level.B.data();
  const float* d = level.Diagonal ? level.Diagonal->data() : nullptr;
  const float eps =
    level.Finest() ? level.LinePermittivity[static_cast<std::size_t>(start / nx)] : 0.0F;
  const std::int64_t last = start + nx - 1;
  if (eps > 0.0F)
  {
    const UniformStencil s(level, eps);
    if (!d)
    {
      const float inverse = 1.0F / s.Diagonal;
      for (std::int64_t p = start + from; p < last; p += 2)
      {
        u[p] = inverse * (b[p] + s.Sum(u, p, nx, nxy));
      }
      return;
    }
    for (std::int64_t p = start + from; p < last; p += 2)
    {
      u[p] = (b[p] + s.Sum(u, p, nx, nxy)) / (s.Diagonal + d[p]);
    }
    return;
  }
  for (std::int64_t p = start + from; p < last; p += 2)
  {
    const Stencil<Edges> s(edges, u, p, nx, nxy);
    u[p] = (b[p] + s.Sum) / (s.Diagonal + (d ? d[p] : 0.0F));
  }
}

/// Residual of layer k into `plane` (0 on the border).
template <typename Edges>
void ResidualPlane(const MultigridLevel& level, const Edges& edges, std::int64_t k, float* plane)
{
  const auto& n = level.Dimensions;
  const std::int64_t nx = n[0];
  const std::int64_t nxy = nx * n[1];
  std::fill(plane, plane + nxy, 0.0F);
  if (k < 1 || k > n[2] - 2)
  {
    return;
  }
  const float* u = level.X.data();
  const float* b = level.B.data();
  const float* d = level.Diagonal ? level.Diagonal->data() : nullptr;
  for (std::int64_t j = 1; j < n[1] - 1; ++j)
  {
    const std::int64_t start = nx * (j + n[1] * k);
    float* out = plane + nx * j - start;
    const float eps =
      level.Finest() ? level.LinePermittivity[static_cast<std::size_t>(start / nx)] : 0.0F;
    if (eps > 0.0F)
    {
      const UniformStencil s(level, eps);
      for (std::int64_t p = start + 1; p < start + nx - 1; ++p)
      {
        out[p] = b[p] + s.Sum(u, p, nx, nxy) - (s.Diagonal + (d ? d[p] : 0.0F)) * u[p];
      }
      continue;
    }
    for (std::int64_t p = start + 1; p < start + nx - 1; ++p)
    {
      const Stencil<Edges> s(edges, u, p, nx, nxy);
      out[p] = b[p] + s.Sum - (s.Diagonal + (d ? d[p] : 0.0F)) * u[p];
    }
  }
}

/// Sums 1/4 1/2 1/4 of three planes (or the middle one alone), then of lines, then of nodes.
void RestrictPlane(const std::array<bool, 3>& halved, const std::array<std::int64_t, 3>& fine,
  const std::array<std::int64_t, 3>& coarse, std::vector<float>& plane, float* out)
{
  const std::int64_t nx = fine[0];
  std::vector<float> line(static_cast<std::size_t>(nx));
  for (std::int64_t j = 1; j < coarse[1] - 1; ++j)
  {
    const std::int64_t fj = halved[1] ? 2 * j : j;
    const float* mid = plane.data() + nx * fj;
    for (std::int64_t i = 0; i < nx; ++i)
    {
      line[static_cast<std::size_t>(i)] =
        halved[1] ? 0.5F * mid[i] + 0.25F * (mid[i - nx] + mid[i + nx]) : mid[i];
    }
    for (std::int64_t i = 1; i < coarse[0] - 1; ++i)
    {
      const auto fi = static_cast<std::size_t>(halved[0] ? 2 * i : i);
      out[i + coarse[0] * j] =
        halved[0] ? 0.5F * line[fi] + 0.25F * (line[fi - 1] + line[fi + 1]) : line[fi];
    }
  }
}

}

void SmoothColour(MultigridLevel& level, int colour)
{
  const auto& n = level.Dimensions;
  WithEdges(level,
    [&](const auto& edges)
    {
      ParallelFor(1, n[2] - 1, std::max<std::int64_t>(1, 20000 / (n[0] * n[1])),
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t k = first; k < last; ++k)
          {
            for (std::int64_t j = 1; j < n[1] - 1; ++j)
            {
              const std::int64_t from = 1 + ((1 + j + k + colour) & 1);
              SmoothLine(level, edges, n[0] * (j + n[1] * k), from);
            }
          }
        });
    });
}

void RestrictResidual(const MultigridLevel& fine, MultigridLevel& coarse)
{
  const auto& n = coarse.Dimensions;
  const std::int64_t nxy = fine.Dimensions[0] * fine.Dimensions[1];
  const bool halved = fine.Halved[2];
  WithEdges(fine,
    [&](const auto& edges)
    {
      ParallelFor(1, n[2] - 1, std::max<std::int64_t>(4, 20000 / nxy),
        [&](std::int64_t first, std::int64_t last)
        {
          std::vector<float> sum(static_cast<std::size_t>(nxy));
          std::vector<float> middle(static_cast<std::size_t>(nxy));
          std::vector<float> above(static_cast<std::size_t>(nxy));
          std::vector<float> below(static_cast<std::size_t>(nxy));
          for (std::int64_t k = first; k < last; ++k)
          {
            if (!halved)
            {
              ResidualPlane(fine, edges, k, sum.data());
            }
            else
            {
              // The plane above one coarse node is the one below the next.
              if (k == first)
              {
                ResidualPlane(fine, edges, 2 * k - 1, below.data());
              }
              ResidualPlane(fine, edges, 2 * k, middle.data());
              ResidualPlane(fine, edges, 2 * k + 1, above.data());
              for (std::size_t p = 0; p < sum.size(); ++p)
              {
                sum[p] = 0.5F * middle[p] + 0.25F * (below[p] + above[p]);
              }
              below.swap(above);
            }
            RestrictPlane(fine.Halved, fine.Dimensions, n, sum, coarse.B.data() + n[0] * n[1] * k);
          }
        });
    });
}

void AddCorrection(const MultigridLevel& coarse, MultigridLevel& fine)
{
  const auto& n = fine.Dimensions;
  const auto& m = coarse.Dimensions;
  ParallelFor(1, n[2] - 1, std::max<std::int64_t>(1, 20000 / (n[0] * n[1])),
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<float> line(static_cast<std::size_t>(m[0]));
      for (std::int64_t k = first; k < last; ++k)
      {
        const std::int64_t k0 = fine.Halved[2] ? k / 2 : k;
        const std::int64_t k1 = fine.Halved[2] ? (k + 1) / 2 : k;
        for (std::int64_t j = 1; j < n[1] - 1; ++j)
        {
          const std::int64_t j0 = fine.Halved[1] ? j / 2 : j;
          const std::int64_t j1 = fine.Halved[1] ? (j + 1) / 2 : j;
          const float* a = coarse.X.data() + m[0] * (j0 + m[1] * k0);
          const float* b = coarse.X.data() + m[0] * (j1 + m[1] * k0);
          const float* c = coarse.X.data() + m[0] * (j0 + m[1] * k1);
          const float* d = coarse.X.data() + m[0] * (j1 + m[1] * k1);
          for (std::size_t i = 0; i < line.size(); ++i)
          {
            line[i] = 0.25F * ((a[i] + b[i]) + (c[i] + d[i]));
          }
          float* u = fine.X.data() + n[0] * (j + n[1] * k);
          for (std::int64_t i = 1; i < n[0] - 1; ++i)
          {
            const auto i0 = static_cast<std::size_t>(fine.Halved[0] ? i / 2 : i);
            const auto i1 = static_cast<std::size_t>(fine.Halved[0] ? (i + 1) / 2 : i);
            u[i] += 0.5F * (line[i0] + line[i1]);
          }
        }
      }
    });
}

}
