#include "Electrostatics/MultigridPoisson.h"

#include "Core/ParallelFor.h"
#include "Electrostatics/MultigridLevel.h"

#include <algorithm>

namespace isthmus
{

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
