#include "Molecules/CovalentBonds.h"

#include "Atoms/AtomRadii.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace isthmus
{
namespace
{

constexpr double Tolerance = 0.45;
constexpr double Closest = 0.4;
constexpr std::size_t MostInACell = 1000;
constexpr int BitsOfAnAxis = 21;

struct Candidate
{
  std::uint64_t Cell; ///< z, y, x in 21 bits each
  std::int64_t Index;
  std::array<double, 3> Position;
  double Radius;
  char AltLoc;
  bool Hydrogen;
};

/// Two hydrogens, and atoms at different alternate locations, come near without a bond.
bool AreBonded(const Candidate& a, const Candidate& b)
{
  if ((a.Hydrogen && b.Hydrogen) || (a.AltLoc != ' ' && b.AltLoc != ' ' && a.AltLoc != b.AltLoc))
  {
    return false;
  }
  const double x = a.Position[0] - b.Position[0];
  const double y = a.Position[1] - b.Position[1];
  const double z = a.Position[2] - b.Position[2];
  const double d2 = x * x + y * y + z * z;
  const double most = a.Radius + b.Radius + Tolerance;
  return d2 > Closest * Closest && d2 < most * most;
}

/// Atoms that can have bonds, sorted by cells as wide as the longest bond.
template <typename AnyAtom>
std::vector<Candidate> SortedCandidates(const std::vector<AnyAtom>& atoms)
{
  std::vector<Candidate> candidates;
  candidates.reserve(atoms.size());
  double longest = 0.0;
  std::array<double, 3> low{ INFINITY, INFINITY, INFINITY };
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    const AnyAtom& atom = atoms[i];
    const double radius = CovalentRadius(atom.Element);
    if (std::isnan(radius))
    {
      continue;
    }
    longest = std::max(longest, radius);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], atom.Position[axis]);
    }
    candidates.push_back(
      { 0, static_cast<std::int64_t>(i), atom.Position, radius, atom.AltLoc, atom.Element == 1 });
  }
  const double width = 2.0 * longest + Tolerance;
  constexpr double cells = (1 << BitsOfAnAxis) - 3;
  for (Candidate& c : candidates)
  {
    for (int axis = 2; axis >= 0; --axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      // From 1, so that a neighbour's number never borrows from the next axis; what is farther
      // away than the cells reach shares the last one.
      const double cell = std::min(std::floor((c.Position[a] - low[a]) / width) + 1.0, cells);
      c.Cell = (c.Cell << BitsOfAnAxis) | static_cast<std::uint64_t>(cell);
    }
  }
  std::sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b)
    { return std::tie(a.Cell, a.Index) < std::tie(b.Cell, b.Index); });
  return candidates;
}

/// In another unit of length all atoms would be bonded to each other, in quadratic time.
bool TooCrowded(const std::vector<Candidate>& sorted)
{
  for (std::size_t i = MostInACell; i < sorted.size(); ++i)
  {
    if (sorted[i].Cell == sorted[i - MostInACell].Cell)
    {
      return true;
    }
  }
  return false;
}

/// Bonds from candidates [first, last) to later ones, in the half of the cells around that is
/// later.
void FindBonds(
  const std::vector<Candidate>& sorted, std::size_t first, std::size_t last, std::vector<Bond>& to)
{
  const auto before = [](const Candidate& c, std::uint64_t cell) { return c.Cell < cell; };
  constexpr std::uint64_t y = std::uint64_t{ 1 } << BitsOfAnAxis;
  constexpr std::uint64_t z = y << BitsOfAnAxis;
  // Rows of three cells along x: the own one, whose earlier part is left out, and four later ones.
  for (const std::uint64_t row : { std::uint64_t{ 0 }, y, z - y, z, z + y })
  {
    std::size_t start = 0;
    for (std::size_t i = first; i < last; ++i)
    {
      const Candidate& atom = sorted[i];
      const std::uint64_t from = atom.Cell + row - 1;
      // Cells come in rising order, so the search only moves on.
      if (start == 0)
      {
        start = static_cast<std::size_t>(
          std::lower_bound(sorted.begin(), sorted.end(), from, before) - sorted.begin());
      }
      while (start < sorted.size() && sorted[start].Cell < from)
      {
        ++start;
      }
      for (std::size_t j = row == 0 ? i + 1 : start; j < sorted.size(); ++j)
      {
        if (sorted[j].Cell > from + 2)
        {
          break;
        }
        if (AreBonded(atom, sorted[j]))
        {
          to.push_back({ std::min(atom.Index, sorted[j].Index),
            std::max(atom.Index, sorted[j].Index), false });
        }
      }
    }
  }
}

std::vector<Bond> FindAllBonds(
  const std::vector<Candidate>& sorted, const ProgressCallback& progress)
{
  constexpr std::size_t block = 1 << 14;
  std::vector<std::vector<Bond>> found((sorted.size() + block - 1) / block);
  ParallelFor(
    0, static_cast<std::int64_t>(found.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto b = static_cast<std::size_t>(begin); b < static_cast<std::size_t>(end); ++b)
      {
        FindBonds(sorted, b * block, std::min(sorted.size(), (b + 1) * block), found[b]);
      }
    },
    progress);
  std::vector<Bond> all;
  for (const auto& bonds : found)
  {
    all.insert(all.end(), bonds.begin(), bonds.end());
  }
  return all;
}

}

void SortBonds(Macromolecule& molecule)
{
  auto& bonds = molecule.Bonds;
  std::sort(bonds.begin(), bonds.end(),
    [](const Bond& a, const Bond& b) {
      return std::tuple(a.First, a.Second, b.FromFile) < std::tuple(b.First, b.Second, a.FromFile);
    });
  bonds.erase(
    std::unique(bonds.begin(), bonds.end(),
      [](const Bond& a, const Bond& b) { return a.First == b.First && a.Second == b.Second; }),
    bonds.end());
}

std::vector<Bond> FindCovalentBonds(
  const std::vector<BondingAtom>& atoms, bool& isCrowded, const ProgressCallback& progress)
{
  const std::vector<Candidate> sorted = SortedCandidates(atoms);
  isCrowded = TooCrowded(sorted);
  return isCrowded ? std::vector<Bond>() : FindAllBonds(sorted, progress);
}

void AddCovalentBonds(Macromolecule& molecule, const ProgressCallback& progress)
{
  const std::vector<Candidate> sorted = SortedCandidates(molecule.Atoms);
  Report(progress, 0.3);
  if (TooCrowded(sorted))
  {
    molecule.Warnings.emplace_back(
      "More than 1000 atoms lie in a box with the side of one bond length, so bonds were not "
      "determined: check that the coordinates are in angstrom.");
    SortBonds(molecule);
    return;
  }
  const std::vector<Bond> found = FindAllBonds(sorted, Between(progress, 0.3, 0.9));
  molecule.Bonds.insert(molecule.Bonds.end(), found.begin(), found.end());
  SortBonds(molecule);
}

}
