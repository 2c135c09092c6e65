#include "Electrostatics/MultigridPoisson.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{

/// The finest level holds codes, the others permittivities (times weight and scale) as they are.
struct MultigridLevel
{
  std::array<std::int64_t, 3> Dimensions;
  std::array<float, 3> Weight;            ///< (h_finest / h_axis)^2 of this level
  EdgePermittivity Coded;                 ///< finest level
  std::array<std::vector<float>, 3> Edge; ///< coarser levels, weights included
  /// Finest level: for each line along x, the one permittivity of all edges it meets, or 0.
  std::vector<float> LinePermittivity;
  std::shared_ptr<const std::vector<float>> Diagonal;
  std::array<bool, 3> Halved{ false, false, false }; ///< axes that the next level halves
  std::vector<float> X, B;

  std::int64_t Size() const
  {
    return this->Dimensions[0] * this->Dimensions[1] * this->Dimensions[2];
  }
  bool IsFinest() const { return this->Edge[0].empty(); }
};

/// Finds lines with one permittivity only.
void ClassifyLines(MultigridLevel& level);

/// Whether there is a coarser level: chooses the axes to halve.
bool ChooseCoarsening(MultigridLevel& level);

/// The next level, without diagonal.
std::unique_ptr<MultigridLevel> Coarsen(const MultigridLevel& fine);

/// The fine diagonal, averaged to the coarse level.
std::shared_ptr<const std::vector<float>> CoarsenDiagonal(
  const MultigridLevel& fine, const MultigridLevel& coarse);

/// One Gauss-Seidel sweep over the nodes with (i + j + k) % 2 == colour.
void SmoothColour(MultigridLevel& level, int colour);

/// Restricts the residual B - A X of `fine` to B of `coarse`.
void RestrictResidual(const MultigridLevel& fine, MultigridLevel& coarse);

/// Adds the correction X of `coarse`, interpolated, to X of `fine`.
void AddCorrection(const MultigridLevel& coarse, MultigridLevel& fine);

namespace
{

/// Permittivity times weight of edges, from codes or as stored.
struct CodedEdges
{
  const unsigned char* Code[3];
  float Table[3][256];

  explicit CodedEdges(const MultigridLevel& level)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Code[a] = level.Coded.Code[a].data();
      for (std::size_t c = 0; c < 256; ++c)
      {
        this->Table[a][c] = level.Weight[a] * level.Coded.Table[c];
      }
    }
  }
  float operator()(std::size_t axis, std::int64_t node) const
  {
    return this->Table[axis][this->Code[axis][node]];
  }
};

struct StoredEdges
{
  const float* Edge[3];

  explicit StoredEdges(const MultigridLevel& level)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Edge[a] = level.Edge[a].data();
    }
  }
  float operator()(std::size_t axis, std::int64_t node) const { return this->Edge[axis][node]; }
};

/// Calls `use` with the edges of the level.
template <typename Use>
void WithEdges(const MultigridLevel& level, Use&& use)
{
  if (level.IsFinest())
  {
    use(CodedEdges(level));
  }
  else
  {
    use(StoredEdges(level));
  }
}

/// Average of `value(fine node)` over the fine nodes around coarse node I, 1/4 1/2 1/4 along the
/// axes of `across`; nodes beyond the border count as those on it.
template <typename Value>
float Average(const MultigridLevel& fine, const std::array<std::int64_t, 3>& at,
  const std::array<bool, 3>& across, Value&& value)
{
  const auto& n = fine.Dimensions;
  float sum = 0.0F;
  std::int64_t reach[3];
  for (std::size_t a = 0; a < 3; ++a)
  {
    reach[a] = across[a] ? 1 : 0;
  }
  for (std::int64_t c = -reach[2]; c <= reach[2]; ++c)
  {
    for (std::int64_t b = -reach[1]; b <= reach[1]; ++b)
    {
      for (std::int64_t a = -reach[0]; a <= reach[0]; ++a)
      {
        const std::int64_t i = std::clamp<std::int64_t>(at[0] + a, 0, n[0] - 1);
        const std::int64_t j = std::clamp<std::int64_t>(at[1] + b, 0, n[1] - 1);
        const std::int64_t k = std::clamp<std::int64_t>(at[2] + c, 0, n[2] - 1);
        float w = reach[0] ? (a ? 0.25F : 0.5F) : 1.0F;
        w *= reach[1] ? (b ? 0.25F : 0.5F) : 1.0F;
        w *= reach[2] ? (c ? 0.25F : 0.5F) : 1.0F;
        sum += w * value(i, j, k);
      }
    }
  }
  return sum;
}

/// The coarse edge along `axis` from coarse node `at`.
template <typename Edges>
float CoarseEdge(const MultigridLevel& fine, const Edges& edges, std::size_t axis,
  const std::array<std::int64_t, 3>& at)
{
  const auto& n = fine.Dimensions;
  const std::array<std::int64_t, 3> step{ 1, n[0], n[0] * n[1] };
  std::array<std::int64_t, 3> from;
  std::array<bool, 3> across = fine.Halved;
  across[axis] = false;
  for (std::size_t a = 0; a < 3; ++a)
  {
    from[a] = fine.Halved[a] ? 2 * at[a] : at[a];
  }
  const std::int64_t lastEdge = n[axis] - 2;
  return Average(fine, from, across,
    [&](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      std::array<std::int64_t, 3> p{ i, j, k };
      p[axis] = std::min(p[axis], lastEdge);
      const std::int64_t node = p[0] * step[0] + p[1] * step[1] + p[2] * step[2];
      const float first = edges(axis, node);
      if (!fine.Halved[axis])
      {
        return first;
      }
      const float second = edges(axis, p[axis] < lastEdge ? node + step[axis] : node);
      // Two consecutive ones, over twice the length: a quarter of their harmonic mean.
      return 0.25F * 2.0F * first * second / (first + second);
    });
}

}

void ClassifyLines(MultigridLevel& level)
{
  const auto& n = level.Dimensions;
  const auto& code = level.Coded.Code;
  level.LinePermittivity.assign(static_cast<std::size_t>(n[1] * n[2]), 0.0F);
  const std::int64_t nxy = n[0] * n[1];
  ParallelFor(1, n[2] - 1, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        for (std::int64_t j = 1; j < n[1] - 1; ++j)
        {
          const std::int64_t start = n[0] * (j + n[1] * k);
          const auto one = code[0][static_cast<std::size_t>(start)];
          bool same = true;
          for (std::int64_t i = 0; same && i < n[0] - 1; ++i)
          {
            const auto p = static_cast<std::size_t>(start + i);
            same = code[0][p] == one && code[1][p] == one && code[2][p] == one &&
              code[1][p - static_cast<std::size_t>(n[0])] == one &&
              code[2][p - static_cast<std::size_t>(nxy)] == one;
          }
          level.LinePermittivity[static_cast<std::size_t>(start / n[0])] =
            same ? level.Coded.Table[one] : 0.0F;
        }
      }
    });
}

bool ChooseCoarsening(MultigridLevel& level)
{
  float strongest = 0.0F;
  for (std::size_t a = 0; a < 3; ++a)
  {
    strongest = level.Dimensions[a] > 3 ? std::max(strongest, level.Weight[a]) : strongest;
  }
  bool any = false;
  for (std::size_t a = 0; a < 3; ++a)
  {
    // A weight of 0.44 is a spacing of 1.5 times the shortest.
    level.Halved[a] = level.Dimensions[a] > 3 && level.Weight[a] >= 0.44F * strongest;
    any = any || level.Halved[a];
  }
  return any;
}

std::unique_ptr<MultigridLevel> Coarsen(const MultigridLevel& fine)
{
  auto coarse = std::make_unique<MultigridLevel>();
  for (std::size_t a = 0; a < 3; ++a)
  {
    coarse->Dimensions[a] = fine.Halved[a] ? fine.Dimensions[a] / 2 + 1 : fine.Dimensions[a];
    coarse->Weight[a] = fine.Halved[a] ? 0.25F * fine.Weight[a] : fine.Weight[a];
  }
  const auto& n = coarse->Dimensions;
  const auto size = static_cast<std::size_t>(coarse->Size());
  coarse->X.resize(size);
  coarse->B.assign(size, 0.0F);
  for (auto& edge : coarse->Edge)
  {
    edge.resize(size);
  }
  WithEdges(fine,
    [&](const auto& edges)
    {
      ParallelFor(0, n[2], 1,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t node = first * n[0] * n[1]; node < last * n[0] * n[1]; ++node)
          {
            const std::array<std::int64_t, 3> at{ node % n[0], node / n[0] % n[1],
              node / (n[0] * n[1]) };
            for (std::size_t a = 0; a < 3; ++a)
            {
              coarse->Edge[a][static_cast<std::size_t>(node)] = CoarseEdge(fine, edges, a, at);
            }
          }
        });
    });
  return coarse;
}

std::shared_ptr<const std::vector<float>> CoarsenDiagonal(
  const MultigridLevel& fine, const MultigridLevel& coarse)
{
  if (!fine.Diagonal)
  {
    return nullptr;
  }
  auto diagonal = std::make_shared<std::vector<float>>(static_cast<std::size_t>(coarse.Size()));
  const auto& n = coarse.Dimensions;
  const float* d = fine.Diagonal->data();
  const auto& m = fine.Dimensions;
  ParallelFor(0, n[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first * n[0] * n[1]; node < last * n[0] * n[1]; ++node)
      {
        std::array<std::int64_t, 3> at{ node % n[0], node / n[0] % n[1], node / (n[0] * n[1]) };
        for (std::size_t a = 0; a < 3; ++a)
        {
          at[a] *= fine.Halved[a] ? 2 : 1;
        }
        (*diagonal)[static_cast<std::size_t>(node)] = Average(fine, at, fine.Halved,
          [&](std::int64_t i, std::int64_t j, std::int64_t k)
          { return d[i + m[0] * (j + m[1] * k)]; });
      }
    });
  return diagonal;
}

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

/// The stencil of a line with one permittivity.
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
    level.IsFinest() ? level.LinePermittivity[static_cast<std::size_t>(start / nx)] : 0.0F;
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
      level.IsFinest() ? level.LinePermittivity[static_cast<std::size_t>(start / nx)] : 0.0F;
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

MultigridPoisson::MultigridPoisson(const std::array<std::int64_t, 3>& dimensions,
  const std::array<double, 3>& weights, EdgePermittivity permittivity)
{
  auto finest = std::make_unique<MultigridLevel>();
  finest->Dimensions = dimensions;
  for (std::size_t a = 0; a < 3; ++a)
  {
    finest->Weight[a] = static_cast<float>(weights[a]);
  }
  finest->Coded = std::move(permittivity);
  ClassifyLines(*finest);
  finest->B.resize(static_cast<std::size_t>(finest->Size()));
  this->Levels.push_back(std::move(finest));
  while (ChooseCoarsening(*this->Levels.back()))
  {
    this->Levels.push_back(Coarsen(*this->Levels.back()));
  }
}

MultigridPoisson::~MultigridPoisson() = default;

int MultigridPoisson::NumberOfLevels() const
{
  return static_cast<int>(this->Levels.size());
}

void MultigridPoisson::SetDiagonal(std::shared_ptr<const std::vector<float>> diagonal)
{
  this->Levels.front()->Diagonal = diagonal && !diagonal->empty() ? std::move(diagonal) : nullptr;
  for (std::size_t level = 1; level < this->Levels.size(); ++level)
  {
    this->Levels[level]->Diagonal = CoarsenDiagonal(*this->Levels[level - 1], *this->Levels[level]);
  }
}

void MultigridPoisson::Descend(std::size_t index)
{
  MultigridLevel& level = *this->Levels[index];
  if (index + 1 == this->Levels.size())
  {
    constexpr int coarsestSweeps = 8;
    for (int sweep = 0; sweep < coarsestSweeps; ++sweep)
    {
      SmoothColour(level, 0);
      SmoothColour(level, 1);
      SmoothColour(level, 1);
      SmoothColour(level, 0);
    }
    return;
  }
  SmoothColour(level, 0);
  SmoothColour(level, 1);
  MultigridLevel& coarse = *this->Levels[index + 1];
  RestrictResidual(level, coarse);
  std::fill(coarse.X.begin(), coarse.X.end(), 0.0F);
  this->Descend(index + 1);
  AddCorrection(coarse, level);
  SmoothColour(level, 0);
  SmoothColour(level, 1);
}

void MultigridPoisson::Cycle(const std::vector<double>& r, std::vector<float>& z)
{
  MultigridLevel& finest = *this->Levels.front();
  constexpr std::int64_t grain = 1 << 16;
  ParallelFor(0, finest.Size(), grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t i = first; i < last; ++i)
      {
        const auto n = static_cast<std::size_t>(i);
        finest.B[n] = static_cast<float>(r[n]);
        z[n] = 0.0F;
      }
    });
  finest.X.swap(z);
  this->Descend(0);
  finest.X.swap(z);
}

}
