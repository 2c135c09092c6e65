#include "Molecules/CoordinateUnits.h"

#include "Atoms/PointBins.h"
#include "Core/Geometry.h"
#include "Core/NumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace isthmus
{
namespace
{

constexpr double NanometreInAngstrom = 10.0;
constexpr double BohrInAngstrom = 0.529177210903;

double AngstromOf(CoordinateUnit unit, const Macromolecule& molecule)
{
  switch (unit)
  {
    case CoordinateUnit::Angstrom:
      return 1.0;
    case CoordinateUnit::Nanometre:
      return NanometreInAngstrom;
    case CoordinateUnit::Bohr:
      return BohrInAngstrom;
    default:
      return molecule.UnitOfFormat;
  }
}

bool IsPlain(const Atom& atom)
{
  return atom.Element > 0 && atom.AltLoc == ' ';
}

/// Atoms at the place of another one are copies.
constexpr double SamePlace = 1e-3;

/// Distances to the nearest of the next atoms in the file, at most `most` of them: an upper bound
/// of those to the nearest neighbour, and equal where bonded atoms follow each other.
std::vector<double> DistancesInFile(const std::vector<Atom>& atoms, std::size_t most)
{
  constexpr std::size_t window = 30;
  std::vector<double> nearest;
  const std::size_t step = atoms.size() / most + 1;
  for (std::size_t i = 0; i < atoms.size(); i += step)
  {
    if (!IsPlain(atoms[i]))
    {
      continue;
    }
    double least = INFINITY;
    const std::size_t last = std::min(atoms.size(), i + window);
    for (std::size_t j = i - std::min(i, window); j < last; ++j)
    {
      const double distance = Distance(atoms[i].Position, atoms[j].Position);
      least =
        j != i && IsPlain(atoms[j]) && distance > SamePlace ? std::min(least, distance) : least;
    }
    if (std::isfinite(least))
    {
      nearest.push_back(least);
    }
  }
  std::sort(nearest.begin(), nearest.end());
  return nearest;
}

/// Whether more than half of the sampled atoms have a neighbour within `reach`.
bool HaveNeighbours(const std::vector<Atom>& atoms, double reach, std::size_t most)
{
  std::vector<Point3> places;
  for (const Atom& atom : atoms)
  {
    if (IsPlain(atom))
    {
      places.push_back(atom.Position);
    }
  }
  const PointBins bins(places, reach);
  std::size_t with = 0;
  std::size_t all = 0;
  for (std::size_t i = 0; i < places.size(); i += places.size() / most + 1, ++all)
  {
    bool isNear = false;
    bins.Near(places[i], reach,
      [&](std::int64_t, double squared) { isNear = isNear || squared > SamePlace * SamePlace; });
    with += isNear ? 1 : 0;
  }
  return 2 * with > all;
}

/// Whether most atoms are in a residue with others, or there are no residues.
bool HaveBondedNeighbours(const std::vector<Atom>& atoms)
{
  std::size_t with = 0;
  for (std::size_t i = 1; i < atoms.size(); ++i)
  {
    with += atoms[i].ResidueId == atoms[i - 1].ResidueId &&
        atoms[i].ResidueName == atoms[i - 1].ResidueName && atoms[i].Chain == atoms[i - 1].Chain
      ? 1
      : 0;
  }
  return 2 * with > atoms.size();
}

}

void ConvertUnit(Macromolecule& molecule, CoordinateUnit unit)
{
  const double factor = AngstromOf(unit, molecule) / molecule.UnitOfFormat;
  if (factor == 1.0)
  {
    return;
  }
  const auto scale = [factor](std::array<double, 3>& vector)
  {
    for (double& x : vector)
    {
      x *= factor;
    }
  };
  for (Atom& atom : molecule.Atoms)
  {
    scale(atom.Position);
  }
  for (std::array<double, 3>& vector : molecule.Cell)
  {
    scale(vector);
  }
}

bool CheckDistances(Macromolecule& molecule, CoordinateUnit unit)
{
  constexpr std::size_t fewest = 10;
  constexpr std::size_t most = 1000;
  constexpr double tooClose = 0.75;
  constexpr double tooFar = 8.0;
  constexpr double far = 25.0;     // also of atoms that are not bonded
  constexpr double shortest = 0.7; // of what distances are in the right unit
  constexpr double longest = 9.0;
  const std::vector<double> nearest = DistancesInFile(molecule.Atoms, most);
  if (nearest.size() < fewest)
  {
    return true;
  }
  const double median = nearest[nearest.size() / 2];
  const double low = nearest[nearest.size() / 10];
  const double high = nearest[nearest.size() - 1 - nearest.size() / 10];
  const bool isSmall = median < tooClose && low * NanometreInAngstrom > shortest &&
    high * NanometreInAngstrom < longest;
  const bool isLarge = median > tooFar && (median > far || HaveBondedNeighbours(molecule.Atoms)) &&
    !HaveNeighbours(molecule.Atoms, tooFar, most);
  if (!isSmall && !isLarge)
  {
    return true;
  }
  const double now = AngstromOf(unit, molecule);
  std::string advice = "Rescale them.";
  if (isSmall && now == 1.0)
  {
    advice = "They seem to be in nanometre: set LengthUnit to Nanometre.";
  }
  else if (isLarge && now == NanometreInAngstrom)
  {
    advice = "They seem to be in angstrom: set LengthUnit to Angstrom.";
  }
  molecule.Warnings.push_back("The coordinates do not fit their unit: read as " +
    std::string(now == 1.0           ? "angstrom"
        : now == NanometreInAngstrom ? "nanometre"
                                     : "bohr") +
    ", the nearest neighbour of an atom is " + FixedNumber(median, median < 1.0 ? 3 : 1) +
    " angstrom away (median of " + std::to_string(nearest.size()) + "; bonds are 1 to 2.5). " +
    advice + (isSmall ? " Bonds by distance were not looked for." : ""));
  return !isSmall;
}

}
