#include "Molecules/PDBLines.h"

#include "Atoms/PointBins.h"
#include "Core/ParallelFor.h"
#include "Files/TextLines.h"
#include "Molecules/PeriodicMolecules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace isthmus
{
namespace
{

/// Whether a line begins with `name` in capitals or not.
bool IsRecord(std::string_view line, std::string_view name)
{
  return line.size() >= name.size() &&
    std::equal(name.begin(), name.end(), line.begin(),
      [](char a, char b) { return a == b || (a == (b & ~0x20) && b >= 'a'); });
}

/// The same, and no letter or digit follows.
bool IsWord(std::string_view line, std::string_view name)
{
  return IsRecord(line, name) && (line.size() == name.size() || line[name.size()] <= ' ');
}

std::optional<PDBRecord::Kind> ParseRecordKind(std::string_view line)
{
  switch (line[0] & ~0x20)
  {
    case 'M':
      return IsWord(line, "MODEL") ? std::optional(PDBRecord::Kind::Model) : std::nullopt;
    case 'E':
      if (IsRecord(line, "ENDMDL"))
      {
        return PDBRecord::Kind::EndModel;
      }
      return IsWord(line, "END") ? std::optional(PDBRecord::Kind::End) : std::nullopt;
    case 'C':
      if (IsRecord(line, "CRYST1"))
      {
        return PDBRecord::Kind::Cell;
      }
      return IsRecord(line, "CONECT") ? std::optional(PDBRecord::Kind::Conect) : std::nullopt;
    case 'S':
      return IsRecord(line, "SSBOND") ? std::optional(PDBRecord::Kind::Link) : std::nullopt;
    case 'L':
      return IsRecord(line, "LINK") ? std::optional(PDBRecord::Kind::Link) : std::nullopt;
    default:
      return {};
  }
}

void Split(std::string_view text, PDBLines& lines)
{
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    at = end + 1;
    line = line.substr(0, line.find('\0'));
    while (!line.empty() && line.back() == '\r')
    {
      line.remove_suffix(1);
    }
    if (line.empty())
    {
      continue;
    }
    if (IsRecord(line, "ATOM") || IsRecord(line, "HETA"))
    {
      lines.Atoms.push_back(line);
    }
    else if (const auto kind = ParseRecordKind(line))
    {
      lines.Records.push_back({ *kind, lines.Atoms.size(), line });
    }
  }
}

std::vector<std::string_view> Cut(std::string_view text, std::size_t bytesOfAPiece)
{
  std::vector<std::string_view> pieces;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end =
      std::min(text.find('\n', std::min(begin + bytesOfAPiece, text.size())), text.size());
    const std::size_t next = std::min(end + 1, text.size());
    pieces.push_back(text.substr(begin, next - begin));
    begin = next;
  }
  return pieces;
}

// ------------------------------------------------------------------------------------------
// Models

/// The same name, location, residue, chain and number (columns 13 to 27), and segment.
bool HasSameColumns(std::string_view a, std::string_view b)
{
  return Columns(a, 12, 15) == Columns(b, 12, 15) && Columns(a, 72, 4) == Columns(b, 72, 4);
}

bool PlaceInColumns(std::string_view atom, Point3& place)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (!IsNumber(Columns(atom, 30 + 8 * axis, 8), place[axis]))
    {
      return false;
    }
  }
  return true;
}

/// The lines of a file, and how to read its atoms.
struct AtomLines
{
  const PDBLines& Lines;
  const PDBAtomText& Text;
};

bool SameAtoms(const AtomLines& file, const PDBPart& a, const PDBPart& b)
{
  const auto begin = file.Lines.Atoms.begin();
  const auto at = [begin](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
  return a.Last - a.First == b.Last - b.First &&
    std::equal(at(a.First), at(a.Last), at(b.First), file.Text.IsSame);
}

/// The smallest number of parts after which the atoms repeat; all of them if never.
std::size_t Period(const AtomLines& file, const std::vector<PDBPart>& parts)
{
  for (std::size_t period = 1; period < parts.size(); ++period)
  {
    bool repeats = parts.size() % period == 0;
    for (std::size_t i = period; repeats && i < parts.size(); ++i)
    {
      repeats = SameAtoms(file, parts[i - period], parts[i]);
    }
    if (repeats)
    {
      return period;
    }
  }
  return parts.size();
}

std::vector<Point3> Places(const AtomLines& file, const PDBModel& model)
{
  constexpr double farthest = 1e8;
  std::vector<Point3> places;
  for (const PDBPart& part : model)
  {
    for (std::size_t i = part.First; i < part.Last; ++i)
    {
      Point3 place{ 0.0, 0.0, 0.0 };
      if (file.Text.Place(file.Lines.Atoms[i], place) &&
        std::all_of(place.begin(), place.end(), [](double x) { return std::abs(x) < farthest; }))
      {
        places.push_back(place);
      }
    }
  }
  return places;
}

/// The distance within which most points have a neighbour.
double UsualDistance(const std::vector<Point3>& places)
{
  constexpr double longest = 4.0; // of C-alphas along a chain; beads are nearer to each other
  constexpr std::size_t mostAsked = 1000;
  const PointBins bins(places, longest);
  std::vector<double> nearest;
  const std::size_t step = places.size() / mostAsked + 1;
  for (std::size_t i = 0; i < places.size(); i += step)
  {
    double least = longest * longest;
    bins.Near(places[i], longest,
      [&](std::int64_t other, double squared)
      {
        if (static_cast<std::size_t>(other) != i)
        {
          least = std::min(least, squared);
        }
      });
    nearest.push_back(least);
  }
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return std::sqrt(*middle);
}

struct Box
{
  Point3 Low{ 0.0, 0.0, 0.0 };
  Point3 High{ 0.0, 0.0, 0.0 };
};

Box ComputeBox(const std::vector<Point3>& places)
{
  Box box;
  for (std::size_t axis = 0; axis < 3 && !places.empty(); ++axis)
  {
    const auto [low, high] = std::minmax_element(places.begin(), places.end(),
      [axis](const Point3& a, const Point3& b) { return a[axis] < b[axis]; });
    box.Low[axis] = (*low)[axis];
    box.High[axis] = (*high)[axis];
  }
  return box;
}

bool AreApart(const Box& a, const Box& b)
{
  constexpr double farther = 4.0; // than two atoms that Overlap considers close
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (a.Low[axis] > b.High[axis] + farther || b.Low[axis] > a.High[axis] + farther)
    {
      return true;
    }
  }
  return false;
}

/// The places of a group of atoms, with a search that is made when it is first needed.
class PlacedGroup
{
public:
  explicit PlacedGroup(std::vector<Point3> places)
    : Places(std::move(places))
    , Bounds(ComputeBox(this->Places))
  {
  }

  /**
   * Whether the same molecule at two places penetrates itself: atoms of the one among those of the
   * other, nearer than atoms of one molecule come to each other, or than `leastReach`. Two
   * molecules in contact do not.
   */
  bool Overlaps(const PlacedGroup& other, double leastReach)
  {
    if (this->Places.empty() || other.Places.empty())
    {
      return true;
    }
    if (AreApart(this->Bounds, other.Bounds))
    {
      return false;
    }
    constexpr double nearerThanUsual = 0.6;
    constexpr std::size_t share = 50; // one atom in fifty
    if (!this->Bins)
    {
      this->Reach = std::max(leastReach, nearerThanUsual * UsualDistance(this->Places));
      this->Bins = std::make_unique<PointBins>(this->Places, 2.0 * this->Reach + 1e-3);
    }
    std::size_t found = 0;
    for (const Point3& place : other.Places)
    {
      bool isNear = false;
      if (!AreApart(this->Bounds, { place, place }))
      {
        this->Bins->Near(place, this->Reach, [&isNear](std::int64_t, double) { isNear = true; });
      }
      found += isNear ? 1 : 0;
    }
    return found * share >= other.Places.size();
  }

  /// Whether atoms in the same order have the same distances from four of them, so that one group
  /// is the other one at another place.
  bool IsCopyOf(const PlacedGroup& other) const
  {
    constexpr double tolerance = 0.3; // of coordinates that are rounded, or copies with differences
    const std::size_t size = this->Places.size();
    if (size != other.Places.size() || size == 0)
    {
      return false;
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < size; ++i)
    {
      for (const std::size_t r : { std::size_t{ 0 }, size / 3, 2 * size / 3, size - 1 })
      {
        const double difference =
          Distance(this->Places[i], this->Places[r]) - Distance(other.Places[i], other.Places[r]);
        sum += difference * difference;
      }
    }
    return sum <= tolerance * tolerance * 4.0 * static_cast<double>(size);
  }

private:
  std::vector<Point3> Places;
  Box Bounds;
  double Reach = 0.0;
  std::unique_ptr<PointBins> Bins;
};

/// Whether any two of `groups` overlap.
bool AnyOverlap(const AtomLines& file, const std::vector<PDBModel>& groups, double leastReach = 0.0)
{
  std::vector<PlacedGroup> placed;
  for (const PDBModel& group : groups)
  {
    placed.emplace_back(Places(file, group));
    for (std::size_t earlier = placed.size() - 1; earlier-- > 0;)
    {
      if (placed[earlier].Overlaps(placed.back(), leastReach))
      {
        return true;
      }
    }
  }
  return false;
}

/// The atoms of a model one after the other.
std::vector<std::string_view> LinesOf(const AtomLines& file, const PDBModel& model)
{
  std::vector<std::string_view> lines;
  for (const PDBPart& part : model)
  {
    const auto at = [&file](std::size_t i)
    { return file.Lines.Atoms.begin() + static_cast<std::ptrdiff_t>(i); };
    lines.insert(lines.end(), at(part.First), at(part.Last));
  }
  return lines;
}

bool HasResidues(const std::vector<std::string_view>& lines, std::size_t fewest)
{
  std::size_t residues = 0;
  for (std::size_t i = 0; i < lines.size() && residues < fewest; ++i)
  {
    residues += i == 0 || Columns(lines[i], 17, 10) != Columns(lines[i - 1], 17, 10) ? 1 : 0;
  }
  return residues >= fewest;
}

/// Whether models are copies beside each other, see FindModels.
bool AreBesideEachOther(const AtomLines& file, const std::vector<PDBModel>& models)
{
  constexpr std::size_t fewestResidues = 4;
  std::vector<std::vector<std::string_view>> lines;
  for (const PDBModel& model : models)
  {
    lines.push_back(LinesOf(file, model));
    if (!HasResidues(lines.back(), fewestResidues))
    {
      return false;
    }
  }
  constexpr double contact = 1.7; // shorter than hydrogen bonds between molecules
  if (AnyOverlap(file, models, contact))
  {
    return false;
  }
  std::vector<std::size_t> first; // models of which no earlier one has the atoms
  std::set<char> chains;          // of these
  for (std::size_t i = 0; i < models.size(); ++i)
  {
    const auto same = std::find_if(first.begin(), first.end(),
      [&](std::size_t other)
      {
        return lines[other].size() == lines[i].size() &&
          std::equal(lines[other].begin(), lines[other].end(), lines[i].begin(), file.Text.IsSame);
      });
    if (same == first.end())
    {
      first.push_back(i);
      std::set<char> own;
      for (const std::string_view line : lines[i])
      {
        own.insert(line.size() > 21 ? line[21] : ' ');
      }
      for (const char chain : own)
      {
        if (!chains.insert(chain).second) // one chain with other atoms
        {
          return false;
        }
      }
    }
    else if (!PlacedGroup(Places(file, models[i]))
                .IsCopyOf(PlacedGroup(Places(file, models[*same]))))
    {
      return false;
    }
  }
  return true;
}

std::vector<PDBModel> GroupParts(const std::vector<PDBPart>& parts, std::size_t size)
{
  std::vector<PDBModel> models;
  for (std::size_t i = 0; i < parts.size(); i += size)
  {
    models.emplace_back(parts.begin() + static_cast<std::ptrdiff_t>(i),
      parts.begin() + static_cast<std::ptrdiff_t>(std::min(i + size, parts.size())));
  }
  return models;
}

/// Models or one structure, of parts that END separates.
std::vector<PDBModel> GroupModels(
  const AtomLines& file, const std::vector<PDBPart>& parts, ReadingReport& report)
{
  const std::string head =
    "END separates " + std::to_string(parts.size()) + " parts of the file, which ";
  const std::size_t period = Period(file, parts);
  std::vector<PDBModel> models = GroupParts(parts, period);
  if (models.size() == 1)
  {
    report.Note(head + "have different atoms: read as one structure.");
    return models;
  }
  if (AnyOverlap(file, models))
  {
    report.Note(head + "repeat the same atoms: read as " + std::to_string(models.size()) +
      " models (time steps).");
    return models;
  }
  report.Note(head + "repeat the same atoms at places that do not overlap: read as one structure.");
  return GroupParts(parts, parts.size());
}

/// Parts of atoms between records of the kinds that separate them.
std::vector<PDBPart> PartsBetween(const PDBLines& lines)
{
  std::vector<PDBPart> parts;
  std::size_t first = 0;
  const auto end = [&](std::size_t last)
  {
    if (last > first)
    {
      parts.push_back({ first, last });
      first = last;
    }
  };
  for (const PDBRecord& record : lines.Records)
  {
    if (record.Is == PDBRecord::Kind::End || record.Is == PDBRecord::Kind::EndModel)
    {
      end(record.Atom);
    }
  }
  end(lines.Atoms.size());
  return parts;
}

/// Models that begin with MODEL.
std::vector<PDBModel> ModelsByRecord(const PDBLines& lines, ReadingReport& report)
{
  std::vector<PDBModel> models;
  std::size_t first = 0;
  std::size_t outside = 0;
  bool isInside = false;
  PDBModel before;
  const auto end = [&](std::size_t last)
  {
    if (last > first)
    {
      (models.empty() ? before : models.back()).push_back({ first, last });
      outside += isInside ? 0 : last - first;
    }
    first = last;
    isInside = false;
  };
  for (const PDBRecord& record : lines.Records)
  {
    if (record.Is == PDBRecord::Kind::Model)
    {
      end(record.Atom);
      models.emplace_back();
      isInside = true;
    }
    else if (record.Is == PDBRecord::Kind::EndModel || record.Is == PDBRecord::Kind::End)
    {
      if (record.Is == PDBRecord::Kind::EndModel && !isInside && record.Atom > first)
      {
        models.emplace_back(); // MODEL is missing
        isInside = true;
      }
      end(record.Atom);
    }
  }
  end(lines.Atoms.size());
  models.front().insert(models.front().begin(), before.begin(), before.end());
  report.Count("Atoms outside of MODEL and ENDMDL, read with the model beside them", "", outside);
  return models;
}

std::size_t CountRecords(const PDBLines& lines, PDBRecord::Kind kind)
{
  return static_cast<std::size_t>(std::count_if(lines.Records.begin(), lines.Records.end(),
    [kind](const PDBRecord& record) { return record.Is == kind; }));
}

bool Has(const PDBLines& lines, PDBRecord::Kind kind)
{
  return CountRecords(lines, kind) > 0;
}

/// One structure of all models, if that is wanted.
std::vector<PDBModel> Combine(std::vector<PDBModel> models, const AtomLines& file,
  ModelCombination combine, ReadingReport& report)
{
  if (models.size() < 2 || combine == ModelCombination::Never ||
    (combine == ModelCombination::Automatic && !AreBesideEachOther(file, models)))
  {
    return models;
  }
  const std::string count = std::to_string(models.size());
  report.Note(combine == ModelCombination::Always
      ? "The " + count + " models of the file were read as one structure, as CombineModels says."
      : "The " + count +
        " models of the file are copies beside each other, as in a file of a biological unit: "
        "read as one structure. To read them as frames (time steps), set CombineModels to Never.");
  PDBModel all;
  for (const PDBModel& model : models)
  {
    all.insert(all.end(), model.begin(), model.end());
  }
  return { all };
}

}

PDBLines SplitPDB(
  std::string_view text, std::size_t bytesOfAPiece, const ProgressCallback& progress)
{
  const std::vector<std::string_view> pieces = Cut(text, bytesOfAPiece);
  std::vector<PDBLines> split(pieces.size());
  ParallelFor(
    0, static_cast<std::int64_t>(pieces.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto p = static_cast<std::size_t>(first); p < static_cast<std::size_t>(last); ++p)
      {
        Split(pieces[p], split[p]);
      }
    },
    progress);
  if (split.size() == 1)
  {
    return std::move(split[0]);
  }
  PDBLines lines;
  std::size_t atoms = 0;
  for (const PDBLines& piece : split)
  {
    atoms += piece.Atoms.size();
  }
  lines.Atoms.reserve(atoms);
  for (PDBLines& piece : split)
  {
    for (PDBRecord& record : piece.Records)
    {
      record.Atom += lines.Atoms.size();
    }
    lines.Records.insert(lines.Records.end(), piece.Records.begin(), piece.Records.end());
    lines.Atoms.insert(lines.Atoms.end(), piece.Atoms.begin(), piece.Atoms.end());
  }
  return lines;
}

std::string FormatLineNumber(std::string_view text, std::string_view line)
{
  return "line " + std::to_string(1 + std::count(text.data(), line.data(), '\n'));
}

const PDBAtomText PDBColumnsOfAtoms{ HasSameColumns, PlaceInColumns };

std::vector<PDBModel> FindModels(
  const PDBLines& lines, ReadingReport& report, const PDBAtomText& atoms, ModelCombination combine)
{
  if (Has(lines, PDBRecord::Kind::Model))
  {
    return Combine(ModelsByRecord(lines, report), { lines, atoms }, combine, report);
  }
  const std::vector<PDBPart> parts = PartsBetween(lines);
  if (parts.size() < 2 || Has(lines, PDBRecord::Kind::EndModel))
  {
    return Combine(GroupParts(parts, 1), { lines, atoms }, combine, report);
  }
  return GroupModels({ lines, atoms }, parts, report);
}

PDBCell FindCell(const PDBLines& lines, const PDBModel& model)
{
  const PDBRecord* chosen = nullptr;
  for (const PDBRecord& record : lines.Records)
  {
    const bool isBefore = !model.empty() && record.Atom <= model.front().First;
    if (record.Is == PDBRecord::Kind::Cell && (!chosen || isBefore))
    {
      chosen = &record;
    }
  }
  std::array<double, 6> numbers{};
  if (!chosen)
  {
    return {};
  }
  constexpr std::array<std::size_t, 7> columns{ 6, 15, 24, 33, 40, 47, 54 };
  constexpr std::size_t firstOfGroup = 55, lengthOfGroup = 11;
  std::string_view rest = chosen->Line.substr(6);
  bool inColumns = true;
  bool inWords = true;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    inColumns = inColumns &&
      IsNumber(Columns(chosen->Line, columns[i], columns[i + 1] - columns[i]), numbers[i]);
  }
  for (std::size_t i = 0; i < numbers.size() && !inColumns; ++i)
  {
    inWords = inWords && IsNumber(NextWord(rest), numbers[i]);
  }
  if (!inColumns && !inWords)
  {
    return {};
  }
  return { CellVectors(
             { numbers[0], numbers[1], numbers[2] }, { numbers[3], numbers[4], numbers[5] }),
    inColumns ? std::string(Columns(chosen->Line, firstOfGroup, lengthOfGroup)) : std::string() };
}

bool AreCombined(const PDBLines& lines, const std::vector<PDBModel>& models)
{
  return models.size() == 1 && models[0].size() > 1 &&
    std::max(CountRecords(lines, PDBRecord::Kind::Model),
      CountRecords(lines, PDBRecord::Kind::EndModel)) > 1;
}

}
