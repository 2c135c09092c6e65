#include "Electrostatics/InterfaceMatrixRows.h"

#include "Core/ParallelFor.h"

#include <cmath>
#include <limits>

namespace isthmus
{
namespace
{

/// One row under construction: entries in a small box around the node.
class RowBuilder
{
public:
  explicit RowBuilder(const SolverBox& box)
    : Steps(box.Steps())
    , Weights(AxisWeights(box))
  {
  }

  void Begin(std::int64_t node)
  {
    this->Node = node;
    this->Entries.clear();
    this->Right = 0.0;
  }
  void Add(std::int64_t column, double value)
  {
    for (auto& entry : this->Entries)
    {
      if (entry.first == column)
      {
        entry.second += value;
        return;
      }
    }
    this->Entries.emplace_back(column, value);
  }
  void Add(const InterfaceExtrapolation& values, const Continuation& v, double factor)
  {
    for (std::size_t i = 0; i < v.Coefficient.size(); ++i)
    {
      if (v.Coefficient[i] != 0.0)
      {
        this->Add(values.Id[i], factor * v.Coefficient[i]);
      }
    }
    this->Right -= factor * v.Constant;
  }

  std::array<std::int64_t, 3> Steps;
  Point3 Weights;
  std::int64_t Node = 0;
  std::vector<std::pair<std::int64_t, double>> Entries;
  double Right = 0.0;
};

/// Index of the crossing on the edge from `node` along `axis`.
std::size_t FindCrossing(const std::vector<InterfaceCrossing>& all, std::int64_t node, int axis)
{
  const auto found = std::lower_bound(all.begin(), all.end(), std::make_pair(node, axis),
    [](const InterfaceCrossing& c, const std::pair<std::int64_t, int>& key)
    { return c.Node != key.first ? c.Node < key.first : c.Axis < key.second; });
  return static_cast<std::size_t>(found - all.begin());
}

void BuildRow(const InterfaceProblem& problem, const std::vector<InterfaceExtrapolation>& values,
  RowBuilder& row, double& preconditioner)
{
  const auto& inside = *problem.Inside;
  const bool here = inside[static_cast<std::size_t>(row.Node)] != 0;
  const FitMedium& m = problem.Medium;
  const double eps = here ? m.SoluteDielectric : m.SolventDielectric;
  preconditioner = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    const double w = eps * row.Weights[a];
    row.Add(row.Node, 2.0 * w);
    for (const std::int64_t step : { -row.Steps[a], row.Steps[a] })
    {
      const std::int64_t other = row.Node + step;
      if ((inside[static_cast<std::size_t>(other)] != 0) == here)
      {
        row.Add(other, -w);
        preconditioner += w;
        continue;
      }
      const std::size_t c = FindCrossing(*problem.Crossings, std::min(row.Node, other), axis);
      row.Add(values[c], step > 0 ? values[c].AtUpper : values[c].AtLower, -w);
      const double fromHere =
        step > 0 ? (*problem.Crossings)[c].Fraction : 1.0 - (*problem.Crossings)[c].Fraction;
      preconditioner += row.Weights[a] *
        SeriesPermittivity(
          m.SoluteDielectric, m.SolventDielectric, here ? fromHere : 1.0 - fromHere);
    }
  }
}

/// Nodes with a crossing on one of their edges, in increasing order.
std::vector<std::int64_t> FindIrregularNodes(
  const std::vector<InterfaceCrossing>& crossings, const std::array<std::int64_t, 3>& steps)
{
  std::vector<std::int64_t> nodes;
  nodes.reserve(2 * crossings.size());
  for (const InterfaceCrossing& c : crossings)
  {
    nodes.push_back(c.Node);
    nodes.push_back(c.Node + steps[static_cast<std::size_t>(c.Axis)]);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// Rows [first, last) of the matrix, appended to `part`.
void AssembleRange(const InterfaceProblem& problem,
  const std::vector<InterfaceExtrapolation>& values, const std::vector<std::int64_t>& nodes,
  std::int64_t first, std::int64_t last, InterfaceMatrixRows& part)
{
  RowBuilder row(*problem.Box);
  for (std::int64_t r = first; r < last; ++r)
  {
    row.Begin(nodes[static_cast<std::size_t>(r)]);
    double wanted = 0.0;
    BuildRow(problem, values, row, wanted);
    const double diagonal = row.Entries.front().second; // the node itself is the first entry
    // A diagonal that the fits have nearly cancelled does not measure the row.
    const double scale = diagonal > 0.1 * wanted ? wanted / diagonal : 1.0;
    part.Start.push_back(static_cast<std::int64_t>(part.Column.size()));
    for (const auto& [column, value] : row.Entries)
    {
      part.Column.push_back(static_cast<std::int32_t>(column - row.Node));
      part.Value.push_back(scale * value);
    }
    part.RightSide.push_back(scale * row.Right);
    part.Scale.push_back(scale);
    part.Diagonal.push_back(scale * diagonal);
  }
}

/// Reserves the memory to be appended: growth by doubling would need twice as much at the peak.
void Reserve(const std::vector<InterfaceMatrixRows>& parts, InterfaceMatrixRows& all)
{
  std::size_t entries = 0;
  for (const InterfaceMatrixRows& part : parts)
  {
    entries += part.Column.size();
  }
  all.Start.reserve(all.Node.size() + 1);
  all.Column.reserve(entries);
  all.Value.reserve(entries);
  all.RightSide.reserve(all.Node.size());
  all.Scale.reserve(all.Node.size());
  all.Diagonal.reserve(all.Node.size());
}

void Append(const InterfaceMatrixRows& part, InterfaceMatrixRows& all)
{
  const auto offset = static_cast<std::int64_t>(all.Column.size());
  for (const std::int64_t start : part.Start)
  {
    all.Start.push_back(start + offset);
  }
  const auto append = [](auto& to, const auto& from)
  { to.insert(to.end(), from.begin(), from.end()); };
  append(all.Column, part.Column);
  append(all.Value, part.Value);
  append(all.RightSide, part.RightSide);
  append(all.Scale, part.Scale);
  append(all.Diagonal, part.Diagonal);
}

}

InterfaceMatrixRows AssembleIrregularRows(
  const InterfaceProblem& problem, const ProgressCallback& progress)
{
  const auto count = static_cast<std::int64_t>(problem.Crossings->size());
  std::vector<InterfaceExtrapolation> values(static_cast<std::size_t>(count));
  ParallelFor(
    0, count, 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t c = first; c < last; ++c)
      {
        values[static_cast<std::size_t>(c)] =
          ValuesAtCrossing(problem, static_cast<std::size_t>(c));
      }
    },
    Between(progress, 0.0, 0.7));
  InterfaceMatrixRows rows;
  rows.Node = FindIrregularNodes(*problem.Crossings, problem.Box->Steps());
  const auto total = static_cast<std::int64_t>(rows.Node.size());
  constexpr std::int64_t block = 1024;
  std::vector<InterfaceMatrixRows> parts(static_cast<std::size_t>((total + block - 1) / block));
  ParallelFor(
    0, static_cast<std::int64_t>(parts.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t p = first; p < last; ++p)
      {
        AssembleRange(problem, values, rows.Node, p * block, std::min(total, (p + 1) * block),
          parts[static_cast<std::size_t>(p)]);
      }
    },
    Between(progress, 0.7, 1.0));
  for (const InterfaceExtrapolation& v : values)
  {
    rows.LinearFits += v.Quality == FitQuality::Linear ? 1 : 0;
    rows.GhostFits += v.Quality == FitQuality::None ? 1 : 0;
  }
  rows.Cavities = CavityFluxes(problem, values, rows.Node);
  values = {};
  Reserve(parts, rows);
  for (InterfaceMatrixRows& part : parts)
  {
    Append(part, rows);
    part = {};
  }
  rows.Start.push_back(static_cast<std::int64_t>(rows.Column.size()));
  return rows;
}

}
