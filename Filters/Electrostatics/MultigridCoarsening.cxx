// The coarser grids of a multigrid cycle, and what they are made of.

#include "Core/ParallelFor.h"
#include "Electrostatics/MultigridEdges.h"

#include <algorithm>

namespace isthmus
{
namespace
{

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
      // Two in a row, over twice the length: a quarter of their harmonic mean.
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

}
