#include "Molecules/PDBColumns.h"

#include "Files/TextLines.h"
#include "Molecules/AtomElements.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace isthmus
{
namespace
{

bool AllDigits(std::string_view text)
{
  return !text.empty() && std::all_of(text.begin(), text.end(), IsDigit);
}

bool AllHexadecimal(std::string_view text)
{
  return !text.empty() &&
    std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
}

/// Columns [from, from + count) with blanks where the line has ended.
std::string PadColumns(std::string_view line, std::size_t from, std::size_t count)
{
  std::string text(from < line.size() ? line.substr(from, count) : std::string_view());
  text.resize(count, ' ');
  return text;
}

/// Columns 73-76.
std::string_view GetSegment(std::string_view line)
{
  return Columns(line, 72 + CoordinateShift(line), 4);
}

/// Columns 18-27.
std::string ResidueColumns(std::string_view line)
{
  return PadColumns(line, 17, 10);
}

// ------------------------------------------------------------------------------------------
// Runs of lines

class SameResidue
{
public:
  explicit SameResidue(bool withSegments)
    : WithSegments(withSegments)
  {
  }

  bool operator()(std::string_view a, std::string_view b) const
  {
    constexpr std::size_t segmentEnd = 76;
    if (a.substr(17, 10) != b.substr(17, 10) || !this->WithSegments)
    {
      return a.substr(17, 10) == b.substr(17, 10);
    }
    const auto isUsual = [](std::string_view line)
    { return line.size() >= segmentEnd && line[34] == '.' && line[42] == '.' && line[50] == '.'; };
    return (isUsual(a) && isUsual(b) && a.substr(72, 4) == b.substr(72, 4)) ||
      GetSegment(a) == GetSegment(b);
  }

private:
  bool WithSegments;
};

std::vector<PDBRun> FindRuns(const PDBLines& lines, const PDBModel& model, bool withSegments)
{
  const SameResidue same(withSegments);
  std::vector<PDBRun> runs;
  for (std::size_t p = 0; p < model.size(); ++p)
  {
    for (std::size_t i = model[p].First; i < model[p].Last; ++i)
    {
      const std::string_view line = lines.Atoms[i];
      constexpr std::size_t fewest = 17; // shorter lines are refused for their coordinates
      bool isNew = i == model[p].First || line.size() < fewest ||
        lines.Atoms[i - 1].size() < fewest || !same(lines.Atoms[i - 1], line);
      // Where the number no longer fits, a residue begins with the name that began the last one.
      isNew = isNew ||
        (line.substr(std::min<std::size_t>(22, line.size()), 4) == "****" &&
          Columns(line, 12, 4) == Columns(lines.Atoms[runs.back().First], 12, 4));
      if (isNew)
      {
        runs.emplace_back();
        runs.back().First = i;
        runs.back().Part = p;
        runs.back().Segment = withSegments ? GetSegment(line) : std::string_view();
      }
      runs.back().Last = i + 1;
    }
  }
  return runs;
}

// ------------------------------------------------------------------------------------------
// Numbers

/// How a file writes numbers of residues that do not fit into columns 23-26.
struct NumberNotes
{
  std::size_t FiveDigits = 0, Hexadecimal = 0, Hybrid36 = 0, Restarted = 0, Missing = 0;

  void AddTo(ReadingReport& report) const
  {
    const std::pair<std::size_t, const char*> kinds[] = {
      { this->FiveDigits, "Residues with numbers of five digits: " },
      { this->Hexadecimal, "Residues with hexadecimal numbers: " },
      { this->Hybrid36, "Residues with hybrid-36 numbers: " },
      { this->Restarted,
        "Residues whose numbers start again at 0 after 9999, counted on from 10000: " },
      { this->Missing, "Residues without a readable number, numbered one after the other: " }
    };
    for (const auto& [count, what] : kinds)
    {
      if (count > 0)
      {
        report.Note(what + std::to_string(count) + ".");
      }
    }
  }
};

/// Decodes the numbers of one part, one residue after the other.
class ResidueNumbers
{
public:
  ResidueNumbers(bool fiveColumns, NumberNotes& notes)
    : FiveColumns(fiveColumns)
    , Notes(notes)
  {
  }

  /// `columns` are 18-27.
  void Read(const std::string& columns, PDBRun& run)
  {
    std::string_view field = std::string_view(columns).substr(5, 4);
    run.InsertionCode = columns[9];
    const std::string_view right = std::string_view(columns).substr(5, 5);
    const std::string_view left = std::string_view(columns).substr(4, 5);
    if (this->FiveColumns || AllDigits(right))
    {
      field = right;
      run.InsertionCode = ' ';
      this->Notes.FiveDigits += AllDigits(right) ? 1 : 0;
    }
    const bool goesOn = AllDigits(left) && this->Last && PDBNumber(left, 10) == *this->Last + 1 &&
      *this->Last >= 9999;
    if (goesOn)
    {
      field = left;
      run.FileChain.clear();
      ++this->Notes.FiveDigits;
    }
    run.Number = this->Decode(Trim(field), run.Segment + run.FileChain);
    this->Last = run.Number;
    this->Chain = run.Segment + run.FileChain;
  }

private:
  std::optional<int> Decode(std::string_view field, const std::string& chain)
  {
    if (field.empty())
    {
      return {};
    }
    if (field[0] == '*')
    {
      ++this->Notes.Missing;
      return this->Last.value_or(0) + 1;
    }
    if (const auto number = this->Hexadecimal(field))
    {
      ++this->Notes.Hexadecimal;
      return number;
    }
    if (std::isalpha(static_cast<unsigned char>(field[0])) != 0)
    {
      const auto number = field.size() == 4 ? PDBNumber(field, 36) : std::nullopt;
      this->Notes.Hybrid36 += number ? 1 : 0;
      this->Notes.Missing += number ? 0 : 1;
      return number ? number : std::optional<int>(this->Last.value_or(0) + 1);
    }
    const auto number = this->Decimal(field);
    return number ? this->Restarted(*number, chain) : number;
  }

  /// Four digits of base 16 for 10000 (2710) and more. Those with letters are known by small ones
  /// (a capital may be an insertion code), those without by the number before them.
  std::optional<int> Hexadecimal(std::string_view field)
  {
    constexpr int lastDecimal = 9999;
    const auto number = AllHexadecimal(field) ? PDBNumber(field, 16) : std::nullopt;
    const bool mayBe = number && field.size() == 4 && *number > lastDecimal;
    const bool follows = mayBe && this->Last && *this->Last >= lastDecimal &&
      (*number == *this->Last || *number == *this->Last + 1);
    const bool hasSmallLetter =
      std::any_of(field.begin(), field.end(), [](unsigned char c) { return std::islower(c) != 0; });
    const bool hasLetter = mayBe && !AllDigits(field);
    const bool begins = follows && *this->Last == lastDecimal;
    this->IsHexadecimal = hasLetter
      ? (IsDigit(field[0]) && (hasSmallLetter || follows)) || (this->IsHexadecimal && follows)
      : follows && (begins || this->IsHexadecimal);
    return this->IsHexadecimal ? number : std::nullopt;
  }

  /// The digits that the field begins with, as gemmi takes them.
  static std::optional<int> Decimal(std::string_view field)
  {
    std::size_t end = field[0] == '-' || field[0] == '+' ? 1 : 0;
    while (end < field.size() && IsDigit(field[end]))
    {
      ++end;
    }
    int number = 0;
    return IsNumber(field.substr(0, end), number) ? std::optional<int>(number) : std::nullopt;
  }

  /// Numbers that go on at 0 after 9999, in the same chain.
  std::optional<int> Restarted(int number, const std::string& chain)
  {
    constexpr int restart = 10000;
    if (this->Last && chain == this->Chain && *this->Last == this->Offset + restart - 1 &&
      number == 0)
    {
      this->Offset += restart;
    }
    const int shifted = number + this->Offset;
    if (this->Offset == 0 ||
      !(this->Last && (shifted == *this->Last || shifted == *this->Last + 1)))
    {
      this->Offset = 0;
      return number;
    }
    ++this->Notes.Restarted;
    return shifted;
  }

  bool FiveColumns;
  NumberNotes& Notes;
  std::optional<int> Last;
  std::string Chain;
  bool IsHexadecimal = false;
  int Offset = 0;
};

/// Whether all numbers are written into columns 23-27: insertion codes are letters, and not all
/// residues have one.
bool HasNumbersInFiveColumns(const PDBLines& lines, const std::vector<PDBRun>& runs)
{
  return !runs.empty() &&
    std::all_of(runs.begin(), runs.end(),
      [&lines](const PDBRun& run)
      { return lines.Atoms[run.First].size() > 26 && IsDigit(lines.Atoms[run.First][26]); });
}

// ------------------------------------------------------------------------------------------
// Chains of several parts

std::string FindFreeName(const std::string& name, const std::set<std::string>& taken)
{
  constexpr std::string_view letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";
  for (const char letter : letters)
  {
    if (taken.count(std::string(1, letter)) == 0)
    {
      return std::string(1, letter);
    }
  }
  std::string free = name;
  for (int number = 2; taken.count(free) > 0; ++number)
  {
    free = name + std::to_string(number);
  }
  return free;
}

}

void FindCopies(const PDBLines& lines, std::vector<PDBRun>& runs)
{
  struct Chain
  {
    std::size_t Part = 0;
    std::size_t Copy = 0;
    int Largest = std::numeric_limits<int>::min();
    std::vector<std::size_t> Rising; ///< runs with rising numbers, which are not among Residues yet
    std::unordered_map<std::string, std::vector<std::size_t>> Residues; ///< their runs
  };
  const auto keyOf = [&runs](std::size_t r)
  {
    const PDBRun& run = runs[r];
    return run.Name + '\n' + std::to_string(run.Number.value_or(0)) + run.InsertionCode +
      run.Segment;
  };
  const auto isPolymer = [](const PDBRun& run)
  {
    const ResidueFamily family = FindResidueFamily(run.Name);
    return family == ResidueFamily::AminoAcid || family == ResidueFamily::Nucleotide;
  };
  std::unordered_map<std::string, Chain> chains;
  const auto nameOf = [&lines](std::size_t i) { return lines.Atoms[i].substr(12, 5); };
  const auto isAgain = [&](const PDBRun& run, const std::vector<std::size_t>& earlier)
  {
    std::set<std::string_view> names;
    for (const std::size_t r : earlier)
    {
      for (std::size_t i = runs[r].First; i < runs[r].Last; ++i)
      {
        names.insert(nameOf(i));
      }
    }
    std::size_t again = 0;
    for (std::size_t i = run.First; i < run.Last; ++i)
    {
      again += names.count(nameOf(i));
    }
    return again > 0 && 2 * again >= run.Last - run.First;
  };
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    PDBRun& run = runs[r];
    Chain& chain = chains[run.FileChain];
    if (chain.Part != run.Part)
    {
      chain = Chain();
      chain.Part = run.Part;
    }
    const int number = run.Number.value_or(0);
    if (number > chain.Largest)
    {
      chain.Largest = number; // the residue is a further one
      chain.Rising.push_back(r);
    }
    else if (isPolymer(run))
    {
      for (const std::size_t before : std::exchange(chain.Rising, {}))
      {
        if (isPolymer(runs[before]))
        {
          chain.Residues[keyOf(before)].push_back(before);
        }
      }
      const std::string key = keyOf(r);
      std::vector<std::size_t>& earlier = chain.Residues[key];
      earlier.push_back(r);
      if (number < chain.Largest && earlier.size() > 1 &&
        isAgain(run, { earlier.begin(), earlier.end() - 1 }))
      {
        ++chain.Copy;
        chain.Residues = { { key, { r } } };
      }
    }
    run.Copy = chain.Copy;
  }
}

void RenameChains(std::vector<PDBRun>& runs, ReadingReport& report)
{
  std::set<std::string> taken;
  for (const PDBRun& run : runs)
  {
    taken.insert(run.FileChain);
  }
  using Group = std::pair<std::size_t, std::size_t>; // part and copy
  std::map<std::string, Group> firstGroup;
  std::map<std::pair<Group, std::string>, std::string> renamed;
  std::string list;
  constexpr std::size_t mostListed = 200;
  for (PDBRun& run : runs)
  {
    const Group group{ run.Part, run.Copy };
    if (firstGroup.emplace(run.FileChain, group).first->second == group)
    {
      continue;
    }
    const auto [found, isNew] = renamed.emplace(std::pair(group, run.FileChain), "");
    if (isNew)
    {
      found->second = FindFreeName(run.FileChain, taken);
      taken.insert(found->second);
      if (list.size() < mostListed)
      {
        list += (list.empty() ? "" : ", ") + (run.FileChain.empty() ? "(no name)" : run.FileChain) +
          (run.Copy > 0 ? ", copy " + std::to_string(run.Copy + 1) + "," : "") +
          (run.Part > 0 ? " of part " + std::to_string(run.Part + 1) : "") + " is " + found->second;
      }
    }
    run.Chain = found->second;
  }
  if (!renamed.empty())
  {
    report.Note("Chains with the name of a chain of an earlier part, or its residues once more, "
                "renamed: " +
      std::to_string(renamed.size()) + " (" + list + (list.size() < mostListed ? ")." : ", ...)."));
  }
}

Macromolecule ReadModelOfRecords(std::string_view text, std::int64_t model,
  const PDBAtomText& atoms, const AtomLinesReader& read, ReadingReport& report,
  const ProgressCallback& progress)
{
  constexpr std::size_t bytesOfAPiece = std::size_t{ 1 } << 20;
  const PDBLines split = SplitPDB(text, bytesOfAPiece, Between(progress, 0.0, 0.2));
  const std::vector<PDBModel> models = FindModels(split, report, atoms);
  Macromolecule molecule;
  molecule.NumberOfModels = static_cast<std::int64_t>(models.size());
  if (model < 0 || model >= molecule.NumberOfModels)
  {
    return molecule;
  }
  const PDBModel& parts = models[static_cast<std::size_t>(model)];
  std::vector<std::string_view> lines;
  std::vector<std::size_t> ends; // of the parts, among the atoms
  for (const PDBPart& part : parts)
  {
    lines.insert(lines.end(), split.Atoms.begin() + static_cast<std::ptrdiff_t>(part.First),
      split.Atoms.begin() + static_cast<std::ptrdiff_t>(part.Last));
    ends.push_back(lines.size());
  }
  molecule.Atoms = read(lines, Between(progress, 0.2, 1.0));
  PDBCell cell = FindCell(split, parts);
  molecule.Cell = std::move(cell.Vectors);
  molecule.SpaceGroup = std::move(cell.SpaceGroup);
  std::vector<PDBRun> runs;
  for (std::size_t part = 0, atom = 0; part < parts.size(); ++part)
  {
    for (; atom < ends[part]; ++atom)
    {
      const std::string& chain = molecule.Atoms[atom].Chain;
      if (runs.empty() || runs.back().Part != part || runs.back().FileChain != chain)
      {
        runs.push_back({ atom, atom, part, 0, {}, chain, chain, {}, {} });
      }
      runs.back().Last = atom + 1;
    }
  }
  RenameChains(runs, report);
  for (const PDBRun& run : runs)
  {
    for (std::size_t i = run.First; i < run.Last && run.Chain != run.FileChain; ++i)
    {
      molecule.Atoms[i].Chain = run.Chain;
    }
  }
  return molecule;
}

std::array<std::size_t, 4> CoordinateColumns(std::string_view atom)
{
  constexpr std::array<std::size_t, 4> usual{ 30, 38, 46, 54 };
  constexpr std::size_t width = 8;
  constexpr std::size_t decimals = 3;
  const bool isUsual =
    atom.size() >= usual[3] && atom[34] == '.' && atom[42] == '.' && atom[50] == '.';
  if (isUsual || !Columns(atom, 27, 3).empty())
  {
    return usual;
  }
  std::array<std::size_t, 4> columns = usual;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t begin = columns[axis];
    const std::size_t end = atom.find('.', begin);
    if (end == std::string_view::npos || end + decimals >= atom.size() + (axis == 2 ? 1 : 0))
    {
      return usual;
    }
    columns[axis + 1] = end + 1 + decimals;
    const std::size_t size = columns[axis + 1] - begin;
    double value = 0.0;
    if (size < width || (size > width && atom[begin] == ' ') ||
      !IsNumber(Columns(atom, begin, size), value))
    {
      return usual;
    }
  }
  const bool endsThere = columns[3] >= atom.size() || atom[columns[3]] == ' ';
  return endsThere ? columns : usual;
}

std::optional<int> PDBNumber(std::string_view text, int base)
{
  int value = 0;
  const auto isNumber = [&](int radix)
  {
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value, radix);
    return !text.empty() && result.ec == std::errc() && result.ptr == text.data() + text.size();
  };
  if (base != 36)
  {
    return isNumber(base) ? std::optional<int>(value) : std::nullopt;
  }
  // http://cci.lbl.gov/hybrid_36/: A000 follows 9999, a000 follows ZZZZ.
  if ((text.size() != 4 && text.size() != 5) ||
    std::isalpha(static_cast<unsigned char>(text[0])) == 0 || !isNumber(36))
  {
    return {};
  }
  int ten = 1;
  int power = 1; // 36^(width - 1)
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    ten *= 10;
    power *= i > 0 ? 36 : 1;
  }
  const bool isSmall = std::islower(static_cast<unsigned char>(text[0])) != 0;
  return value + ten + (isSmall ? 16 : -10) * power;
}

int PDBSerials::Next(std::string_view field)
{
  std::optional<int> number;
  const std::optional<int> hexadecimal =
    AllHexadecimal(field) ? PDBNumber(field, 16) : std::nullopt;
  const bool follows = hexadecimal && *hexadecimal == this->Last + 1;
  if (hexadecimal && !AllDigits(field) && (IsDigit(field[0]) || (this->IsHexadecimal && follows)))
  {
    number = hexadecimal;
    this->IsHexadecimal = true;
  }
  else if (hexadecimal && this->IsHexadecimal && follows)
  {
    number = hexadecimal;
  }
  else if (!field.empty() && std::isalpha(static_cast<unsigned char>(field[0])) != 0)
  {
    number = PDBNumber(field, 36);
  }
  else
  {
    int decimal = 0;
    number = IsNumber(field, decimal) ? std::optional<int>(decimal) : std::nullopt;
  }
  this->Last = number.value_or(this->Last + 1);
  return this->Last;
}

PDBResidueNames::PDBResidueNames(const std::vector<PDBRun>& runs, const PDBLines& lines)
{
  std::set<std::string> fives; // columns 18-22 with something in 21
  for (const PDBRun& run : runs)
  {
    const std::string five = ResidueColumns(lines.Atoms[run.First]).substr(0, 5);
    if (five[3] != ' ')
    {
      fives.insert(five);
    }
  }
  const auto isKnownLong = [](const std::string& five)
  { return five[0] != ' ' && five[2] != ' ' && IsLongResidueName(five.substr(0, 4)); };
  std::set<std::string> chains; // of two letters, that contains a standard residue
  bool anyLong = false;
  for (const std::string& five : fives)
  {
    const bool isLong = isKnownLong(five);
    anyLong = anyLong || isLong;
    if (!isLong &&
      FindResidueFamily(Trim(std::string_view(five).substr(0, 3))) != ResidueFamily::Unknown)
    {
      chains.insert(five.substr(3));
    }
  }
  for (const std::string& five : fives)
  {
    const bool mayBeLong = five[0] != ' ' && five[2] != ' ' && chains.count(five.substr(3)) == 0;
    if (mayBeLong && (isKnownLong(five) || anyLong || chains.empty()))
    {
      this->Long.insert(five);
    }
  }
}

bool PDBResidueNames::IsLong(std::string_view fiveColumns) const
{
  return !this->Long.empty() && this->Long.count(std::string(fiveColumns)) > 0;
}

std::vector<PDBRun> ReadRuns(const PDBLines& lines, const PDBModel& model, bool withSegments,
  PDBResidueNames& names, ReadingReport& report)
{
  std::vector<PDBRun> runs = FindRuns(lines, model, withSegments);
  names = PDBResidueNames(runs, lines);
  const bool fiveColumns = HasNumbersInFiveColumns(lines, runs);
  NumberNotes notes;
  std::optional<ResidueNumbers> numbers;
  std::size_t part = model.size();
  std::size_t bySegment = 0;
  for (PDBRun& run : runs)
  {
    if (run.Part != part)
    {
      part = run.Part;
      numbers.emplace(fiveColumns, notes);
    }
    const std::string columns = ResidueColumns(lines.Atoms[run.First]);
    const std::string_view text(columns);
    const bool isLong = names.IsLong(text.substr(0, 5));
    run.Name = Trim(text.substr(0, isLong ? 4 : 3));
    run.FileChain = Trim(isLong ? text.substr(4, 1) : text.substr(3, 2));
    numbers->Read(columns, run);
    if (run.FileChain.empty() && !run.Segment.empty())
    {
      run.FileChain = run.Segment;
      bySegment += run.Last - run.First;
    }
    run.Chain = run.FileChain;
  }
  notes.AddTo(report);
  if (bySegment > 0)
  {
    report.Note("Atoms whose chain is their segment (columns 73-76), since column 22 is blank: " +
      std::to_string(bySegment) + ".");
  }
  FindCopies(lines, runs);
  if (model.size() > 1 ||
    std::any_of(runs.begin(), runs.end(), [](const PDBRun& run) { return run.Copy > 0; }))
  {
    RenameChains(runs, report);
  }
  return runs;
}

bool EndsWithinRecord(std::string_view text, const PDBLines& lines)
{
  const std::string_view line = UnfinishedLine(text);
  if (line.substr(0, 6) == "CONECT")
  {
    constexpr std::size_t first = 11; // after the first serial number; each is five columns wide
    return line.size() > first && (line.size() - first) % 5 != 0;
  }
  if (lines.Atoms.empty() || line.empty() || lines.Atoms.back().data() != line.data())
  {
    return false;
  }
  const auto fieldsOf = [](std::string_view atom)
  {
    constexpr std::size_t withElement = 78; // a charge may follow
    const std::size_t size = atom.find_last_not_of(" \r") + 1;
    return std::min(size, withElement + CoordinateShift(atom)) - CoordinateShift(atom);
  };
  const std::size_t size = line.size() - CoordinateShift(line);
  const bool isWithinField = (size > 54 && size < 60) || (size > 60 && size < 66) || size == 77 ||
    (size == 79 && line.back() != ' ');
  return isWithinField ||
    (lines.Atoms.size() > 1 && size < fieldsOf(lines.Atoms[lines.Atoms.size() - 2]));
}

}
