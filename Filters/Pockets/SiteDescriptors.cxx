#include "Pockets/SiteDescriptors.h"

#include "Atoms/PointBins.h"
#include "Core/ParallelFor.h"
#include "Pockets/SiteModel.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace isthmus
{
namespace
{

constexpr std::size_t NumberOfKinds = static_cast<std::size_t>(SiteAtomKind::Other);
constexpr std::size_t NumberOfResidues = 40;
constexpr std::array<double, 5> BurialReaches{ 5.0, 6.0, 8.0, 10.0, 12.0 };
constexpr std::array<double, 3> EnclosureReaches{ 6.0, 8.0, 12.0 };
constexpr std::array<double, 4> CellReaches{ 3.0, 5.0, 7.0, 10.0 };
constexpr double LiningReach = 8.0;
constexpr double PropensityReach = 6.0;
constexpr double MetalReach = 4.5;

const std::array<const char*, 20> AminoAcids{ "ALA", "ARG", "ASN", "ASP", "CYS", "GLN", "GLU",
  "GLY", "HIS", "ILE", "LEU", "LYS", "MET", "PHE", "PRO", "SER", "THR", "TRP", "TYR", "VAL" };

const std::map<std::string, std::string>& Variants()
{
  static const std::map<std::string, std::string> variants{ { "MSE", "MET" }, { "HID", "HIS" },
    { "HIE", "HIS" }, { "HIP", "HIS" }, { "HSD", "HIS" }, { "HSE", "HIS" }, { "HSP", "HIS" },
    { "CYX", "CYS" }, { "CYM", "CYS" }, { "CSO", "CYS" }, { "CSD", "CYS" }, { "ASH", "ASP" },
    { "GLH", "GLU" }, { "LYN", "LYS" }, { "LLP", "LYS" }, { "KCX", "LYS" }, { "TPO", "THR" },
    { "SEP", "SER" }, { "PTR", "TYR" } };
  return variants;
}

bool IsBackbone(const std::string& name)
{
  return name == "N" || name == "CA" || name == "C" || name == "O" || name == "OXT";
}

/// Residue and atom as one word, "HIS ND1".
bool IsOneOf(const std::string& word, const std::set<std::string>& words)
{
  return words.count(word) > 0;
}

SiteAtomKind KindOf(int element, const std::string& residue, const std::string& name)
{
  static const std::set<std::string> rings{ "PHE CG", "PHE CD1", "PHE CD2", "PHE CE1", "PHE CE2",
    "PHE CZ", "TYR CG", "TYR CD1", "TYR CD2", "TYR CE1", "TYR CE2", "TYR CZ", "TRP CG", "TRP CD1",
    "TRP CD2", "TRP NE1", "TRP CE2", "TRP CE3", "TRP CZ2", "TRP CZ3", "TRP CH2", "HIS CG",
    "HIS CD2", "HIS CE1" };
  static const std::set<std::string> acids{ "ASP OD1", "ASP OD2", "GLU OE1", "GLU OE2" };
  static const std::set<std::string> bases{ "LYS NZ", "ARG NH1", "ARG NH2", "ARG NE" };
  static const std::set<std::string> hydroxyls{ "SER OG", "THR OG1", "TYR OH" };
  static const std::set<std::string> amides{ "ASN OD1", "ASN ND2", "GLN OE1", "GLN NE2" };
  static const std::set<std::string> polarCarbons{ "ASP CG", "GLU CD", "ASN CG", "GLN CD",
    "ARG CZ" };
  const std::string word = residue + " " + name;
  if (IsOneOf(word, rings))
  {
    return SiteAtomKind::Aromatic;
  }
  if (word == "HIS ND1" || word == "HIS NE2")
  {
    return SiteAtomKind::Imidazole;
  }
  if (element == 16)
  {
    return SiteAtomKind::Sulfur;
  }
  if (name == "O" || name == "OXT")
  {
    return SiteAtomKind::CarbonylOxygen;
  }
  if (name == "N")
  {
    return SiteAtomKind::AmideNitrogen;
  }
  const std::pair<const std::set<std::string>*, SiteAtomKind> polar[] = {
    { &acids, SiteAtomKind::Acid }, { &bases, SiteAtomKind::Base },
    { &hydroxyls, SiteAtomKind::Hydroxyl }, { &amides, SiteAtomKind::SideChainAmide }
  };
  for (const auto& [words, kind] : polar)
  {
    if (IsOneOf(word, *words))
    {
      return kind;
    }
  }
  const bool apolar = element == 6 && !IsBackbone(name) && !IsOneOf(word, polarCarbons);
  return apolar ? SiteAtomKind::Aliphatic : SiteAtomKind::Other;
}

/// Sums over unit vectors.
struct Directions
{
  double Count = 0.0;
  Point3 Sum{ 0.0, 0.0, 0.0 };
  std::array<double, 6> Products{}; ///< xx, yy, zz, xy, xz, yz

  void Add(const Point3& u)
  {
    this->Count += 1.0;
    this->Sum = this->Sum + u;
    const double products[] = { u[0] * u[0], u[1] * u[1], u[2] * u[2], u[0] * u[1], u[0] * u[2],
      u[1] * u[2] };
    for (std::size_t k = 0; k < 6; ++k)
    {
      this->Products[k] += products[k];
    }
  }

  void Add(const Directions& other)
  {
    this->Count += other.Count;
    this->Sum = this->Sum + other.Sum;
    for (std::size_t k = 0; k < 6; ++k)
    {
      this->Products[k] += other.Products[k];
    }
  }

  /// Length of the mean, and the two smaller eigenvalues of the mean product.
  std::array<double, 3> Enclosure() const
  {
    if (this->Count == 0.0)
    {
      return { 1.0, 0.0, 0.0 };
    }
    std::array<double, 6> m = this->Products;
    for (double& entry : m)
    {
      entry /= this->Count;
    }
    // Eigenvalues of a symmetric matrix in closed form (O. K. Smith, Commun. ACM 4 (1961) 168).
    const double mean = (m[0] + m[1] + m[2]) / 3.0;
    const double off = m[3] * m[3] + m[4] * m[4] + m[5] * m[5];
    const double a = m[0] - mean, b = m[1] - mean, c = m[2] - mean;
    const double p = std::sqrt((a * a + b * b + c * c + 2.0 * off) / 6.0);
    const double length = Length(this->Sum) / this->Count;
    if (p < 1e-12)
    {
      return { length, mean, mean };
    }
    const double determinant =
      a * (b * c - m[5] * m[5]) - m[3] * (m[3] * c - m[5] * m[4]) + m[4] * (m[3] * m[5] - b * m[4]);
    const double angle = std::acos(std::clamp(determinant / (2.0 * p * p * p), -1.0, 1.0)) / 3.0;
    const double largest = mean + 2.0 * p * std::cos(angle);
    const double smallest = mean + 2.0 * p * std::cos(angle + 2.0 * Pi / 3.0);
    return { length, smallest, 3.0 * mean - largest - smallest };
  }
};

/// The number of the first of these rising reaches that is above `d`.
template <std::size_t N>
std::size_t ShellOf(const std::array<double, N>& reaches, double d)
{
  std::size_t shell = 0;
  while (shell < N && d >= reaches[shell])
  {
    ++shell;
  }
  return shell;
}

/// What the atoms around a place say.
class AtomsAround
{
public:
  AtomsAround(const std::vector<SiteAtom>& atoms, const PointBins& bins, const Point3& place)
  {
    bins.Near(place, BurialReaches.back(),
      [&](std::int64_t id, double squared)
      { this->Add(atoms[static_cast<std::size_t>(id)], place, std::sqrt(squared)); });
    // Shells become balls.
    for (std::size_t k = 1; k < BurialReaches.size(); ++k)
    {
      this->Counts[k] += this->Counts[k - 1];
    }
    for (std::size_t k = 1; k < EnclosureReaches.size(); ++k)
    {
      this->Around[k].Add(this->Around[k - 1]);
    }
  }

  double Burial() const { return this->Counts[3]; }

  void Write(std::vector<float>& row) const
  {
    const auto put = [&](double value) { row.push_back(static_cast<float>(value)); };
    std::for_each(this->Counts.begin(), this->Counts.end() - 1, put);
    for (std::size_t k = 0; k < EnclosureReaches.size(); ++k)
    {
      for (const double value : this->Around[k].Enclosure())
      {
        put(value);
      }
    }
    std::for_each(this->Kinds.begin(), this->Kinds.end() - 1, put);
    put(this->Weight);
    double largest = 0.0;
    for (const auto& chain : this->Chains)
    {
      largest = std::max(largest, chain.second);
    }
    put(this->Weight > 0.0 ? 1.0 - largest / this->Weight : 0.0);
    put(static_cast<double>(this->Chains.size()));
    put(this->MetalBinders);
    double sum = 0.0, weights = 0.0;
    for (std::size_t k = 0; k < NumberOfResidues; ++k)
    {
      sum += this->Residues[k] * SitePropensity(static_cast<int>(k));
      weights += this->Residues[k];
    }
    put(weights > 0.0 ? sum / weights : 0.0);
  }

  const std::array<double, NumberOfResidues>& NearResidues() const { return this->Residues; }

private:
  void Add(const SiteAtom& atom, const Point3& place, double d)
  {
    this->Counts[ShellOf(BurialReaches, d)] += 1.0;
    this->Around[ShellOf(EnclosureReaches, d)].Add(
      (1.0 / std::max(d, 1e-6)) * (atom.Place - place));
    if (d >= LiningReach)
    {
      return;
    }
    const double weight = 1.0 - d / LiningReach;
    this->Kinds[static_cast<std::size_t>(atom.Kind)] += weight;
    this->Weight += weight;
    this->ChainWeight(atom.Chain) += weight;
    if (d < PropensityReach && atom.Residue >= 0)
    {
      this->Residues[static_cast<std::size_t>(atom.Residue)] += 1.0 - d / PropensityReach;
    }
    this->MetalBinders += d < MetalReach && atom.BindsMetals ? 1.0 : 0.0;
  }

  /// A place has few chains around it.
  double& ChainWeight(int chain)
  {
    for (auto& one : this->Chains)
    {
      if (one.first == chain)
      {
        return one.second;
      }
    }
    this->Chains.emplace_back(chain, 0.0);
    return this->Chains.back().second;
  }

  // The last of each is what lies beyond the reaches, and Other.
  std::array<double, BurialReaches.size() + 1> Counts{};
  std::array<Directions, EnclosureReaches.size() + 1> Around{};
  std::array<double, NumberOfKinds + 1> Kinds{};
  std::array<double, NumberOfResidues> Residues{};
  std::vector<std::pair<int, double>> Chains;
  double Weight = 0.0, MetalBinders = 0.0;
};

/// What the tetrahedra around a place say.
void WriteCellsAround(const std::vector<const PocketCell*>& cells, const PointBins& bins,
  const std::vector<double>& burial, const Point3& place, std::vector<float>& row)
{
  std::array<double, CellReaches.size() + 1> volume{}, sum{}, count{}; // last: beyond
  double clearance = 0.0;
  bins.Near(place, CellReaches.back(),
    [&](std::int64_t id, double squared)
    {
      const auto i = static_cast<std::size_t>(id);
      const std::size_t shell = ShellOf(CellReaches, std::sqrt(squared));
      volume[shell] += std::max(0.0, cells[i]->Volume);
      sum[shell] += burial[i];
      count[shell] += 1.0;
      clearance = shell < 2 ? std::max(clearance, cells[i]->Clearance) : clearance;
    });
  for (std::size_t k = 0; k < CellReaches.size(); ++k)
  {
    if (k > 0)
    {
      volume[k] += volume[k - 1];
      sum[k] += sum[k - 1];
      count[k] += count[k - 1];
    }
    row.push_back(static_cast<float>(volume[k]));
    row.push_back(static_cast<float>(sum[k] / std::max(1.0, count[k])));
  }
  row.push_back(static_cast<float>(count[1]));
  row.push_back(static_cast<float>(clearance));
}

}

SiteAtom SiteAtomOf(
  const Point3& place, int element, const std::string& residue, const std::string& name)
{
  const auto variant = Variants().find(residue);
  const std::string& known = variant != Variants().end() ? variant->second : residue;
  SiteAtom atom;
  atom.Place = place;
  const auto at = std::find(AminoAcids.begin(), AminoAcids.end(), known);
  if (at == AminoAcids.end())
  {
    return atom;
  }
  atom.Kind = KindOf(element, known, name);
  atom.Residue = static_cast<int>(at - AminoAcids.begin()) + (IsBackbone(name) ? 0 : 20);
  atom.BindsMetals = atom.Kind == SiteAtomKind::Acid || atom.Kind == SiteAtomKind::Imidazole ||
    (known == "CYS" && name == "SG");
  return atom;
}

const std::vector<std::string>& SiteDescriptorNames()
{
  static const std::vector<std::string> names{ "Atoms5", "Atoms6", "Atoms8", "Atoms10", "Atoms12",
    "Asymmetry6", "Smallest6", "Middle6", "Asymmetry8", "Smallest8", "Middle8", "Asymmetry12",
    "Smallest12", "Middle12", "Aromatic", "Aliphatic", "Sulfur", "Acid", "Base", "Imidazole",
    "CarbonylOxygen", "AmideNitrogen", "Hydroxyl", "SideChainAmide", "Lining", "OtherChains",
    "Chains", "MetalBinders", "Propensity", "Volume3", "Burial3", "Volume5", "Burial5", "Volume7",
    "Burial7", "Volume10", "Burial10", "Cells5", "Clearance5", "Clearance", "Access", "Narrowing",
    "RelativeBurial" };
  return names;
}

const std::vector<std::string>& SiteResidueNames()
{
  static const std::vector<std::string> names = []()
  {
    std::vector<std::string> made;
    for (const char* part : { " backbone", " side chain" })
    {
      for (const char* residue : AminoAcids)
      {
        made.push_back(std::string(residue) + part);
      }
    }
    return made;
  }();
  return names;
}

SiteDescriptorTable DescribeSites(
  const std::vector<SiteAtom>& atoms, const std::vector<const PocketCell*>& cells, bool residues)
{
  const std::size_t width = SiteDescriptorNames().size();
  SiteDescriptorTable table;
  table.Descriptors.resize(cells.size() * width);
  table.Residues.resize(residues ? cells.size() * NumberOfResidues : 0);
  if (cells.empty())
  {
    return table;
  }
  std::vector<Point3> places, centres;
  for (const SiteAtom& atom : atoms)
  {
    places.push_back(atom.Place);
  }
  for (const PocketCell* cell : cells)
  {
    centres.push_back(cell->Centre);
  }
  const PointBins atomBins(places, 6.0);
  const PointBins cellBins(centres, 5.0);
  std::vector<std::vector<float>> rows(cells.size());
  std::vector<double> burial(cells.size());
  const auto each = [&](const auto& work)
  {
    ParallelFor(0, static_cast<std::int64_t>(cells.size()), 64,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        {
          work(i);
        }
      });
  };
  each(
    [&](std::size_t i)
    {
      const AtomsAround around(atoms, atomBins, centres[i]);
      rows[i].reserve(width);
      around.Write(rows[i]);
      burial[i] = around.Burial();
      for (std::size_t k = 0; residues && k < NumberOfResidues; ++k)
      {
        table.Residues[i * NumberOfResidues + k] = static_cast<float>(around.NearResidues()[k]);
      }
    });
  // The largest burial but for a twentieth of the places: that of a core with a hole may be alone.
  std::vector<double> sorted = burial;
  const auto most = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) * 19 / 20);
  std::nth_element(sorted.begin(), most, sorted.end());
  const double largest = std::max(1.0, *most);
  each(
    [&](std::size_t i)
    {
      std::vector<float>& row = rows[i];
      WriteCellsAround(cells, cellBins, burial, centres[i], row);
      row.push_back(static_cast<float>(cells[i]->Clearance));
      row.push_back(static_cast<float>(cells[i]->Access));
      row.push_back(static_cast<float>(cells[i]->Access - cells[i]->Clearance));
      row.push_back(static_cast<float>(burial[i] / largest));
      std::copy(
        row.begin(), row.end(), table.Descriptors.begin() + static_cast<std::ptrdiff_t>(i * width));
    });
  return table;
}

}
