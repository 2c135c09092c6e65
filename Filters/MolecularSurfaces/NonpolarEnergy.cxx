#include "MolecularSurfaces/NonpolarEnergy.h"

#include "Atoms/NearestBall.h"
#include "Core/Geometry.h"
#include "Core/ParallelFor.h"
#include "MolecularSurfaces/Dispersion.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/LevelMeasure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

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
  Finish(MeasureLevelSet(grid, distance), solvent, energies);
  return energies;
}

}
