#include "Electrostatics/ClosedCavities.h"

#include "Core/DisjointSets.h"

#include <algorithm>
#include <unordered_map>

namespace isthmus
{
namespace
{

/// Consecutive nodes [First, Last) outside along x.
struct Run
{
  std::int64_t First, Last;
};

/// The runs of all lines of nodes along x.
class OutsideRuns
{
public:
  OutsideRuns(const SolverBox& box, const std::vector<unsigned char>& inside)
    : Width(box.Dimensions[0])
  {
    const std::int64_t lines = box.Dimensions[1] * box.Dimensions[2];
    this->Start.reserve(static_cast<std::size_t>(lines) + 1);
    for (std::int64_t line = 0; line < lines; ++line)
    {
      this->Start.push_back(this->Runs.size());
      this->AddLine(inside, line * this->Width);
    }
    this->Start.push_back(this->Runs.size());
  }

  /// Sets of runs that are connected through neighbouring lines.
  DisjointSets<std::int64_t> Components(const SolverBox& box) const
  {
    DisjointSets<std::int64_t> sets(static_cast<std::int64_t>(this->Runs.size()));
    const std::int64_t columns = box.Dimensions[1];
    for (std::int64_t line = 1; line < columns * box.Dimensions[2]; ++line)
    {
      const bool before = line % columns != 0;
      const bool behind = line % columns != columns - 1;
      const bool below = line >= columns;
      if (before)
      {
        this->Join(line, line - 1, 1, sets);
      }
      if (below)
      {
        this->Join(line, line - columns, 1, sets);
      }
      if (before && below)
      {
        this->Join(line, line - columns - 1, 0, sets);
      }
      if (behind && below)
      {
        this->Join(line, line - columns + 1, 0, sets);
      }
    }
    return sets;
  }

  std::int64_t FindRun(std::int64_t node) const
  {
    const auto line = static_cast<std::size_t>(node / this->Width);
    const auto first = this->Runs.begin() + static_cast<std::ptrdiff_t>(this->Start[line]);
    const auto last = this->Runs.begin() + static_cast<std::ptrdiff_t>(this->Start[line + 1]);
    const auto after = std::upper_bound(
      first, last, node, [](std::int64_t n, const Run& run) { return n < run.First; });
    return after - this->Runs.begin() - 1;
  }

private:
  void AddLine(const std::vector<unsigned char>& inside, std::int64_t first)
  {
    const auto begin = inside.begin() + first;
    const auto end = begin + this->Width;
    auto from = std::find(begin, end, 0);
    while (from != end)
    {
      const auto to = std::find_if(from, end, [](unsigned char in) { return in != 0; });
      this->Runs.push_back({ from - inside.begin(), to - inside.begin() });
      from = std::find(to, end, 0);
    }
  }

  /// Joins runs of two lines that come within `reach` nodes of each other along x.
  void Join(std::int64_t line, std::int64_t other, std::int64_t reach,
    DisjointSets<std::int64_t>& sets) const
  {
    const std::int64_t shift = (line - other) * this->Width;
    std::size_t a = this->Start[static_cast<std::size_t>(line)];
    std::size_t b = this->Start[static_cast<std::size_t>(other)];
    const std::size_t aEnd = this->Start[static_cast<std::size_t>(line) + 1];
    const std::size_t bEnd = this->Start[static_cast<std::size_t>(other) + 1];
    while (a < aEnd && b < bEnd)
    {
      const Run& here = this->Runs[a];
      const Run there{ this->Runs[b].First + shift, this->Runs[b].Last + shift };
      if (here.First < there.Last + reach && there.First < here.Last + reach)
      {
        sets.Join(static_cast<std::int64_t>(a), static_cast<std::int64_t>(b));
      }
      here.Last < there.Last ? ++a : ++b;
    }
  }

  std::int64_t Width;
  std::vector<Run> Runs;
  std::vector<std::size_t> Start; ///< of each line's runs, and the end
};

}

std::vector<std::vector<std::int64_t>> FindCavityWalls(const SolverBox& box,
  const std::vector<unsigned char>& inside, const std::vector<InterfaceCrossing>& crossings)
{
  const OutsideRuns runs(box, inside);
  DisjointSets<std::int64_t> sets = runs.Components(box);
  const std::int64_t open = sets.Find(0); // the first node is on the border
  std::vector<std::vector<std::int64_t>> walls;
  std::unordered_map<std::int64_t, std::size_t> wallOf;
  for (std::size_t c = 0; c < crossings.size(); ++c)
  {
    const InterfaceCrossing& crossing = crossings[c];
    const bool lowerInside = inside[static_cast<std::size_t>(crossing.Node)] != 0;
    const std::int64_t step = box.Steps()[static_cast<std::size_t>(crossing.Axis)];
    const std::int64_t root = sets.Find(runs.FindRun(crossing.Node + (lowerInside ? step : 0)));
    if (root != open)
    {
      const auto found = wallOf.emplace(root, walls.size()).first;
      walls.resize(wallOf.size());
      walls[found->second].push_back(static_cast<std::int64_t>(c));
    }
  }
  return walls;
}

namespace
{

/// A sum over nodes under construction: columns may occur more than once.
struct FluxSum
{
  std::vector<std::pair<std::int64_t, double>> Entries;
  double RightSide = 0.0;

  void Add(std::int64_t node, double factor) { this->Entries.emplace_back(node, factor); }
  void Add(const InterfaceExtrapolation& values, const Continuation& v, double factor)
  {
    for (std::size_t i = 0; i < v.Coefficient.size(); ++i)
    {
      if (v.Coefficient[i] != 0.0)
      {
        this->Add(values.Id[i], factor * v.Coefficient[i]);
      }
    }
    this->RightSide -= factor * v.Constant;
  }
  /// Moves the sum into a cavity, with each column once.
  void Move(CavityFlux& cavity)
  {
    std::stable_sort(this->Entries.begin(), this->Entries.end(),
      [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [node, value] : this->Entries)
    {
      if (cavity.Column.empty() || cavity.Column.back() != node)
      {
        cavity.Column.push_back(node);
        cavity.Value.push_back(0.0);
      }
      cavity.Value.back() += value;
    }
    cavity.RightSide = this->RightSide;
  }
};

/// Adds F+ - F- of a crossing; returns its node outside.
std::int64_t AddExcess(const InterfaceProblem& problem, const InterfaceCrossing& c,
  const InterfaceExtrapolation& values, FluxSum& sum)
{
  const auto a = static_cast<std::size_t>(c.Axis);
  const double weight = AxisWeights(*problem.Box)[a];
  const std::int64_t upper = c.Node + problem.Box->Steps()[a];
  const bool lowerInside = (*problem.Inside)[static_cast<std::size_t>(c.Node)] != 0;
  const std::int64_t outer = lowerInside ? upper : c.Node;
  sum.Add(values, lowerInside ? values.AtLower : values.AtUpper,
    weight * problem.Medium.SolventDielectric);
  sum.Add(outer, -weight * problem.Medium.SolventDielectric);
  sum.Add(lowerInside ? c.Node : upper, -weight * problem.Medium.SoluteDielectric);
  sum.Add(values, lowerInside ? values.AtUpper : values.AtLower,
    weight * problem.Medium.SoluteDielectric);
  return outer;
}

/// Rows and shares of the nodes that the wall's edges end at, one entry of `outer` for each edge.
void SetShares(
  std::vector<std::int64_t>& outer, const std::vector<std::int64_t>& nodes, CavityFlux& cavity)
{
  std::sort(outer.begin(), outer.end());
  for (auto first = outer.begin(); first != outer.end();)
  {
    const auto last = std::upper_bound(first, outer.end(), *first);
    cavity.Row.push_back(std::lower_bound(nodes.begin(), nodes.end(), *first) - nodes.begin());
    cavity.Share.push_back(static_cast<double>(last - first) / static_cast<double>(outer.size()));
    first = last;
  }
}

}

// The sum of the equations of a cavity's nodes states that the flux through its wall equals the
// charge of its ions, with fluxes F+ that a fit has only up to its truncation error times eps_s. F-
// differs from them edge by edge, but by the divergence theorem not in the sum: eps d_n phi goes
// through the surface, and either function's flux through it is that through the edges. The error
// of F- is smaller by eps_s / eps_m, and F- is the flux in the equations inside, so no flux is lost
// between the two sides.
std::vector<CavityFlux> CavityFluxes(const InterfaceProblem& problem,
  const std::vector<InterfaceExtrapolation>& values, const std::vector<std::int64_t>& nodes)
{
  std::vector<CavityFlux> cavities;
  for (const std::vector<std::int64_t>& wall : problem.Cavities)
  {
    cavities.emplace_back();
    FluxSum sum;
    std::vector<std::int64_t> outer;
    for (const std::int64_t crossing : wall)
    {
      const auto c = static_cast<std::size_t>(crossing);
      outer.push_back(AddExcess(problem, (*problem.Crossings)[c], values[c], sum));
    }
    sum.Move(cavities.back());
    SetShares(outer, nodes, cavities.back());
  }
  return cavities;
}

}
