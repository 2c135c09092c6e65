#include "Persistence/AtomDistanceGrid.h"

#include "Core/MemoryBudget.h"
#include "Core/RangeChecks.h"
#include "Persistence/CubicalPersistence.h"
#include "Persistence/FastMarching.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

void CheckAtoms(const std::vector<Point3>& atoms, const std::vector<double>& scales)
{
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    if (!std::isfinite(atoms[i][0] + atoms[i][1] + atoms[i][2]))
    {
      throw std::invalid_argument("Atom " + std::to_string(i) +
        " has a coordinate that is not a "
        "finite number.");
    }
    if (!scales.empty() && (!(scales[i] > 0.0) || std::isinf(scales[i])))
    {
      throw std::invalid_argument("Atom " + std::to_string(i) + " has the radius " +
        FormatNumber(scales[i]) + ", but distances are divided by it: set a positive one.");
    }
  }
}

AtomDistances GridAround(const std::vector<Point3>& atoms, double reach, double spacing)
{
  AtomDistances grid;
  grid.Spacing = spacing;
  double nodes = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto ends = std::minmax_element(atoms.begin(), atoms.end(),
      [axis](const Point3& a, const Point3& b) { return a[axis] < b[axis]; });
    const double low = (*ends.first)[axis] - reach;
    const double cells = std::ceil(((*ends.second)[axis] + reach - low) / spacing);
    nodes *= cells + 1.0;
    if (!(nodes < 2147483648.0))
    {
      throw std::runtime_error("A Spacing of " + FormatNumber(spacing) +
        " makes a grid of more than 2^31 nodes: choose a larger one.");
    }
    grid.Origin[axis] = low;
    grid.Dimensions[axis] = static_cast<std::int64_t>(cells) + 1;
  }
  constexpr double bytes = 16.0; // for each node, with the pairs of its persistence
  MemoryBudget().RequireGrid(grid.Dimensions, bytes, "choose a larger Spacing");
  return grid;
}

/// Lowers the nodes within `reach` of an atom to their distance over `scale`.
void AddAtom(const Point3& atom, double scale, double reach, AtomDistances& grid)
{
  std::array<std::int64_t, 3> low{};
  std::array<std::int64_t, 3> high{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double at = (atom[axis] - grid.Origin[axis]) / grid.Spacing;
    const double steps = reach / grid.Spacing;
    low[axis] = std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(at - steps)));
    high[axis] = std::min<std::int64_t>(
      grid.Dimensions[axis] - 1, static_cast<std::int64_t>(std::floor(at + steps)));
  }
  for (std::int64_t k = low[2]; k <= high[2]; ++k)
  {
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
    {
      for (std::int64_t i = low[0]; i <= high[0]; ++i)
      {
        const double x = grid.Origin[0] + grid.Spacing * static_cast<double>(i) - atom[0];
        const double y = grid.Origin[1] + grid.Spacing * static_cast<double>(j) - atom[1];
        const double z = grid.Origin[2] + grid.Spacing * static_cast<double>(k) - atom[2];
        float& value = grid.Values[static_cast<std::size_t>(
          i + grid.Dimensions[0] * (j + grid.Dimensions[1] * k))];
        value = std::min(value, static_cast<float>(std::sqrt(x * x + y * y + z * z) / scale));
      }
    }
  }
}

/// Fast marching from the nodes round the atoms of one type, whose distances are exact.
void MarchType(const std::vector<Point3>& atoms, double scale, double theta, AtomDistances& grid)
{
  AtomDistances own = grid;
  const auto far = static_cast<float>(theta);
  std::fill(own.Values.begin(), own.Values.end(), far);
  for (const Point3& atom : atoms)
  {
    AddAtom(atom, scale, 1.0001 * std::sqrt(3.0) * grid.Spacing, own);
  }
  std::vector<std::int64_t> known;
  for (std::size_t i = 0; i < own.Values.size(); ++i)
  {
    if (own.Values[i] < far)
    {
      known.push_back(static_cast<std::int64_t>(i));
    }
  }
  FastMarch(own.Dimensions, own.Spacing / scale, known, far, own.Values);
  std::transform(own.Values.begin(), own.Values.end(), grid.Values.begin(), grid.Values.begin(),
    [](float a, float b) { return std::min(a, b); });
}

}

void Check(const GridDistanceParameters& parameters)
{
  RequireAbove("Spacing", parameters.Spacing, 0.0, LargestLength, "It is a length.");
  RequireAbove("Theta", parameters.Theta, 0.0, LargestLength, "It is a length.");
}

AtomDistances AtomDistance(const std::vector<Point3>& atoms, const std::vector<double>& scales,
  const GridDistanceParameters& parameters, const ProgressCallback& progress)
{
  Check(parameters);
  CheckAtoms(atoms, scales);
  if (atoms.empty())
  {
    return {};
  }
  const double largest = scales.empty() ? 1.0 : *std::max_element(scales.begin(), scales.end());
  const double theta = parameters.Theta;
  AtomDistances grid = GridAround(atoms, theta * largest + parameters.Spacing, parameters.Spacing);
  grid.Values.assign(
    static_cast<std::size_t>(grid.Dimensions[0] * grid.Dimensions[1] * grid.Dimensions[2]),
    static_cast<float>(theta));
  if (!parameters.FastMarching)
  {
    for (std::size_t i = 0; i < atoms.size(); ++i)
    {
      const double scale = scales.empty() ? 1.0 : scales[i];
      AddAtom(atoms[i], scale, theta * scale, grid);
      Report(progress, static_cast<double>(i + 1) / static_cast<double>(atoms.size()));
    }
    return grid;
  }
  std::map<double, std::vector<Point3>> types;
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    types[scales.empty() ? 1.0 : scales[i]].push_back(atoms[i]);
  }
  std::size_t done = 0;
  for (const auto& type : types)
  {
    MarchType(type.second, type.first, theta, grid);
    Report(progress, static_cast<double>(++done) / static_cast<double>(types.size()));
  }
  return grid;
}

std::vector<DistanceBar> GridBars(const std::vector<Point3>& atoms,
  const std::vector<double>& scales, const GridDistanceParameters& parameters,
  const ProgressCallback& progress)
{
  const AtomDistances grid = AtomDistance(atoms, scales, parameters, Between(progress, 0.0, 0.5));
  const VolumeView volume(grid.Values.data(), grid.Dimensions);
  std::vector<DistanceBar> bars;
  for (const CubicalPair& pair : CubicalPersistence(volume, {}, Between(progress, 0.5, 1.0)).Pairs)
  {
    if (pair.Dimension > 0)
    {
      // A bar that reaches Theta there ends at Theta itself, not at its float.
      const double death = volume.Value(pair.Death.Node());
      bars.push_back({ pair.Dimension, volume.Value(pair.Birth.Node()),
        death < static_cast<float>(parameters.Theta) ? death : parameters.Theta });
    }
  }
  SortBars(bars);
  return bars;
}

void SortBars(std::vector<DistanceBar>& bars)
{
  std::sort(bars.begin(), bars.end(),
    [](const DistanceBar& a, const DistanceBar& b)
    {
      return a.Dimension != b.Dimension ? a.Dimension < b.Dimension
        : a.Length() != b.Length()      ? a.Length() > b.Length()
        : a.Birth != b.Birth            ? a.Birth < b.Birth
                                        : a.Death < b.Death;
    });
}

}
