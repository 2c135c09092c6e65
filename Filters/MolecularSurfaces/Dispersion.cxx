#include "MolecularSurfaces/Dispersion.h"

#include "Atoms/BallBricks.h"
#include "Core/ParallelFor.h"
#include "Core/Pi.h"
#include "Core/VectorClones.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double Reach = 10.0; // angstrom; beyond, a pair gives less than 1/1000 of its depth

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

/// Adds the energy of one pair to the nodes of a brick. Lengths in angstrom but for the ball.
void AddPair(const FlowGrid& grid, const Ball& ball, const DispersionPair& pair, const Brick& brick,
  std::vector<float>& energy)
{
  const double h = grid.Spacing();
  ForEachRow(ball, brick,
    [&](const NodeRange& row, std::int64_t j, std::int64_t k, double y, double z)
    {
      float* to = energy.data() + grid.Row() * j + grid.Plane() * k;
      AddRow(pair, h, static_cast<double>(row.First) - ball.Centre[0], y * y + z * z,
        static_cast<int>(row.Last - row.First), to + row.First);
    });
}

void AddEnergy(const FlowGrid& grid, const std::vector<DispersionAtom>& atoms,
  const SolventParameters& solvent, std::vector<float>& energy)
{
  const double h = grid.Spacing();
  const std::array<double, 3> origin = grid.Origin();
  // Bricks sort equal balls by place: the pairs go into that order, too.
  std::vector<DispersionAtom> sorted = atoms;
  std::sort(sorted.begin(), sorted.end(),
    [](const DispersionAtom& a, const DispersionAtom& b)
    {
      return std::tie(a.Centre[2], a.Centre[1], a.Centre[0], a.WellDepth, a.Radius) <
        std::tie(b.Centre[2], b.Centre[1], b.Centre[0], b.WellDepth, b.Radius);
    });
  std::vector<Ball> balls;
  std::vector<DispersionPair> pairs;
  for (const DispersionAtom& atom : sorted)
  {
    Ball ball{ {}, Reach / h };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      ball.Centre[axis] = (atom.Centre[axis] - origin[axis]) / h;
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
  : Minimum(atom.Radius + solvent.Radius)
  , Depth(std::sqrt(atom.WellDepth * solvent.WellDepth))
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

std::array<double, 2> DispersionOfElement(int element)
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
          (solvent.Pressure - solvent.Density * static_cast<double>(value)) / tension);
      });
  };
}

}
