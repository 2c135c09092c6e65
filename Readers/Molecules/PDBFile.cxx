#include "Molecules/PDBFile.h"

#include "Core/LargePages.h"
#include "Core/ParallelFor.h"
#include "Files/TextLines.h"
#include "Molecules/AtomElements.h"
#include "Molecules/BiologicalAssembly.h"
#include "Molecules/MoleculeParsers.h"
#include "Molecules/PDBColumns.h"
#include "Molecules/ResidueOrder.h"
#include "Molecules/StructureRecords.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include <gemmi/pdb.hpp>

namespace isthmus
{
namespace
{

/// Thrown for a line whose coordinates are not in the columns of PDB.
struct NonstandardColumnsError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

struct PDBMolecule
{
  std::vector<Atom> Atoms;           ///< in the order of the file, but those of a residue together
  std::vector<std::size_t> Residues; ///< the first atom of each
  std::vector<Bond> Bonds;           ///< of CONECT, each as often as the file names it
  std::vector<Bond> Links;           ///< of SSBOND and LINK, within the asymmetric unit
};

constexpr std::int64_t AtomsAtOnce = 1 << 13;

/// The number that a field begins with, as programs in C read it; NaN if it begins with none.
double NumberAtBegin(std::string_view field)
{
  double value = 0.0;
  if (IsShortDecimal(field, value))
  {
    return value;
  }
  if (!field.empty() && field[0] == '+')
  {
    field.remove_prefix(1);
  }
  const auto result = std::from_chars(field.data(), field.data() + field.size(), value);
  return result.ec == std::errc() && std::isfinite(value) ? value : Atom::Unknown;
}

/// Lines of a chain with the same residue are one residue, even if other residues are between them.
ResidueOrder FindResidueOrder(const std::vector<PDBRun>& runs)
{
  std::vector<ResidueRun> found;
  found.reserve(runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    const PDBRun& run = runs[r];
    const bool isChain = r > 0 && (run.Chain != runs[r - 1].Chain || run.Part != runs[r - 1].Part);
    const std::size_t group = r == 0 ? 0 : found[r - 1].Group + (isChain ? 1 : 0);
    found.push_back({ run.First, run.Last, group, run.Number.value_or(0), run.Name,
      static_cast<char>(run.InsertionCode | 0x20), run.Segment });
  }
  return FindResidueOrder(found);
}

// ------------------------------------------------------------------------------------------
// Lines

/// Whether columns 77-80 hold the number of a line or anything else than element and charge.
bool HasOldColumns(std::string_view line)
{
  if (line.size() < 79 || (line[78] == ' ' && (line.size() < 80 || line[79] == ' ')))
  {
    return false;
  }
  const std::size_t shift = CoordinateShift(line);
  const bool noElement =
    Columns(line, 76 + shift, 2).find_first_not_of("0123456789") == std::string_view::npos;
  const std::string_view charge = Columns(line, 78 + shift, 2);
  return noElement && !charge.empty() && charge.find_first_of("+-") == std::string_view::npos;
}

/// Whether most atoms have other data in columns 73-80, as files from before 1996 do.
bool HasOldColumns(const PDBLines& lines, const PDBModel& model)
{
  std::size_t all = 0;
  std::size_t old = 0;
  for (const PDBPart& part : model)
  {
    for (std::size_t i = part.First; i < part.Last; ++i)
    {
      old += HasOldColumns(lines.Atoms[i]) ? 1 : 0;
    }
    all += part.Last - part.First;
  }
  return 2 * old > all;
}

/// "2+", "+2" or "2"; nothing otherwise.
std::optional<double> ParseCharge(std::string_view text)
{
  if (text.empty())
  {
    return Atom::Unknown;
  }
  char digit = text[0];
  char sign = text.size() > 1 ? text[1] : ' ';
  if (IsDigit(sign))
  {
    std::swap(digit, sign);
  }
  if (!IsDigit(digit) || (sign != '+' && sign != '-' && sign != ' '))
  {
    return {};
  }
  const double charge = (digit - '0') * (sign == '-' ? -1.0 : 1.0);
  return charge == 0.0 ? Atom::Unknown : charge;
}

/// Faults of lines, with the first one of each kind.
struct Faults
{
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  std::size_t NoCoordinate = None; ///< lines of PDBLines::Atoms
  std::size_t NoCoordinateColumn = 0;
  std::size_t Short = None;
  std::size_t Lost = 0; ///< asterisks for coordinates
  std::size_t FirstLost = None;
  std::size_t Shifted = 0;
  std::size_t BadValues = 0; ///< occupancies and B factors
  std::size_t FirstBadValue = None;
  std::size_t BadCharges = 0;
  std::size_t FirstBadCharge = None;
  std::size_t OddSerials = 0;

  void Add(const Faults& other)
  {
    if (other.NoCoordinate < this->NoCoordinate)
    {
      this->NoCoordinate = other.NoCoordinate;
      this->NoCoordinateColumn = other.NoCoordinateColumn;
    }
    this->Short = std::min(this->Short, other.Short);
    this->Lost += other.Lost;
    this->FirstLost = std::min(this->FirstLost, other.FirstLost);
    this->Shifted += other.Shifted;
    this->BadValues += other.BadValues;
    this->FirstBadValue = std::min(this->FirstBadValue, other.FirstBadValue);
    this->BadCharges += other.BadCharges;
    this->FirstBadCharge = std::min(this->FirstBadCharge, other.FirstBadCharge);
    this->OddSerials += other.OddSerials;
  }
};

/// Columns 7-11, or 7-12 where six digits are.
std::string_view GetSerial(std::string_view line)
{
  const bool isWide = line.size() > 11 && IsDigit(line[11]) && IsDigit(line[10]);
  return Columns(line, 6, isWide ? 6 : 5);
}

bool ReadPosition(std::string_view line, const std::array<std::size_t, 4>& ends, std::size_t index,
  Atom& atom, Faults& faults)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::string_view field = Columns(line, ends[axis], ends[axis + 1] - ends[axis]);
    if (IsNumber(field, atom.Position[axis]) && std::isfinite(atom.Position[axis]))
    {
      continue;
    }
    if (field.size() > 3 && field.find_first_not_of('*') == std::string_view::npos)
    {
      ++faults.Lost;
      faults.FirstLost = std::min(faults.FirstLost, index);
      atom.Position[axis] = Atom::Unknown;
    }
    else if (index < faults.NoCoordinate)
    {
      faults.NoCoordinate = index;
      faults.NoCoordinateColumn = ends[axis];
    }
    return false;
  }
  if (line.size() < ends[3])
  {
    faults.Short = std::min(faults.Short, index);
    return false;
  }
  faults.Shifted += ends[3] > 54 ? 1 : 0;
  return true;
}

void ReadAtom(std::string_view line, std::size_t index, bool withColumns73To80, Atom& atom,
  AtomColumns& columns, Faults& faults)
{
  const std::array<std::size_t, 4> ends = CoordinateColumns(line);
  if (!ReadPosition(line, ends, index, atom, faults))
  {
    return;
  }
  atom.Name = Columns(line, 12, 4);
  atom.AltLoc = line[16];
  const std::string_view serial = GetSerial(line);
  faults.OddSerials += IsNumber(serial, atom.Serial) ? 0 : 1;
  const std::size_t shift = ends[3] - 54;
  for (const auto& [from, value] :
    { std::pair(54 + shift, &atom.Occupancy), std::pair(60 + shift, &atom.BFactor) })
  {
    const std::string_view field = Columns(line, from, 6);
    *value = NumberAtBegin(field);
    if (std::isnan(*value) && !field.empty())
    {
      ++faults.BadValues;
      faults.FirstBadValue = std::min(faults.FirstBadValue, index);
    }
  }
  std::copy_n(line.begin() + 12, 4, columns.Name.begin());
  columns.Symbol = { ' ', ' ' };
  if (!withColumns73To80)
  {
    return;
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    columns.Symbol[i] = 76 + shift + i < line.size() ? line[76 + shift + i] : ' ';
  }
  const std::optional<double> charge = ParseCharge(Columns(line, 78 + shift, 2));
  atom.Charge = charge.value_or(Atom::Unknown);
  if (!charge)
  {
    ++faults.BadCharges;
    faults.FirstBadCharge = std::min(faults.FirstBadCharge, index);
  }
}

// ------------------------------------------------------------------------------------------
// Residue names of five letters, as in gemmi's documentation ("tilde-hetnam")

/// The full names of shortened ones: ~00 of HETNAM in columns 12-14 with the full name in columns
/// 72-79 or, as others write it, alone after it.
std::map<std::string, std::string> ReadShortenedNames(std::string_view text)
{
  std::map<std::string, std::string> names;
  TextLines lines(text, {}, {});
  for (std::string_view line; lines.Next(line);)
  {
    if (line.substr(0, 6) != "HETNAM" || Columns(line, 11, 1) != "~")
    {
      continue;
    }
    std::string_view full = Columns(line, 71, 8);
    std::string_view described = Columns(line, 15, 55);
    full = full.empty() && described.find(' ') == std::string_view::npos ? described : full;
    if (!full.empty())
    {
      names.emplace(Columns(line, 11, 3), full);
    }
  }
  return names;
}

void ExpandShortenedNames(std::string_view text, std::vector<Atom>& atoms, ReadingReport& report)
{
  const auto isShort = [](const Atom& atom)
  { return !atom.ResidueName.empty() && atom.ResidueName[0] == '~'; };
  if (std::none_of(atoms.begin(), atoms.end(), isShort))
  {
    return;
  }
  const std::map<std::string, std::string> names = ReadShortenedNames(text);
  std::set<std::string> used;
  std::set<std::string> unknown;
  for (Atom& atom : atoms)
  {
    if (!isShort(atom))
    {
      continue;
    }
    const auto full = names.find(atom.ResidueName);
    if (full == names.end())
    {
      unknown.insert(atom.ResidueName);
      continue;
    }
    used.insert(full->first + " is " + full->second);
    atom.ResidueName = full->second;
  }
  const auto list = [](const std::set<std::string>& items)
  {
    std::string all;
    for (const std::string& item : items)
    {
      all += (all.empty() ? "" : ", ") + item;
    }
    return all;
  };
  if (!used.empty())
  {
    report.Note("Shortened residue names, replaced by those of HETNAM: " + list(used) + ".");
  }
  if (!unknown.empty())
  {
    report.Note("Shortened residue names whose full names the file does not give (HETNAM): " +
      list(unknown) + ".");
  }
}

// ------------------------------------------------------------------------------------------
// The model

class ModelReader
{
public:
  ModelReader(std::string_view text, const std::string& path, const PDBLines& lines,
    const PDBModel& model, bool isOfCopies, ReadingReport& report)
    : Text(text)
    , Path(path)
    , Lines(lines)
    , Model(model)
    , IsOfCopies(isOfCopies)
    , Report(report)
  {
  }

  PDBMolecule Read(const ProgressCallback& progress)
  {
    const bool isOld = HasOldColumns(this->Lines, this->Model);
    if (isOld)
    {
      this->Report.Warn("Columns 73-80 contain something other than segment, element and charge, "
                        "as in old PDB files; they were ignored.");
    }
    this->Runs = ReadRuns(this->Lines, this->Model, !isOld, this->Names, this->Report);
    ResidueOrder order = FindResidueOrder(this->Runs);
    this->ReadAtoms(order, !isOld, progress);
    this->Result.Residues = std::move(order.Starts);
    this->ReportFaults();
    this->DropLost();
    if (this->Problems.OddSerials > 0)
    {
      this->ReadSerials();
    }
    SetElements(this->Result.Atoms, this->Texts, this->Result.Residues, this->Report);
    this->AddConect();
    this->AddLinks();
    ExpandShortenedNames(this->Text, this->Result.Atoms, this->Report);
    return std::move(this->Result);
  }

private:
  void ReadAtoms(
    const ResidueOrder& order, bool withColumns73To80, const ProgressCallback& progress)
  {
    std::vector<std::size_t> firstRun(order.Starts.size()); // which names the residue
    std::size_t count = 0;
    for (std::size_t r = this->Runs.size(); r-- > 0;)
    {
      firstRun[order.Residue[r]] = r;
      count += this->Runs[r].Last - this->Runs[r].First;
    }
    this->Result.Atoms.reserve(count);
    AdviseLargePages(this->Result.Atoms.data(), count * sizeof(Atom));
    this->Result.Atoms.resize(count);
    this->Texts.resize(count);
    this->LineOfAtom.resize(count);
    std::mutex mutex;
    ParallelFor(
      0, static_cast<std::int64_t>(this->Runs.size()), AtomsAtOnce / 8,
      [&](std::int64_t first, std::int64_t last)
      {
        Faults faults;
        for (auto r = static_cast<std::size_t>(first); r < static_cast<std::size_t>(last); ++r)
        {
          const PDBRun& run = this->Runs[r];
          const PDBRun& residue = this->Runs[firstRun[order.Residue[r]]];
          const bool isHetero = (this->Lines.Atoms[residue.First][0] & ~0x20) == 'H';
          std::size_t place = order.Place[r];
          for (std::size_t i = run.First; i < run.Last; ++i, ++place)
          {
            Atom& atom = this->Result.Atoms[place];
            this->LineOfAtom[place] = i;
            ReadAtom(this->Lines.Atoms[i], i, withColumns73To80, atom, this->Texts[place], faults);
            atom.ResidueName = residue.Name;
            atom.Chain = residue.Chain;
            atom.ResidueId = residue.Number.value_or(0);
            atom.InsertionCode = residue.InsertionCode;
            atom.IsHetero = isHetero;
          }
        }
        const std::lock_guard<std::mutex> lock(mutex);
        this->Problems.Add(faults);
      },
      progress);
  }

  std::string Here(std::size_t atom) const
  {
    return FormatLineNumber(this->Text, this->Lines.Atoms[atom]);
  }

  void ReportFaults()
  {
    const Faults& found = this->Problems;
    if (found.NoCoordinate < found.Short)
    {
      throw NonstandardColumnsError(this->Path + ", " + this->Here(found.NoCoordinate) +
        ": columns " + std::to_string(found.NoCoordinateColumn + 1) + " to " +
        std::to_string(found.NoCoordinateColumn + 8) +
        " hold no coordinate (a finite number). The file may be damaged, or not a PDB file.");
    }
    if (found.Short != Faults::None)
    {
      throw std::runtime_error(this->Path + ", " + this->Here(found.Short) +
        ": the line ends within its coordinates. The file may be truncated.");
    }
    const auto count = [this](std::size_t times, const char* what, std::size_t first)
    {
      if (times > 0)
      {
        this->Report.Count(what, this->Here(first), times);
      }
    };
    count(found.Lost, "Atoms with asterisks for coordinates, dropped", found.FirstLost);
    count(found.BadValues, "Occupancies and B factors that are not numbers, dropped",
      found.FirstBadValue);
    count(
      found.BadCharges, "Unreadable formal charges (columns 79-80), dropped", found.FirstBadCharge);
    if (found.Shifted > 0)
    {
      this->Report.Note(
        "Atoms with coordinates wider than their columns, which shift what follows: " +
        std::to_string(found.Shifted) + ".");
    }
  }

  /// Removes atoms whose coordinates are asterisks, and residues without atoms.
  void DropLost()
  {
    if (this->Problems.Lost == 0)
    {
      return;
    }
    std::vector<std::size_t> kept;
    std::vector<std::size_t> starts;
    std::vector<std::size_t>& residues = this->Result.Residues;
    residues.push_back(this->Result.Atoms.size());
    for (std::size_t r = 0; r + 1 < residues.size(); ++r)
    {
      const std::size_t before = kept.size();
      for (std::size_t i = residues[r]; i < residues[r + 1]; ++i)
      {
        const auto& x = this->Result.Atoms[i].Position;
        if (!std::isnan(x[0] + x[1] + x[2]))
        {
          kept.push_back(i);
        }
      }
      if (kept.size() > before)
      {
        starts.push_back(before);
      }
    }
    residues = std::move(starts);
    Reorder(this->Result.Atoms, kept);
    Reorder(this->Texts, kept);
    Reorder(this->LineOfAtom, kept);
  }

  /// Serial numbers that can only be decoded from those before them.
  void ReadSerials()
  {
    std::unordered_map<std::size_t, int> serials;
    PDBSerials decoder;
    for (const PDBPart& part : this->Model)
    {
      for (std::size_t i = part.First; i < part.Last; ++i)
      {
        serials.emplace(i, decoder.Next(GetSerial(this->Lines.Atoms[i])));
      }
    }
    this->IsHexadecimal = decoder.AnyHexadecimal();
    for (std::size_t i = 0; i < this->Result.Atoms.size(); ++i)
    {
      this->Result.Atoms[i].Serial = serials.at(this->LineOfAtom[i]);
    }
  }

  // ---------------------------------------------------------------------------------------
  // Bonds

  /// The part of the model that a record is in; none if it is in none and concerns all.
  std::optional<std::size_t> FindPart(const PDBRecord& record) const
  {
    if (this->Model.size() < 2)
    {
      return {};
    }
    const bool isBefore = record.Is == PDBRecord::Kind::Link; // SSBOND and LINK come first
    if (!isBefore && record.Atom == 0)
    {
      return {};
    }
    return this->PartOfLine(isBefore ? record.Atom : record.Atom - 1);
  }

  /// The parts to which a record applies: the one that it is in, or each of several copies.
  std::vector<std::optional<std::size_t>> FindParts(const PDBRecord& record) const
  {
    if (!this->IsOfCopies)
    {
      return { this->FindPart(record) };
    }
    std::vector<std::optional<std::size_t>> parts;
    for (std::size_t part = 0; part < this->Model.size(); ++part)
    {
      parts.emplace_back(part);
    }
    return parts;
  }

  /// The part with an atom of PDBLines; none if it is of another model.
  std::optional<std::size_t> PartOfLine(std::size_t atom) const
  {
    const auto after = std::upper_bound(this->Model.begin(), this->Model.end(), atom,
      [](std::size_t line, const PDBPart& part) { return line < part.First; });
    if (after == this->Model.begin() || atom >= (after - 1)->Last)
    {
      return {};
    }
    return static_cast<std::size_t>(after - this->Model.begin()) - 1;
  }

  /// From a serial number to the index of its atom; -1 if there are several.
  using Places = std::unordered_map<int, std::int64_t>;

  /// Those of a part, whose atoms are consecutive, or of all.
  Places IndexAtoms(std::optional<std::size_t> part) const
  {
    std::size_t first = 0;
    std::size_t last = this->Result.Atoms.size();
    if (part)
    {
      const auto begin = [this](std::size_t p)
      {
        const auto found = std::partition_point(this->LineOfAtom.begin(), this->LineOfAtom.end(),
          [&](std::size_t line) { return line < this->Model[p].First; });
        return static_cast<std::size_t>(found - this->LineOfAtom.begin());
      };
      first = begin(*part);
      last = *part + 1 < this->Model.size() ? begin(*part + 1) : last;
    }
    Places places;
    places.reserve(last - first);
    for (std::size_t i = first; i < last; ++i)
    {
      const auto [found, isNew] =
        places.emplace(this->Result.Atoms[i].Serial, static_cast<std::int64_t>(i));
      found->second = isNew ? found->second : -1;
    }
    return places;
  }

  /// The numbers that a field of a CONECT record can mean.
  std::vector<int> Meanings(std::string_view field) const
  {
    std::vector<int> numbers;
    const auto add = [&](std::optional<int> number)
    {
      if (number)
      {
        numbers.push_back(*number);
      }
    };
    int decimal = 0;
    if (IsNumber(field, decimal))
    {
      numbers.push_back(decimal);
    }
    if (this->IsHexadecimal)
    {
      add(PDBNumber(field, 16));
    }
    if (numbers.empty() && field.size() == 5)
    {
      add(PDBNumber(field, 36));
    }
    return numbers;
  }

  /// Fields of a CONECT record: five columns each, or words where serials have six digits.
  std::vector<std::string_view> ConectFields(std::string_view line) const
  {
    std::vector<std::string_view> fields;
    std::string_view rest = line.substr(6);
    if (this->HasLongSerials)
    {
      for (auto word = NextWord(rest); !word.empty(); word = NextWord(rest))
      {
        for (; word.size() > 6; word.remove_prefix(6))
        {
          fields.push_back(word.substr(0, 6));
        }
        fields.push_back(word);
      }
      return fields;
    }
    for (std::size_t at = 6; at < 31; at += 5)
    {
      const std::string_view field = Columns(line, at, 5);
      if (!field.empty() || at == 6)
      {
        fields.push_back(field);
      }
    }
    return fields;
  }

  enum class Found
  {
    Unreadable,
    Missing,
    Ambiguous,
    One
  };

  Found Find(std::string_view field, const Places& places, std::int64_t& place) const
  {
    const std::vector<int> meanings = this->Meanings(field);
    if (meanings.empty())
    {
      return Found::Unreadable;
    }
    int count = 0;
    for (const int number : meanings)
    {
      const auto found = places.find(number);
      if (found != places.end())
      {
        place = found->second;
        count += place < 0 ? 2 : 1;
      }
    }
    return count == 0 ? Found::Missing : (count == 1 ? Found::One : Found::Ambiguous);
  }

  void AddConect()
  {
    std::map<std::optional<std::size_t>, Places> known;
    const auto placesOf = [&](std::optional<std::size_t> part) -> const Places&
    {
      const auto [places, isNew] = known.try_emplace(part);
      if (isNew)
      {
        places->second = this->IndexAtoms(part);
      }
      return places->second;
    };
    std::size_t missing = 0;
    this->HasLongSerials = std::any_of(this->Result.Atoms.begin(), this->Result.Atoms.end(),
                             [](const Atom& atom) { return atom.Serial > 99999; }) &&
      this->Problems.OddSerials == 0;
    for (const PDBRecord& record : this->Lines.Records)
    {
      if (record.Is != PDBRecord::Kind::Conect)
      {
        continue;
      }
      for (const std::optional<std::size_t> part : this->FindParts(record))
      {
        this->AddConect(record, placesOf(part),
          placesOf(part && this->IsOfCopies ? part : std::nullopt), missing);
      }
    }
    if (missing > 0)
    {
      this->Report.Note("Bonds of CONECT records with atoms that are not in this model, dropped: " +
        std::to_string(missing) + ".");
    }
  }

  /// Counts a fault. Finding the first line's number takes time, and is not repeated.
  void Count(const char* what, const PDBRecord& record)
  {
    const bool isFirst = this->Counted.insert(what).second;
    this->Report.Count(what, isFirst ? FormatLineNumber(this->Text, record.Line) : std::string());
  }

  /// `ofPart` has the atoms of the part that the record is in, `all` those of the model.
  void AddConect(
    const PDBRecord& record, const Places& ofPart, const Places& all, std::size_t& missing)
  {
    const auto find = [&](std::string_view field, std::int64_t& place)
    {
      const Found found = this->Find(field, ofPart, place);
      return found == Found::Missing ? this->Find(field, all, place) : found;
    };
    const std::vector<std::string_view> fields = this->ConectFields(record.Line);
    std::int64_t from = 0;
    const Found first = fields.empty() ? Found::Unreadable : find(fields[0], from);
    if (first == Found::Unreadable || fields.size() < 2)
    {
      this->Count("Unreadable CONECT records, dropped", record);
      return;
    }
    for (std::size_t i = 1; i < fields.size(); ++i)
    {
      std::int64_t to = 0;
      const Found second = find(fields[i], to);
      if (second == Found::Unreadable)
      {
        this->Count("Fields of CONECT records that are not serial numbers, dropped", record);
      }
      else if (first == Found::Missing || second == Found::Missing)
      {
        ++missing;
      }
      else if (first == Found::Ambiguous || second == Found::Ambiguous)
      {
        this->Count("Bonds of CONECT records with ambiguous serial numbers, dropped", record);
      }
      else if (from != to)
      {
        this->Result.Bonds.push_back({ std::min(from, to), std::max(from, to), true });
      }
    }
  }

  /// Residues by address, of those that come more than once the first.
  void IndexResidues()
  {
    std::unordered_map<std::size_t, std::size_t> atomOfLine;
    for (std::size_t i = 0; i < this->LineOfAtom.size(); ++i)
    {
      atomOfLine.emplace(this->LineOfAtom[i], i);
    }
    const std::vector<std::size_t>& starts = this->Result.Residues;
    for (const PDBRun& run : this->Runs)
    {
      const auto atom = atomOfLine.find(run.First);
      if (atom == atomOfLine.end())
      {
        continue;
      }
      const auto next = std::upper_bound(starts.begin(), starts.end(), atom->second);
      const std::size_t end = next == starts.end() ? this->Result.Atoms.size() : *next;
      for (const std::string_view chain : { std::string_view(run.FileChain), std::string_view() })
      {
        this->Residues.Add(
          run.Part, chain, run.Name, run.Number.value_or(0), run.InsertionCode, *(next - 1), end);
      }
    }
  }

  /// The atoms of the residue at columns [name, ...) of a record; empty if there is none.
  std::pair<std::size_t, std::size_t> FindResidue(const PDBRecord& record,
    std::optional<std::size_t> part, std::size_t nameAt, std::size_t chainAt,
    std::size_t numberAt) const
  {
    const std::string_view line = record.Line;
    std::string five(5, ' ');
    for (std::size_t i = 0; i < 5 && nameAt + i < line.size(); ++i)
    {
      five[i] = line[nameAt + i];
    }
    const bool isLong = nameAt + 3 == chainAt && this->Names.IsLong(five);
    const std::string_view name(Columns(line, nameAt, isLong ? 4 : 3));
    const std::string_view chain(
      isLong ? Columns(line, chainAt + 1, 1) : Columns(line, chainAt, 2));
    const char code = numberAt + 4 < line.size() ? line[numberAt + 4] : ' ';
    int number = 0;
    const std::string_view field = Columns(line, numberAt, 4);
    const auto hybrid = field.size() == 4 ? PDBNumber(field, 36) : std::nullopt;
    if (!IsNumber(field, number) && !hybrid)
    {
      return {};
    }
    number = hybrid.value_or(number);
    for (std::size_t p = part.value_or(0); p < this->Model.size(); ++p)
    {
      const auto atoms = this->Residues.Find(p, chain, name, number, code);
      if (atoms.first < atoms.second)
      {
        return atoms;
      }
      if (part)
      {
        break;
      }
    }
    return {};
  }

  /// The sulfur of a disulfide bond, which the record does not name.
  std::optional<std::size_t> FindSulfur(std::pair<std::size_t, std::size_t> residue) const
  {
    constexpr int sulfur = 16;
    const auto usual = FindAtom(this->Result.Atoms, residue, "SG", ' ');
    if (usual && this->Result.Atoms[*usual].Element == sulfur)
    {
      return usual;
    }
    for (std::size_t i = residue.first; i < residue.second; ++i)
    {
      if (this->Result.Atoms[i].Element == sulfur)
      {
        return i;
      }
    }
    return usual;
  }

  /// Adds the bond of a record between atoms of a part, if they exist.
  bool AddLink(const PDBRecord& record, std::optional<std::size_t> part, bool isDisulfide)
  {
    const std::string_view line = record.Line;
    const auto altLoc = [line](std::size_t at) { return at < line.size() ? line[at] : ' '; };
    const auto first = isDisulfide
      ? this->FindSulfur(this->FindResidue(record, part, 11, 14, 17))
      : FindAtom(this->Result.Atoms, this->FindResidue(record, part, 17, 20, 22),
          Columns(line, 12, 4), altLoc(16));
    const auto second = isDisulfide
      ? this->FindSulfur(this->FindResidue(record, part, 25, 28, 31))
      : FindAtom(this->Result.Atoms, this->FindResidue(record, part, 47, 50, 52),
          Columns(line, 42, 4), altLoc(46));
    if (!first || !second)
    {
      return false;
    }
    const auto a = static_cast<std::int64_t>(std::min(*first, *second));
    const auto b = static_cast<std::int64_t>(std::max(*first, *second));
    if (a != b)
    {
      this->Result.Links.push_back({ a, b, true });
    }
    return true;
  }

  void AddLinks()
  {
    std::size_t missing = 0;
    bool isIndexed = false;
    for (const PDBRecord& record : this->Lines.Records)
    {
      if (record.Is != PDBRecord::Kind::Link)
      {
        continue;
      }
      if (!std::exchange(isIndexed, true))
      {
        this->IndexResidues();
      }
      const std::string_view line = record.Line;
      const std::string_view operators[] = { Columns(line, 59, 6), Columns(line, 66, 6) };
      if (operators[0] != operators[1])
      {
        continue; // to a symmetry mate
      }
      const bool isDisulfide = (line[0] & ~0x20) == 'S';
      for (const std::optional<std::size_t> part : this->FindParts(record))
      {
        missing += this->AddLink(record, part, isDisulfide) ? 0 : 1;
      }
    }
    if (missing > 0)
    {
      this->Report.Note("SSBOND and LINK records that are unreadable or have atoms that are "
                        "not in this model, dropped: " +
        std::to_string(missing) + ".");
    }
  }

  std::string_view Text;
  const std::string& Path;
  const PDBLines& Lines;
  const PDBModel& Model;
  bool IsOfCopies;
  ReadingReport& Report;
  PDBMolecule Result;
  PDBResidueNames Names;
  std::vector<PDBRun> Runs;
  std::vector<AtomColumns> Texts;
  std::vector<std::size_t> LineOfAtom;
  Faults Problems;
  std::set<std::string> Counted;
  bool IsHexadecimal = false;
  bool HasLongSerials = false;
  ResidueIndex Residues;
};

/// REMARK 350, which describes assemblies.
std::string RemarksOnAssemblies(std::string_view text)
{
  std::string remarks;
  TextLines lines(text, {}, {});
  for (std::string_view line; lines.Next(line);)
  {
    if (line.substr(0, 10) == "REMARK 350")
    {
      remarks.append(line).append("\n");
    }
  }
  return remarks;
}

/// CONECT records name atoms of the file: in copies, bonds are found by distance.
Macromolecule BuildPDBAssembly(const Macromolecule& molecule, const std::string& name,
  std::string_view text, const std::string& path)
{
  const std::string remarks = RemarksOnAssemblies(text);
  const gemmi::Structure structure =
    gemmi::read_pdb_from_memory(remarks.data(), remarks.size(), path);
  return BuildAssembly(molecule, FindAssembly(name, structure.assemblies, path), path);
}

Macromolecule ReadPDBColumns(std::string_view text, const std::string& path,
  const StructureChoice& choice, std::size_t bytesOfAPiece, const ProgressCallback& progress)
{
  const PDBLines lines = SplitPDB(text, bytesOfAPiece, Between(progress, 0.0, 0.3));
  ReadingReport report;
  const std::vector<PDBModel> models = FindModels(lines, report, PDBColumnsOfAtoms, choice.Combine);
  const bool isOfCopies = AreCombined(lines, models);
  Macromolecule molecule;
  molecule.NumberOfModels = static_cast<std::int64_t>(models.size());
  if (choice.Model < 0 || choice.Model >= molecule.NumberOfModels)
  {
    return molecule;
  }
  const PDBModel& model = models[static_cast<std::size_t>(choice.Model)];
  PDBMolecule read =
    ModelReader(text, path, lines, model, isOfCopies, report).Read(Between(progress, 0.3, 1.0));
  if (EndsWithinRecord(text, lines))
  {
    throw std::runtime_error(path + ", " + FormatLineNumber(text, UnfinishedLine(text)) +
      ": the file ends within this record. Fetch or write it again.");
  }
  Macromolecule result;
  result.Atoms = std::move(read.Atoms);
  result.Bonds = std::move(read.Links);
  if (!choice.Assembly.empty())
  {
    result = BuildPDBAssembly(result, choice.Assembly, text, path);
  }
  else
  {
    result.Bonds.insert(result.Bonds.end(), read.Bonds.begin(), read.Bonds.end());
    if (!isOfCopies) // whose chains have other names, and are beside the cell
    {
      SetStructure(ReadPDBStructure(text), result.Atoms);
      if (ReadPDBConfidence(text, result.Atoms))
      {
        report.Note("Predicted model, as its title says: the B factors are confidences (pLDDT).");
      }
      PDBCell cell = FindCell(lines, model);
      result.Cell = std::move(cell.Vectors);
      result.SpaceGroup = std::move(cell.SpaceGroup);
    }
  }
  result.NumberOfModels = molecule.NumberOfModels;
  report.AddTo(result);
  return result;
}

/// Some programs, APBS among them, separate the values by blanks regardless of the columns.
Macromolecule ReadPDBByWords(std::string_view text, const std::string& path,
  const StructureChoice& choice, const NonstandardColumnsError& first,
  const ProgressCallback& progress)
{
  Macromolecule molecule;
  try
  {
    molecule = ParsePQR(text, path, choice, progress);
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::runtime_error&)
  {
    throw first;
  }
  if (molecule.NumberOfModels == 0) // records in small letters
  {
    throw first;
  }
  for (Atom& atom : molecule.Atoms)
  {
    atom.Occupancy = std::exchange(atom.Charge, Atom::Unknown);
    atom.BFactor = std::exchange(atom.Radius, Atom::Unknown);
  }
  molecule.Warnings.emplace_back(
    "The values are not in the columns of a PDB file; they were separated at blanks.");
  return molecule;
}

}

/// Atoms, in a text that is not mmCIF, which may contain PDB's words.
bool IsPDB(std::string_view text)
{
  if (IsMMCIF(text))
  {
    return false;
  }
  for (const char* record : { "ATOM", "HETATM" })
  {
    const std::size_t at = text.find(record);
    if (at == 0 || (at != std::string_view::npos && text[at - 1] == '\n'))
    {
      return true;
    }
  }
  return false;
}

Macromolecule ParsePDB(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress)
{
  constexpr std::size_t bytesOfAPiece = std::size_t{ 1 } << 20;
  return ParsePDB(text, path, choice, progress, bytesOfAPiece);
}

Macromolecule ParsePDB(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress, std::size_t bytesOfAPiece)
{
  if (text.substr(0, 5) == "data_" || text.substr(0, 4) == "{\"da")
  {
    throw std::runtime_error(path +
      ": this is mmCIF or mmJSON, not PDB. Name it .cif or choose its format (mmJSON: gemmi "
      "convert).");
  }
  try
  {
    return ReadPDBColumns(text, path, choice, bytesOfAPiece, progress);
  }
  catch (const NonstandardColumnsError& error)
  {
    if (!choice.Assembly.empty())
    {
      throw UnknownAssembly(path +
        ": the values are not in the columns of a PDB file, so its assemblies can't be read. Leave "
        "Assembly empty.");
    }
    // Without a progress that restarts from 0, which would not be monotone.
    return ReadPDBByWords(text, path, choice, error,
      progress ? [&progress](double) { return progress(0.6); } : ProgressCallback());
  }
}

}
