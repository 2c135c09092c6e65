#include "Molecules/PeriodicMolecules.h"

#include "Atoms/PeriodicCell.h"
#include "Atoms/PointBins.h"
#include "Core/Geometry.h"
#include "Core/NumberText.h"
#include "Molecules/AtomElements.h"
#include "Molecules/CovalentBonds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double LongestBond = 2.6;

/// A bond to atom `To`, moved by `Image` cells.
struct PeriodicBond
{
  std::size_t From, To;
  CellShift Image;
};

/// Whether atoms may be bonded to images: some are nearly a cell apart.
bool MayCrossCell(const Macromolecule& molecule, const PeriodicCell& cell)
{
  Point3 low{ INFINITY, INFINITY, INFINITY };
  Point3 high{ -INFINITY, -INFINITY, -INFINITY };
  for (const Atom& atom : molecule.Atoms)
  {
    const Point3 f = cell.Fractions(atom.Position);
    for (std::size_t k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], f[k]);
      high[k] = std::max(high[k], f[k]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (high[k] - low[k] > 1.0 - LongestBond / cell.Height(k))
    {
      return true;
    }
  }
  return false;
}

/// Bonds by distance, with the images of atoms near the faces of the cell, and those of the file.
std::vector<PeriodicBond> FindPeriodicBonds(const Macromolecule& molecule, const PeriodicCell& cell)
{
  const std::size_t count = molecule.Atoms.size();
  std::vector<BondingAtom> atoms; // in the cell, then images beside it
  std::vector<std::size_t> of;
  std::vector<CellShift> moved;
  atoms.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Atom& atom = molecule.Atoms[i];
    const Point3 f = cell.Fractions(atom.Position);
    const CellShift into{ -static_cast<int>(std::floor(f[0])), -static_cast<int>(std::floor(f[1])),
      -static_cast<int>(std::floor(f[2])) };
    atoms.push_back({ atom.Position + cell.Vector(into), atom.Element, atom.AltLoc });
    of.push_back(i);
    moved.push_back(into);
  }
  const Point3 margin{ LongestBond / cell.Height(0), LongestBond / cell.Height(1),
    LongestBond / cell.Height(2) };
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point3 f = cell.Fractions(atoms[i].Position);
    for (int code = 1; code < 27; ++code)
    {
      const CellShift image{ (code % 3 + 1) % 3 - 1, (code / 3 % 3 + 1) % 3 - 1,
        (code / 9 + 1) % 3 - 1 };
      bool isBeside = true;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const double at = f[k] + image[k];
        isBeside = isBeside && at > -margin[k] && at < 1.0 + margin[k];
      }
      if (isBeside)
      {
        atoms.push_back(
          { atoms[i].Position + cell.Vector(image), atoms[i].Element, atoms[i].AltLoc });
        of.push_back(i);
        moved.push_back(Add(moved[i], image));
      }
    }
  }
  bool isCrowded = false;
  std::vector<PeriodicBond> bonds;
  for (const Bond& bond : FindCovalentBonds(atoms, isCrowded))
  {
    const auto a = static_cast<std::size_t>(bond.First);
    const auto b = static_cast<std::size_t>(bond.Second);
    if (a < count || b < count) // others are images of these
    {
      bonds.push_back({ of[a], of[b], Add(moved[b], Negative(moved[a])) });
    }
  }
  constexpr double longest = 4.0; // of those of the file, e.g. to metals
  for (const Bond& bond : molecule.Bonds)
  {
    const auto a = static_cast<std::size_t>(bond.First);
    const auto b = static_cast<std::size_t>(bond.Second);
    const Point3& from = molecule.Atoms[a].Position;
    const Point3& to = molecule.Atoms[b].Position;
    const CellShift image = cell.NearestImage(from, to);
    if (bond.FromFile && Distance(from, to + cell.Vector(image)) < longest)
    {
      bonds.push_back({ a, b, image });
    }
  }
  return bonds;
}

bool AreOneResidue(const Atom& a, const Atom& b)
{
  return a.ResidueId == b.ResidueId && a.InsertionCode == b.InsertionCode && a.Chain == b.Chain &&
    a.ResidueName == b.ResidueName;
}

/// The number of the residue of each atom, in the order of the file.
std::vector<std::size_t> NumberResidues(const std::vector<Atom>& atoms)
{
  std::vector<std::size_t> of(atoms.size(), 0);
  for (std::size_t i = 1; i < atoms.size(); ++i)
  {
    of[i] = of[i - 1] + (AreOneResidue(atoms[i - 1], atoms[i]) ? 0 : 1);
  }
  return of;
}

/// Atoms that are bonded, with the shifts that make them whole.
struct Component
{
  std::vector<std::size_t> Atoms;
  std::size_t Residues = 0;
  bool IsBroken = false;   ///< some shifts differ
  bool IsInfinite = false; ///< bonded to its own images
};

class MoleculeMender
{
public:
  MoleculeMender(Macromolecule& molecule, const PeriodicCell& cell, std::vector<PeriodicBond> bonds)
    : Molecule(molecule)
    , Cell(cell)
    , Bonds(std::move(bonds))
    , Residue(NumberResidues(molecule.Atoms))
    , Shifts(molecule.Atoms.size(), NoCellShift)
  {
  }

  /// Whether there are molecules that are broken, rather than bonded to mates in a crystal.
  bool AnyBroken() const
  {
    return std::any_of(this->Bonds.begin(), this->Bonds.end(),
      [this](const PeriodicBond& bond)
      {
        const std::size_t a = this->Residue[bond.From];
        const std::size_t b = this->Residue[bond.To];
        return bond.Image != NoCellShift && std::max(a, b) - std::min(a, b) <= 1 &&
          this->Molecule.Atoms[bond.From].Chain == this->Molecule.Atoms[bond.To].Chain;
      });
  }

  void Mend(bool addBonds)
  {
    this->FindComponents();
    std::size_t broken = 0;
    std::size_t infinite = 0;
    for (const Component& component : this->Components)
    {
      broken += component.IsBroken && !component.IsInfinite ? 1 : 0;
      infinite += component.IsInfinite ? 1 : 0;
    }
    if (infinite > 0)
    {
      this->Molecule.Notes.push_back(
        "Molecules bonded to their own images in the cell, left as they "
        "are in the file: " +
        std::to_string(infinite) + ".");
    }
    if (broken == 0)
    {
      return;
    }
    const std::size_t moved = this->CountMoved();
    this->MoveAtoms();
    const std::size_t joined = this->MoveToContacts();
    if (addBonds)
    {
      this->AddBonds();
    }
    this->Molecule.Notes.push_back(
      "Molecules broken at the periodic box, made whole by the cell of "
      "the file: " +
      std::to_string(broken) + " (" + std::to_string(moved) + " atoms moved by whole cells)." +
      (joined == 0 ? ""
                   : " Molecules moved by whole cells to those they touch: " +
            std::to_string(joined) + "."));
  }

private:
  void FindComponents()
  {
    const std::size_t count = this->Molecule.Atoms.size();
    std::vector<std::size_t> begin(count + 1, 0);
    for (const PeriodicBond& bond : this->Bonds)
    {
      ++begin[bond.From + 1];
      ++begin[bond.To + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::pair<std::size_t, CellShift>> neighbours(2 * this->Bonds.size());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (const PeriodicBond& bond : this->Bonds)
    {
      neighbours[next[bond.From]++] = { bond.To, bond.Image };
      neighbours[next[bond.To]++] = { bond.From, Negative(bond.Image) };
    }
    this->ComponentOf.assign(count, count);
    for (std::size_t root = 0; root < count; ++root)
    {
      if (this->ComponentOf[root] != count)
      {
        continue;
      }
      Component component;
      component.Atoms.push_back(root);
      this->ComponentOf[root] = this->Components.size();
      for (std::size_t at = 0; at < component.Atoms.size(); ++at)
      {
        const std::size_t i = component.Atoms[at];
        for (std::size_t n = begin[i]; n < begin[i + 1]; ++n)
        {
          const auto& [other, image] = neighbours[n];
          const CellShift shift = Add(this->Shifts[i], image);
          if (this->ComponentOf[other] == count)
          {
            this->ComponentOf[other] = this->Components.size();
            this->Shifts[other] = shift;
            component.Atoms.push_back(other);
          }
          component.IsInfinite = component.IsInfinite || this->Shifts[other] != shift;
        }
      }
      this->Complete(component);
      this->Components.push_back(std::move(component));
    }
  }

  /// Most atoms of a molecule stay where they are.
  void Complete(Component& component)
  {
    std::map<CellShift, std::size_t> counts;
    std::vector<std::size_t> residues;
    for (const std::size_t i : component.Atoms)
    {
      ++counts[this->Shifts[i]];
      residues.push_back(this->Residue[i]);
    }
    std::sort(residues.begin(), residues.end());
    component.Residues =
      static_cast<std::size_t>(std::unique(residues.begin(), residues.end()) - residues.begin());
    component.IsBroken = counts.size() > 1;
    const CellShift most = std::max_element(counts.begin(), counts.end(),
      [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first;
    for (const std::size_t i : component.Atoms)
    {
      this->Shifts[i] = component.IsInfinite ? NoCellShift : Add(this->Shifts[i], Negative(most));
    }
  }

  std::size_t CountMoved() const
  {
    return static_cast<std::size_t>(std::count_if(this->Shifts.begin(), this->Shifts.end(),
      [](const CellShift& shift) { return shift != NoCellShift; }));
  }

  void MoveAtoms()
  {
    for (std::size_t i = 0; i < this->Shifts.size(); ++i)
    {
      Point3& place = this->Molecule.Atoms[i].Position;
      place = place + this->Cell.Vector(this->Shifts[i]);
    }
  }

  /// Components that are moved to others: chains, longest first, then other molecules of which
  /// there are few.
  std::vector<std::size_t> OrderOfMoves() const
  {
    constexpr std::size_t fewestResidues = 3;
    constexpr std::size_t few = 50;
    std::vector<std::size_t> chains, others;
    std::map<std::string, std::size_t> names;
    for (std::size_t c = 0; c < this->Components.size(); ++c)
    {
      const Component& component = this->Components[c];
      if (component.Residues >= fewestResidues && !component.IsInfinite)
      {
        chains.push_back(c);
      }
      else
      {
        ++names[this->NameOf(component)];
      }
    }
    std::stable_sort(chains.begin(), chains.end(),
      [this](std::size_t a, std::size_t b)
      { return this->Components[a].Atoms.size() > this->Components[b].Atoms.size(); });
    for (std::size_t c = 0; c < this->Components.size(); ++c)
    {
      const Component& component = this->Components[c];
      const std::string& name = this->NameOf(component);
      if (component.Residues < fewestResidues && !component.IsInfinite && names[name] <= few &&
        FindResidueFamily(name) != ResidueFamily::Water)
      {
        others.push_back(c);
      }
    }
    chains.insert(chains.end(), others.begin(), others.end());
    return chains;
  }

  const std::string& NameOf(const Component& component) const
  {
    return this->Molecule.Atoms[component.Atoms.front()].ResidueName;
  }

  Point3 CenterOf(const std::vector<std::size_t>& atoms) const
  {
    Point3 sum{ 0.0, 0.0, 0.0 };
    for (const std::size_t i : atoms)
    {
      sum = sum + this->Molecule.Atoms[i].Position;
    }
    return (1.0 / static_cast<double>(atoms.size())) * sum;
  }

  /// Returns how many molecules were moved.
  std::size_t MoveToContacts()
  {
    constexpr double contact = 5.0;
    constexpr std::size_t fewestResidues = 3;
    std::vector<Point3> placed;
    Point3 center{ 0.0, 0.0, 0.0 };
    std::size_t moved = 0;
    std::optional<PointBins> bins;
    for (const std::size_t c : this->OrderOfMoves())
    {
      const Component& component = this->Components[c];
      const bool isChain = component.Residues >= fewestResidues;
      if (placed.empty() && !isChain)
      {
        break; // nothing to be moved to
      }
      if (!placed.empty())
      {
        if (!bins)
        {
          bins.emplace(placed, contact);
        }
        const CellShift best = this->BestShift(component, *bins, center, contact);
        moved += best != NoCellShift ? 1 : 0;
        this->MoveBy(component, best);
      }
      if (isChain)
      {
        for (const std::size_t i : component.Atoms)
        {
          placed.push_back(this->Molecule.Atoms[i].Position);
        }
        center = placed.size() == component.Atoms.size() ? this->CenterOf(component.Atoms) : center;
        bins.reset();
      }
    }
    return moved;
  }

  /// The shift with most contacts, none if it has no more than there are now.
  CellShift BestShift(
    const Component& component, const PointBins& bins, const Point3& center, double contact) const
  {
    const auto count = [&](const CellShift& shift)
    {
      const Point3 by = this->Cell.Vector(shift);
      std::size_t contacts = 0;
      for (const std::size_t i : component.Atoms)
      {
        bins.Near(this->Molecule.Atoms[i].Position + by, contact,
          [&contacts](std::int64_t, double) { ++contacts; });
      }
      return contacts;
    };
    CellShift best = NoCellShift;
    std::size_t most = count(NoCellShift);
    const CellShift middle = this->Cell.NearestImage(center, this->CenterOf(component.Atoms));
    for (int code = 0; code < 27; ++code)
    {
      const CellShift shift = Add(middle, { code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1 });
      const std::size_t contacts = shift == NoCellShift ? 0 : count(shift);
      if (contacts > most)
      {
        most = contacts;
        best = shift;
      }
    }
    return best;
  }

  void MoveBy(const Component& component, const CellShift& shift)
  {
    const Point3 by = this->Cell.Vector(shift);
    for (const std::size_t i : component.Atoms)
    {
      Point3& place = this->Molecule.Atoms[i].Position;
      place = place + by;
    }
  }

  /// The bonds that had crossed the box.
  void AddBonds()
  {
    for (const PeriodicBond& bond : this->Bonds)
    {
      if (bond.Image != NoCellShift && bond.From != bond.To &&
        !this->Components[this->ComponentOf[bond.From]].IsInfinite)
      {
        this->Molecule.Bonds.push_back({ static_cast<std::int64_t>(std::min(bond.From, bond.To)),
          static_cast<std::int64_t>(std::max(bond.From, bond.To)), false });
      }
    }
    SortBonds(this->Molecule);
  }

  Macromolecule& Molecule;
  const PeriodicCell& Cell;
  std::vector<PeriodicBond> Bonds;
  std::vector<std::size_t> Residue;
  std::vector<CellShift> Shifts;
  std::vector<Component> Components;
  std::vector<std::size_t> ComponentOf;
};

bool IsPolymer(const Atom& atom)
{
  const ResidueFamily family = FindResidueFamily(atom.ResidueName);
  return family == ResidueFamily::AminoAcid || family == ResidueFamily::Nucleotide;
}

/// Whether two bonded atoms are apart by a length along one axis, and by about a bond in all.
bool AreApartAlongAxis(const Point3& a, const Point3& b)
{
  constexpr double least = 15.0;
  constexpr double bond = 1.8;
  int along = 0;
  int beside = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double d = std::abs(a[k] - b[k]);
    along += d > least ? 1 : 0;
    beside += d < bond ? 1 : 0;
  }
  return along == 1 && beside == 2;
}

/// The atoms [Begin, End) of a residue, and those at which neighbours in a chain are bonded.
struct ResidueInFile
{
  std::size_t Begin = 0;
  std::size_t End = 0;
  const Atom* Last = nullptr; ///< C or O3'
  const Atom* Next = nullptr; ///< N or P
  const Atom* Away = nullptr; ///< far from the first one
};

ResidueInFile FindResidueAt(const std::vector<Atom>& atoms, std::size_t begin)
{
  constexpr double largest = 20.0;
  ResidueInFile residue{ begin, begin + 1 };
  while (residue.End < atoms.size() && AreOneResidue(atoms[begin], atoms[residue.End]))
  {
    ++residue.End;
  }
  const std::size_t end = IsPolymer(atoms[begin]) ? residue.End : begin;
  for (std::size_t i = begin; i < end; ++i)
  {
    const Atom& atom = atoms[i];
    const std::string_view name = atom.Name;
    residue.Last = name == "C" || name == "O3'" ? &atom : residue.Last;
    residue.Next = name == "N" || name == "P" ? &atom : residue.Next;
    const bool isAway = Distance(atoms[begin].Position, atom.Position) > largest;
    residue.Away = !residue.Away && isAway ? &atom : residue.Away;
  }
  return residue;
}

/// Whether no name of an atom comes twice: otherwise they are residues with the same number.
bool IsOneResidue(const std::vector<Atom>& atoms, const ResidueInFile& residue)
{
  std::vector<std::string> names;
  for (std::size_t i = residue.Begin; i < residue.End; ++i)
  {
    names.push_back(atoms[i].Name + atoms[i].AltLoc);
  }
  std::sort(names.begin(), names.end());
  return std::adjacent_find(names.begin(), names.end()) == names.end();
}

/// "N residues are torn ..." where atoms that belong together are far apart.
std::string DescribeTorn(const std::vector<Atom>& atoms)
{
  std::size_t torn = 0;
  std::string first;
  const auto add = [&](const Atom& a, const Atom& b)
  {
    if (torn++ == 0)
    {
      first = Describe(a) + " and " + Describe(b) + " are " +
        FixedNumber(Distance(a.Position, b.Position), 0) + " angstrom apart";
    }
  };
  ResidueInFile before;
  for (std::size_t begin = 0; begin < atoms.size(); begin = before.End)
  {
    const ResidueInFile residue = FindResidueAt(atoms, begin);
    const bool isJump = before.Last && residue.Next && before.Last->Chain == residue.Next->Chain &&
      before.Last->ResidueId + 1 == residue.Next->ResidueId &&
      AreApartAlongAxis(before.Last->Position, residue.Next->Position);
    if (residue.Away && IsOneResidue(atoms, residue))
    {
      add(atoms[begin], *residue.Away);
    }
    if (isJump && IsOneResidue(atoms, residue) && IsOneResidue(atoms, before))
    {
      add(*before.Last, *residue.Next);
    }
    before = residue;
  }
  return torn == 0 ? std::string()
                   : "Residues that are torn apart: " + std::to_string(torn) + " (" + first + ").";
}

bool IsCell(const std::vector<Point3>& cell)
{
  constexpr double shortest = 3.0; // than a molecule; 1 1 1 is a dummy
  if (cell.size() != 3)
  {
    return false;
  }
  const double volume = Dot(cell[0], Cross(cell[1], cell[2]));
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double face = Length(Cross(cell[(k + 1) % 3], cell[(k + 2) % 3]));
    if (!std::isfinite(volume) || !(face > 0.0) || !(std::abs(volume) / face > shortest))
    {
      return false;
    }
  }
  return true;
}

}

std::vector<Point3> CellVectors(const Point3& lengths, const Point3& angles)
{
  const auto cosine = [](double degrees)
  { return degrees == 90.0 ? 0.0 : std::cos(degrees * Pi / 180.0); };
  const double sine = angles[2] == 90.0 ? 1.0 : std::sin(angles[2] * Pi / 180.0);
  const double x = cosine(angles[1]);
  const double y = (cosine(angles[0]) - x * cosine(angles[2])) / sine;
  std::vector<Point3> cell{ { lengths[0], 0.0, 0.0 },
    { lengths[1] * cosine(angles[2]), lengths[1] * sine, 0.0 },
    { lengths[2] * x, lengths[2] * y, lengths[2] * std::sqrt(1.0 - x * x - y * y) } };
  return IsCell(cell) ? cell : std::vector<Point3>();
}

void MakeMoleculesWhole(Macromolecule& molecule, bool addBonds)
{
  const bool hasCell = IsCell(molecule.Cell);
  if (hasCell)
  {
    const PeriodicCell cell(molecule.Cell);
    if (MayCrossCell(molecule, cell))
    {
      MoleculeMender mender(molecule, cell, FindPeriodicBonds(molecule, cell));
      if (mender.AnyBroken())
      {
        mender.Mend(addBonds);
      }
    }
  }
  const std::string torn = DescribeTorn(molecule.Atoms);
  if (!torn.empty())
  {
    molecule.Warnings.push_back(torn +
      (hasCell
          ? " The cell of the file does not join them."
          : " They seem to be broken at a periodic box, and the file has no cell by which they "
            "could be joined.") +
      " Write whole molecules, e.g. by 'gmx trjconv -pbc whole'.");
  }
}

}
