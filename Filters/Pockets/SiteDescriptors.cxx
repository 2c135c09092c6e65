#include "Pockets/SiteDescriptors.h"

#include "Atoms/PointBins.h"
#include "Core/ParallelFor.h"
#include "Pockets/SiteModel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
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
constexpr double AtomBin = 6.0; // angstrom
constexpr double CellBin = 5.0;

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
bool IsInList(const std::string& word, const std::set<std::string>& words)
{
  return words.count(word) > 0;
}

SiteAtomKind ClassifySiteAtom(int element, const std::string& residue, const std::string& name)
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
  if (IsInList(word, rings))
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
    if (IsInList(word, *words))
    {
      return kind;
    }
  }
  const bool apolar = element == 6 && !IsBackbone(name) && !IsInList(word, polarCarbons);
  return apolar ? SiteAtomKind::Aliphatic : SiteAtomKind::Other;
}

constexpr std::size_t Lanes = 4; // sums at a time, so that compilers use wide instructions
using LaneSums = std::array<double, Lanes>;

double ComputeSum(const LaneSums& sums)
{
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// Points by coordinate, in the order of PointBins.
struct PointColumns
{
  std::array<std::vector<double>, 3> At;

  explicit PointColumns(const std::vector<Point3>& points)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->At[axis].reserve(points.size());
      for (const Point3& point : points)
      {
        this->At[axis].push_back(point[axis]);
      }
    }
  }
};

/// Points around a place, padded to full Lanes with points far away.
struct NearPoints
{
  std::size_t Count = 0; ///< without the padding
  std::vector<std::size_t> Positions;
  std::vector<double> Squared; ///< distances
  std::array<std::vector<double>, 3> Difference;

  std::size_t PaddedCount() const { return (this->Count + Lanes - 1) / Lanes * Lanes; }

  void MakeRoom(std::size_t count)
  {
    if (this->Squared.size() < count)
    {
      this->Positions.resize(2 * count);
      this->Squared.resize(2 * count);
      for (auto& axis : this->Difference)
      {
        axis.resize(2 * count);
      }
    }
  }

  void Pad()
  {
    for (std::size_t i = this->Count; i < this->PaddedCount(); ++i)
    {
      this->Squared[i] = std::numeric_limits<double>::infinity();
      for (auto& axis : this->Difference)
      {
        axis[i] = 0.0;
      }
    }
  }

  /// Points nearer than `reach`.
  void Gather(const PointBins& bins, const PointColumns& points, const Point3& place, double reach)
  {
    this->Count = 0;
    bins.NearRanges(place, reach,
      [&](std::size_t first, std::size_t last)
      {
        this->MakeRoom(this->Count + last - first + Lanes);
        this->Append(first, last, points, place, reach * reach);
      });
    this->Pad();
  }

  /// Those of `all` that are nearer than `reach`.
  void CopyNearer(const NearPoints& all, double reach)
  {
    this->MakeRoom(all.Count + Lanes);
    std::size_t count = 0;
    for (std::size_t i = 0; i < all.Count; ++i)
    {
      this->Positions[count] = all.Positions[i];
      this->Squared[count] = all.Squared[i];
      this->Difference[0][count] = all.Difference[0][i];
      this->Difference[1][count] = all.Difference[1][i];
      this->Difference[2][count] = all.Difference[2][i];
      count += all.Squared[i] < reach * reach ? 1 : 0;
    }
    this->Count = count;
    this->Pad();
  }

  /// Divides the differences by their lengths.
  void MakeUnit()
  {
    const double* squared = this->Squared.data();
    double* x = this->Difference[0].data();
    double* y = this->Difference[1].data();
    double* z = this->Difference[2].data();
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const double inverse = 1.0 / std::sqrt(std::max(squared[i], 1e-12));
      x[i] *= inverse;
      y[i] *= inverse;
      z[i] *= inverse;
    }
  }

  double CountWithin(double reach) const
  {
    LaneSums counts{};
    for (std::size_t i = 0; i < this->Count; i += Lanes)
    {
      for (std::size_t lane = 0; lane < Lanes; ++lane)
      {
        counts[lane] += this->Squared[i + lane] < reach * reach ? 1.0 : 0.0;
      }
    }
    return ComputeSum(counts);
  }

private:
  /// Writing beyond the end costs less than a branch.
  void Append(std::size_t first, std::size_t last, const PointColumns& points, const Point3& from,
    double limit)
  {
    const double px = from[0], py = from[1], pz = from[2];
    const double *atX = points.At[0].data(), *atY = points.At[1].data(), *atZ = points.At[2].data();
    std::size_t* positions = this->Positions.data();
    double *squares = this->Squared.data(), *dx = this->Difference[0].data();
    double *dy = this->Difference[1].data(), *dz = this->Difference[2].data();
    std::size_t count = this->Count;
    for (std::size_t i = first; i < last; ++i)
    {
      const double x = atX[i] - px;
      const double y = atY[i] - py;
      const double z = atZ[i] - pz;
      const double squared = x * x + y * y + z * z;
      positions[count] = i;
      squares[count] = squared;
      dx[count] = x;
      dy[count] = y;
      dz[count] = z;
      count += squared < limit ? 1 : 0;
    }
    this->Count = count;
  }
};

/// Working memory of one thread, reused from place to place.
struct Scratch
{
  NearPoints All, Some, Fewer;
  std::vector<double> Volumes, Burials;
  std::vector<std::pair<int, double>> Chains;
};

/// Sums over unit vectors.
struct Directions
{
  double Count = 0.0;
  Point3 Sum{ 0.0, 0.0, 0.0 };
  std::array<double, 6> Products{}; ///< xx, yy, zz, xy, xz, yz

  explicit Directions(const NearPoints& unit)
    : Count(static_cast<double>(unit.Count))
  {
    std::array<LaneSums, 9> sums{};
    const double* x = unit.Difference[0].data();
    const double* y = unit.Difference[1].data();
    const double* z = unit.Difference[2].data();
    for (std::size_t i = 0; i < unit.Count; i += Lanes)
    {
      for (std::size_t lane = 0; lane < Lanes; ++lane)
      {
        const double u = x[i + lane], v = y[i + lane], w = z[i + lane];
        sums[0][lane] += u;
        sums[1][lane] += v;
        sums[2][lane] += w;
        sums[3][lane] += u * u;
        sums[4][lane] += v * v;
        sums[5][lane] += w * w;
        sums[6][lane] += u * v;
        sums[7][lane] += u * w;
        sums[8][lane] += v * w;
      }
    }
    for (std::size_t k = 0; k < sums.size(); ++k)
    {
      (k < 3 ? this->Sum[k] : this->Products[k - 3]) = ComputeSum(sums[k]);
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

/// Descriptors from the atoms around a place.
class AtomsAround
{
public:
  AtomsAround(const std::vector<SiteAtom>& atoms, Scratch& scratch)
  {
    static_assert(LiningReach == EnclosureReaches[1] && EnclosureReaches[2] == BurialReaches[4] &&
        EnclosureReaches[1] == BurialReaches[2] && EnclosureReaches[0] == BurialReaches[1],
      "All, Some and Fewer are for all of them");
    NearPoints& all = scratch.All;
    scratch.Chains.clear();
    all.MakeUnit();
    scratch.Some.CopyNearer(all, EnclosureReaches[1]);
    scratch.Fewer.CopyNearer(scratch.Some, EnclosureReaches[0]);
    this->Counts = { scratch.Fewer.CountWithin(BurialReaches[0]),
      static_cast<double>(scratch.Fewer.Count), static_cast<double>(scratch.Some.Count),
      all.CountWithin(BurialReaches[3]), static_cast<double>(all.Count) };
    this->Enclosures = { Directions(scratch.Fewer).Enclosure(),
      Directions(scratch.Some).Enclosure(), Directions(all).Enclosure() };
    for (std::size_t i = 0; i < scratch.Some.Count; ++i)
    {
      this->AddLining(
        atoms[scratch.Some.Positions[i]], std::sqrt(scratch.Some.Squared[i]), scratch.Chains);
    }
    for (const auto& chain : scratch.Chains)
    {
      this->LargestChain = std::max(this->LargestChain, chain.second);
    }
    this->ChainCount = static_cast<double>(scratch.Chains.size());
  }

  double Burial() const { return this->Counts[3]; }

  void Write(const double* propensity, std::vector<float>& row) const
  {
    const auto put = [&](double value) { row.push_back(static_cast<float>(value)); };
    std::for_each(this->Counts.begin(), this->Counts.end(), put);
    for (const auto& enclosure : this->Enclosures)
    {
      std::for_each(enclosure.begin(), enclosure.end(), put);
    }
    std::for_each(this->Kinds.begin(), this->Kinds.end() - 1, put);
    put(this->Weight);
    put(this->Weight > 0.0 ? 1.0 - this->LargestChain / this->Weight : 0.0);
    put(this->ChainCount);
    put(this->MetalBinders);
    double sum = 0.0, weights = 0.0;
    for (std::size_t k = 0; k < NumberOfResidues; ++k)
    {
      sum += this->Residues[k] * propensity[k];
      weights += this->Residues[k];
    }
    put(weights > 0.0 ? sum / weights : 0.0);
  }

  const std::array<double, NumberOfResidues>& NearResidues() const { return this->Residues; }

private:
  void AddLining(const SiteAtom& atom, double d, std::vector<std::pair<int, double>>& chains)
  {
    const double weight = 1.0 - d / LiningReach;
    this->Kinds[static_cast<std::size_t>(atom.Kind)] += weight;
    this->Weight += weight;
    ChainWeight(atom.Chain, chains) += weight;
    if (d < PropensityReach && atom.Residue >= 0)
    {
      this->Residues[static_cast<std::size_t>(atom.Residue)] += 1.0 - d / PropensityReach;
    }
    this->MetalBinders += d < MetalReach && atom.BindsMetals ? 1.0 : 0.0;
  }

  /// A place has few chains around it.
  static double& ChainWeight(int chain, std::vector<std::pair<int, double>>& chains)
  {
    for (auto& one : chains)
    {
      if (one.first == chain)
      {
        return one.second;
      }
    }
    chains.emplace_back(chain, 0.0);
    return chains.back().second;
  }

  std::array<double, BurialReaches.size()> Counts{};
  std::array<std::array<double, 3>, EnclosureReaches.size()> Enclosures{};
  std::array<double, NumberOfKinds + 1> Kinds{}; ///< the last: Other
  std::array<double, NumberOfResidues> Residues{};
  double Weight = 0.0, LargestChain = 0.0, ChainCount = 0.0, MetalBinders = 0.0;
};

/// Values that a tetrahedron contributes to its neighbours.
struct CellNear
{
  double Volume, Burial, Clearance;
};

/// Descriptors from the tetrahedra around a place: those of scratch.All, whose positions `cells`
/// has.
void WriteCellsAround(const std::vector<CellNear>& cells, Scratch& scratch, std::vector<float>& row)
{
  NearPoints& all = scratch.All;
  scratch.Volumes.resize(std::max(scratch.Volumes.size(), all.Count + Lanes));
  scratch.Burials.resize(scratch.Volumes.size());
  double clearance = 0.0;
  for (std::size_t i = 0; i < all.Count; ++i)
  {
    const CellNear& cell = cells[all.Positions[i]];
    scratch.Volumes[i] = cell.Volume;
    scratch.Burials[i] = cell.Burial;
    const bool isNear = all.Squared[i] < CellReaches[1] * CellReaches[1];
    clearance = std::max(clearance, isNear ? cell.Clearance : 0.0);
  }
  double* squares = all.Squared.data();
  double* volumes = scratch.Volumes.data();
  double* burials = scratch.Burials.data();
  std::array<double, CellReaches.size()> volume{}, burial{}, counts{};
  std::size_t count = all.Count;
  for (std::size_t k = CellReaches.size(); k-- > 0;)
  {
    // Keeps the other atoms within the larger reach.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const bool isNear = squares[i] < CellReaches[k] * CellReaches[k];
      squares[kept] = squares[i];
      volumes[kept] = volumes[i];
      burials[kept] = burials[i];
      kept += isNear ? 1 : 0;
    }
    count = kept;
    std::fill(volumes + count, volumes + count + Lanes, 0.0);
    std::fill(burials + count, burials + count + Lanes, 0.0);
    LaneSums volumeSums{}, burialSums{};
    for (std::size_t i = 0; i < count; i += Lanes)
    {
      for (std::size_t lane = 0; lane < Lanes; ++lane)
      {
        volumeSums[lane] += volumes[i + lane];
        burialSums[lane] += burials[i + lane];
      }
    }
    volume[k] = ComputeSum(volumeSums);
    burial[k] = ComputeSum(burialSums);
    counts[k] = static_cast<double>(count);
  }
  for (std::size_t k = 0; k < CellReaches.size(); ++k)
  {
    row.push_back(static_cast<float>(volume[k]));
    row.push_back(static_cast<float>(burial[k] / std::max(1.0, counts[k])));
  }
  row.push_back(static_cast<float>(counts[1]));
  row.push_back(static_cast<float>(clearance));
}

std::vector<Point3> CollectPlaces(const std::vector<SiteAtom>& atoms)
{
  std::vector<Point3> places;
  places.reserve(atoms.size());
  for (const SiteAtom& atom : atoms)
  {
    places.push_back(atom.Place);
  }
  return places;
}

/// The same, in another order.
template <typename T>
std::vector<T> Reorder(const std::vector<T>& values, const std::vector<std::int64_t>& order)
{
  std::vector<T> reordered;
  reordered.reserve(order.size());
  for (const std::int64_t i : order)
  {
    reordered.push_back(values[static_cast<std::size_t>(i)]);
  }
  return reordered;
}

}

SiteAtom MakeSiteAtom(
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
  atom.Kind = ClassifySiteAtom(element, known, name);
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

SiteDescriptorTable DescribeSites(const std::vector<SiteAtom>& atoms,
  const std::vector<const PocketCell*>& cells, bool residues, const ProgressCallback& progress)
{
  const std::size_t width = SiteDescriptorNames().size();
  SiteDescriptorTable table;
  table.Descriptors.resize(cells.size() * width);
  table.Residues.resize(residues ? cells.size() * NumberOfResidues : 0);
  if (cells.empty())
  {
    return table;
  }
  // Neighbours in space become neighbours in memory: work item j is cell order[j].
  std::vector<Point3> centers;
  centers.reserve(cells.size());
  for (const PocketCell* cell : cells)
  {
    centers.push_back(cell->Center);
  }
  const std::vector<std::int64_t> order = PointBins(centers, CellBin).Order();
  centers = Reorder(centers, order);
  const std::vector<const PocketCell*> ordered = Reorder(cells, order);
  const std::vector<SiteAtom> near =
    Reorder(atoms, PointBins(CollectPlaces(atoms), AtomBin).Order());
  const PointBins atomBins(CollectPlaces(near), AtomBin);
  const PointBins cellBins(centers, CellBin);
  const PointColumns atomColumns(CollectPlaces(near));
  const PointColumns cellColumns(centers);
  const auto each = [&](const ProgressCallback& part, const auto& work)
  {
    ParallelFor(
      0, static_cast<std::int64_t>(cells.size()), 64,
      [&](std::int64_t begin, std::int64_t end)
      {
        Scratch scratch;
        for (auto j = static_cast<std::size_t>(begin); j < static_cast<std::size_t>(end); ++j)
        {
          work(j, static_cast<std::size_t>(order[j]), scratch);
        }
      },
      part);
  };
  std::vector<std::vector<float>> rows(cells.size());
  std::vector<CellNear> told(cells.size());
  each(Between(progress, 0.0, 0.6),
    [&](std::size_t j, std::size_t i, Scratch& scratch)
    {
      scratch.All.Gather(atomBins, atomColumns, centers[j], BurialReaches.back());
      const AtomsAround around(near, scratch);
      rows[j].reserve(width);
      around.Write(GetSiteModel().Propensity, rows[j]);
      told[j] = { std::max(0.0, ordered[j]->Volume), around.Burial(), ordered[j]->Clearance };
      for (std::size_t k = 0; residues && k < NumberOfResidues; ++k)
      {
        table.Residues[i * NumberOfResidues + k] = static_cast<float>(around.NearResidues()[k]);
      }
    });
  // The 95th percentile of the burial: a core with a hole may have a single outlier.
  std::vector<double> sorted;
  sorted.reserve(told.size());
  for (const CellNear& cell : told)
  {
    sorted.push_back(cell.Burial);
  }
  const auto most = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) * 19 / 20);
  std::nth_element(sorted.begin(), most, sorted.end());
  const double largest = std::max(1.0, *most);
  each(Between(progress, 0.6, 1.0),
    [&](std::size_t j, std::size_t i, Scratch& scratch)
    {
      std::vector<float>& row = rows[j];
      scratch.All.Gather(cellBins, cellColumns, centers[j], CellReaches.back());
      WriteCellsAround(told, scratch, row);
      const PocketCell& cell = *ordered[j];
      row.push_back(static_cast<float>(cell.Clearance));
      row.push_back(static_cast<float>(cell.Access));
      row.push_back(static_cast<float>(cell.Access - cell.Clearance));
      row.push_back(static_cast<float>(told[j].Burial / largest));
      std::copy(
        row.begin(), row.end(), table.Descriptors.begin() + static_cast<std::ptrdiff_t>(i * width));
    });
  return table;
}

}
