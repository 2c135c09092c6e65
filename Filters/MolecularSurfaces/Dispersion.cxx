#include "MolecularSurfaces/Dispersion.h"

#include "Atoms/BallBricks.h"
#include "Core/Geometry.h"
#include "Core/ParallelFor.h"
#include "Core/VectorClones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double CutOff =
  10.0; // angstrom; beyond, a pair contributes less than 1/1000 of its depth

/// Adds the energy of one pair to a row of nodes, the first `x` spacings from the atom along the
/// row, all with the squared distance `rest` across.
ISTHMUS_VECTOR_CLONES void AddRow(
  const DispersionPair& pair, double h, double x, double rest, int count, float* to)
{
  const double squared = pair.Minimum * pair.Minimum / (h * h);
  const double depth = pair.Depth;
  for (int i = 0; i < count; ++i)
  {
    const double along = x + static_cast<double>(i);
    const double r2 = along * along + rest;
    const double ratio = squared / (r2 > squared ? r2 : squared);
    const double sixth = ratio * ratio * ratio;
    to[i] += static_cast<float>(depth * (sixth * sixth - 2.0 * sixth));
  }
}

/// Adds the energy of one pair to the nodes of a brick. Lengths in angstrom, except for the ball.
void AddPair(const FlowGrid& grid, const Ball& ball, const DispersionPair& pair, const Brick& brick,
  std::vector<float>& energy)
{
  const double h = grid.Spacing();
  ForEachRow(ball, brick,
    [&](const NodeRange& row, std::int64_t j, std::int64_t k, double y, double z)
    {
      float* to = energy.data() + grid.Row() * j + grid.Plane() * k;
      AddRow(pair, h, static_cast<double>(row.First) - ball.Center[0], y * y + z * z,
        static_cast<int>(row.Last - row.First), to + row.First);
    });
}

void AddEnergy(const FlowGrid& grid, const std::vector<DispersionAtom>& atoms,
  const SolventParameters& solvent, std::vector<float>& energy)
{
  const double h = grid.Spacing();
  const std::array<double, 3> origin = grid.Origin();
  // Bricks sort equal balls by position: the pairs are sorted in the same order.
  std::vector<DispersionAtom> sorted = atoms;
  std::sort(sorted.begin(), sorted.end(),
    [](const DispersionAtom& a, const DispersionAtom& b)
    {
      return std::tie(a.Center[2], a.Center[1], a.Center[0], a.WellDepth, a.Radius) <
        std::tie(b.Center[2], b.Center[1], b.Center[0], b.WellDepth, b.Radius);
    });
  std::vector<Ball> balls;
  std::vector<DispersionPair> pairs;
  for (const DispersionAtom& atom : sorted)
  {
    Ball ball{ {}, CutOff / h };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      ball.Center[axis] = (atom.Center[axis] - origin[axis]) / h;
    }
    balls.push_back(ball);
    pairs.emplace_back(atom, solvent);
  }
  const BallBricks bricks(balls, 1.0, grid.Dimensions());
  ParallelFor(0, bricks.Size(), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t b = first; b < last; ++b)
      {
        const Brick brick = bricks.At(b);
        bricks.ForEachIndex(
          b, [&](std::size_t atom) { AddPair(grid, balls[atom], pairs[atom], brick, energy); });
      }
    });
}

}

DispersionPair::DispersionPair(const DispersionAtom& atom, const SolventParameters& solvent)
  : Minimum(atom.Radius + solvent.SolventRadius)
  , Depth(std::sqrt(atom.WellDepth * solvent.SolventWellDepth))
{
}

double DispersionPair::At(double squaredDistance) const
{
  const double squared = this->Minimum * this->Minimum;
  if (squaredDistance < squared)
  {
    return -this->Depth;
  }
  const double ratio = squared / squaredDistance;
  const double sixth = ratio * ratio * ratio;
  return this->Depth * (sixth * sixth - 2.0 * sixth);
}

double DispersionPair::Integral() const
{
  // 4 pi m^3 eps (-1/3 + 1/9 - 2/3), by powers of r.
  return -32.0 / 9.0 * Pi * std::pow(this->Minimum, 3) * this->Depth;
}

std::array<double, 2> ElementDispersion(int element)
{
  switch (element)
  {
    case 1:
      return { 1.4870, 0.0157 };
    case 6:
      return { 1.9080, 0.1094 };
    case 7:
      return { 1.8240, 0.1700 };
    case 8:
      return { 1.6612, 0.2100 };
    case 9:
      return { 1.7500, 0.0610 };
    case 15:
      return { 2.1000, 0.2000 };
    case 16:
      return { 2.0000, 0.2500 };
    case 17:
      return { 1.9480, 0.2650 };
    case 35:
      return { 2.2200, 0.3200 };
    case 53:
      return { 2.3500, 0.4000 };
    default:
      return { 1.9080, 0.0 };
  }
}

PullField SolventPull(std::vector<DispersionAtom> atoms, const SolventParameters& solvent)
{
  return [atoms = std::move(atoms), solvent](const FlowGrid& grid, std::vector<float>& pull)
  {
    AddEnergy(grid, atoms, solvent, pull);
    const double tension = solvent.SurfaceTension;
    std::for_each(pull.begin(), pull.end(),
      [&](float& value)
      {
        value = static_cast<float>(
          (solvent.Pressure - solvent.SolventDensity * static_cast<double>(value)) / tension);
      });
  };
}

namespace
{

using Place = std::array<double, 3>;

constexpr double Near = 12.0;    // angstrom, within which an atom interacts with single nodes
constexpr std::int64_t Side = 8; // nodes along a block
constexpr std::size_t Lanes = 8;

/// Nodes of a block with their volumes, and their sums. In four arrays, for vector instructions,
/// padded with nodes without volume.
struct Block
{
  Place At{ 0.0, 0.0, 0.0 };
  double Whole = 0.0;
  std::vector<double> X, Y, Z, Volume;

  void Add(const Place& at, double volume)
  {
    this->X.push_back(at[0]);
    this->Y.push_back(at[1]);
    this->Z.push_back(at[2]);
    this->Volume.push_back(volume);
    this->Whole += volume;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->At[axis] += volume * at[axis];
    }
  }

  void Finish()
  {
    for (double& at : this->At)
    {
      at /= std::max(this->Whole, 1e-300);
    }
    while (this->X.size() % Lanes != 0)
    {
      this->X.push_back(this->X.front());
      this->Y.push_back(this->Y.front());
      this->Z.push_back(this->Z.front());
      this->Volume.push_back(0.0);
    }
  }
};

/// `part(node)` is the part of its cell that a node represents.
template <typename Part>
Block BlockAt(const DensityGrid& grid, Part&& part, const std::array<std::int64_t, 3>& first)
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
        const double volume = cell * part(i + n[0] * (j + n[1] * k));
        if (volume != 0.0)
        {
          block.Add({ grid.Origin[0] + grid.Spacing * static_cast<double>(i),
                      grid.Origin[1] + grid.Spacing * static_cast<double>(j),
                      grid.Origin[2] + grid.Spacing * static_cast<double>(k) },
            volume);
        }
      }
    }
  }
  block.Finish();
  return block;
}

template <typename Part>
std::vector<Block> DivideIntoBlocks(const DensityGrid& grid, Part&& part)
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
        blocks[static_cast<std::size_t>(b)] = BlockAt(grid, part,
          { Side * (b % counts[0]), Side * (b / counts[0] % counts[1]),
            Side * (b / (counts[0] * counts[1])) });
      }
    });
  blocks.erase(std::remove_if(
                 blocks.begin(), blocks.end(), [](const Block& block) { return block.X.empty(); }),
    blocks.end());
  return blocks;
}

/// Adds (m / r)^12 - 2 (m / r)^6 times the volumes of `groups` x 8 nodes, with r at least m.
ISTHMUS_VECTOR_CLONES void WellLoop(std::size_t groups, const double* x, const double* y,
  const double* z, const double* volume, const double* at, double squaredMinimum, double* sums)
{
  for (std::size_t g = 0; g < groups; ++g)
  {
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      const double dx = x[g * Lanes + l] - at[0];
      const double dy = y[g * Lanes + l] - at[1];
      const double dz = z[g * Lanes + l] - at[2];
      const double r2 = dx * dx + dy * dy + dz * dz;
      const double ratio = squaredMinimum / (r2 > squaredMinimum ? r2 : squaredMinimum);
      const double sixth = ratio * ratio * ratio;
      sums[l] += volume[g * Lanes + l] * (sixth * sixth - 2.0 * sixth);
    }
  }
}

/// The integral of a pair over blocks, of which those farther than `near` count as one point.
double IntegralOver(
  const std::vector<Block>& blocks, const Place& center, const DispersionPair& pair, double near)
{
  double far = 0.0;
  double sums[Lanes] = {};
  for (const Block& block : blocks)
  {
    const Place& at = block.At;
    const double squared = (at[0] - center[0]) * (at[0] - center[0]) +
      (at[1] - center[1]) * (at[1] - center[1]) + (at[2] - center[2]) * (at[2] - center[2]);
    if (squared > near * near)
    {
      far += block.Whole * pair.At(squared);
      continue;
    }
    WellLoop(block.X.size() / Lanes, block.X.data(), block.Y.data(), block.Z.data(),
      block.Volume.data(), center.data(), pair.Minimum * pair.Minimum, sums);
  }
  double sum = 0.0;
  for (const double lane : sums)
  {
    sum += lane;
  }
  return far + pair.Depth * sum;
}

}

double InsidePart(float distance, double spacing)
{
  return std::clamp(0.5 - static_cast<double>(distance) / spacing, 0.0, 1.0);
}

std::vector<double> DispersionEnergies(const std::vector<DispersionAtom>& atoms,
  const DensityGrid& grid, const float* distance, const SolventParameters& solvent,
  const ProgressCallback& progress)
{
  const std::vector<Block> inside = DivideIntoBlocks(
    grid, [&](std::int64_t node) { return InsidePart(distance[node], grid.Spacing); });
  const double near = Near + 0.5 * std::sqrt(3.0) * grid.Spacing * static_cast<double>(Side);
  std::vector<double> energies(atoms.size());
  ParallelFor(
    0, static_cast<std::int64_t>(atoms.size()), 8,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto a = static_cast<std::size_t>(first); a < static_cast<std::size_t>(last); ++a)
      {
        const DispersionPair pair(atoms[a], solvent);
        energies[a] = solvent.SolventDensity *
          (pair.Integral() - IntegralOver(inside, atoms[a].Center, pair, near));
      }
    },
    progress);
  return energies;
}

double DispersionChange(const std::vector<DispersionAtom>& atoms, const DensityGrid& grid,
  const float* before, const float* now, const SolventParameters& solvent)
{
  const std::vector<Block> gained = DivideIntoBlocks(grid,
    [&](std::int64_t node)
    { return InsidePart(now[node], grid.Spacing) - InsidePart(before[node], grid.Spacing); });
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  return -solvent.SolventDensity *
    ParallelReduce(static_cast<std::int64_t>(atoms.size()), 8, 0.0,
      [&](double& partial, std::int64_t first, std::int64_t last)
      {
        for (auto a = static_cast<std::size_t>(first); a < static_cast<std::size_t>(last); ++a)
        {
          const DispersionPair pair(atoms[a], solvent);
          partial += IntegralOver(gained, atoms[a].Center, pair, everywhere);
        }
      });
}

}
