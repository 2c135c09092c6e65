#include "Electrostatics/CavityFlux.h"

#include <algorithm>

namespace isthmus
{
namespace
{

/// A sum over nodes under construction: columns may come more than once.
struct FluxSum
{
  std::vector<std::pair<std::int64_t, double>> Entries;
  double RightSide = 0.0;

  void Add(std::int64_t node, double factor) { this->Entries.emplace_back(node, factor); }
  void Add(const CrossingValues& values, const Continuation& v, double factor)
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
  /// Moves it into a cavity, each column once.
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
  const CrossingValues& values, FluxSum& sum)
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

std::vector<CavityFlux> CavityFluxes(const InterfaceProblem& problem,
  const std::vector<CrossingValues>& values, const std::vector<std::int64_t>& nodes)
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
