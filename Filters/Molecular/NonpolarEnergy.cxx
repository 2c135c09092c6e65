#include "NonpolarEnergy.h"

#include "FlowBand.h"
#include "LevelMeasure.h"
#include "NearestBall.h"
#include "ParallelFor.h"
#include "Pi.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

using Place = std::array<double, 3>;

constexpr double Near = 12.0;    // angstrom, within which an atom sees single nodes
constexpr std::int64_t Side = 8; // nodes along a block

/// An inside node's share of its cell, or a block of them.
struct Piece
{
  Place At{};
  double Volume = 0.0;
};

struct Block
{
  Piece Whole;
  std::vector<Piece> Nodes;
};

Place PlaceOf(const DensityGrid& grid, std::int64_t i, std::int64_t j, std::int64_t k)
{
  return { grid.Origin[0] + grid.Spacing * static_cast<double>(i),
    grid.Origin[1] + grid.Spacing * static_cast<double>(j),
    grid.Origin[2] + grid.Spacing * static_cast<double>(k) };
}

/// The part of a node's cell that is inside.
double Inside(float distance, double spacing)
{
  return std::clamp(0.5 - static_cast<double>(distance) / spacing, 0.0, 1.0);
}

Block BlockAt(const DensityGrid& grid, const float* distance, std::array<std::int64_t, 3> first)
{
  Block block;
  const auto& n = grid.Dimensions;
  const double cell = std::pow(grid.Spacing, 3);
  for (std::int64_t k = first[2]; k < std::min(first[2] + Side, n[2]); ++k)
  {
    for (std::int64_t j = first[1]; j < std::min(first[1] + Side, n[1]); ++j)
    {
      for (std::int64_t i = first[0]; i < std::min(first[0] + Side, n[0]); ++i)
      {
        const double volume = cell * Inside(distance[i + n[0] * (j + n[1] * k)], grid.Spacing);
        if (volume > 0.0)
        {
          block.Nodes.push_back({ PlaceOf(grid, i, j, k), volume });
          block.Whole.Volume += volume;
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            block.Whole.At[axis] += volume * block.Nodes.back().At[axis];
          }
        }
      }
    }
  }
  for (double& at : block.Whole.At)
  {
    at /= std::max(block.Whole.Volume, 1e-300);
  }
  return block;
}

std::vector<Block> BlocksOf(const DensityGrid& grid, const float* distance)
{
  std::array<std::int64_t, 3> counts;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    counts[axis] = (grid.Dimensions[axis] + Side - 1) / Side;
  }
  std::vector<Block> blocks(static_cast<std::size_t>(counts[0] * counts[1] * counts[2]));
  ParallelFor(0, static_cast<std::int64_t>(blocks.size()), 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t b = first; b < last; ++b)
      {
        blocks[static_cast<std::size_t>(b)] = BlockAt(grid, distance,
          { Side * (b % counts[0]), Side * (b / counts[0] % counts[1]),
            Side * (b / (counts[0] * counts[1])) });
      }
    });
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                 [](const Block& block) { return block.Nodes.empty(); }),
    blocks.end());
  return blocks;
}

double Squared(const Place& a, const Place& b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
    (a[2] - b[2]) * (a[2] - b[2]);
}

/// The integral of a pair over the inside.
double InsideIntegral(
  const Place& centre, const DispersionPair& pair, const std::vector<Block>& blocks, double radius)
{
  double sum = 0.0;
  const double near = Near + radius;
  for (const Block& block : blocks)
  {
    const double squared = Squared(centre, block.Whole.At);
    if (squared > near * near)
    {
      sum += block.Whole.Volume * pair.At(squared);
      continue;
    }
    for (const Piece& node : block.Nodes)
    {
      sum += node.Volume * pair.At(Squared(centre, node.At));
    }
  }
  return sum;
}

/// Shares of area (not yet to scale) and volume, by the nearest atom of each node.
void ShareOut(const std::vector<Ball>& balls, const DensityGrid& grid, const float* distance,
  std::vector<NonpolarTerms>& atoms, const ProgressCallback& progress)
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
            nearest.At(PlaceOf(grid, node % n[0], node / n[0] % n[1], node / (n[0] * n[1]))));
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
      terms.Volume += h * h * h * Inside(distance[node], h);
      terms.Area += std::abs(at) < reach ? 1.0 + std::cos(Pi * at / reach) : 0.0;
    }
  }
}

LevelMeasure MeasureOf(const DensityGrid& grid, const float* distance)
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
  if (atoms.size() != balls.size())
  {
    throw std::invalid_argument("There are " + std::to_string(balls.size()) + " balls and " +
      std::to_string(atoms.size()) + " Lennard-Jones atoms, but they are to be the same atoms.");
  }
  NonpolarEnergies energies;
  energies.Atoms.resize(balls.size());
  if (balls.empty())
  {
    return energies;
  }
  ShareOut(balls, grid, distance, energies.Atoms, Between(progress, 0.0, 0.4));
  const std::vector<Block> blocks = BlocksOf(grid, distance);
  const double radius = 0.5 * std::sqrt(3.0) * grid.Spacing * static_cast<double>(Side);
  ParallelFor(
    0, static_cast<std::int64_t>(atoms.size()), 8,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t a = first; a < last; ++a)
      {
        const DispersionAtom& atom = atoms[static_cast<std::size_t>(a)];
        const DispersionPair pair(atom, solvent);
        const double outside = pair.Integral() - InsideIntegral(atom.Centre, pair, blocks, radius);
        energies.Atoms[static_cast<std::size_t>(a)].DispersionEnergy = solvent.Density * outside;
      }
    },
    Between(progress, 0.4, 1.0));
  Finish(MeasureOf(grid, distance), solvent, energies);
  return energies;
}

}
