#include "ChokingLoops/AnalysisCost.h"

#include "Core/DisjointSets.h"
#include "Core/MemoryBudget.h"

#include <algorithm>

namespace isthmus
{
namespace
{

/// Threads and their arenas, and what of a complex does not depend on its size.
constexpr double FixedBytes = 8e6;

/// Of the complex, its pairs and the surface: 1.3 KB on a million samples, more where a finer
/// sampling that was given up was held beside it. Of each own point the same again.
constexpr double BytesOfSample = 1700.0;

/// Of each sample's three edges, a bit for each dual loop that crosses it.
constexpr double BytesOfWord = 24.0;

/// In triangulations: all stages together,
constexpr double UnitsOfStages = 3.2;

/// what reducing a class of M adds,
constexpr double UnitsOfClass = 0.006;

/// and TetGen's mesh of the surface's own points with its pairs, as much as so many samples a
/// point.
constexpr double SamplesOfOwnPoint = 11.4;

/// Connected parts, of points that triangles use and others: none of a sampled surface.
int Parts(const SurfaceView& mesh)
{
  DisjointSets<std::int64_t> sets(static_cast<std::int64_t>(mesh.Points.size()));
  auto components = static_cast<int>(mesh.Points.size());
  for (const Triangle& t : mesh.Triangles)
  {
    for (std::size_t k = 1; k < 3; ++k)
    {
      components -= sets.Find(t[0]) != sets.Find(t[k]) ? 1 : 0;
      sets.Join(t[0], t[k]);
    }
  }
  return components;
}

}

AnalysisCost AnalysisCost::After(double triangulation) const
{
  AnalysisCost cost = *this;
  cost.Triangulation = triangulation;
  cost.Seconds = cost.Units * triangulation + cost.Completion();
  return cost;
}

void AnalysisCost::LearnFrom(const AnalysisCost& before, double seconds)
{
  if (before.Triangulation > 0.0)
  {
    this->Units = seconds / before.Triangulation;
  }
}

void AnalysisCost::ExpectCompletion(std::size_t points)
{
  this->Own = points;
  this->Bytes += BytesOfSample * static_cast<double>(points);
}

double AnalysisCost::Completion() const
{
  return this->Samples == 0 ? 0.0
                            : SamplesOfOwnPoint * static_cast<double>(this->Own) *
      this->Triangulation / static_cast<double>(this->Samples);
}

AnalysisCost CostOf(const SurfaceView& samples)
{
  AnalysisCost cost;
  cost.Samples = samples.Points.size();
  // Each triangle has three halves of an edge.
  const auto euler = static_cast<std::int64_t>(samples.Points.size()) -
    static_cast<std::int64_t>(samples.Triangles.size() / 2);
  cost.Rank =
    static_cast<std::size_t>(std::max<std::int64_t>(0, 2 * std::int64_t{ Parts(samples) } - euler));
  cost.Units = UnitsOfStages + UnitsOfClass * static_cast<double>(cost.Rank);
  const std::size_t words = (cost.Rank + 63) / 64;
  cost.Bytes = FixedBytes +
    (BytesOfSample + BytesOfWord * static_cast<double>(words)) * static_cast<double>(cost.Samples);
  return cost;
}

bool FitsMemory(const AnalysisCost& cost, double limit, std::string& sentence)
{
  const MemoryBudget budget(limit / 1048576.0);
  if (budget.Allows(cost.Bytes))
  {
    return true;
  }
  sentence =
    budget.Message(cost.Bytes, "The analysis of " + std::to_string(cost.Samples) + " samples",
      "raise SampleSpacing or simplify the surface");
  return false;
}

}
