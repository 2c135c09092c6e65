#include "Contouring/SeedPoints.h"

#include "Surfaces/SurfaceTopology.h"

#include <cmath>
#include <limits>
#include <unordered_map>

namespace isthmus
{
namespace
{

double Distance2(const Point3& a, const Point3& b)
{
  const Point3 d = a - b;
  return Dot(d, d);
}

/// Accepts points that have a minimum distance from all previously accepted ones.
class Spacer
{
public:
  explicit Spacer(double spacing)
    : Spacing(spacing)
  {
  }

  bool Accept(const Point3& p)
  {
    std::int64_t cell[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      cell[a] = static_cast<std::int64_t>(std::floor(p[a] / this->Spacing));
    }
    for (std::int64_t n = 0; n < 27; ++n)
    {
      const auto found =
        this->Cells.find(Key(cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1));
      if (found == this->Cells.end())
      {
        continue;
      }
      for (const Point3& other : found->second)
      {
        if (Distance2(p, other) < this->Spacing * this->Spacing)
        {
          return false;
        }
      }
    }
    this->Cells[Key(cell[0], cell[1], cell[2])].push_back(p);
    return true;
  }

private:
  /// Cells that share a key only cause a few more comparisons.
  static std::int64_t Key(std::int64_t i, std::int64_t j, std::int64_t k)
  {
    constexpr std::int64_t range = 1 << 20;
    return (i % range) + range * ((j % range) + range * (k % range));
  }

  double Spacing;
  std::unordered_map<std::int64_t, std::vector<Point3>> Cells;
};

/// Up to `count` points of `ids`, each farthest from those before.
std::vector<std::int64_t> Farthest(
  const View<Point3>& points, const std::vector<std::int64_t>& ids, std::size_t count)
{
  const auto at = [&points](std::int64_t id) { return points[static_cast<std::size_t>(id)]; };
  std::vector<std::int64_t> chosen{ ids.front() };
  std::vector<double> nearest(ids.size(), std::numeric_limits<double>::infinity());
  while (chosen.size() < std::min(count, ids.size()))
  {
    std::size_t best = 0;
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      nearest[i] = std::min(nearest[i], Distance2(at(ids[i]), at(chosen.back())));
      best = nearest[i] > nearest[best] ? i : best;
    }
    chosen.push_back(ids[best]);
  }
  return chosen;
}

}

std::vector<SeededComponent> SpreadSeeds(const SurfaceView& surface, double spacing)
{
  constexpr double far = std::numeric_limits<double>::infinity();
  constexpr std::size_t fewest = 4;
  const std::vector<int> component = Components(surface);
  std::vector<SeededComponent> result;
  std::vector<bool> met(surface.Points.size());
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const auto c = static_cast<std::size_t>(component[t]);
    if (c == result.size())
    {
      result.push_back({ {}, {}, { { far, far, far }, { -far, -far, -far } } });
    }
    for (const std::int64_t p : surface.Triangles[t])
    {
      if (!met[static_cast<std::size_t>(p)])
      {
        met[static_cast<std::size_t>(p)] = true;
        result[c].Points.push_back(p);
        result[c].Bounds.Add(surface.Points[static_cast<std::size_t>(p)]);
      }
    }
  }
  Spacer spacer(spacing);
  for (SeededComponent& one : result)
  {
    for (const std::int64_t p : one.Points)
    {
      if (spacer.Accept(surface.Points[static_cast<std::size_t>(p)]))
      {
        one.Seeds.push_back(p);
      }
    }
    if (one.Seeds.size() < fewest)
    {
      one.Seeds = Farthest(surface.Points, one.Points, fewest);
    }
  }
  return result;
}

}
