#include "MolecularSurfaces/NonpolarEnergy.h"

#include "Atoms/NearestBall.h"
#include "Core/Geometry.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "MolecularSurfaces/Dispersion.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/LevelMeasure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace isthmus
{
namespace
{

using Place = std::array<double, 3>;

Place GetPosition(const DensityGrid& grid, std::int64_t i, std::int64_t j, std::int64_t k)
{
  return { grid.Origin[0] + grid.Spacing * static_cast<double>(i),
    grid.Origin[1] + grid.Spacing * static_cast<double>(j),
    grid.Origin[2] + grid.Spacing * static_cast<double>(k) };
}

/// Shares of area (not yet to scale) and volume, by the nearest atom of each node.
void DistributeShares(const std::vector<Ball>& balls, const DensityGrid& grid,
  const float* distance, std::vector<NonpolarTerms>& atoms, const ProgressCallback& progress)
{
  const auto& n = grid.Dimensions;
  const double h = grid.Spacing;
  const double reach = 1.5 * h; // of the smeared delta function
  const NearestBall nearest(balls);
  std::vector<std::int64_t> owner(static_cast<std::size_t>(n[0] * n[1] * n[2]), -1);
  ParallelFor(
    0, n[1] * n[2], 64,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = n[0] * first; node < n[0] * last; ++node)
      {
        if (static_cast<double>(distance[node]) < reach)
        {
          owner[static_cast<std::size_t>(node)] = static_cast<std::int64_t>(
            nearest.At(GetPosition(grid, node % n[0], node / n[0] % n[1], node / (n[0] * n[1]))));
        }
      }
    },
    progress);
  for (std::size_t node = 0; node < owner.size(); ++node)
  {
    if (owner[node] >= 0)
    {
      NonpolarTerms& terms = atoms[static_cast<std::size_t>(owner[node])];
      const double at = static_cast<double>(distance[node]);
      terms.Volume += h * h * h * InsidePart(distance[node], h);
      terms.Area += std::abs(at) < reach ? 1.0 + std::cos(Pi * at / reach) : 0.0;
    }
  }
}

/// Every other node.
std::pair<DensityGrid, std::vector<float>> Coarsen(const DensityGrid& grid, const float* distance)
{
  const auto& n = grid.Dimensions;
  DensityGrid coarse = grid;
  coarse.Spacing *= 2.0;
  for (std::int64_t& count : coarse.Dimensions)
  {
    count = (count + 1) / 2;
  }
  std::vector<float> values;
  for (std::int64_t k = 0; k < n[2]; k += 2)
  {
    for (std::int64_t j = 0; j < n[1]; j += 2)
    {
      for (std::int64_t i = 0; i < n[0]; i += 2)
      {
        values.push_back(distance[i + n[0] * (j + n[1] * k)]);
      }
    }
  }
  return { coarse, values };
}

LevelMeasure MeasureLevelSet(const DensityGrid& grid, const float* distance)
{
  FlowField field{ FlowGrid(grid) };
  const auto& n = grid.Dimensions;
  const auto h = static_cast<float>(grid.Spacing);
  for (std::int64_t line = 0; line < n[1] * n[2]; ++line)
  {
    std::transform(distance + n[0] * line, distance + n[0] * (line + 1),
      field.Distance.data() + field.Grid.Index(0, line % n[1], line / n[1]),
      [h](float value) { return value / h; });
  }
  FindBand(field);
  return MeasureLevel(field);
}

/// Scales the shares to the measures of the surface, and gives each its energy.
void Finish(
  const LevelMeasure& measure, const SolventParameters& solvent, NonpolarEnergies& energies)
{
  NonpolarTerms& whole = energies.Whole;
  NonpolarTerms shares;
  for (const NonpolarTerms& atom : energies.Atoms)
  {
    shares.Area += atom.Area;
    shares.Volume += atom.Volume;
    whole.DispersionEnergy += atom.DispersionEnergy;
  }
  whole.Area = measure.Area;
  whole.Volume = measure.Volume;
  whole.SurfaceEnergy = solvent.SurfaceTension * whole.Area;
  whole.VolumeEnergy = solvent.Pressure * whole.Volume;
  for (NonpolarTerms& atom : energies.Atoms)
  {
    atom.Area *= shares.Area > 0.0 ? measure.Area / shares.Area : 0.0;
    atom.Volume *= shares.Volume > 0.0 ? measure.Volume / shares.Volume : 0.0;
    atom.SurfaceEnergy = solvent.SurfaceTension * atom.Area;
    atom.VolumeEnergy = solvent.Pressure * atom.Volume;
  }
}

}

void RequireDistances(const DensityGrid& grid, const std::vector<float>& distance)
{
  const auto& n = grid.Dimensions;
  const std::array<std::int64_t, 3> steps{ 1, n[0], n[0] * n[1] };
  std::vector<double> slopes;
  for (std::int64_t node = 0; node < n[0] * n[1] * n[2]; ++node)
  {
    if (distance[static_cast<std::size_t>(node)] > 0.0F)
    {
      continue;
    }
    double square = 0.0;
    bool isAtSurface = false;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::int64_t at = node / steps[a] % n[a];
      if (at == 0 || at == n[a] - 1)
      {
        throw std::invalid_argument(std::string("The surface leaves the volume along ") + "xyz"[a] +
          ", so it is not closed: compute SignedDistance on a larger volume.");
      }
      const float before = distance[static_cast<std::size_t>(node - steps[a])];
      const float after = distance[static_cast<std::size_t>(node + steps[a])];
      isAtSurface = isAtSurface || before > 0.0F || after > 0.0F;
      square += std::pow(
        (static_cast<double>(after) - static_cast<double>(before)) / (2.0 * grid.Spacing), 2);
    }
    if (isAtSurface && std::isfinite(square))
    {
      slopes.push_back(std::sqrt(square));
    }
  }
  const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::nth_element(slopes.begin(), middle, slopes.end());
  constexpr double factor = 2.0;
  if (!slopes.empty() && (*middle > factor || *middle < 1.0 / factor))
  {
    throw std::invalid_argument("SignedDistance has a gradient of " + FormatNumber(*middle, 3) +
      " at the surface, but that of a distance is 1: give it in the unit of the volume, or compute "
      "it from the surface (Surface To Grid).");
  }
}

NonpolarEnergies NonpolarEnergy(const std::vector<Ball>& balls,
  const std::vector<DispersionAtom>& atoms, const DensityGrid& grid, const float* distance,
  const SolventParameters& solvent, const ProgressCallback& progress)
{
  Check(solvent);
  if (atoms.size() != balls.size())
  {
    throw std::invalid_argument("There are " + std::to_string(balls.size()) + " balls and " +
      std::to_string(atoms.size()) + " Lennard-Jones atoms, but they must be the same atoms.");
  }
  NonpolarEnergies energies;
  energies.Atoms.resize(balls.size());
  if (balls.empty())
  {
    return energies;
  }
  DistributeShares(balls, grid, distance, energies.Atoms, Between(progress, 0.0, 0.4));
  const std::vector<double> dispersion =
    DispersionEnergies(atoms, grid, distance, solvent, Between(progress, 0.4, 1.0));
  for (std::size_t a = 0; a < atoms.size(); ++a)
  {
    energies.Atoms[a].DispersionEnergy = dispersion[a];
  }
  const LevelMeasure measure = MeasureLevelSet(grid, distance);
  Finish(measure, solvent, energies);
  const auto [coarse, values] = Coarsen(grid, distance);
  const LevelMeasure rough = MeasureLevelSet(coarse, values.data());
  // A second order error is a third of the difference.
  constexpr double share = 0.5;
  energies.Error = share *
    (solvent.SurfaceTension * std::abs(rough.Area - measure.Area) +
      std::abs(solvent.Pressure * (rough.Volume - measure.Volume)));
  return energies;
}

}
