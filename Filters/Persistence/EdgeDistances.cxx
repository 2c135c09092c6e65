#include "Persistence/EdgeDistances.h"

#include "Core/Index.h"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace isthmus
{

std::vector<double> EdgeDistances(const TetrahedralMesh& mesh,
  const std::vector<std::int64_t>& sources, const ProgressCallback& progress)
{
  std::vector<std::vector<std::int64_t>> beside(mesh.Points.size());
  for (const Tetrahedron& t : mesh.Tetrahedra)
  {
    for (const std::int64_t a : t)
    {
      for (const std::int64_t b : t)
      {
        if (a != b)
        {
          beside[At(a)].push_back(b);
        }
      }
    }
  }
  std::vector<double> distance(mesh.Points.size(), HUGE_VAL);
  using Entry = std::pair<double, std::int64_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::int64_t p : sources)
  {
    distance[At(p)] = 0.0;
    queue.push({ 0.0, p });
  }
  Report(progress, 0.0);
  std::size_t settled = 0;
  while (!queue.empty())
  {
    const auto [d, p] = queue.top();
    queue.pop();
    if (d > distance[At(p)])
    {
      continue;
    }
    if (settled++ % (1U << 16) == 0)
    {
      Report(progress, static_cast<double>(settled) / static_cast<double>(mesh.Points.size()));
    }
    for (const std::int64_t q : beside[At(p)])
    {
      const Point3 step = mesh.Points[At(q)] - mesh.Points[At(p)];
      const double there = d + Length(step);
      if (there < distance[At(q)])
      {
        distance[At(q)] = there;
        queue.push({ there, q });
      }
    }
  }
  return distance;
}

}
