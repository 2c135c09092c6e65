#include "Molecules/StructureRecords.h"

#include "Files/TextLines.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <utility>

#include <gemmi/cifdoc.hpp>
#include <gemmi/util.hpp>

namespace isthmus
{
namespace
{

// As SecondaryStructure of Filters/Atoms numbers them.
constexpr unsigned char Coil = 0;
constexpr unsigned char AlphaHelix = 1;
constexpr unsigned char Strand = 2;
constexpr unsigned char Helix310 = 3;
constexpr unsigned char PiHelix = 4;

std::optional<int> ResidueNumber(std::string_view text)
{
  const std::string_view digits = Trim(text);
  int value = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return fault == std::errc() && end == digits.data() + digits.size() ? std::optional(value)
                                                                      : std::nullopt;
}

/// Classes of HELIX: 1 alpha, 3 pi, 5 3-10, 10 polyproline; the rare others count as alpha.
unsigned char HelixFromClass(std::optional<int> number)
{
  switch (number.value_or(1))
  {
    case 3:
      return PiHelix;
    case 5:
      return Helix310;
    case 10:
      return Coil;
    default:
      return AlphaHelix;
  }
}

/// Where a record has the chain and the numbers with insertion codes, columns from 0.
struct RangeColumns
{
  std::size_t Chain, First, FirstCode, Last, LastCode;
};

std::optional<StructureRange> RangeIn(std::string_view line, const RangeColumns& columns)
{
  if (line.size() <= columns.Last + 3)
  {
    return {};
  }
  const auto first = ResidueNumber(line.substr(columns.First, 4));
  const auto last = ResidueNumber(line.substr(columns.Last, 4));
  if (!first || !last)
  {
    return {};
  }
  StructureRange range;
  range.Chain = std::string(Trim(line.substr(columns.Chain, 1)));
  range.First = *first;
  range.Last = *last;
  const auto code = [line](std::size_t at)
  { return line.size() > at && line[at] > ' ' ? line[at] : ' '; };
  range.FirstCode = code(columns.FirstCode);
  range.LastCode = code(columns.LastCode);
  return range;
}

/// The type of a helix or strand of ModelCIF, or of a helix of the PDB with its class.
std::optional<unsigned char> StructureFromType(const std::string& type, std::optional<int> number)
{
  const std::string upper = gemmi::to_upper(type);
  if (upper == "STRN")
  {
    return Strand;
  }
  if (upper.compare(0, 4, "HELX") != 0)
  {
    return {};
  }
  const auto has = [&upper](const char* part) { return upper.find(part) != std::string::npos; };
  return has("_3T") ? Helix310 : has("_PI") ? PiHelix : has("_PP") ? Coil : HelixFromClass(number);
}

/// Chain, numbers and codes in columns `from` to `from` + 4 of a row.
std::optional<StructureRange> RangeIn(gemmi::cif::Table::Row& row, std::size_t from)
{
  const auto code = [&row](std::size_t column)
  {
    const std::string text = row.has(column) ? row.str(static_cast<int>(column)) : std::string();
    return text.empty() ? ' ' : text[0];
  };
  const auto at = [&row](std::size_t column) { return row.str(static_cast<int>(column)); };
  const auto first = ResidueNumber(at(from + 1));
  const auto last = ResidueNumber(at(from + 3));
  if (!first || !last)
  {
    return {};
  }
  return StructureRange{ at(from), *first, *last, code(from + 2), code(from + 4) };
}

}

std::vector<StructureRange> ReadPDBStructure(std::string_view text)
{
  constexpr RangeColumns helix{ 19, 21, 25, 33, 37 };
  constexpr RangeColumns strand{ 21, 22, 26, 33, 37 };
  std::vector<StructureRange> ranges;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    at = end + 1;
    const std::string_view name = line.substr(0, 6);
    if (name == "ATOM  " || name == "HETATM")
    {
      break;
    }
    const bool isHelix = name == "HELIX ";
    if (!isHelix && name != "SHEET ")
    {
      continue;
    }
    if (auto range = RangeIn(line, isHelix ? helix : strand))
    {
      range->Structure = isHelix
        ? HelixFromClass(ResidueNumber(line.size() > 38 ? line.substr(38, 2) : ""))
        : Strand;
      ranges.push_back(std::move(*range));
    }
  }
  return ranges;
}

bool ReadPDBConfidence(std::string_view text, std::vector<Atom>& atoms)
{
  std::string title;
  TextLines lines(text, {}, {});
  for (std::string_view line; lines.Next(line);)
  {
    const std::string_view name = line.substr(0, 6);
    const bool isExperiment =
      name == "EXPDTA" && line.find("THEORETICAL") == std::string_view::npos;
    if (isExperiment || name == "ATOM  " || name == "HETATM")
    {
      title = isExperiment ? "" : title;
      break;
    }
    title += name == "TITLE " ? gemmi::to_upper(std::string(Columns(line, 10, 70))) + " " : "";
  }
  const auto says = [&title](const char* word) { return title.find(word) != std::string::npos; };
  if (!(says("PREDICT") || says("MODEL")) ||
    !(says("ALPHAFOLD") || says("ESMFOLD") || says("COLABFOLD") || says("OPENFOLD")))
  {
    return false;
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    const double value = atoms[i].BFactor;
    const bool isSame = i > 0 && atoms[i].ResidueId == atoms[i - 1].ResidueId &&
      atoms[i].InsertionCode == atoms[i - 1].InsertionCode && atoms[i].Chain == atoms[i - 1].Chain;
    if (!(value >= 0.0 && value <= 100.0) || (isSame && value != atoms[i - 1].BFactor))
    {
      return false;
    }
    largest = std::max(largest, value);
  }
  const double scale = largest > 1.0 ? 1.0 : 100.0;
  for (Atom& atom : atoms)
  {
    atom.PLDDT = scale * atom.BFactor;
  }
  return largest > 0.0;
}

std::vector<StructureRange> ReadCIFStructure(gemmi::cif::Block& block)
{
  std::vector<StructureRange> ranges;
  for (gemmi::cif::Table::Row row : block.find("_struct_conf.",
         { "conf_type_id", "beg_auth_asym_id", "beg_auth_seq_id", "?pdbx_beg_PDB_ins_code",
           "end_auth_seq_id", "?pdbx_end_PDB_ins_code", "?pdbx_PDB_helix_class" }))
  {
    const auto structure =
      StructureFromType(row.str(0), row.has(6) ? ResidueNumber(row.str(6)) : std::nullopt);
    auto range = structure ? RangeIn(row, 1) : std::nullopt;
    if (range)
    {
      range->Structure = *structure;
      ranges.push_back(std::move(*range));
    }
  }
  for (gemmi::cif::Table::Row row : block.find("_struct_sheet_range.",
         { "beg_auth_asym_id", "beg_auth_seq_id", "?pdbx_beg_PDB_ins_code", "end_auth_seq_id",
           "?pdbx_end_PDB_ins_code" }))
  {
    if (auto range = RangeIn(row, 0))
    {
      range->Structure = Strand;
      ranges.push_back(std::move(*range));
    }
  }
  return ranges;
}

void SetStructure(const std::vector<StructureRange>& ranges, std::vector<Atom>& atoms)
{
  if (ranges.empty())
  {
    return;
  }
  using Place = std::pair<int, char>;
  std::map<std::string, std::vector<const StructureRange*>> ofChain;
  for (const StructureRange& range : ranges)
  {
    ofChain[range.Chain].push_back(&range);
  }
  std::vector<unsigned char> found(atoms.size(), Coil);
  bool any = false;
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    const Atom& atom = atoms[i];
    const bool isNext = i > 0 && atom.ResidueId == atoms[i - 1].ResidueId &&
      atom.InsertionCode == atoms[i - 1].InsertionCode && atom.Chain == atoms[i - 1].Chain;
    if (isNext)
    {
      found[i] = found[i - 1];
      continue;
    }
    const auto chain = ofChain.find(atom.Chain);
    if (chain == ofChain.end())
    {
      continue;
    }
    const Place place{ atom.ResidueId, atom.InsertionCode };
    for (const StructureRange* range : chain->second)
    {
      if (Place{ range->First, range->FirstCode } <= place &&
        place <= Place{ range->Last, range->LastCode })
      {
        found[i] = range->Structure;
        any = true;
        break; // helices come first
      }
    }
  }
  for (std::size_t i = 0; any && i < atoms.size(); ++i)
  {
    atoms[i].Structure = found[i];
  }
}

}
