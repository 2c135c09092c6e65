#include "Electrostatics/SoluteVolume.h"

#include "Atoms/MolecularDensity.h"
#include "Core/ImageScalars.h"
#include "Core/MemoryBudget.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"
#include "Surfaces/GridDistance.h"
#include "Surfaces/GridImages.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace isthmus
{
namespace
{

/// Spacings from the level to the farthest node of a stencil at it: (3, 2, 2) from an edge's end.
constexpr double StencilReach = 4.2;

/// Width of the band in which distances are exact, in spacings: stencils reach three diagonally.
constexpr double Band = 6.0;

/// A box of more nodes along an axis is long and thin, and mostly empty.
constexpr double MostNodesAlong = 20000.0;

vtkSmartPointer<vtkImageData> MakeImage(
  const Point3& origin, const std::array<double, 3>& nodes, double spacing)
{
  const double most = *std::max_element(nodes.begin(), nodes.end());
  if (most > MostNodesAlong)
  {
    const double length = spacing * most;
    throw std::invalid_argument("The box around the molecule is " + FormatNumber(length) +
      " angstrom long: at a Spacing of " + FormatNumber(spacing) + " these are " +
      FormatNumber(most) + " nodes, more than the " + FormatNumber(MostNodesAlong) +
      " along an axis that are solved for. Choose a Spacing of at least " +
      FormatNumber(1.01 * length / MostNodesAlong, 3) +
      ", or look for atoms that lie far from the others.");
  }
  int dimensions[3];
  double all = 1.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    all *= nodes[a];
    dimensions[a] = nodes[a] < 2e9 ? static_cast<int>(nodes[a]) : 0;
  }
  if (!(all < 1e11) || dimensions[0] < 1 || dimensions[1] < 1 || dimensions[2] < 1)
  {
    throw std::invalid_argument("A Spacing of " + FormatNumber(spacing) + " makes a grid of " +
      FormatNumber(all) + " nodes, too many: choose a larger one.");
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dimensions);
  image->SetOrigin(origin[0], origin[1], origin[2]);
  image->SetSpacing(spacing, spacing, spacing);
  return image;
}

std::vector<Ball> MakeBalls(const std::vector<ChargedAtom>& atoms)
{
  std::vector<Ball> balls;
  for (const ChargedAtom& atom : atoms)
  {
    if (atom.Radius > 0.0)
    {
      balls.push_back({ atom.Position, atom.Radius });
    }
  }
  if (balls.empty())
  {
    throw std::invalid_argument(
      "No atom has a radius above 0, so there is no surface around them: connect a surface to "
      "input 1, or use atoms with radii (a PQR file).");
  }
  return balls;
}

/// Fourth differences of S and of log S across the level, over its slopes: the polynomial through
/// six nodes follows the one with the smaller ones better. Also determines whether S is clipped
/// near the level.
struct Straightness
{
  double Plain = 0.0, Logarithm = 0.0;
  bool Positive = true;
  std::int64_t Edges = 0, Flat = 0;
  std::int64_t Steps = 0; ///< edges from clipped to clipped: of a mask
};

/// The minimum and maximum, if many nodes have these values: the values were clipped there.
struct Plateaus
{
  double Low = -std::numeric_limits<double>::infinity();
  double High = std::numeric_limits<double>::infinity();

  bool Has(double s) const { return s <= this->Low || s >= this->High; }
};

Plateaus FindPlateaus(const LevelFunction& level)
{
  const auto& n = level.Dimensions();
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::int64_t atLow = 0, atHigh = 0;
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        const double s = level.Scalar(i, j, k);
        atLow = s < low ? 1 : atLow + (s == low ? 1 : 0);
        atHigh = s > high ? 1 : atHigh + (s == high ? 1 : 0);
        low = std::min(low, s);
        high = std::max(high, s);
      }
    }
  }
  // A clamped distance or a mask has many nodes at its least or greatest value, a smooth field few.
  const std::int64_t many = std::max<std::int64_t>(27, n[0] * n[1] * n[2] / 1000);
  Plateaus plateaus;
  plateaus.Low = atLow >= many ? low : plateaus.Low;
  plateaus.High = atHigh >= many ? high : plateaus.High;
  return plateaus;
}

double FourthDifferences(const double (&s)[6])
{
  const auto at = [&](int i)
  { return std::abs(s[i] - 4.0 * (s[i + 1] + s[i + 3]) + 6.0 * s[i + 2] + s[i + 4]); };
  return (at(0) + at(1)) / std::abs(s[3] - s[2]);
}

void Add(const double (&s)[6], const Plateaus& plateaus, Straightness& sum)
{
  // Nodes 0..5 along a line, the level between 2 and 3.
  sum.Plain += FourthDifferences(s);
  ++sum.Edges;
  sum.Flat += std::any_of(s, s + 6, [&](double v) { return plateaus.Has(v); }) ? 1 : 0;
  sum.Steps += plateaus.Has(s[2]) && plateaus.Has(s[3]) ? 1 : 0;
  sum.Positive = sum.Positive && std::all_of(s, s + 6, [](double v) { return v > 0.0; });
  if (sum.Positive)
  {
    double logarithms[6];
    std::transform(s, s + 6, logarithms, [](double v) { return std::log(v); });
    sum.Logarithm += FourthDifferences(logarithms);
  }
}

/// The logarithm of a node two to four steps away, continued to it, where the values fall towards
/// it; NaN elsewhere.
double ExtrapolateLogarithm(double next, double second, double third)
{
  return next > 0.0 && next < second && second < third
    ? 3.0 * std::log(next) - 3.0 * std::log(second) + std::log(third)
    : std::numeric_limits<double>::quiet_NaN();
}

/// Sums of Gaussians end where their terms were neglected, and their logarithm would jump there.
/// Nodes with the value `cut` near the level get that of a quadratic continuation of the logarithm
/// along the axes, so a mask, whose values do not decrease before they end, is unchanged. Returns
/// all values, or none, without a copy, if nothing changed.
std::vector<double> ExtrapolateTails(const LevelFunction& level, double cut)
{
  constexpr double largestTail = 0.05; // of the level, before the cut
  const auto& n = level.Dimensions();
  const std::int64_t steps[3] = { 1, n[0], n[0] * n[1] };
  std::vector<double> values;
  const auto valueAt = [&](std::int64_t node)
  {
    return values.empty() ? level.Scalar(node % n[0], node / n[0] % n[1], node / steps[2])
                          : values[static_cast<std::size_t>(node)];
  };
  const std::int64_t count = n[0] * n[1] * n[2];
  std::vector<std::int64_t> missing;
  for (std::int64_t node = 0; node < count; ++node)
  {
    if (!(valueAt(node) > cut))
    {
      missing.push_back(node);
    }
  }
  for (int sweep = 0; sweep < static_cast<int>(StencilReach); ++sweep)
  {
    std::vector<std::pair<std::int64_t, double>> found;
    for (const std::int64_t node : missing)
    {
      const std::int64_t at[3] = { node % n[0], node / n[0] % n[1], node / steps[2] };
      double sum = 0.0;
      int terms = 0;
      for (std::size_t a = 0; a < 3; ++a)
      {
        for (const int way : { -1, 1 })
        {
          if (at[a] + 3 * way < 0 || at[a] + 3 * way >= n[a])
          {
            continue;
          }
          const auto value = [&](int step) { return valueAt(node + step * way * steps[a]); };
          const bool tail = value(1) > cut && value(1) < largestTail * level.Level;
          const double continued =
            tail ? ExtrapolateLogarithm(value(1), value(2), value(3)) : std::nan("");
          sum += std::isnan(continued) ? 0.0 : continued;
          terms += std::isnan(continued) ? 0 : 1;
        }
      }
      if (terms > 0)
      {
        found.emplace_back(node, std::exp(sum / terms));
      }
    }
    if (found.empty())
    {
      break;
    }
    if (values.empty())
    {
      std::vector<double> copy(static_cast<std::size_t>(count));
      for (std::int64_t node = 0; node < count; ++node)
      {
        copy[static_cast<std::size_t>(node)] = valueAt(node);
      }
      values = std::move(copy);
    }
    for (const auto& [node, value] : found)
    {
      values[static_cast<std::size_t>(node)] = value;
    }
    missing.erase(std::remove_if(missing.begin(), missing.end(),
                    [&](std::int64_t node) { return valueAt(node) > cut; }),
      missing.end());
  }
  return values;
}

Straightness Measure(const LevelFunction& level)
{
  Straightness sum;
  const Plateaus plateaus = FindPlateaus(level);
  const auto& n = level.Dimensions();
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        const std::array<std::int64_t, 3> at{ i, j, k };
        for (std::size_t a = 0; a < 3; ++a)
        {
          if (at[a] < 2 || at[a] + 3 >= n[a])
          {
            continue;
          }
          auto next = at;
          ++next[a];
          if (level.Inside(i, j, k) == level.Inside(next[0], next[1], next[2]))
          {
            continue;
          }
          double s[6];
          for (int m = 0; m < 6; ++m)
          {
            auto p = at;
            p[a] += m - 2;
            s[m] = level.Scalar(p[0], p[1], p[2]);
          }
          Add(s, plateaus, sum);
        }
      }
    }
  }
  return sum;
}

/// Makes the level that of the signed distance from `surface` (in grid axes).
void SetDistance(SoluteVolume& volume, vtkPolyData* surface,
  const std::vector<unsigned char>* sides, const ProgressCallback& progress)
{
  const GridShape shape = GetGridShape(volume.Grid);
  const PolyDataTriangles triangles(surface);
  const std::vector<unsigned char> inside =
    sides ? *sides : NodesInside(triangles.View(), shape, MakeWorldTransform(volume.Grid));
  const double h = *std::max_element(shape.Spacing.begin(), shape.Spacing.end());
  volume.Doubles = DistanceToSurface(triangles.View(), shape, Band * h, progress);
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    // A node on the surface stays outside, as in the level.
    volume.Doubles[i] = inside[i] ? -std::max(volume.Doubles[i], 1e-12 * h) : volume.Doubles[i];
  }
  volume.Level = LevelFunction{};
  volume.Level.Doubles = { volume.Doubles.data(), shape.Dimensions, shape.Spacing };
  volume.Level.InsideIsHigher = false;
}

vtkSmartPointer<vtkImageData> CopyGridStructure(vtkImageData* image)
{
  auto grid = vtkSmartPointer<vtkImageData>::New();
  grid->CopyStructure(image);
  return grid;
}

}

vtkSmartPointer<vtkImageData> GridAroundSurface(vtkPolyData* surface, const GridRequest& request)
{
  Check(request);
  double box[6];
  if (!ComputePolygonBounds(surface, box))
  {
    throw std::invalid_argument("The surface has no polygons, so it has no inside.");
  }
  Point3 origin;
  std::array<double, 3> nodes;
  for (std::size_t a = 0; a < 3; ++a)
  {
    origin[a] = box[2 * a] - request.Padding;
    nodes[a] = std::ceil((box[2 * a + 1] + request.Padding - origin[a]) / request.Spacing) + 1.0;
  }
  return MakeImage(origin, nodes, request.Spacing);
}

vtkSmartPointer<vtkImageData> GridAroundAtoms(
  const std::vector<ChargedAtom>& atoms, const GridRequest& request)
{
  Check(request);
  const DensityGrid grid = GridAroundBalls(
    MakeBalls(atoms), request.Spacing, { request.Padding, request.Padding, request.Padding });
  return MakeImage(grid.Origin,
    { static_cast<double>(grid.Dimensions[0]), static_cast<double>(grid.Dimensions[1]),
      static_cast<double>(grid.Dimensions[2]) },
    request.Spacing);
}

SoluteVolume VolumeFromImage(vtkImageData* image, vtkDataArray* scalars, double level,
  bool insideIsHigher, const ProgressCallback& progress)
{
  SoluteVolume volume;
  volume.Grid = CopyGridStructure(image);
  volume.Scalars = scalars;
  volume.Kind = std::string("level ") + FormatNumber(level) + " of " +
    (scalars->GetName() ? scalars->GetName() : "the scalars");
  GetGridShape(image);
  RequireUsualValues(scalars);
  UseScalars(image, scalars,
    [&](const auto& grid)
    {
      CheckFinite(grid);
      using T = std::remove_const_t<std::remove_pointer_t<decltype(grid.Data)>>;
      if constexpr (std::is_same_v<T, float>)
      {
        volume.Level.Floats = grid;
      }
      else if (vtkArrayDownCast<vtkDoubleArray>(scalars))
      {
        volume.Level.Doubles = grid;
      }
      else
      {
        // The view's values are a temporary copy.
        volume.Doubles.assign(grid.Data, grid.Data + grid.Size());
        volume.Level.Doubles = { volume.Doubles.data(), grid.Dimensions, grid.Spacing };
      }
    });
  volume.Level.Level = level;
  volume.Level.InsideIsHigher = insideIsHigher;
  const Plateaus plateaus = FindPlateaus(volume.Level);
  if (insideIsHigher && level > 0.0 && plateaus.Low >= 0.0)
  {
    std::vector<double> continued = ExtrapolateTails(volume.Level, plateaus.Low);
    if (!continued.empty())
    {
      volume.Doubles = std::move(continued);
      volume.Level.Doubles = { volume.Doubles.data(), volume.Level.Dimensions(),
        volume.Level.Spacing() };
      volume.Level.Floats = {};
    }
  }
  const Straightness straight = Measure(volume.Level);
  if (straight.Flat * 20 > straight.Edges)
  {
    std::vector<unsigned char> inside(static_cast<std::size_t>(image->GetNumberOfPoints()));
    const auto& n = volume.Level.Dimensions();
    for (std::size_t node = 0; node < inside.size(); ++node)
    {
      const auto p = static_cast<std::int64_t>(node);
      inside[node] = volume.Level.Inside(p % n[0], p / n[0] % n[1], p / (n[0] * n[1])) ? 1 : 0;
    }
    SetDistance(volume, IsosurfaceInGridAxes(image, scalars, level), &inside, progress);
    volume.Kind += ", by distance since the values are cut off near it";
    volume.IsMask = straight.Steps * 2 > straight.Edges;
    return volume;
  }
  volume.Level.Logarithm = level > 0.0 && straight.Positive && straight.Logarithm < straight.Plain;
  return volume;
}

SoluteVolume VolumeFromSurface(
  vtkPolyData* surface, const GridRequest& request, const ProgressCallback& progress)
{
  SoluteVolume volume;
  volume.Grid = GridAroundSurface(surface, request);
  volume.Kind = "closed polygons";
  MemoryBudget().RequireGrid(GetGridShape(volume.Grid).Dimensions, SolutionBytesPerNode,
    "choose a larger Spacing or a smaller Padding");
  SetDistance(volume, InGridAxes(surface, volume.Grid), nullptr, progress);
  return volume;
}

SoluteVolume VolumeFromAtoms(
  const std::vector<ChargedAtom>& atoms, vtkImageData* grid, const ProgressCallback& progress)
{
  constexpr double decay = 2.3;
  SoluteVolume volume;
  volume.Grid = grid;
  volume.Decay = decay;
  volume.Kind = "level 1 of a sum of Gaussians, decay 2.3";
  const GridShape shape = GetGridShape(volume.Grid);
  MemoryBudget().RequireGrid(
    shape.Dimensions, SolutionBytesPerNode, "choose a larger Spacing or a smaller Padding");
  volume.Floats.resize(static_cast<std::size_t>(shape.Size()));
  Point3 origin;
  volume.Grid->GetOrigin(origin.data());
  GaussianLevel(MakeBalls(atoms), decay, StencilReach, origin,
    { volume.Floats.data(), shape.Dimensions, shape.Spacing }, progress);
  volume.Level.Floats = { volume.Floats.data(), shape.Dimensions, shape.Spacing };
  volume.Level.InsideIsHigher = false;
  return volume;
}

Point3 ToGrid(vtkImageData* grid, const Point3& world)
{
  const int* const extent = grid->GetExtent();
  Point3 index;
  grid->TransformPhysicalPointToContinuousIndex(world.data(), index.data());
  for (std::size_t a = 0; a < 3; ++a)
  {
    index[a] = (index[a] - extent[2 * a]) * grid->GetSpacing()[a];
  }
  return index;
}

Point3 ToWorld(vtkImageData* grid, const Point3& place)
{
  const int* const extent = grid->GetExtent();
  Point3 index, world;
  for (std::size_t a = 0; a < 3; ++a)
  {
    index[a] = place[a] / grid->GetSpacing()[a] + extent[2 * a];
  }
  grid->TransformContinuousIndexToPhysicalPoint(index.data(), world.data());
  return world;
}

}
